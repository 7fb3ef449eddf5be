// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/engine_values.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/color/srgb.h"
#include "core/exchange/color_parts.h"
#include "core/exchange/color_text.h"
#include "core/fresnel/fresnel.h"
#include "core/fresnel/solve_index.h"

namespace etak {
namespace {

// ---- one target

struct Job {
  const ExportSurface& s;
  Fit fit;
  EngineValues& out;

  bool metal() const { return s.kind == SurfaceKind::metal; }
  bool black_body() const { return s.diffuse == LinearRgb{}; }
  bool clear() const { return s.clear.has_value(); }
  double roughness() const { return s.gloss.roughness(); }

  void add(const char* field, std::vector<double> values, std::string text) const {
    out.fields.push_back({field, std::move(values), std::move(text)});
  }
  void add(const char* field, double value) const { add(field, {value}, number(value, digits)); }
  void add(const char* field, const LinearRgb& c, std::string (*text)(const LinearRgb&)) const {
    add(field, list(c), text(c));
  }
  void opacity(const char* field) const {
    if (s.opacity < 1) add(field, s.opacity);
  }
  void note(std::string text) const { out.notes.push_back(std::move(text)); }
  // The index of a clear body: that of the luminance of F0.
  double index() const { return ior_of_f0(std::clamp(luminance(s.f0, s.space), 0.0, largest_dielectric_f0)); }
  std::string index_text() const { return "index " + number(index(), 5); }
  // What absorption over a depth has to be told beside fields that have none for it.
  void note_absorption(const char* where) const {
    if (clear() && s.clear->depth_m > 0)
      note("light through " + number(s.clear->depth_m, 3) + " m of it becomes " + plain_text(s.clear->color) +
           " (linear): " + where);
  }
  void note_no_transmission(const char* what) const {
    if (clear()) note("the body is clear, which " + std::string(what) + ": " + index_text());
  }
  // A dielectric's diffuse colour where the target takes the surface's reflectance off it. Typed colours go
  // as they are; a measured total has to come out as it was.
  LinearRgb layered_body() const { return layered_diffuse(s); }

