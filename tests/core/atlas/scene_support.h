// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/color/srgb.h"
#include "core/image/image_io.h"
#include "core/image/load.h"
#include "core/pack/pack.h"
#include "core/scene/gltf.h"
#include "tests/core/material/library_support.h"
#include "tests/support.h"

// Real scenes, and what a sampler finds in their textures.
namespace etak::test {

inline std::optional<std::string> asset(const std::string& name) {
  const auto shared = shared_folder();
  if (!shared) {
    WARN("no shared folder: scenes not packed");
    return std::nullopt;
  }
  return *shared + "/data/assets/" + name;
}

inline const std::vector<std::string> real_models{"flight_helmet/FlightHelmet.gltf",
                                                  "tennis_racquet/TennisRacquet.gltf",
                                                  "wicker_chair/WickerChair.gltf", "mixer/Mixer.gltf"};

inline Image8 picture_of(const PictureFile& image) {
  const std::string bytes = image.path.empty() ? image.bytes : slurp(image.path);
  return std::get<Image8>(load_picture(bytes, image.label, picture_door()).pixels);
}

// The pictures of a scene, read when first asked for.
class ReadPictures {
 public:
  explicit ReadPictures(const GltfScene& scene) : scene_(scene) {}
  const Image8& operator()(int image) {
    const auto found = pictures_.find(image);
    if (found != pictures_.end()) return found->second;
    return pictures_[image] = picture_of(scene_.images[static_cast<std::size_t>(image)]);
  }

 private:
  const GltfScene& scene_;
  std::map<int, Image8> pictures_;
};

inline double wrapped(double at, int size, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(at, 0.0, size - 1.0);
  const double period = wrap == Wrap::mirrored ? 2.0 * size : size;
  const double in = at - std::floor(at / period) * period;
  return in < size ? in : period - 1 - in;
}

// How colours are filtered: as codes, which is enough to see a texel out of its place, or as GPUs do.
enum class Filter { codes, light };

// Bilinear; codes come back, of a colour's mean light too.
inline std::array<double, 4> lookup(const Image8& image, const GltfTexture& texture,
                                    const std::array<float, 2>& uv, Filter filter) {
  const Uv at = transformed(texture.transform, {double{uv[0]}, double{uv[1]}});
  const double u = at[0] * image.width - 0.5, v = at[1] * image.height - 0.5;
  const double left = std::floor(u), top = std::floor(v);
  std::array<double, 4> sum{};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const double share = (i == 0 ? 1 - (u - left) : u - left) * (j == 0 ? 1 - (v - top) : v - top);
      const int x = static_cast<int>(wrapped(left + i, image.width, texture.sampler.wrap_u));
      const int y = static_cast<int>(wrapped(top + j, image.height, texture.sampler.wrap_v));
      for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c)
        sum[c] += share * (filter == Filter::light && c < 3 ? srgb_decode(image.at(x, y)[c] / 255.0)
                                                            : double{static_cast<double>(image.at(x, y)[c])});
    }
  if (filter == Filter::light)
    for (std::size_t c = 0; c < 3; ++c) sum[c] = 255 * srgb_encode(sum[c]);
  return sum;
}

inline PackResult pack_scene(const std::string& path, const std::string& out, bool islands,
                             PackOptions options = {}) {
  options.leave_out.islands = islands;
  options.run.threads = 2;
  options.input.pictures.door = picture_door();
  return pack(path, out, options, test::library());
}

}  // namespace etak::test
