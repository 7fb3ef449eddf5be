// SPDX-License-Identifier: Apache-2.0
#include "core/image/astc_codec.h"

#include <astcenc.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr astcenc_swizzle as_they_are{ASTCENC_SWZ_R, ASTCENC_SWZ_G, ASTCENC_SWZ_B, ASTCENC_SWZ_A};

// What a context of astcenc is made for.
//   weights   of the channels, as powers of 2
struct Kind {
  AstcEncoding how;
  bool decodes = false;
  std::array<int, 4> weights{};
  auto key() const { return std::tuple(how.format, how.srgb, how.effort, decodes, weights); }
  friend bool operator<(const Kind& a, const Kind& b) { return a.key() < b.key(); }
};

using Context = std::unique_ptr<astcenc_context, decltype(&astcenc_context_free)>;

void check_done(astcenc_error error) {
  if (error == ASTCENC_ERR_OUT_OF_MEM) throw std::bad_alloc();
  if (error != ASTCENC_SUCCESS) throw Error::at("ASTC", astcenc_get_error_string(error), "astcenc to work");
}

Context new_context(const Kind& kind) {
  const std::array presets{ASTCENC_PRE_FAST, ASTCENC_PRE_MEDIUM, ASTCENC_PRE_THOROUGH,
                           ASTCENC_PRE_VERYTHOROUGH};
  astcenc_config config{};
  astcenc_context* context = nullptr;
  const auto effort = static_cast<std::size_t>(std::clamp(kind.how.effort, 1, most_block_effort) - 1);
  check_done(astcenc_config_init(kind.how.srgb ? ASTCENC_PRF_LDR_SRGB : ASTCENC_PRF_LDR,
                                 static_cast<unsigned>(kind.how.format->block_width),
                                 static_cast<unsigned>(kind.how.format->block_height), 1, presets[effort],
                                 kind.decodes ? ASTCENC_FLG_DECOMPRESS_ONLY : 0, &config));
  const std::array to{&config.cw_r_weight, &config.cw_g_weight, &config.cw_b_weight, &config.cw_a_weight};
  for (std::size_t c = 0; c < to.size(); ++c) *to[c] = math::exp2(static_cast<float>(kind.weights[c]));
  check_done(astcenc_context_alloc(&config, 1, &context));
  return {context, &astcenc_context_free};
}

// Contexts that no thread uses at the moment: to make one takes as long as to compress some thousand texels.
class Contexts {
 public:
  // Calls work() with a context of the kind, which is then kept for others.
  template <class Work>
  void with(const Kind& kind, const Work& work) {
    Context context = taken(kind);
    if (!context) context = new_context(kind);
    work(context.get());
    const std::lock_guard lock(mutex_);
    if (free_.size() >= most) free_.erase(free_.begin());
    free_.emplace(kind, std::move(context));
  }

 private:
  static constexpr std::size_t most = 48;  // of about a megabyte each

  Context taken(const Kind& kind) {
    const std::lock_guard lock(mutex_);
    const auto found = free_.find(kind);
    if (found == free_.end()) return {nullptr, &astcenc_context_free};
    Context out = std::move(found->second);
    free_.erase(found);
    return out;
  }

  std::mutex mutex_;
  std::multimap<Kind, Context> free_;
};

Contexts& contexts() {
  static Contexts all;
  return all;
}

// The weights of a block as powers of 2, the greatest of which is 1: blocks of equal ones are compressed together.
std::array<int, 4> classed(const ChannelWeights& weights) {
  constexpr int least = -10;  // astcenc takes no channel for less than a thousandth of another
  const float most = std::max(1e-30f, *std::ranges::max_element(weights));
  std::array<int, 4> out{};
  std::ranges::transform(weights, out.begin(), [&](float weight) {
    return std::max(least, static_cast<int>(std::lround(math::log2(std::max(1e-30f, weight / most)))));
  });
  return out;
}

// Compresses blocks of equal weights as a picture that is one block high.
void encode_strip(std::span<const AnyBlock> blocks, const std::vector<std::size_t>& which, const Kind& kind,
                  std::uint8_t* bytes) {
  const auto width = static_cast<std::size_t>(kind.how.format->block_width),
             height = static_cast<std::size_t>(kind.how.format->block_height);
  const std::size_t across = width * which.size(), size = kind.how.format->block_bytes;
  std::vector<std::uint8_t> texels(4 * across * height), out(size * which.size());
  for (std::size_t b = 0; b < which.size(); ++b)
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t x = 0; x < width; ++x)
        std::ranges::copy(blocks[which[b]].texels[width * y + x],
                          texels.begin() + static_cast<std::ptrdiff_t>(4 * (across * y + width * b + x)));
  void* slice = texels.data();
  astcenc_image image{static_cast<unsigned>(across), static_cast<unsigned>(height), 1, ASTCENC_TYPE_U8,
                      &slice};
  contexts().with(kind, [&](astcenc_context* context) {
    check_done(astcenc_compress_image(context, &image, &as_they_are, out.data(), out.size(), 0));
    check_done(astcenc_compress_reset(context));
  });
  for (std::size_t b = 0; b < which.size(); ++b)
    std::copy_n(out.data() + size * b, size, bytes + size * which[b]);
}

void encode(std::span<const AnyBlock> blocks, const AstcEncoding& how, std::uint8_t* bytes) {
  std::map<std::array<int, 4>, std::vector<std::size_t>> classes;
  for (std::size_t b = 0; b < blocks.size(); ++b) classes[classed(blocks[b].weights)].push_back(b);
  for (const auto& [weights, which] : classes) encode_strip(blocks, which, {how, false, weights}, bytes);
}

Image8 decode(std::string_view bytes, const AstcEncoding& how, int width, int height,
              const std::string& place) {
  Image8 out(width, height, 4);
  void* slice = out.values.data();
  astcenc_image image{static_cast<unsigned>(width), static_cast<unsigned>(height), 1, ASTCENC_TYPE_U8,
                      &slice};
  contexts().with({{how.format, how.srgb, 1}, true, {}}, [&](astcenc_context* context) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of a file
    const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    const astcenc_error error =
        astcenc_decompress_image(context, data, bytes.size(), &image, &as_they_are, 0);
    if (error != ASTCENC_SUCCESS)
      throw Error::at(place, std::string("ASTC: ") + astcenc_get_error_string(error), "whole blocks");
    check_done(astcenc_decompress_reset(context));
  });
  return out;
}

}  // namespace

AstcDoor astc_door() {
  return {encode, decode};
}

}  // namespace etak
