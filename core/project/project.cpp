// SPDX-License-Identifier: Apache-2.0
#include "core/project/project.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/text/free_names.h"
#include "core/material/appearance.h"
#include "core/material/find.h"
#include "core/material/limits.h"
#include "core/material/names.h"
#include "core/material/quality.h"
#include "core/material/stack_text.h"

namespace etak {
namespace {

LinearRgb in_unit(const LinearRgb& color) {
  return {std::clamp(color.r, 0.0, 1.0), std::clamp(color.g, 0.0, 1.0), std::clamp(color.b, 0.0, 1.0)};
}

TextureSource source_of(const ProjectMaterial& m, Channel channel, const LinearRgb& color,
                        std::vector<std::string>& remarks) {
  if (m.texture(channel)) return *m.texture(channel);
  const LinearRgb inside = in_unit(color);
  if (inside != color)
    remarks.push_back(m.name + ": " + std::string(name(channel)) + " (" + number(color.r, 4) + ", " +
                      number(color.g, 4) + ", " + number(color.b, 4) +
                      " linear) is outside of what a texture holds; brought back to 0..1");
  return ConstantSource{inside, {}};
}

bool is_total(const FoundF0& found) {
  return !gives_f0(found.material.material_class);
}

// In the alpha mode "opaque" the alpha of a material has no effect.
double opacity_by_mode(const ProjectMaterial& material) {
  return material.alpha_mode == AlphaMode::opaque ? 1 : material.alpha;
}

}  // namespace

std::string_view name(Channel channel) {
  constexpr std::array<std::string_view, all_channels.size()> names{
      "diffuse",    "specular", "gloss",     "alpha",      "emission", "occlusion",
      "base_color", "metallic", "roughness", "smoothness", "normal"};
  return names[static_cast<std::size_t>(channel)];
}

LinearRgb standard_emission(const ProjectMaterial& material) {
  return material.texture(Channel::emission) ? LinearRgb{1, 1, 1} : LinearRgb{};
}

Channel drawn_as(Channel channel) {
  switch (channel) {
    case Channel::base_color:
      return Channel::diffuse;
    case Channel::metallic:
      return Channel::specular;
    case Channel::roughness:
    case Channel::smoothness:
      return Channel::gloss;
    default:
      return channel;
  }
}

bool gives(const ProjectMaterial& material, Channel quantity) {
  if (quantity == Channel::specular && material.texture(Channel::base_color)) return true;
  return std::ranges::any_of(all_channels, [&](Channel each) {
    return material.texture(each) && drawn_as(each) == quantity && each != Channel::metallic;
  });
}

void set_texture(ProjectMaterial& material, Channel channel, std::optional<ImageSource> source) {
  const bool standard = material.emission == standard_emission(material);
  const auto leave = [&](std::initializer_list<Channel> others) {
    for (const Channel each : others)
      if (source && each != channel) material.texture(each).reset();
  };
  if (channel == Channel::base_color || channel == Channel::metallic)
    leave({Channel::diffuse, Channel::specular});
  else if (channel == Channel::diffuse || channel == Channel::specular)
    leave({Channel::base_color, Channel::metallic});
  else if (drawn_as(channel) == Channel::gloss)
    leave({Channel::gloss, Channel::roughness, Channel::smoothness});
  material.texture(channel) = std::move(source);
  if (standard) material.emission = standard_emission(material);
}

const ProjectMaterial* Project::find(std::string_view material) const {
  const auto found = std::find_if(materials.begin(), materials.end(),
                                  [&](const ProjectMaterial& each) { return each.name == material; });
  return found == materials.end() ? nullptr : &*found;
}

Project single(const Project& project, const ProjectMaterial& material) {
  Project out;
  out.materials = {material};
  out.view = project.view;
  out.view.compare = {};
  if (!material.measured) return out;
  const std::string& outside = material.measured->outside;
  std::vector<std::string> used{material.measured->material, outside};
  if (is_stack_text(used[0])) {
    const StackText stack = parse_stack(used[0], material.name);
    used.push_back(stack.base);
    for (const StackText::Layer& layer : stack.layers) used.push_back(layer.name);
  }
  for (const Material& each : project.spectra)
    if (std::ranges::any_of(
            used, [&](const std::string& name) { return each.id == name.substr(0, name.find('/')); }))
      out.spectra.push_back(each);
  return out;
}

MaterialLibrary library_of(const Project& project, const MaterialLibrary& library) {
  MaterialLibrary out = library;
  for (const Material& each : project.spectra) out.add(each);
  return out;
}

F0Options f0_options(const MeasuredF0& measured, const MaterialLibrary& library) {
  F0Options options;
  options.viewing = measured.viewing;
  NameWords words;
  words.place = "outside";
  words.instead = "an index of refraction";
  options.outside = outside_medium(library, measured.outside, "outside", words);
  return options;
}

FoundF0 find_f0(const MeasuredF0& measured, const MaterialLibrary& library) {
  NameWords words;
  words.found = "is no material of the library or the project";
  FoundF0 out{find_dataset(library, measured.material, measured.dataset, words), {}};
  out.result = solve(F0Solver(f0_options(measured, library)), out.material, out.chosen());
  if (out.result.refused())
    throw Error::at(out.material.id + "/" + out.chosen().id, "has no F0: " + out.result.refusal,
                    "data over the visible range");
  return out;
}

void take_measured(ProjectMaterial& material, const FoundF0& found) {
  const LinearRgb& color = found.result.srgb_linear;
  if (!is_total(found)) {
    material.specular = color;
    return;
  }
  const TotalReflectance parts = divided(color, material.specular);
  material.diffuse = parts.diffuse;
  material.specular = parts.f0;
}

std::string text_of_layers(const ProjectMaterial& material, const MaterialLibrary& library) {
  if (!material.measured || gives(material, Channel::specular)) return {};
  const auto record = library.find(material.measured->material);
  if (!record) return {};
  const Dataset& used = dataset_named(*record, material.measured->dataset, record->id);
  const auto* stack = std::get_if<Stack>(&used.optics);
  return stack != nullptr ? stack->text : std::string();
}

std::string body_note(const ProjectMaterial& material, const FoundF0& found, const MaterialLibrary& library) {
  std::string out;
  const bool clear = is_clear_body(found.material, found.chosen(), material.diffuse);
  if (is_total(found)) {
    const LinearRgb &r = found.result.srgb_linear, &f0 = material.specular;
    out = "total reflectance " + number(r.r, 3) + " " + number(r.g, 3) + " " + number(r.b, 3) +
          ": diffuse is what F0 " + number(f0.g, 3) + " leaves of it";
  } else if (clear) {
    out = "the body is clear (" + clarity(found.material, found.chosen()).reason +
          "): exports say so; here alpha 0 lets the environment through, as a ball of " +
          number(1000 * clear_ball_m, 3) + " mm bends and absorbs it";
  }
  if (std::holds_alternative<Stack>(found.chosen().optics))
    out += (out.empty() ? "" : "\n") + curve_note(*surface_of(material, library).curve);
  if (const DefaultGloss standard = default_gloss(found.material, clear); material.gloss == standard.gloss)
    out += (out.empty() ? "" : "\n") + default_gloss_remark(standard);
  return out;
}

std::vector<std::string> resolve(Project& project, const MaterialLibrary& library) {
  std::vector<std::string> problems;
  std::optional<MaterialLibrary> all;  // the library is copied only where a material is measured
  const auto take = [&](ProjectMaterial& each) {
    if (!each.measured) return;
    if (!all) all = library_of(project, library);
    try {
      take_measured(each, find_f0(*each.measured, *all));
    } catch (const Error& error) {
      problems.push_back(each.name + ": " + error.what());
      each.measured.reset();
    }
  };
  for (ProjectMaterial& each : project.materials) take(each);
  if (project.view.compare.pinned) take(*project.view.compare.pinned);
  return problems;
}

SurfaceValues surface_of(const ProjectMaterial& material, const MaterialLibrary& library) {
  SurfaceValues out;
  if (material.measured) {
    const FoundF0 found = find_f0(*material.measured, library);
    out = surface_of(found.material, found.chosen(), found.result, vec(material.diffuse), material.gloss,
                     f0_options(*material.measured, library));
    // The record has n and k against vacuum, which do not hold for another outside medium.
    if (!material.measured->outside.empty()) out.optics.reset();
    if (!gives_f0(found.material.material_class)) {
      out.f0 = vec(material.specular);
      complete_from_f0(out);
    }
  } else {
    out.f0 = vec(material.specular);
    complete_from_f0(out);
  }
  take_numbers(material, out);
  return out;
}

void take_numbers(const ProjectMaterial& material, SurfaceValues& surface) {
  surface.diffuse = vec(material.diffuse);
  surface.gloss = material.gloss;
  surface.opacity = opacity_by_mode(material);
  // Where the texture is not seen, nothing is sent out.
  surface.emission = material.texture(Channel::emission) ? Vec3{} : vec(material.emission);
  surface.occlusion = material.occlusion;
}

ExportSurface export_surface(const ProjectMaterial& material, const MaterialLibrary& library) {
  ExportSurface out;
  if (material.measured) {
    const FoundF0 found = find_f0(*material.measured, library);
    out = export_surface(found.material, found.chosen(), f0_options(*material.measured, library),
                         found.result, material.diffuse, material.gloss);
    // Where a total reflectance was divided, the author may have chosen another F0 than the assumed one.
    if (out.total && out.f0 != material.specular) {
      out.f0 = material.specular;
      out.notes.push_back("F0 " + number(out.f0.g, 3) + " is the author's");
    }
  } else {
    out.f0 = material.specular;
    out.kind = authored_kind(material.diffuse, material.specular);
    out.source = "typed";
  }
  out.diffuse = material.diffuse;
  out.gloss = material.gloss;
  // Targets are told separately that the body is clear. An opacity below 1 would take away the reflection at
  // the surface as well.
  out.opacity = out.clear ? 1 : opacity_by_mode(material);
  out.emission = material.emission;
  out.name = material.name;
  out.id = material.name;
  return out;
}

AtlasManifest manifest_of(const Project& project, const MaterialLibrary& library,
                          std::vector<std::string>& remarks) {
  Project with_colors = project;
  for (std::string& problem : resolve(with_colors, library)) remarks.push_back(std::move(problem));
  AtlasManifest out;
  const MaterialLibrary all = library_of(project, library);
  for (const ProjectMaterial& m : with_colors.materials) {
    ManifestMaterial row;
    row.name = m.name;
    row.place = m.name;
    const auto& metallic = m.texture(Channel::metallic);
    if (const auto& base = m.texture(Channel::base_color)) {
      row.base_color = *base;
      if (metallic) row.metallic = *metallic;
    } else {
      row.diffuse = source_of(m, Channel::diffuse, m.diffuse, remarks);
      row.specular = source_of(m, Channel::specular, m.specular, remarks);
      if (metallic) remarks.push_back(m.name + ": its metallic says nothing without a base colour");
    }
    if (auto* f0 = row.specular ? std::get_if<ConstantSource>(&*row.specular) : nullptr)
      f0->layers = text_of_layers(m, all);
    // A roughness is passed on as it was given: the packer then reports what its form of gloss cannot hold.
    if (m.texture(Channel::roughness)) {
      row.roughness = *m.texture(Channel::roughness);
    } else if (m.texture(Channel::smoothness)) {
      row.gloss = *m.texture(Channel::smoothness);
      row.gloss_form = GlossForm::one_minus_roughness;
    } else if (m.gloss.given_roughness() && !m.texture(Channel::gloss)) {
      const double r = *m.gloss.given_roughness();
      row.roughness = ConstantSource{{r, r, r}, {}};
    } else {
      row.gloss = source_of(m, Channel::gloss, {m.gloss, m.gloss, m.gloss}, remarks);
    }
    row.alpha = source_of(m, Channel::alpha, {m.alpha, m.alpha, m.alpha}, remarks);
    row.alpha_mode = m.alpha_mode;
    row.alpha_cutoff = m.alpha_cutoff;
    if (const auto& normal = m.texture(Channel::normal)) row.normal = normal->path;
    for (const Channel channel : {Channel::emission, Channel::occlusion})
      if (m.texture(channel) || (channel == Channel::emission && m.emission != LinearRgb{}))
        remarks.push_back(m.name + ": its " + std::string(name(channel)) + " is in none of the textures");
    out.materials.push_back(std::move(row));
  }
  std::sort(out.materials.begin(), out.materials.end(),
            [](const ManifestMaterial& a, const ManifestMaterial& b) { return a.name < b.name; });
  return out;
}

FreeNames names_of(const Project& project) {
  FreeNames out;
  for (const ProjectMaterial& each : project.materials) out.take(each.name);
  return out;
}

std::string free_name(FreeNames& names, const std::string& wanted) {
  // The beginning of `wanted`, of at most `most` bytes and of whole UTF-8 characters.
  const auto front = [&](std::size_t most) {
    std::size_t end = std::min(wanted.size(), most);
    const auto goes_on = [&] { return (static_cast<unsigned char>(wanted[end]) & 0xC0) == 0x80; };
    while (end > 0 && end < wanted.size() && goes_on()) --end;
    return wanted.substr(0, end);
  };
  const auto numbered = [&](int i) {
    const std::string number = " " + std::to_string(i);
    return front(most_name_bytes - number.size()) + number;
  };
  return names.free(front(most_name_bytes), numbered);
}

std::string free_name(const Project& project, const std::string& wanted) {
  FreeNames names = names_of(project);
  return free_name(names, wanted);
}

bool is_project(std::string_view text) {
  return text.substr(0, std::size_t{4} << 10).find("\"etak-project/1\"") != text.npos;
}

}  // namespace etak
