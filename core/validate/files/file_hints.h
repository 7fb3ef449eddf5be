// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace etak {

// What paths and first lines tell of files that a search comes by.

/// Why nothing stands at `path`.
std::string why_missing(const std::string& path);

/// What a pattern leaves of a file name: "crate" for "*_spec.*" and "crate_spec.png"; for other forms the
/// whole name.
std::string pattern_stem(const std::string& pattern, const std::string& name);

/// "atlas/page0.mip3.png" is a level of "atlas/page0.png", as etak pack names them; "" for other names.
std::string level_0_of(const std::string& path);

/// Tables and YAML files of a project are rarely spectra: one found in a folder is taken for that only when
/// it says so, by a refractiveindex.info page's "DATA:" or a header line that begins with a wavelength.
bool looks_like_spectrum(const std::string& path);

/// Throws Error where a link leads from `folder` out to `path`, which was found there and which nobody named.
void check_links(const std::string& folder, const std::string& path);

/// `path` relative to `root` (empty: the working folder) as text alone (links are not looked at), with '/'.
std::string relative_label(const std::string& path, const std::string& root);

}  // namespace etak
