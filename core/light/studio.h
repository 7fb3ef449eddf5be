// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "core/light/lights.h"
#include "core/math/mat3.h"

namespace etak {

/// An area light so far away that its direction alone counts. It hides the wall behind it.
///   towards, right, up      its middle and its sides' directions: unit vectors at right angles
///   half_width, half_height tangents of the half angles under which the object sees it, above 0
///   edge                    share of a half side over which it fades out, smoothly: above 0, at most 1
///   round                   an ellipse instead of a rectangle
struct Lamp {
  Vec3 towards{0, 0, 1}, right{1, 0, 0}, up{0, 1, 0};
  double half_width = 0.5, half_height = 0.5;
  double edge = 0.3;
  bool round = false;
  Vec3 radiance{1, 1, 1};  // linear sRGB, where it is whole
  friend bool operator==(const Lamp&, const Lamp&) = default;
};

/// Surroundings made by arithmetic: a floor, a wall or sky that changes with height, and area lights before
/// them. All colours are radiances in linear sRGB, at least 0.
///   horizon, top   of the wall: top + (horizon - top) (1 - y)^fall at height y of the direction, [0, 1]
///   skirting       height, up and down, within which floor and wall pass into each other
struct Studio {
  Vec3 floor{0, 0, 0}, horizon{0, 0, 0}, top{0, 0, 0};
  double fall = 1;
  double skirting = 0.05;
  std::vector<Lamp> lamps;
  friend bool operator==(const Studio&, const Studio&) = default;
};

/// Radiance that arrives from direction `d`, a unit vector in the scene's space (core/light/lights.h).
Vec3 radiance(const Studio& studio, const Vec3& d);

/// Irradiance on a plane that faces the camera, normal +z.
///   error   0.3 % for the studios below
Vec3 irradiance_before_camera(const Studio& studio);

/// etak's own surroundings. Each is exposed for a grey card that faces the camera: the luminance of
/// irradiance_before_camera() is pi, so that a Lambert surface of 18 % shows its 0.18.
///   name   as light setups and `--env` have it
struct NamedStudio {
  std::string_view name, title;
  Studio studio;
};
const std::vector<NamedStudio>& named_studios();

/// The one of that name; null where there is none, and the name is that of a file.
const Studio* find_studio(std::string_view name);

/// The lights that pictures are made with when nothing is said: the environment "studio" and two directional lights, a
/// bare flash before its key light and one before a strip behind the object. The flashes are what shading
/// models are told apart by, as an environment is the same for all of them. Of the irradiance on a plane that
/// faces the camera the key flash gives a fifth; all of it is pi.
LightSetup studio_lights();

}  // namespace etak
