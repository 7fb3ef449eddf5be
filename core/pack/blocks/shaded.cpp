// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/shaded.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/atlas/texels/page_pixels.h"
#include "core/base/parallel.h"
#include "core/brdf/models.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/image/blocks/budget.h"
#include "core/image/flip.h"
#include "core/light/lights.h"
#include "core/math/functions.h"
#include "core/pack/blocks/block_codec.h"
#include "core/pack/blocks/block_uses.h"

namespace etak {
namespace {

constexpr std::array view_degrees{0.0, 20.0, 40.0, 60.0, 75.0};

using Codes = std::array<std::uint8_t, channel_count>;  // of both textures

// What a texel looks like from one direction after the other.
class Looks {
 public:
  Looks(GlossForm form, bool opaque) : form_(form), opaque_(opaque) {
    for (const Light& light : default_lights().lights) {
      const Vec3 to = scaled(light.direction, -1);
      // The rim light comes from behind; it is turned to the front.
      lights_.push_back({{to[0], to[1], std::abs(to[2])}, scaled(light.color, light.intensity)});
    }
    const Vec3& key = lights_.front().to;
    const double across = math::hypot(key[0], key[1]);
    for (std::size_t v = 0; v < views_.size(); ++v) {
      const double tilt = view_degrees[v] * std::numbers::pi / 180, side = -math::sin(tilt) / across;
      views_[v] = {side * key[0], side * key[1], math::cos(tilt)};
    }
  }

  std::array<Lab, view_degrees.size()> of(const Codes& codes) const {
    std::array<Lab, view_degrees.size()> out;
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = to_lab(from(v, codes));
    return out;
  }

  // What it looks like from one of them.
  LinearRgb from(std::size_t v, const Codes& codes) const {
    std::array<double, 4> specular{};
    for (std::size_t c = 0; c < 3; ++c) specular[c] = srgb_decode(codes[specular_channel + c] / 255.0);
    specular[3] =
        std::clamp(converted_gloss(codes[gloss_channel] / 255.0, form_, GlossForm::schueler), 0.0, 1.0);
    const double opacity = opaque_ ? 1 : codes[alpha_channel] / 255.0;
    const Vec3& view = views_[v];
    Vec3 sum{};
    for (const Lit& light : lights_) {
      std::array<double, 3> lobe{};
      model_.f64({light.to[0], light.to[1], light.to[2], view[0], view[1], view[2]}, specular.data(),
                 lobe.data());
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] +=
            light.irradiance[c] * light.to[2] * (srgb_decode(codes[c] / 255.0) / std::numbers::pi + lobe[c]);
    }
    for (double& each : sum) each = opacity * std::min(1.0, each);
    return {sum[0], sum[1], sum[2]};
  }

 private:
  struct Lit {
    Vec3 to, irradiance;
  };
  GlossForm form_;
  bool opaque_;
  const Model& model_ = *find_model(default_specular);
  std::vector<Lit> lights_;
  std::array<Vec3, view_degrees.size()> views_;
};

// A part of a material under light, as its textures are and as their blocks hold them; black where it reads nothing.
struct ShadedPart {
  Image exact, held;  // linear light, red, green and blue
  std::vector<bool> read;
};

// Some blocks of a page, and the direction from which they are seen.
struct Window {
  std::size_t left, top, width, height, view;
};

// Sums of differences from each direction, by block.
using Sums = std::map<std::size_t, std::array<double, view_degrees.size()>>;

double mean_flip(const ShadedPart& part) {
  if (part.exact == part.held) return 0;
  const std::vector<double> map = flip(flip_view(part.exact), flip_view(part.held)).map;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < map.size(); ++i)
    if (part.read[i]) sum += map[i], ++count;
  return sum / count;
}