  LinearRgb fit_f0(const char* field, const char* reason) const {
    return fitted(s.f0, fit, 1, s.space, field, reason, out.changes);
  }
  // What the target's own curve makes of an edge that is known.
  void schlick_edge(const LinearRgb& f0_used) const {
    if (s.f82)
      note_change(out.changes, "F82", list(*s.f82), list(schlick82(f0_used)), "schlick",
                  "no edge colour: the edge follows from F0 alone");
  }
  // A dielectric's F0 as one number.
  double one_f0(const char* reason) const {
    const double y = luminance(s.f0, s.space);
    note_change(out.changes, "F0", list(s.f0), list(grey(y)), "luminance", reason);
    return y;
  }
};

void write_hex(const Job& j) {
  const auto color = [&](const char* field, const LinearRgb& wanted) {
    const LinearRgb c = fitted(wanted, j.fit, 1, j.s.space, field, "8 bits end at 1", j.out.changes);
    const Srgb8 codes = srgb_u8(c);
    j.add(field, {double(codes.r), double(codes.g), double(codes.b)}, hex(codes));
  };
  color("F0", j.s.f0);
  if (!j.black_body()) color("diffuse", j.s.diffuse);
  j.note_no_transmission("colours alone do not say");
}

void write_srgb8(const Job& j) {
  write_hex(j);
  for (EngineField& field : j.out.fields)
    field.text =
        number(field.values[0], 3) + ", " + number(field.values[1], 3) + ", " + number(field.values[2], 3);
}

void write_linear(const Job& j) {
  j.add("F0", j.s.f0, plain_text);
  if (!j.black_body()) j.add("diffuse", j.s.diffuse, plain_text);
  j.note_no_transmission("colours alone do not say");
}

void write_glsl(const Job& j) {
  j.add("f0", j.s.f0, glsl_text);
  if (j.s.f82) j.add("f82", *j.s.f82, glsl_text);
  if (!j.black_body()) j.add("diffuse", j.s.diffuse, glsl_text);
  for (const auto& [field, value] :
       {std::pair<const char*, double>{"gloss", j.s.gloss}, {"alpha", j.s.gloss.alpha()}})
    j.add(field, {value}, real_text(value));
  if (j.s.gloss.held())
    note_change(j.out.changes, "roughness", {j.roughness()}, {roughness_of_gloss(j.s.gloss)}, "clamp",
                "Schueler's gloss ends there; alpha has the roughness that was given");
  j.note_no_transmission("is the shader's to draw");
  j.note_absorption("the shader's to apply");
  if (j.s.opacity < 1) j.add("opacity", {j.s.opacity}, real_text(j.s.opacity));
}

void write_unreal(const Job& j) {
  const LinearRgb base = j.metal() ? j.fit_f0("Base Color", "Base Color ends at 1") : j.s.diffuse;
  j.add("Base Color", base, unreal_text);
  j.add("Metallic", j.metal() ? 1 : 0);
  if (j.metal()) {
    j.add("Specular", 0.5);
    j.note("Specular has no effect on a metal");
    j.schlick_edge(base);
  } else {
    const double wanted = j.one_f0("Specular is one number") / 0.08;
    const double specular =
        fitted(wanted, 0, 1, "Specular", "Specular ends at 1, an F0 of 0.08", j.out.changes);
    j.add("Specular", specular);
    if (specular * 0.08 < 0.02)
      j.note("an F0 below 0.02 is taken as shadow: the rim fades with 50 F0");
    else
      j.schlick_edge(grey(specular * 0.08));
  }
  j.add("Roughness", j.roughness());
  if (j.clear()) {
    j.add("Refraction (Index of Refraction)", j.index());
    j.note(
        "the body is clear: Blend Mode Translucent, Lighting Mode Surface ForwardShading, Refraction Method "
        "Index of "
        "Refraction; Opacity is left to you, because it fades the reflection too");
    j.note_absorption("no field of the material takes it");
  }
  j.opacity("Opacity");
}

void unity_alpha(const Job& j) {
  if (!j.clear()) return j.opacity("Alpha");
  j.add("Alpha", j.s.opacity < 1 ? j.s.opacity : 0);
  j.note(
      "the body is clear: Rendering Mode Transparent, which keeps the reflection where Alpha is 0; it does "
      "not refract (" +
      j.index_text() + ")");
  j.note_absorption("no field of the material takes it");
}

void write_unity_metallic(const Job& j) {
  constexpr double dielectric = 0.04;
  LinearRgb albedo = j.s.diffuse;
  if (j.metal()) {
    albedo = j.fit_f0("Albedo", "Albedo ends at 1");
    j.schlick_edge(albedo);
  } else {
    note_change(j.out.changes, "F0", list(j.s.f0), list(grey(dielectric)), "fixed",
                "the metallic setup has one F0 for all dielectrics");
    // What is to come out of a measured total does not depend on the F0 that was wanted.
    const LinearRgb body =
        j.s.total ? LinearRgb{j.s.total->r - dielectric, j.s.total->g - dielectric, j.s.total->b - dielectric}
                  : j.s.diffuse;
    albedo = fitted(scaled(body, 1 / (1 - dielectric)), j.fit, 1, j.s.space, "Albedo",
                    "Albedo is 0 to 1; 0.04 of the light is taken off it", j.out.changes);
  }
  j.add("Albedo", albedo, hex_text);
  j.add("Metallic", j.metal() ? 1 : 0);
  j.add("Smoothness", 1 - j.roughness());
  unity_alpha(j);
}

void write_unity_specular(const Job& j) {
  const LinearRgb f0 = j.fit_f0("Specular", "Specular ends at 1");
  const double left = 1 - largest(f0);
  LinearRgb albedo{0, 0, 0};
  if (!j.black_body() && left > 0) albedo = scaled(j.s.diffuse, 1 / left);
  albedo = fitted(albedo, j.fit, 1, j.s.space, "Albedo",
                  "Albedo ends at 1; the largest of Specular is taken off it", j.out.changes);
  j.add("Albedo", albedo, hex_text);
  j.add("Specular", f0, hex_text);
  j.add("Smoothness", 1 - j.roughness());
  j.schlick_edge(f0);
  unity_alpha(j);
}

void write_blender(const Job& j) {
  if (j.metal()) {
    const LinearRgb f0 = j.fit_f0("Base Color", "Base Color of a metal ends at 1");
    j.add("Base Color", f0, blender_text);
    j.add("Metallic", 1);
    const LinearRgb tint = fitted(tint82(j.s, f0), Fit::clamp, 1, j.s.space, "Specular Tint",
                                  "the edge tint ends at 1", j.out.changes);
    j.add("Specular Tint", tint, blender_text);
  } else {
    const LinearRgb f0 = fitted(j.s.f0, j.fit, largest_dielectric_f0, j.s.space, "F0",
                                "the index of a dielectric has to be finite", j.out.changes);
    const double most = largest(f0);
    j.add("Base Color", j.clear() ? grey(1) : j.layered_body(), blender_text);
    j.add("Metallic", 0);
    j.add("IOR", ior_of_f0(most));
    j.add("IOR Level", 0.5);
    j.add("Specular Tint", most > 0 ? scaled(f0, 1 / most) : grey(1), blender_text);
  }
  j.add("Roughness", j.roughness());
  if (j.clear()) {
    j.add("Transmission Weight", 1);
    j.note_absorption("a Volume Absorption node beside the shader takes it");
  }
  j.opacity("Alpha");
}

// Of Beer and Lambert, in 1/m: what turns white light into `color` over `depth_m`.
LinearRgb absorption_of(const ClearBody& body) {
  // Against the infinity of a channel that nothing passes, or that is out of gamut.
  constexpr double darkest = 1e-6;
  const auto channel = [&](double c) {
    return std::max(0.0, -std::log(std::max(c, darkest)) / body.depth_m);
  };
  return {channel(body.color.r), channel(body.color.g), channel(body.color.b)};
}

void write_filament(const Job& j) {
  const LinearRgb base = j.metal()   ? j.fit_f0("baseColor", "baseColor ends at 1")
                         : j.clear() ? grey(1)
                                     : j.s.diffuse;
  j.add("baseColor", base, plain_text);
  j.add("metallic", j.metal() ? 1 : 0);
  if (j.metal()) {
    j.note("reflectance has no effect on a metal");
    j.schlick_edge(base);
  } else {
    const double wanted = std::sqrt(std::max(j.one_f0("reflectance is one number"), 0.0) / 0.16);
    const double reflectance =
        fitted(wanted, 0, 1, "reflectance", "reflectance ends at 1, an F0 of 0.16", j.out.changes);
    j.add("reflectance", reflectance);
    if (0.16 * reflectance * reflectance < 0.02)
      j.note("an F0 below 0.02 is taken as shadow: the rim fades with 50 F0");
    else
      j.schlick_edge(grey(0.16 * reflectance * reflectance));
  }
  j.add("roughness", j.roughness());
  if (j.clear()) {
    j.add("transmission", 1);
    j.add("ior", j.index());
    if (j.s.clear->depth_m > 0) j.add("absorption", absorption_of(*j.s.clear), plain_text);
    j.note("the body is clear: the material has to be compiled with refractionMode screenspace or cubemap");
  }
  if (j.s.opacity < 1) {
    j.add("alpha", j.s.opacity);
    j.note("baseColor is to be multiplied by alpha before it is set");
  }
}

void write_open_pbr(const Job& j) {
  const OpenPbrValues v = open_pbr_values(j.s, j.fit, j.out.changes);
  j.add("base_metalness", v.base_metalness);
  j.add("base_color", v.base_color, plain_text);
  j.add("specular_color", v.specular_color, plain_text);
  if (!j.metal()) j.add("specular_ior", v.specular_ior);
  j.add("specular_roughness", v.specular_roughness);
  if (v.transmission_weight > 0) {
    j.add("transmission_weight", v.transmission_weight);
    j.add("transmission_color", v.transmission_color, plain_text);
    j.add("transmission_depth", v.transmission_depth);
  }
  j.opacity("geometry_opacity");
}

void write_gltf(const Job& j) {
  const GltfMaterialValues v = gltf_values(j.s, false, j.fit, j.out.changes);
  j.add("baseColorFactor", v.base_color, plain_text);
  j.add("metallicFactor", v.metallic);
  j.add("roughnessFactor", v.roughness);
  if (!j.metal()) {
    j.add("KHR_materials_ior.ior", v.ior);
    j.add("KHR_materials_specular.specularColorFactor", v.specular_color, plain_text);
  }
  if (v.transmission > 0) j.add("KHR_materials_transmission.transmissionFactor", v.transmission);
  if (v.volume && v.volume->depth_m > 0) {
    j.add("KHR_materials_volume.attenuationColor", v.volume->color, plain_text);
    j.add("KHR_materials_volume.attenuationDistance", v.volume->depth_m);
  }
  j.opacity("baseColorFactor alpha");
}

void write_gltf_gloss(const Job& j) {
  const GltfMaterialValues v = gltf_values(j.s, true, j.fit, j.out.changes);
  j.add("diffuseFactor", v.base_color, plain_text);
  j.add("specularFactor", v.specular_color, plain_text);
  j.add("glossinessFactor", v.glossiness);
  j.note_no_transmission("this form of material does not say; gltf does");
  j.opacity("diffuseFactor alpha");
}

// n and k of the three channels with what they miss.
struct RgbIndex {
  LinearRgb n, k, residual;
};
RgbIndex rgb_index(const ExportSurface& s) {
  const Vec3 f0 = vec(s.f0);
  Vec3 n{}, k{}, residual{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (!s.f82) {
      n[c] = ior_of_f0(std::clamp(f0[c], 0.0, largest_dielectric_f0));
      residual[c] = std::abs(f64::f0(n[c], 0) - f0[c]);
      continue;
    }
    const double f82 = vec(*s.f82)[c];
    const SolvedIndex found = solve_index(f0[c], f82, s.log_n_hint[c]);
    n[c] = found.n;
    k[c] = found.k;
    residual[c] = std::max(std::abs(f64::f0(n[c], k[c]) - f0[c]),
                           std::abs(f64::fresnel_exact(n[c], k[c], f82_cosine) - f82));
  }
  return {to_rgb(n), to_rgb(k), to_rgb(residual)};
}

void write_rgb_nk(const Job& j) {
  const RgbIndex index = rgb_index(j.s);
  j.add("n", index.n, plain_text);
  j.add("k", index.k, plain_text);
  j.add("residual", index.residual, plain_text);
  j.note_no_transmission("a shader of conductors does not draw");
  j.note(j.s.f82 ? "n and k give F0 and F82 of each channel; residual is what they miss of the two"
                 : "without a known edge: k is 0 and n gives F0");
  if (largest(index.residual) > 1e-6) {
    const auto reflected = [&](double c) {
      return LinearRgb{f64::fresnel_exact(index.n.r, index.k.r, c),
                       f64::fresnel_exact(index.n.g, index.k.g, c),
                       f64::fresnel_exact(index.n.b, index.k.b, c)};
    };
    note_change(j.out.changes, "F0", list(j.s.f0), list(reflected(1)), "clamp",
                "no n and k reflect more than all");
    if (j.s.f82)
      note_change(j.out.changes, "F82", list(*j.s.f82), list(reflected(f82_cosine)), "nearest",
                  "no n and k have this F0 and this edge");
  }
}

void write_gulbrandsen(const Job& j) {
  constexpr double most_r = 0.99;
  const LinearRgb r = fitted(j.s.f0, j.fit, most_r, j.s.space, "reflectivity",
                             "n and k are undefined at 1 and above", j.out.changes);
  LinearRgb g{0, 0, 0};
  if (j.s.f82) {
    const Vec3 f0 = vec(r), f82 = vec(*j.s.f82);
    Vec3 edge{}, seen{};
    for (std::size_t c = 0; c < 3; ++c) {
      const SolvedIndex index = solve_index(f0[c], f82[c], j.s.log_n_hint[c]);
      const double root = std::sqrt(f0[c]);
      const double most = (1 + root) / (1 - root), least = (1 - f0[c]) / (1 + f0[c]);
      edge[c] = most > least ? std::clamp((most - index.n) / (most - least), 0.0, 1.0) : 0;
      seen[c] = f64::fresnel_exact(index.n, index.k, f82_cosine);
    }
    g = to_rgb(edge);
    note_change(j.out.changes, "F82", list(*j.s.f82), {seen[0], seen[1], seen[2]}, "nearest",
                "no edge colour gives this F82 with this reflectivity");
  }
  j.note_no_transmission("a shader of conductors does not draw");
  j.add("reflectivity", r, plain_text);
  j.add("edge_color", g, plain_text);
}

struct TargetRow {
  EngineTarget target;
  void (*write)(const Job&);
};
constexpr std::array rows{
    TargetRow{{"hex", "hex, sRGB"}, write_hex},
    TargetRow{{"srgb8", "8-bit sRGB"}, write_srgb8},
    TargetRow{{"linear", "linear sRGB, not clipped"}, write_linear},
    TargetRow{{"glsl", "GLSL"}, write_glsl},
    TargetRow{{"unreal", "Unreal Engine"}, write_unreal},
    TargetRow{{"unity-metallic", "Unity, metallic setup"}, write_unity_metallic},
    TargetRow{{"unity-specular", "Unity, specular setup"}, write_unity_specular},
    TargetRow{{"blender", "Blender 4 Principled BSDF"}, write_blender},
    TargetRow{{"filament", "Filament"}, write_filament},
    TargetRow{{"openpbr", "OpenPBR 1.1"}, write_open_pbr},
    TargetRow{{"gltf", "glTF 2.0 metal-rough"}, write_gltf},
    TargetRow{{"gltf-specular-glossiness", "glTF 2.0 specular-glossiness"}, write_gltf_gloss},
    TargetRow{{"gulbrandsen", "Gulbrandsen (MaterialX artistic_ior)"}, write_gulbrandsen},
    TargetRow{{"rgb-nk", "RGB n, k (conductor shaders)"}, write_rgb_nk},
};

constexpr auto targets = [] {
  std::array<EngineTarget, rows.size()> out{};
  for (std::size_t i = 0; i < rows.size(); ++i) out[i] = rows[i].target;
  return out;
}();

}  // namespace

std::span<const EngineTarget> engine_targets() {
  return targets;
}

const EngineTarget* engine_target(std::string_view id) {
  for (const EngineTarget& target : targets)
    if (target.id == id) return &target;
  return nullptr;
}

EngineValues engine_values(const EngineTarget& target, const ExportSurface& surface, Fit fit) {
  validate(surface);
  if (surface.space != RgbSpace::srgb)
    throw Error::at(surface.id, "colours in " + std::string(name(surface.space)), "linear sRGB");
  EngineValues out;
  out.target = target.id;
  const Job job{surface, fit, out};
  for (const TargetRow& row : rows)
    if (row.target.id == target.id) row.write(job);
  return out;
}

std::string copy_text(const EngineValues& values) {
  if (values.fields.size() == 1) return values.fields.front().text;
  std::string out;
  for (const EngineField& field : values.fields) {
    if (values.target == "glsl")
      out += std::string("const ") + (field.values.size() == 3 ? "vec3 " : "float ") + field.name + " = " +
             field.text + ";\n";
    else
      out += field.name + ": " + field.text + '\n';
  }
  return out;
}

}  // namespace etak
