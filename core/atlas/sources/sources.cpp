// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/sources.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/atlas/sources/floats.h"
#include "core/atlas/sources/masked.h"
#include "core/atlas/sources/metallic.h"
#include "core/base/error.h"
#include "core/base/number.h"
#include "core/color/gloss.h"
#include "core/color/luminance.h"
#include "core/color/srgb.h"
#include "core/image/mean_squares.h"
#include "core/material/appearance.h"
#include "core/material/f0.h"
#include "core/material/find.h"
#include "core/math/functions.h"

namespace etak {
namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

// What no dielectric without a colour of its own reflects (Hoffman's zone begins here).
constexpr double least_metal_f0 = 0.2;
// What the materials of a manifest are read with, and the remarks on what had to be changed.
struct Resolving {
  const AtlasManifest& manifest;
  const MaterialLibrary& library;
  const PictureReading& reading;
  GlossForm gloss;  // of texture B
  std::vector<std::string>& remarks;
};

// A texture of a material in the manifest.
struct RolePlace {
  const ManifestMaterial& material;
  std::string role;
  std::string pointer() const { return material.place + '/' + role; }
};

PlaneSource fixed_grey(double value) {
  PlaneSource out;
  out.color = false;
  out.pick = {0, 0, 0};
  out.exact.fill(value);
  out.constant.fill(plain_u8(value));
  return out;
}

void note_clamped(const RolePlace& at, double encoded, const Resolving& r) {
  if (encoded < 0 || encoded > 1)
    r.remarks.push_back(at.material.name + ": " + at.role + " comes out as " + number(encoded, 4) +
                        " in the form " + std::string(name(r.gloss)) + "; brought back to 0..1");
}

int channel_at(char letter) {
  return static_cast<int>(std::string_view("rgba").find(letter));
}

PlaneSource grey_plane(const RolePlace& at, const TextureSource& source,
                       std::shared_ptr<const CodeCurve> curve, const Resolving& r) {
  PlaneSource out = fixed_grey(0);
  if (const auto* constant = std::get_if<ConstantSource>(&source)) {
    const double value = constant->linear.r, encoded = curve ? curve->apply(value) : value;
    note_clamped(at, encoded, r);
    return fixed_grey(encoded);
  }
  const auto& image = std::get<ImageSource>(source);
  out.path = image.path;
  out.door = &r.reading.door;
  out.decoded = &r.reading.decoded;
  out.curve = std::move(curve);
  if (!image.channels.empty()) out.pick.fill(channel_at(image.channels[0])), out.picked = true;
  if (!image.space.empty() && image.space != "linear")
    throw Error::at(at.pointer() + "/space", printable(image.space), "linear, or nothing");
  return out;
}

GlossForm gloss_form(const ManifestMaterial& m, const Resolving& r) {
  return m.roughness ? GlossForm::roughness : m.gloss_form.value_or(r.manifest.gloss);
}

PlaneSource gloss_plane(const ManifestMaterial& m, const Resolving& r) {
  const GlossForm from = gloss_form(m, r), to = r.gloss;
  std::shared_ptr<CodeCurve> curve;
  if (from != to) {
    curve = std::make_shared<CodeCurve>();
    curve->apply = [from, to](double v) { return converted_gloss(v, from, to); };
  }
  return grey_plane({m, m.roughness ? "roughness" : "gloss"}, m.roughness ? *m.roughness : *m.gloss, curve,
                    r);
}

void set_space(const RolePlace& at, const SpaceOpener& open_space, PlaneSource& to) {
  const std::string& space = to.space_name;
  const auto same = [](double v) { return v; };
  const auto encode = [](double v) { return srgb_encode(v); };
  static const std::shared_ptr<const CodeCurve> floats_linear = [&] {
    // Codes of files of 8 and 16 bits are sRGB-encoded already; numbers of EXR and HDR files are linear.
    auto curve = std::make_shared<CodeCurve>();
    curve->apply_float = encode;
    curve->linear_float = same;
    return curve;
  }();
  if (space.empty()) {
    to.curve = floats_linear;
    return;
  }
  if (space == "srgb") return;
  auto curve = std::make_shared<CodeCurve>();
  if (space == "linear") {
    curve->linear = same;
    curve->apply = encode;
  } else if (space == "power-2.2") {
    curve->linear = [](double v) { return math::pow(std::max(v, 0.0), 2.2); };
    curve->apply = [](double v) { return srgb_encode(math::pow(std::max(v, 0.0), 2.2)); };
  } else {
    const std::string place = at.pointer() + "/space";
    if (!open_space)
      throw Error::at(place, printable(space), "srgb, linear, power-2.2 or a space of an OpenColorIO config");
    try {
      to.space = open_space(space);
    } catch (const Error& error) {
      throw Error::at(place, printable(space) + ": " + error.what(), "srgb, linear or power-2.2 otherwise");
    }
    return;
  }
  to.curve = std::move(curve);
}

// Tells of a colour that textures of 8 bits cannot hold; those of floats keep it.
void tell_outside(const RolePlace& at, const std::string& what, const LinearRgb& c, const Resolving& r) {
  for (const double v : {c.r, c.g, c.b})
    if (v < 0 || v > 1) {
      r.remarks.push_back(at.material.name + ": " + what + " is outside of sRGB (" + number(c.r, 4) + ", " +
                          number(c.g, 4) + ", " + number(c.b, 4) +
                          " linear); in 8 bits brought back to 0..1");
      return;
    }
}

PlaneSource plane_of(const Srgb8& codes, const LinearRgb& linear) {
  PlaneSource out;
  out.constant = {codes.r, codes.g, codes.b};
  out.exact = {linear.r, linear.g, linear.b};
  return out;
}

// A record of the library and its colour.
struct FoundColor {
  FoundDataset found;
  F0Result result;
};

FoundColor found_color(const RolePlace& at, const LibrarySource& source, const Resolving& r) {
  const std::string place = at.pointer();
  NameWords words;
  words.place = place;
  words.instead = "a file name with its ending";
  FoundColor out{find_dataset(r.library, source.material, source.dataset, words), {}};
  F0Options options;
  const std::string outside_place = place + "/outside";
  words.place = outside_place;
  words.instead = "an index of refraction";
  options.outside = outside_medium(r.library, source.outside, outside_place, words);
  if (!source.method.empty()) {
    const auto method = method_named(source.method);
    if (!method) throw Error::at(place, printable(source.method), "a method of integration");
    options.method = *method;
  }
  const Dataset& dataset = out.found.chosen();
  out.result = F0Solver(std::move(options)).solve(dataset.optics, dataset.flags);
  if (out.result.refused()) throw Error::at(place, out.found.material.id + ": " + out.result.refusal);
  return out;
}

// The colour of a material of the library, as a plane of one value.
PlaneSource library_color(const RolePlace& at, const LibrarySource& source, const Resolving& r) {
  const FoundColor of = found_color(at, source, r);
  const Material& material = of.found.material;
  const Dataset& dataset = of.found.chosen();
  const bool diffuse = at.role == "diffuse";
  if (diffuse && !std::holds_alternative<Reflectance>(dataset.optics))
    throw Error::at(at.pointer(), material.id + " has n and k, which say nothing of a diffuse colour",
                    "a material with measured reflectance");
  if (diffuse && optical_kind(material.material_class) == "surface")
    r.remarks.push_back(at.material.name + ": diffuse is the total reflectance of " + material.id +
                        ", which holds what its surface reflects: specular comes on top of it");
  const LinearRgb& linear = of.result.srgb_linear;
  tell_outside(at, material.id, linear, r);
  PlaneSource out = plane_of(of.result.srgb8, linear);
  if (const auto* stack = std::get_if<Stack>(&dataset.optics)) out.layers = stack->text;
  return out;
}

PlaneSource color_plane(const RolePlace& at, const TextureSource& source, const Resolving& r) {
  PlaneSource out;
  if (const auto* constant = std::get_if<ConstantSource>(&source)) {
    out = plane_of(constant->codes ? *constant->codes : srgb_u8(constant->linear), constant->linear);
    out.layers = constant->layers;
    tell_outside(at, at.role, constant->linear, r);
    return out;
  }
  if (const auto* material = std::get_if<LibrarySource>(&source)) return library_color(at, *material, r);
  const auto& image = std::get<ImageSource>(source);
  out.path = image.path;
  out.door = &r.reading.door;
  out.decoded = &r.reading.decoded;
  const auto usual = r.reading.spaces.find(at.role);
  out.space_name = image.space.empty() && usual != r.reading.spaces.end() ? usual->second : image.space;
  set_space(at, r.reading.open_space, out);
  if (!image.channels.empty()) {
    out.picked = true;
    for (std::size_t i = 0; i < 3; ++i) out.pick[i] = channel_at(image.channels[i]);
  }
  return out;
}

// The size that all pictures share.
void set_size(const ManifestMaterial& m, std::vector<const PlaneSource*> planes, const PictureDoor& door,
              PackInput& in) {
  for (std::size_t t = 0; t < 2; ++t) planes.insert(planes.end(), {&in.color[t], &in.grey[t]});
  std::string first;
  for (const PlaneSource* plane : planes) {
    if (!plane->is_image()) continue;
    const PictureHeader header = picture_header(plane->path, door);
    in.files.push_back(plane->path);
    if (m.width && (header.width != *m.width || (m.height && header.height != *m.height)))
      throw Error::at(plane->path, "is " + size_text(header.width, header.height),
                      size_text(*m.width, m.height.value_or(header.height)) + ", as " + m.place + " says");
    if (!first.empty() && (header.width != in.width || header.height != in.height))
      throw Error::at(plane->path, "is " + size_text(header.width, header.height),
                      size_text(in.width, in.height) + " like " + first + ", which is of the same material");
    in.width = header.width;
    in.height = header.height;
    in.streamed = in.streamed && header.strips;
    first = plane->path;
  }
  if (first.empty()) in.width = m.width.value_or(1), in.height = m.height.value_or(1);
}

std::string plane_text(const PlaneSource& p) {
  std::string out = p.path + '|' + (p.curve ? "c" : "-") + p.space_name;
  for (const int pick : p.pick) out += std::to_string(pick);
  for (const std::uint8_t code : p.constant) out += ',' + std::to_string(code);
  for (const double value : p.exact) out += ',' + number(value, 17);
  return out;
}

// A material of numbers alone is known before anything is read.
void set_facts(PackInput& in) {
  MaterialFacts& f = in.facts;
  f.name = in.name;
  f.width = in.width;
  f.height = in.height;
  f.opaque = in.alpha_mode == AlphaMode::opaque;
  f.crop = {0, 0, in.width, in.height};
  for (std::size_t t = 0; t < 2; ++t) f.source += plane_text(in.color[t]) + plane_text(in.grey[t]);
  if (in.convert) f.source += in.name;
  if (!in.files.empty() || in.convert) return;
  f.learned = true;
  for (std::size_t t = 0; t < 2; ++t) {
    const std::array<std::uint8_t, 4> texel{in.color[t].constant[0], in.color[t].constant[1],
                                            in.color[t].constant[2], in.grey[t].constant[0]};
    add_texels(f.range, both_textures[t], texel.data(), 1);
    std::uint64_t packed = 0;
    for (const std::uint8_t code : texel) packed = packed << 8 | code;
    (t == 0 ? f.color_hash : f.specular_hash) = {packed, std::numeric_limits<std::uint64_t>::max()};
  }
}

// A material of a mask: what its record says, and what the manifest says instead.
MaskedPart masked_part(const ManifestMaterial& m, const MaskPart& part, const Resolving& r) {
  ManifestMaterial of;
  of.name = m.name;
  of.place = part.place;
  of.gloss = part.gloss;
  of.roughness = part.roughness;
  MaskedPart out;
  out.code = part.code;
  if (part.specular) out.specular = color_plane({of, "specular"}, *part.specular, r);
  if (!part.record.material.empty()) {
    const RolePlace at{of, "material"};
    const FoundColor found = found_color(at, part.record, r);
    const Material& record = found.found.material;
    LinearRgb f0 = found.result.srgb_linear;
    if (!gives_f0(record.material_class)) {
      const TotalReflectance divided_total = divided(f0);
      out.diffuse = plane_of(srgb_u8(divided_total.diffuse), divided_total.diffuse);
      f0 = divided_total.f0;
    }
    tell_outside(at, record.id, f0, r);
    out.specular = plane_of(srgb_u8(f0), f0);
    if (!part.gloss && !part.roughness) {
      const double standard = default_gloss(record, false).gloss.roughness();
      of.roughness = ConstantSource{{standard, standard, standard}, {}};
    }
  }
  if (part.diffuse) out.diffuse = color_plane({of, "diffuse"}, *part.diffuse, r);
  out.gloss = gloss_plane(of, r);
  const auto [red, green, blue] = out.specular.exact;
  const bool black = !out.diffuse.is_image() && out.diffuse.constant == std::array<std::uint8_t, 3>{};
  out.metal = black && luminance_of(red, green, blue) > least_metal_f0;
  return out;
}

// Both textures by a mask.
void set_mask(const ManifestMaterial& m, const Resolving& r, PackInput& in) {
  const MaterialMask& from = *m.mask;
  auto masked = std::make_shared<MaskedSource>();
  masked->mask.path = from.image.path;
  masked->mask.door = &r.reading.door;
  masked->mask.color = from.colors;
  const std::string& letters = from.image.channels;
  masked->mask.picked = !letters.empty();
  for (std::size_t i = 0; i < letters.size(); ++i) masked->mask.pick[i] = channel_at(letters[i]);
  masked->colors = from.colors;
  masked->alpha = in.grey[0];
  masked->gloss = r.gloss;
  masked->specular_gloss = from.specular_gloss;
  masked->metal_rough = from.metal_rough;
  for (const MaskPart& part : from.parts) {
    masked->parts.push_back(masked_part(m, part, r));
    for (const MaskPart& other : from.parts)
      if (&other < &part && codes_apart(other.code, part.code) < least_codes_apart)
        throw Error::at(part.place + "/at", "too near to another material's",
                        std::to_string(least_codes_apart) + " codes from every other");
    const MaskedPart& made = masked->parts.back();
    if (from.metal_rough && !made.metal && std::abs(made.specular.exact[1] - assumed_f0) > 0.005)
      r.remarks.push_back(m.name + ": F0 " + number(made.specular.exact[1], 3) +
                          " of a material that is no metal; metal-rough means " + number(assumed_f0, 3));
  }
  set_size(m, masked->pictures(), r.reading.door, in);
  in.streamed = false;
  const int width = in.width, height = in.height;
  in.convert = [masked, width, height](std::vector<std::string>&) { return masked->pair(width, height); };
  in.convert_floats = [masked, width, height] { return masked->floats(width, height); };
  in.masked = std::move(masked);
}

PackInput input_of(const ManifestMaterial& m, const Resolving& r) {
  constexpr auto a = static_cast<std::size_t>(Texture::diffuse_alpha);
  constexpr auto b = static_cast<std::size_t>(Texture::specular_gloss);
  PackInput in;
  in.name = m.name;
  in.alpha_mode = m.alpha_mode;
  in.alpha_cutoff = m.alpha_cutoff;
  in.normal.path = m.normal;
  in.normal.door = &r.reading.door;
  in.grey[a] = m.alpha && m.alpha_mode != AlphaMode::opaque ? grey_plane({m, "alpha"}, *m.alpha, nullptr, r)
                                                            : fixed_grey(1);
  if (m.mask) {
    set_mask(m, r, in);
    set_facts(in);
    return in;
  }
  std::optional<PlaneSource> metal;
  if (m.base_color) {
    in.color[a] = color_plane({m, "basecolor"}, *m.base_color, r);
    metal = m.metallic ? grey_plane({m, "metallic"}, *m.metallic, nullptr, r) : fixed_grey(0);
    in.streamed = false;
  } else {
    if (m.diffuse) in.color[a] = color_plane({m, "diffuse"}, *m.diffuse, r);
    in.color[b] = color_plane({m, "specular"}, *m.specular, r);
  }
  in.grey[b] = gloss_plane(m, r);
  set_size(m, metal ? std::vector<const PlaneSource*>{&*metal} : std::vector<const PlaneSource*>{},
           r.reading.door, in);
  if (metal) set_metallic(*metal, in);
  set_facts(in);
  if (in.grey[b].curve) in.facts.source += name(gloss_form(m, r));
  return in;
}

// The texels of a picture by itself, at most `side` on a side. Throws Error for those out of range.
Image floats_of(const RolePlace& at, const ImageSource& source, double most, const PictureReading& reading,
                int side) {
  const AtlasManifest manifest;
  const MaterialLibrary library;
  std::vector<std::string> remarks;
  const Resolving resolving{manifest, library, reading, manifest.gloss, remarks};
  const PlaneSource plane =
      at.role == "emission" ? color_plane(at, source, resolving) : grey_plane(at, source, nullptr, resolving);
  const PictureHeader header = picture_header(source.path, reading.door);
  const PlaneNumbers numbers(plane, header.width, header.height);
  return mean_squares(header.width, header.height, numbers.channels(), side, [&](int) {
    return [&, row = std::vector<float>(static_cast<std::size_t>(header.width * numbers.channels()))](
               int y) mutable {
      numbers.read(y, row.data());
      for (const float each : row)
        if (!(each >= 0 && double{each} <= most))
          throw Error::at(source.path, "holds " + number(double{each}, 6) + " as " + at.role,
                          most == 1 ? "0 to 1" : "at least 0");
      return row.data();
    };
  });
}

}  // namespace

Image emission_floats(const ImageSource& source, const std::string& material, const PictureReading& reading,
                      int most) {
  ManifestMaterial m;
  m.name = m.place = material;
  ImageSource spaced = source;
  if (spaced.space.empty() && picture_header(source.path, reading.door).colour_space == "linear")
    spaced.space = "linear";
  return floats_of({m, "emission"}, spaced, std::numeric_limits<float>::max(), reading, most);
}

Image occlusion_floats(const ImageSource& source, const std::string& material, const PictureReading& reading,
                       int most) {
  ManifestMaterial m;
  m.name = m.place = material;
  return floats_of({m, "occlusion"}, source, 1, reading, most);
}

PackInputs resolve_manifest(const AtlasManifest& manifest, const MaterialLibrary& library,
                            const PictureReading& reading) {
  PackInputs out;
  out.gloss = reading.gloss.value_or(manifest.gloss);
  const Resolving resolving{manifest, library, reading, out.gloss, out.remarks};
  for (const ManifestMaterial& m : manifest.materials) out.materials.push_back(input_of(m, resolving));
  return out;
}

}  // namespace etak