// The textures of a page as they are and as their blocks hold them.
class ShadedPage {
 public:
  ShadedPage(const BlockJob& job, const std::array<CompressedTexture, 2>& made) : job_(job) {
    for (const Texture texture : both_textures) {
      Plane& plane = planes_[index_of(texture)];
      const CompressedTexture& its = made[index_of(texture)];
      const PlannedPage& page = job.decision.plan.pages[static_cast<std::size_t>(job.page)];
      if (!page.has[index_of(texture)]) continue;
      plane.view = job.pixels.view(texture, 0);
      plane.holds.resize(job.materials.size());
      for (std::size_t r = 0; r < job.decision.regions.size(); ++r)
        if (job.decision.plan.places[r].page == job.page && job.decision.regions[r].in[index_of(texture)])
          plane.holds[job.decision.regions[r].material] = true;
      if (!its.blocks) continue;
      plane.codec.emplace(*its.blocks->format, job.astc);
      plane.bytes = &its.blocks->levels.front();
      plane.fourth_apart = its.blocks->fourth_apart;
      plane.uses = block_uses(job.decision, job.shown, job.page, texture, 0, its.blocks->format->block_width);
      plane.owned.resize(job.materials.size());
      for (std::size_t b = 0; b < plane.uses.owner.size(); ++b)
        if (const auto& owner = plane.uses.owner[b]) plane.owned[*owner].push_back(b);
    }
    same_uses_ = planes_[0].codec && planes_[1].codec && planes_[0].uses.used == planes_[1].uses.used;
  }

  // Whether the texels that count of a material are the same in both textures, which are in blocks.
  bool are_same(std::size_t material) const {
    return same_uses_ && planes_[0].owned[material] == planes_[1].owned[material];
  }

  // The differences of a material's texels that a texture in blocks holds, without FLIP.
  //   sums   gets those of the differences
  BlockShaded differences(Texture texture, std::size_t material, Sums& sums) const {
    const Plane& plane = planes_[index_of(texture)];
    std::size_t total = 0, at = 0, taken = 0;
    for (const std::size_t b : plane.owned[material])
      each_read(plane, b, [&](std::size_t, std::size_t) { ++total; });
    const Looks looks = looks_of(material);
    LastBlocks last;
    TexelSpread spread(0.01);
    const std::size_t count = std::min(total, most_shaded_texels);
    for (const std::size_t b : plane.owned[material])
      each_read(plane, b, [&](std::size_t x, std::size_t y) {
        if (at++ != taken * total / count) return;
        ++taken;
        const Codes exact = codes(x, y, material, nullptr), held = codes(x, y, material, &last);
        if (exact == held) {
          for (std::size_t v = 0; v < view_degrees.size(); ++v) spread.add(0);
          return;
        }
        const auto from = looks.of(exact), to = looks.of(held);
        for (std::size_t v = 0; v < from.size(); ++v) {
          const double difference = delta_e2000(from[v], to[v]);
          spread.add(difference);
          sums[b][v] += difference;
        }
      });
    return {spread.percentile_99(), spread.largest(), 0};
  }

  // Where a material's blocks changed most, from the direction in which they did.
  //   texels   a side, at most
  Window window(Texture texture, std::size_t material, const Sums& of, std::size_t texels) const {
    const Plane& plane = planes_[index_of(texture)];
    const std::vector<std::size_t>& owned = plane.owned[material];
    const auto across = static_cast<std::size_t>(plane.uses.across);
    Window all{across, owned.front() / across, 0, owned.back() / across - owned.front() / across + 1, 0};
    for (const std::size_t b : owned) all.left = std::min(all.left, b % across);
    for (const std::size_t b : owned) all.width = std::max(all.width, b % across + 1 - all.left);
    std::array<double, view_degrees.size()> total{};
    for (const auto& [b, differences] : of)
      for (std::size_t v = 0; v < total.size(); ++v) total[v] += differences[v];
    const std::size_t side = texels / plane.side(),
                      view = static_cast<std::size_t>(std::ranges::max_element(total) - total.begin());
    Window best{all.left, all.top, std::min(side, all.width), std::min(side, all.height), view};
    // Sums of what is above and to the left.
    const std::size_t row = all.width + 1;
    std::vector<double> sums(row * (all.height + 1));
    for (const auto& [b, differences] : of)
      sums[(b / across - all.top + 1) * row + b % across - all.left + 1] = differences[view];
    for (std::size_t i = row + 1; i < sums.size(); ++i)
      if (i % row != 0) sums[i] += sums[i - 1] + sums[i - row] - sums[i - row - 1];
    double most = 0;
    for (std::size_t y = 0; y + best.height <= all.height; ++y)
      for (std::size_t x = 0; x + best.width <= all.width; ++x) {
        const double* above = &sums[y * row + x];
        const double* below = above + best.height * row;
        const double sum = below[best.width] - below[0] - above[best.width] + above[0];
        if (sum <= most) continue;
        most = sum;
        best.left = all.left + x;
        best.top = all.top + y;
      }
    return best;
  }

