// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/color/delta_e.h"
#include "core/render/view_state.h"

namespace etak {

// The view after drags and turns of the mouse wheel.

/// A place in a picture or a distance in it, in radii of the sphere; x to the right, y up.
struct ViewPlace {
  double x = 0, y = 0;
};

/// A place in a picture, and the radius of the sphere there in pixels.
struct PlaceUnder {
  ViewPlace place;
  double radius_pixels = 1;
};

/// The place at a point of a `width` x `height` picture of `state`. Throws Error as view_tiles() does.
///   column, row   pixels from the top left corner
PlaceUnder place_under(const ViewState& state, int width, int height, double column, double row);

/// The camera after a drag that turns the object with the mouse; a drag of one radius is a quarter turn.
View orbited(const View& view, const ViewPlace& way);

/// The camera after a drag that moves the picture with the mouse.
View panned(const View& view, const ViewPlace& way);

/// The camera with its zoom multiplied by `factor`, while the place `fixed` stays where it is. The zoom is
/// clamped to 0.05..50.
View zoomed(const View& view, double factor, const ViewPlace& fixed);

/// The camera at the same direction, with the whole object in the middle of the picture.
View framed(const View& view);

/// The camera of picture `number` (from 0) of a turntable of `count` pictures: the camera goes once around the object.
View on_turntable(const View& view, int number, int count);

/// The name of that picture's file: a number behind the name, before its ending, with as many digits as the last one
/// has.
///   path   has an ending
std::string on_turntable(const std::string& path, int number, int count);

/// The turn of the environment, in degrees, after a drag that moves it with the mouse; a drag of one radius
/// is a quarter turn.
double turned_environment(double turn_deg, const ViewPlace& way);

/// The handle by which the mouse moves a light: the place of its highlight on a sphere.
struct LightMark {
  int light = 0;  // index in the setup, or hemispheres_mark for the axis of the hemispheres
  ViewPlace place;
};
inline constexpr int hemispheres_mark = -1;
std::vector<LightMark> light_marks(const LightSetup& setup, const View& view);

/// The setup with the light `mark` (an index, or hemispheres_mark) moved so that its highlight lies at
/// `place`. Lights that have a position keep their distance, and spots still point at the object. A place at
/// the rim puts the light behind the object. Throws Error for an index that the setup does not have.
LightSetup moved_light(const LightSetup& setup, const View& view, int mark, const ViewPlace& place);

/// A scene whose picture is a rectangle of the picture of `scene`: `width` x `height` pixels from column x,
/// row y on.
Scene cropped(const Scene& scene, int x, int y, int width, int height);

/// The surroundings of a pixel as each of the two sides shows them: at most 5 x 5 pixels of four channels,
/// linear radiance times exposure.
struct ViewPatch {
  Image a, b;
};

/// The mean of the first three channels over all pixels.
Vec3 mean_color(const Image& picture);

/// The surroundings of a pixel of the `width` x `height` picture. Throws Error as view_tiles() does.
ViewPatch patch_under(const ViewState& state, int width, int height, int column, int row);

}  // namespace etak
