// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace etak {

/// A GLSL text that is embedded in the library: the formula texts of core/fresnel, core/brdf and core/light
/// in order of use ("brdf/d_ggx.glsl"), then the texts for GPUs alone ("shaders/picture.glsl", from
/// resources/shaders).
struct GlslFile {
  std::string_view name;
  std::string_view text;

  /// Whether this is a formula text, which is also C++, and in which whole numbers stand for real ones.
  bool is_formula() const { return !name.starts_with("shaders/"); }
};
std::span<const GlslFile> glsl_files();

/// The text of the file with this name. Throws Error for unknown names.
std::string_view glsl_file(std::string_view name);

/// `text` with every whole number written as a real one, 2 as 2.0, because GLSL "300 es" has no implicit
/// conversions. Comments and names (`m2`) are not changed.
std::string real_literals(std::string_view text);

/// The functions, structs, constants and uniforms of the *.glsl files among glsl_files() that the code `root`
/// uses, directly or through others, and no others. They come in the order of the files; the part of each
/// file begins with its name and its heading comment. Members of structs and variables that nobody reads are left out.
std::string glsl_needed_by(std::string_view root);

/// Whether the code `root`, or a function that it uses, reads the member of a struct.
bool glsl_reads_member(std::string_view root, std::string_view member);

/// The text of a shader of version 450 with what SPIR-V asks for: its uniforms in one block of binding 0, samplers with
/// the bindings from 1 on, locations for what the stages hand over, and for Vulkan its vertex index and rows that count
/// from the top.
std::string with_bindings(std::string_view text, bool vertex);

}  // namespace etak