  // A part of a material.
  ShadedPart part(Texture texture, std::size_t material, const Window& window) const {
    const Plane& plane = planes_[index_of(texture)];
    const auto across = static_cast<std::size_t>(plane.uses.across), side = plane.side();
    const std::size_t width = window.width * side, view = window.view;
    ShadedPart out;
    out.exact = out.held = Image(static_cast<int>(width), static_cast<int>(window.height * side), 3);
    out.read.resize(out.exact.pixel_count());
    const Looks looks = looks_of(material);
    LastBlocks last;
    for (const std::size_t b : plane.owned[material]) {
      // What lies left of the window or above it gives differences beyond its sides, since they are unsigned.
      if (b % across - window.left >= window.width || b / across - window.top >= window.height) continue;
      each_read(plane, b, [&](std::size_t x, std::size_t y) {
        const Codes exact = codes(x, y, material, nullptr), held = codes(x, y, material, &last);
        const std::size_t i = (y - window.top * side) * width + x - window.left * side;
        out.read[i] = true;
        const auto put = [&](const LinearRgb& light, Image& to) {
          to.values[3 * i] = static_cast<float>(light.r);
          to.values[3 * i + 1] = static_cast<float>(light.g);
          to.values[3 * i + 2] = static_cast<float>(light.b);
        };
        const LinearRgb light = looks.from(view, exact);
        put(light, out.exact);
        put(exact == held ? light : looks.from(view, held), out.held);
      });
    }
    return out;
  }

 private:
  using Texel = std::array<std::uint8_t, 4>;
  struct Plane {
    std::optional<ConstPixelsView8> view;  // none: the page has no such texture
    std::optional<BlockCodec> codec;       // none: it is not in blocks
    const std::string* bytes = nullptr;
    bool fourth_apart = false;
    BlockUses uses;
    std::vector<bool> holds;                      // by material
    std::vector<std::vector<std::size_t>> owned;  // blocks by material
    std::size_t side() const { return static_cast<std::size_t>(codec->format().block_width); }
  };
  // The block that was decoded last, of each texture; neighbours are mostly of one.
  struct LastBlock {
    std::size_t number = std::size_t(-1);
    std::vector<Texel> texels;
  };
  using LastBlocks = std::array<LastBlock, 2>;

  Looks looks_of(std::size_t material) const {
    return {job_.gloss, job_.materials[material].alpha_mode == AlphaMode::opaque};
  }

  // The texels of a block that count.
  template <class See>
  static void each_read(const Plane& plane, std::size_t block, const See& see) {
    const std::size_t side = plane.side(), width = static_cast<std::size_t>(plane.view->width),
                      across = static_cast<std::size_t>(plane.uses.across);
    const std::size_t left = block % across * side, top = block / across * side;
    for (std::size_t y = top; y < std::min(top + side, plane.uses.used.size() / width); ++y)
      for (std::size_t x = left; x < std::min(left + side, width); ++x)
        if (plane.uses.used[y * width + x] != 0) see(x, y);
  }

  //   last   null: as the textures are, else as their blocks hold them
  Codes codes(std::size_t x, std::size_t y, std::size_t material, LastBlocks* last) const {
    Codes out = elsewhere;
    const MaterialFate& fate = job_.decision.left_out.fates[material];
    for (const Texture texture : both_textures) {
      const std::size_t first = texture == Texture::diffuse_alpha ? 0 : specular_channel;
      const Plane& plane = planes_[index_of(texture)];
      if (plane.view && plane.holds[material]) {
        Texel texel{};
        std::copy_n(plane.view->at(static_cast<int>(x), static_cast<int>(y)), 4, texel.data());
        const std::uint8_t fourth = texel[3];
        if (last != nullptr && plane.codec) texel = decoded(plane, x, y, (*last)[index_of(texture)]);
        if (plane.fourth_apart) texel[3] = fourth;
        std::ranges::copy(texel, out.begin() + static_cast<std::ptrdiff_t>(first));
      }
    }
    for (std::size_t c = 0; c < out.size(); ++c) out[c] = fate.constant[c].value_or(out[c]);
    return out;
  }

