// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/color/delta_e.h"
#include "core/render/view_state.h"

namespace etak {

/// What a hand does to a view. Places and ways are in radii of the sphere, x to the right, y up.
struct ViewPlace {
  double x = 0, y = 0;
};

/// The place behind a point of a `width` x `height` picture of `state`, counted from its left upper corner,
/// and the side of a radius there in pixels. Throws Error as view_tiles() does.
struct PlaceUnder {
  ViewPlace place;
  double radius_pixels = 1;
};
PlaceUnder place_under(const ViewState& state, int width, int height, double column, double row);

/// The camera after a drag that takes the object along: a radius is a quarter turn.
View orbited(const View& view, const ViewPlace& way);

/// The camera after a drag that takes the picture along.
View panned(const View& view, const ViewPlace& way);

/// The camera nearer by `factor`; what lies at `fixed` stays there. Zoom is held to 0.05 to 50.
View zoomed(const View& view, double factor, const ViewPlace& fixed);

/// The same direction, with the whole object in the middle.
View framed(const View& view);

/// The environment's turn after a drag: a radius is a quarter turn, and it goes where the hand goes.
double turned_environment(double turn_deg, const ViewPlace& way);

/// Where a light's highlight lies on a sphere: where hands take hold of it.
struct LightMark {
  int light = 0;  // index in the setup; hemispheres_mark: the axis of the hemispheres
  ViewPlace place;
};
inline constexpr int hemispheres_mark = -1;
std::vector<LightMark> light_marks(const LightSetup& setup, const View& view);

/// The setup with light `mark` (an index, or hemispheres_mark) moved so that its highlight lies at `place`.
/// Lights with a place keep their distance, spots go on looking at the object. At the rim the light is
/// behind.
LightSetup moved_light(const LightSetup& setup, const View& view, int mark, const ViewPlace& place);

/// `scene` as it is in a rectangle of its picture, in a picture of that size.
Scene cropped(const Scene& scene, int x, int y, int width, int height);

/// Linear radiance of both sides at a pixel of the picture and around it: 5 x 5 pixels at most, four
/// channels, times exposure. Throws Error as view_tiles() does.
struct ViewPatch {
  Image a, b;
};
Vec3 mean_color(const Image& picture);  // of the first three channels
ViewPatch patch_under(const ViewState& state, int width, int height, int column, int row);

}  // namespace etak
