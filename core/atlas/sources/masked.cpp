// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/sources/masked.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "core/atlas/sources/floats.h"
#include "core/atlas/sources/sources.h"
#include "core/atlas/texels/page_memory.h"
#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/color/srgb.h"
#include "core/image/files/png.h"
#include "core/scene/material_texels.h"

namespace etak {
namespace {

constexpr std::uint8_t undecided = 255;
constexpr int edge_reach = 3;         // texels over which filters of masks spread
constexpr int most_exact = 8;         // codes from a material's, within which a texel is of it
constexpr int most_beside_line = 48;  // codes from the line between two materials that a mixture may have

int difference(const std::uint8_t* texel, const MaskCode& code) {
  return codes_apart({texel[0], texel[1], texel[2]}, code);
}

/// A texel as a mixture of two materials.
///   aside   codes between it and the line from one to the other
///   span    codes between the two
struct Mixture {
  double aside = 0, span = 0;
  std::uint8_t nearer = 0;
  friend bool operator<(const Mixture& a, const Mixture& b) {
    return std::pair(a.aside, a.span) < std::pair(b.aside, b.span);
  }
};

class MaskReader {
 public:
  MaskReader(const Image8& mask, std::span<const MaskCode> codes, bool colors, const std::string& path)
      : mask_(mask), codes_(codes), colors_(colors), path_(path), exact_(exact_reach()) {}

  std::vector<std::uint8_t> parts() const {
    const std::size_t count = mask_.pixel_count();
    std::vector<std::uint8_t> first(count, undecided);
    for (std::size_t i = 0; i < count; ++i) first[i] = exact_part(texel(i));
    const std::vector<std::uint8_t> solid = two_greys() ? first : solid_parts(first);
    std::vector<std::uint8_t> out = solid;
    for (int y = 0, i = 0; y < mask_.height; ++y)
      for (int x = 0; x < mask_.width; ++x, ++i) {
        std::uint8_t& part = out[static_cast<std::size_t>(i)];
        if (part == undecided) part = edge_part(x, y, first[static_cast<std::size_t>(i)], solid);
      }
    return out;
  }

 private:
  bool two_greys() const { return codes_.size() == 2 && !colors_; }

  // Those texels whose material fills a square of 2 x 2 with them. On an edge from black to white one column can have the
  // very grey of a third material.
  std::vector<std::uint8_t> solid_parts(const std::vector<std::uint8_t>& first) const {
    std::vector<std::uint8_t> out(first.size(), undecided);
    for (int y = 0; y + 1 < mask_.height; ++y)
      for (int x = 0; x + 1 < mask_.width; ++x) {
        const std::array square{index(x, y), index(x + 1, y), index(x, y + 1), index(x + 1, y + 1)};
        const std::uint8_t part = first[square[0]];
        if (part == undecided ||
            !std::ranges::all_of(square, [&](std::size_t i) { return first[i] == part; }))
          continue;
        for (const std::size_t i : square) out[i] = part;
      }
    return out;
  }

  const std::uint8_t* texel(std::size_t i) const { return mask_.values.data() + 3 * i; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(mask_.width) + static_cast<std::size_t>(x);
  }

  int exact_reach() const {
    int least = 255;
    for (std::size_t a = 0; a < codes_.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) least = std::min(least, codes_apart(codes_[a], codes_[b]));
    return std::min(most_exact, (least - 1) / 2);
  }

  std::uint8_t exact_part(const std::uint8_t* texel) const {
    for (std::size_t k = 0; k < codes_.size(); ++k)
      if (difference(texel, codes_[k]) <= exact_) return static_cast<std::uint8_t>(k);
    return undecided;
  }

  Mixture mixture(const std::uint8_t* texel, std::uint8_t a, std::uint8_t b) const {
    double dot = 0, square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double step = codes_[b][c] - codes_[a][c];
      dot += step * (texel[c] - codes_[a][c]);
      square += step * step;
    }
    const double share = std::clamp(dot / square, 0.0, 1.0);
    Mixture out{0, std::sqrt(square), share > 0.5 ? b : a};
    for (std::size_t c = 0; c < 3; ++c)
      out.aside =
          std::max(out.aside, std::abs(texel[c] - codes_[a][c] - share * (codes_[b][c] - codes_[a][c])));
    return out;
  }