  static Texel decoded(const Plane& plane, std::size_t x, std::size_t y, LastBlock& last) {
    const std::size_t side = plane.side();
    const std::size_t block = y / side * static_cast<std::size_t>(plane.uses.across) + x / side;
    if (last.number != block) {
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of a file
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(plane.bytes->data());
      last = {block, plane.codec->decode(bytes + plane.codec->format().block_bytes * block, 1)};
    }
    return last.texels[y % side * side + x % side];
  }

  const BlockJob& job_;
  std::array<Plane, 2> planes_;
  bool same_uses_ = false;
};

// A material that was told, and what its picture is of.
struct ToldMaterial {
  BlockShaded shaded;
  Texture texture;
  Window window;
};

BlockPicture picture_of(const ShadedPart& part) {
  BlockPicture out;
  out.exact = out.held = out.difference = Image8(part.exact.width, part.exact.height, 3);
  const auto light = [](const Image& of, std::size_t i) {
    return LinearRgb{of.values[3 * i], of.values[3 * i + 1], of.values[3 * i + 2]};
  };
  const auto put = [](const Srgb8& code, Image8& to, std::size_t i) {
    to.values[3 * i] = code.r, to.values[3 * i + 1] = code.g, to.values[3 * i + 2] = code.b;
  };
  for (std::size_t i = 0; i < part.read.size(); ++i) {
    const LinearRgb exact = light(part.exact, i), held = light(part.held, i);
    put(srgb_u8(exact), out.exact, i);
    put(srgb_u8(held), out.held, i);
    const std::uint8_t grey = plain_u8(delta_e2000(to_lab(exact), to_lab(held)) / white_difference);
    put({grey, grey, grey}, out.difference, i);
  }
  return out;
}

}  // namespace

void tell_shaded(const BlockJob& job, std::array<CompressedTexture, 2>& made, std::size_t most,
                 std::vector<BlockPicture>& pictures) {
  const ShadedPage page(job, made);
  std::vector<std::optional<ToldMaterial>> told(job.materials.size());
  for (const Texture texture : both_textures) {
    if (!made[index_of(texture)].blocks) continue;
    std::vector<BlockMaterial>& materials = made[index_of(texture)].report.front().materials;
    parallel_chunks(materials.size(), job.threads, 1, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t m = begin; m < end; ++m) {
        const std::size_t material = materials[m].number;
        std::optional<ToldMaterial>& its = told[material];
        if (!its || !page.are_same(material)) {
          Sums sums;
          BlockShaded shaded = page.differences(texture, material, sums);
          const auto window = [&](std::size_t side) { return page.window(texture, material, sums, side); };
          shaded.flip = mean_flip(page.part(texture, material, window(most_shaded_side)));
          its = {shaded, texture, most == 0 ? Window{} : window(2 * most_shaded_side)};
        }
        materials[m].shaded = its->shaded;
      }
    });
  }
  for (std::size_t m = 0; m < told.size() && most > 0; ++m) {
    if (!told[m]) continue;
    const BlockShaded& shaded = told[m]->shaded;
    const Window& window = told[m]->window;
    const Texture texture = told[m]->texture;
    const auto at = std::ranges::find_if(
        pictures, [&](const BlockPicture& each) { return each.shaded.p99 < shaded.p99; });
    if (at == pictures.end() && pictures.size() >= most) continue;
    BlockPicture picture = picture_of(page.part(texture, m, window));
    picture.page = job.page;
    picture.material = job.materials[m].name;
    picture.shaded = shaded;
    const auto side = static_cast<std::size_t>(made[index_of(texture)].blocks->format->block_width);
    picture.x = static_cast<int>(window.left * side);
    picture.y = static_cast<int>(window.top * side);
    picture.degrees = view_degrees[window.view];
    pictures.insert(at, std::move(picture));
    if (pictures.size() > most) pictures.pop_back();
  }
}

}  // namespace etak
