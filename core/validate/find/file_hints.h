// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace etak {

// What paths and first lines tell of the files that a search finds.

/// Why there is no file at `path`, for messages, and what helps there.
std::string why_missing(const std::string& path);
const char* missing_fix(std::string_view path);

/// The part of a file name that a pattern leaves open: "crate" of "crate_spec.png" for "*_spec.*"; for
/// patterns of other forms the name without its format.
std::string pattern_stem(const std::string& pattern, const std::string& name);

/// The picture that a file is a mip level of, as etak pack names them: "atlas/page0.png" for
/// "atlas/page0.mip3.png"; "" for other names.
std::string level_0_of(const std::string& path);

/// Whether a table or YAML file tells that it is a spectrum, by the "DATA:" of a page of refractiveindex.info
/// or by a header line that begins with a wavelength. Files found in folders have to, because tables and YAML
/// files of a project are rarely spectra.
bool looks_like_spectrum(const std::string& path);

/// Throws Error where `path`, which a search of `folder` has found, leads out of the folder by a link.
void check_links(const std::string& folder, const std::string& path);

/// `path` relative to `root` (empty: the working folder) as text alone (links are not looked at), with '/'.
std::string relative_label(const std::string& path, const std::string& root);

}  // namespace etak