  //   exact   the material whose code the texel has, though none around it has; undecided: none
  //   solid   of the texels around
  std::uint8_t edge_part(int x, int y, std::uint8_t exact, const std::vector<std::uint8_t>& solid) const {
    const std::uint8_t* at = texel(index(x, y));
    if (two_greys()) return mixture(at, 0, 1).nearer;
    if (exact == undecided && is_flat(x, y)) refuse(x, y);
    std::vector<std::uint8_t> near;
    for (int v = std::max(0, y - edge_reach); v <= std::min(mask_.height - 1, y + edge_reach); ++v)
      for (int u = std::max(0, x - edge_reach); u <= std::min(mask_.width - 1, x + edge_reach); ++u)
        if (const std::uint8_t part = solid[index(u, v)];
            part != undecided && std::ranges::find(near, part) == near.end())
          near.push_back(part);
    const bool alone = near.size() == 1;
    if (exact != undecided && (near.empty() || alone)) return exact;
    if (near.empty()) refuse(x, y);
    std::ranges::sort(near);
    // Of a feature too thin to be seen by itself only the material beside it is known.
    std::optional<Mixture> best;
    for (std::uint8_t b = 0; b < codes_.size(); ++b)
      for (const std::uint8_t a : near) {
        if (a == b || (!alone && (b < a || std::ranges::find(near, b) == near.end()))) continue;
        const Mixture each = mixture(at, a, b);
        if (!best || each < *best) best = each;
      }
    if (exact != undecided && best->aside > exact_) return exact;
    // Where three meet, the colour lies between all of them.
    if (best->aside > most_beside_line && near.size() < 3) refuse(x, y);
    return alone ? near.front() : best->nearer;
  }

  // Whether all texels around have the same colour, as they do on no edge.
  bool is_flat(int x, int y) const {
    if (x == 0 || y == 0 || x + 1 == mask_.width || y + 1 == mask_.height) return false;
    const std::uint8_t* at = texel(index(x, y));
    const MaskCode code{at[0], at[1], at[2]};
    for (int v = y - 1; v <= y + 1; ++v)
      for (int u = x - 1; u <= x + 1; ++u)
        if (difference(texel(index(u, v)), code) > 1) return false;
    return true;
  }

  std::string text_of(const MaskCode& code) const {
    return colors_ ? hex({code[0], code[1], code[2]}) : std::to_string(code[0]);
  }

  [[noreturn]] void refuse(int x, int y) const {
    const std::uint8_t* at = texel(index(x, y));
    std::string all;
    for (const MaskCode& code : codes_) all += (all.empty() ? "" : ", ") + text_of(code);
    throw Error::at(path_,
                    "texel " + std::to_string(x) + ", " + std::to_string(y) + " is " +
                        text_of({at[0], at[1], at[2]}) + ", which no material has and no edge explains",
                    all);
  }

  const Image8& mask_;
  std::span<const MaskCode> codes_;
  bool colors_;
  const std::string& path_;
  int exact_;
};

// The codes of a plane, or the one that all of its texels have.
struct PlaneCodes {
  PlaneCodes(const PlaneSource& source, int width, int height)
      : channels(source.color ? 3 : 1), constant(source.constant) {
    if (!source.is_image()) return;
    FileBytes memory;
    PlaneRows rows(source, memory);
    check_size(source, rows.width(), rows.height(), width, height);
    image = Image8(width, height, static_cast<int>(channels));
    const std::array<int, 3> pick = rows.pick();
    for (int y = 0; y < height; ++y) {
      const std::uint8_t* row = rows.read(1);
      for (int x = 0; x < width; ++x)
        for (std::size_t c = 0; c < channels; ++c) image.at(x, y)[c] = row[x * rows.step() + pick[c]];
    }
  }
  const std::uint8_t* at(std::size_t texel) const {
    return image.values.empty() ? constant.data() : image.values.data() + channels * texel;
  }
  std::size_t channels;
  std::array<std::uint8_t, 3> constant;
  Image8 image;
};

std::vector<std::uint8_t> parts_of(const MaskedSource& source, int width, int height) {
  PlaneCodes mask(source.mask, width, height);
  if (mask.channels == 1) {
    Image8 wide(width, height, 3);
    for (std::size_t i = 0; i < wide.pixel_count(); ++i)
      std::fill_n(wide.values.data() + 3 * i, 3, mask.image.values[i]);
    mask.image = std::move(wide);
  }
  std::vector<MaskCode> codes;
  for (const MaskedPart& part : source.parts) codes.push_back(part.code);
  return parts_of_mask(mask.image, codes, source.colors, source.mask.path);
}

// The texels of both textures.
//   of   the material of each texel
MaterialPair pair_of(const MaskedSource& source, const std::vector<std::uint8_t>& of, int width, int height) {
  const std::vector<MaskedPart>& parts = source.parts;
  MaterialPair out{Image8(width, height, 4), Image8(width, height, 4)};
  const PlaneCodes opacity(source.alpha, width, height);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const PlaneCodes diffuse(parts[k].diffuse, width, height), gloss_codes(parts[k].gloss, width, height);
    for (std::size_t i = 0; i < of.size(); ++i) {
      if (of[i] != k) continue;
      std::uint8_t* a = out.diffuse_alpha.values.data() + 4 * i;
      std::uint8_t* b = out.specular_gloss.values.data() + 4 * i;
      std::copy_n(diffuse.at(i), 3, a);
      a[3] = *opacity.at(i);
      std::copy_n(parts[k].specular.constant.data(), 3, b);
      b[3] = *gloss_codes.at(i);
    }
  }
  return out;
}

}  // namespace

