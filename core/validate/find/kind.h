// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/judge/target.h"

namespace etak {

/// The kind of a file by its ending and, for .json and input from a pipe, by its first bytes; nullopt: a kind
/// that is not checked. Throws Error where those bytes cannot be read. Every picture is specular_gloss here;
/// the caller finds its role by its name.
std::optional<FileRole> role_of_file(const std::string& path);

}  // namespace etak
