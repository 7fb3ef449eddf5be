// SPDX-License-Identifier: Apache-2.0
#include "app/cli/shader/subject.h"

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/number.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

const AtlasMaterialRow& material_named(const AtlasLayout& layout, const std::string& file,
                                       const std::string& name) {
  const auto& all = layout.materials;
  std::string names;
  for (const AtlasMaterialRow& row : all) {
    if (row.name == name || (name.empty() && all.size() == 1)) return row;
    if (names.size() < 200) names += (names.empty() ? "" : ", ") + row.name;
  }
  if (name.empty())
    throw Error::at("--layout", file + " holds " + std::to_string(all.size()) + " materials",
                    "--material with one of " + names);
  throw Error::at("--material", printable(name), "one of " + names);
}

std::string color_text(const char* name, const LinearRgb& c, int digits) {
  return std::string(name) + '=' + number(c.r, digits) + ',' + number(c.g, digits) + ',' +
         number(c.b, digits);
}

}  // namespace

LayoutShader shader_of_layout(const std::string& layout_file, const std::string& name) {
  const AtlasLayout layout = parse_layout(read_file(layout_file), layout_file);
  return layout_shader(layout, material_named(layout, layout_file, name));
}

MaterialVariant variant_of_choice(const std::string& choice_file, const std::string& name) {
  const ShadingVariants choices = parse_choices(read_file(choice_file), choice_file);
  const MaterialVariant* variant = choices.find(name);
  if (name.empty() && choices.materials.size() == 1) variant = &choices.materials.front();
  if (variant == nullptr)
    throw Error::at("--material", name.empty() ? "no name" : printable(name),
                    joined(choices.materials, ", ", &MaterialVariant::material));
  return *variant;
}

std::vector<std::string> subject_of(const LayoutShader& shader) {
  std::vector<std::string> out;
  if (shader.f0) out.push_back(color_text("f0", *shader.f0, 9));
  if (shader.diffuse) out.push_back(color_text("diffuse", *shader.diffuse, 9));
  if (shader.gloss) out.push_back("gloss=" + number(*shader.gloss, 9));
  if (shader.opacity) out.push_back("opacity=" + number(*shader.opacity, 9));
  if (out.empty()) out.push_back("f0=0.04");  // everything is fetched from textures: the value is not used
  return out;
}

std::vector<std::string> subject_of(const MaterialVariant& variant) {
  const auto roughness = variant.gloss.given_roughness();
  return {color_text("f0", to_rgb(variant.f0), 17), color_text("diffuse", to_rgb(variant.diffuse), 17),
          roughness ? "roughness=" + number(*roughness, 17) : "gloss=" + number(double{variant.gloss}, 17)};
}

}  // namespace etak::cli
