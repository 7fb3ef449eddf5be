// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/judge/pixels/evidence.h"
#include "core/material/material.h"

namespace etak {

/// The evidence of a material: its datasets, and the F0 computed from the preferred one.
MaterialEvidence evidence_of_material(const Material& material);

/// The evidence of a material file. A file that the strict reader refuses (ETK611) is read once more leniently
/// for its numbers, so that a misspelt key does not hide a wrong table.
MaterialEvidence evidence_of_material(std::string_view text, const std::string& label);

/// The evidence of a page of refractiveindex.info (.yml) or of a table (.csv, .txt). Throws Error for other texts.
MaterialEvidence evidence_of_spectrum(std::string_view text, const std::string& path,
                                      const std::string& label);

}  // namespace etak
