// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/certainty/identify.h"
#include "core/material/catalogue.h"

namespace etak {

struct GlslText;
enum class GlslVersion;
enum class ShaderLanguage;

// Lists of the materials of the library and of the models and functions of etak: tables of fixed width for
// people, CSV and JSON for programs. Each CSV begins with the names of its columns; each JSON document names
// its schema.

/// Materials of the library, a line each.
///   color   a swatch of F0 stands before each line, for terminals
std::string catalogue_table(std::span<const CatalogueEntry* const> entries, bool color);
std::string catalogue_csv(std::span<const CatalogueEntry* const> entries);
std::string catalogue_json(std::span<const CatalogueEntry* const> entries);
std::string catalogue_jsonl(std::span<const CatalogueEntry* const> entries);  // one JSON object per line

/// Materials near a colour, nearest first, with their distances over the bands' nine-tenths radii and, but in CSV, which of them
/// cannot be told apart.
///   bands    of the found ones
///   asked    the colour as the user typed it
///   linear   the colour was read as linear sRGB, not as 8-bit codes
std::string nearest_table(std::span<const NearMaterial> found, std::span<const BandOfF0> bands, bool color);
std::string nearest_csv(std::span<const NearMaterial> found, std::span<const BandOfF0> bands);
std::string nearest_json(std::span<const NearMaterial> found, std::span<const BandOfF0> bands,
                         std::string_view asked, bool linear);

/// The library's answer to each of a list of names: a material, or why there is none.
std::string names_table(std::span<const NameAnswer> answers);
std::string names_markdown(std::span<const NameAnswer> answers);
std::string names_csv(std::span<const NameAnswer> answers);
std::string names_json(std::span<const NameAnswer> answers);
std::string names_jsonl(std::span<const NameAnswer> answers);

/// Shading models, their terms and the kinds of light, with their claims (reciprocal, conserves energy).
///   legend   the table ends with an explanation of its marks and kinds
///   search   only what has this text in id, kind or title, in any case
std::string models_table(bool legend, const std::string& search = {});
std::string models_csv(const std::string& search = {});
std::string models_json(const std::string& search = {});

/// The functions of core/light/functions.h with their inputs, ranges and sources.
std::string functions_text();
std::string functions_json();

/// The fragment shader with comments that list the features that are in it and those that were left out, with
/// reasons. The comments stand after the first line, because GLSL wants `#version` there.
std::string annotated_fragment(const GlslText& text);

/// Both shaders, the features in and left out, and the uniforms, as resources/schema/shader.schema.json
/// describes them.
std::string shader_json(const GlslText& text, GlslVersion version, const std::vector<std::string>& remarks);

/// The text of shader_function() in the same schema.
std::string shader_function_json(const std::string& text, ShaderLanguage language,
                                 const std::vector<std::string>& remarks);

}  // namespace etak
