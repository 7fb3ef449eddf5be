// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/material/catalogue.h"

namespace etak {

struct GlslText;
enum class GlslVersion;

// Lists of what the library holds and of what etak computes: tables of fixed width for people, CSV and JSON
// for programs. Each CSV begins with the names of its columns; each JSON names its schema.

/// Materials of the library, a line each. `color`: with a swatch of F0 before each line, for terminals.
std::string catalogue_table(std::span<const CatalogueEntry* const> entries, bool color);
std::string catalogue_csv(std::span<const CatalogueEntry* const> entries);
std::string catalogue_json(std::span<const CatalogueEntry* const> entries);
std::string catalogue_jsonl(std::span<const CatalogueEntry* const> entries);  // an object a line

/// Materials near a colour, nearest first.
///   asked    the colour as it was typed
///   linear   it was taken as linear sRGB
std::string nearest_table(std::span<const NearMaterial> found, bool color);
std::string nearest_csv(std::span<const NearMaterial> found);
std::string nearest_json(std::span<const NearMaterial> found, std::string_view asked, bool linear);

/// What names are answered with.
std::string names_table(std::span<const NameAnswer> answers);
std::string names_markdown(std::span<const NameAnswer> answers);
std::string names_csv(std::span<const NameAnswer> answers);
std::string names_json(std::span<const NameAnswer> answers);
std::string names_jsonl(std::span<const NameAnswer> answers);

/// Shading models, their terms and the kinds of light, with what they claim. The table ends in a legend where
/// it is asked for.
std::string models_table(bool legend);
std::string models_csv();
std::string models_json();

/// The functions of core/light/functions.h with their inputs, ranges and sources.
std::string functions_text();
std::string functions_json();

/// The fragment shader with what is in it and what was left out, and why, as comments behind its first line,
/// which must stay the version.
std::string annotated_fragment(const GlslText& text);

/// Both shaders with the same and the uniforms, as resources/schema/shader.schema.json describes them.
std::string shader_json(const GlslText& text, GlslVersion version);

}  // namespace etak