int codes_apart(const MaskCode& a, const MaskCode& b) {
  int out = 0;
  for (std::size_t c = 0; c < 3; ++c) out = std::max(out, std::abs(int{a[c]} - int{b[c]}));
  return out;
}

std::vector<std::uint8_t> parts_of_mask(const Image8& mask, std::span<const MaskCode> codes, bool colors,
                                        const std::string& path) {
  return MaskReader(mask, codes, colors, path).parts();
}

std::vector<const PlaneSource*> MaskedSource::pictures() const {
  std::vector<const PlaneSource*> out{&mask};
  for (const MaskedPart& part : parts)
    for (const PlaneSource* plane : {&part.diffuse, &part.gloss})
      if (plane->is_image()) out.push_back(plane);
  if (alpha.is_image()) out.push_back(&alpha);
  return out;
}

MaterialPair MaskedSource::pair(int width, int height) const {
  return pair_of(*this, parts_of(*this, width, height), width, height);
}

FloatPair MaskedSource::floats(int width, int height) const {
  const std::vector<std::uint8_t> of = parts_of(*this, width, height);
  FloatPair out{Image(width, height, 4), Image(width, height, 4)};
  const Image opacity = plane_floats(alpha, width, height);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Image diffuse = plane_floats(parts[k].diffuse, width, height);
    const Image gloss_values = plane_floats(parts[k].gloss, width, height);
    for (std::size_t i = 0; i < of.size(); ++i) {
      if (of[i] != k) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        out.diffuse_alpha.values[4 * i + c] = diffuse.values[3 * i + c];
        out.specular_gloss.values[4 * i + c] = static_cast<float>(parts[k].specular.exact[c]);
      }
      out.diffuse_alpha.values[4 * i + 3] = opacity.values[i];
      out.specular_gloss.values[4 * i + 3] = gloss_values.values[i];
    }
  }
  return out;
}

std::vector<std::pair<std::string, std::string>> mask_files(const PackInput& material) {
  std::vector<std::pair<std::string, std::string>> out;
  if (!material.masked || !(material.masked->specular_gloss || material.masked->metal_rough)) return out;
  const MaskedSource& source = *material.masked;
  const int width = material.width, height = material.height;
  const std::vector<std::uint8_t> of = parts_of(source, width, height);
  const MaterialPair pair = pair_of(source, of, width, height);
  std::string stem = identifier(material.name, '_');
  if (stem.empty()) stem = "material";
  const auto add = [&](std::size_t ending, int channels, bool srgb, const auto& put) {
    Image8 image(width, height, channels);
    for (std::size_t i = 0; i < of.size(); ++i)
      put(i, image.values.data() + static_cast<std::size_t>(channels) * i);
    PngOptions options;
    options.srgb = srgb;
    out.emplace_back(stem + std::string(mask_file_endings[ending]), png_bytes(image, options));
  };
  const auto* a = pair.diffuse_alpha.values.data();
  const auto* b = pair.specular_gloss.values.data();
  using Codes = std::uint8_t*;
  if (source.specular_gloss) {
    add(0, 3, true, [&](std::size_t i, Codes to) { std::copy_n(a + 4 * i, 3, to); });
    add(1, 3, true, [&](std::size_t i, Codes to) { std::copy_n(b + 4 * i, 3, to); });
    add(2, 1, false, [&](std::size_t i, Codes to) { *to = b[4 * i + 3]; });
  }
  if (source.metal_rough) {
    const auto metal = [&](std::size_t i) { return source.parts[of[i]].metal; };
    const auto roughness = roughness_codes(source.gloss);
    add(3, 3, true, [&](std::size_t i, Codes to) { std::copy_n((metal(i) ? b : a) + 4 * i, 3, to); });
    add(4, 1, false, [&](std::size_t i, Codes to) { *to = metal(i) ? 255 : 0; });
    add(5, 1, false, [&](std::size_t i, Codes to) { *to = roughness[b[4 * i + 3]]; });
  }
  return out;
}

}  // namespace etak
