// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/shaded.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/atlas/texels/page_pixels.h"
#include "core/base/parallel.h"
#include "core/brdf/models.h"
#include "core/color/delta_e.h"
#include "core/color/srgb.h"
#include "core/light/lights.h"
#include "core/math/functions.h"
#include "core/pack/blocks/block_codec.h"
#include "core/pack/blocks/block_uses.h"
#include "core/pack/blocks/budget.h"

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
    std::array<double, 4> specular{};
    for (std::size_t c = 0; c < 3; ++c) specular[c] = srgb_decode(codes[specular_channel + c] / 255.0);
    specular[3] =
        std::clamp(converted_gloss(codes[gloss_channel] / 255.0, form_, GlossForm::schueler), 0.0, 1.0);
    const double opacity = opaque_ ? 1 : codes[alpha_channel] / 255.0;
    std::array<Lab, view_degrees.size()> out;
    for (std::size_t v = 0; v < views_.size(); ++v) {
      const Vec3& view = views_[v];
      Vec3 sum{};
      for (const Lit& light : lights_) {
        std::array<double, 3> lobe{};
        model_.f64({light.to[0], light.to[1], light.to[2], view[0], view[1], view[2]}, specular.data(),
                   lobe.data());
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += light.irradiance[c] * light.to[2] *
                    (srgb_decode(codes[c] / 255.0) / std::numbers::pi + lobe[c]);
      }
      for (double& each : sum) each = opacity * std::min(1.0, each);
      out[v] = to_lab(LinearRgb{sum[0], sum[1], sum[2]});
    }
    return out;
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
      plane.uses = block_uses(job.decision, job.shown, job.page, texture, 0, its.blocks->format->block_width);
    }
  }

  // The differences of a material's texels that a texture in blocks holds.
  BlockShaded differences(Texture texture, std::size_t material) const {
    const Plane& plane = planes_[index_of(texture)];
    const BlockUses& uses = plane.uses;
    const auto width = static_cast<std::size_t>(plane.view->width);
    const auto side = static_cast<std::size_t>(plane.codec->format().block_width);
    const auto each_read = [&](const auto& see) {
      for (std::size_t b = 0; b < uses.owner.size(); ++b) {
        if (uses.owner[b] != material) continue;
        const std::size_t left = b % static_cast<std::size_t>(uses.across) * side,
                          top = b / static_cast<std::size_t>(uses.across) * side;
        for (std::size_t y = top; y < std::min(top + side, uses.used.size() / width); ++y)
          for (std::size_t x = left; x < std::min(left + side, width); ++x)
            if (uses.used[y * width + x] != 0) see(x, y);
      }
    };
    std::size_t total = 0, at = 0, taken = 0;
    each_read([&](std::size_t, std::size_t) { ++total; });
    const PackInput& input = job_.materials[material];
    const Looks looks(job_.gloss, input.alpha_mode == AlphaMode::opaque);
    Spread spread(0.01);
    const std::size_t count = std::min(total, most_shaded_texels);
    each_read([&](std::size_t x, std::size_t y) {
      if (at++ != taken * total / count) return;
      ++taken;
      const Codes exact = codes(x, y, material, false), held = codes(x, y, material, true);
      if (exact == held) {
        for (std::size_t v = 0; v < view_degrees.size(); ++v) spread.add(0);
        return;
      }
      const auto from = looks.of(exact), to = looks.of(held);
      for (std::size_t v = 0; v < from.size(); ++v) spread.add(delta_e2000(from[v], to[v]));
    });
    return {spread.percentile_99(), spread.largest()};
  }

 private:
  struct Plane {
    std::optional<ConstPixelsView8> view;  // none: the page has no such texture
    std::optional<BlockCodec> codec;       // none: it is not in blocks
    const std::string* bytes = nullptr;
    BlockUses uses;
    std::vector<bool> holds;  // by material
  };

  Codes codes(std::size_t x, std::size_t y, std::size_t material, bool held) const {
    Codes out = elsewhere;
    const MaterialFate& fate = job_.decision.left_out.fates[material];
    for (const Texture texture : both_textures) {
      const std::size_t first = texture == Texture::diffuse_alpha ? 0 : specular_channel;
      const Plane& plane = planes_[index_of(texture)];
      if (plane.view && plane.holds[material]) {
        std::array<std::uint8_t, 4> texel{};
        std::copy_n(plane.view->at(static_cast<int>(x), static_cast<int>(y)), 4, texel.data());
        if (held && plane.codec) texel = decoded(plane, x, y);
        std::ranges::copy(texel, out.begin() + static_cast<std::ptrdiff_t>(first));
      }
    }
    for (std::size_t c = 0; c < out.size(); ++c) out[c] = fate.constant[c].value_or(out[c]);
    return out;
  }

  static std::array<std::uint8_t, 4> decoded(const Plane& plane, std::size_t x, std::size_t y) {
    const BlockFormat& format = plane.codec->format();
    const auto side = static_cast<std::size_t>(format.block_width);
    const std::size_t block = y / side * static_cast<std::size_t>(plane.uses.across) + x / side;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of a file
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(plane.bytes->data());
    return plane.codec->decode(bytes + format.block_bytes * block, 1)[y % side * side + x % side];
  }

  const BlockJob& job_;
  std::array<Plane, 2> planes_;
};

}  // namespace

void tell_shaded(const BlockJob& job, std::array<CompressedTexture, 2>& made) {
  const ShadedPage page(job, made);
  for (const Texture texture : both_textures) {
    if (!made[index_of(texture)].blocks) continue;
    std::vector<BlockMaterial>& materials = made[index_of(texture)].report.front().materials;
    parallel_chunks(materials.size(), job.threads, 1, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t m = begin; m < end; ++m)
        materials[m].shaded = page.differences(texture, materials[m].number);
    });
  }
}

}  // namespace etak
