// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace etak {

/// A GLSL text that is kept in the library: the formula texts of core/fresnel, core/brdf and core/light in
/// order of use ("brdf/d_ggx.glsl"), then what only a GPU needs ("shaders/picture.glsl", of
/// resources/shaders).
struct GlslFile {
  std::string_view name;
  std::string_view text;

  /// A formula text is C++ too: whole numbers stand for real ones.
  bool is_formula() const { return !name.starts_with("shaders/"); }
};
std::span<const GlslFile> glsl_files();

/// The text of one file. Throws Error for a name that is not there.
std::string_view glsl_file(std::string_view name);

/// `text` with every whole-number literal as a real one, 2 as 2.0: "300 es" converts nothing by itself.
/// Comments and names (`m2`) stay as they are.
std::string real_literals(std::string_view text);

/// All functions, structs, constants and uniforms of the *.glsl among glsl_files() that `root` uses, directly
/// or through others, in the order of the files, each file's part under its name and heading comment. What is
/// not used is not there.
std::string glsl_needed_by(std::string_view root);

}  // namespace etak
