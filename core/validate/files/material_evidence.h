// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/material/material.h"
#include "core/validate/pixels/evidence.h"

namespace etak {

/// What there is to judge of a material.
MaterialEvidence evidence_of_material(const Material& material);

/// The same of a material file. What the strict reader refuses (ETK611) is read once more leniently for the
/// numbers, so that a misspelt key does not hide a wrong table.
MaterialEvidence evidence_of_material(std::string_view text, const std::string& label);

/// Of a page of refractiveindex.info (.yml) or a table (.csv, .txt). Throws Error for what is neither.
MaterialEvidence evidence_of_spectrum(std::string_view text, const std::string& path,
                                      const std::string& label);

}  // namespace etak
