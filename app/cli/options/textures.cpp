// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>

#include "app/cli/options/scene.h"
#include "app/cli/pictures/pictures.h"
#include "core/atlas/sources/floats.h"
#include "core/atlas/sources/sources.h"
#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/load.h"
#include "core/render/surface_textures.h"

namespace etak::cli {
namespace {

// The picture of a file in linear light.
std::optional<Image> linear_texture(const char* option, const std::string& path) {
  if (path.empty()) return std::nullopt;
  Picture picture = load_picture(path, picture_door());
  const bool linear = picture.header.floating;
  Image out = fractions(std::move(picture));
  if (out.channels < 3)
    throw Error::at(path, std::to_string(out.channels) + " channels",
                    std::string("three or four for ") + option);
  if (!linear)
    for (std::size_t i = 0; i < out.values.size(); ++i)
      if (i % static_cast<std::size_t>(out.channels) < 3)
        out.values[i] = static_cast<float>(srgb_decode(double{out.values[i]}));
  return out;
}

}  // namespace

void read_textures(SceneArguments& arguments) {
  const std::string &of_emission = arguments.emission_texture, &of_occlusion = arguments.occlusion_texture;
  if (arguments.textures || (arguments.texture.empty() && arguments.gloss_texture.empty() &&
                             of_emission.empty() && of_occlusion.empty()))
    return;
  const auto body = linear_texture("--texture", arguments.texture),
             gloss = linear_texture("--gloss-texture", arguments.gloss_texture);
  std::optional<Image> emission, occlusion;
  if (!of_emission.empty())
    emission = emission_floats({of_emission, {}, {}}, of_emission, {std::nullopt, picture_door(), {}, {}});
  if (!of_occlusion.empty())
    occlusion =
        occlusion_floats({of_occlusion, {}, {}}, of_occlusion, {std::nullopt, picture_door(), {}, {}});
  const auto given = [](const std::optional<Image>& picture) { return picture ? &*picture : nullptr; };
  arguments.textures =
      surface_textures({given(body), given(gloss), given(emission), given(occlusion)}, max_scene_texture);
}

}  // namespace etak::cli
