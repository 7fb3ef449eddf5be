// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/glsl_camera.h"

#include <cmath>
#include <numbers>

#include "core/math/functions.h"
#include "core/render/backdrop.h"
#include "core/render/environment.h"

namespace etak {
namespace {

constexpr int ring_corners = 32;

// Sets where the polygon lies, and the radius of its corners in pixels.
void place_fan(GlslGlue& glue, const Scene& scene, const Camera& camera, double radius, int corners) {
  const auto two = [](double x, double y) {
    return std::vector<float>{static_cast<float>(x), static_cast<float>(y)};
  };
  const double w = scene.width / 2.0, h = scene.height / 2.0;
  glue.vertex_uniform(
      {"fan_centre", 2, 1, false, two(camera.centre_column() / w - 1, 1 - camera.centre_row() / h)});
  glue.vertex_uniform({"fan_radius", 2, 1, false, two(radius / w, radius / h)});
  glue.vertex_uniform({"fan_corners", 1, 1, false, {static_cast<float>(corners)}});
}

// Draws a polygon around the object instead of the whole picture, because for a software rasteriser the
// pixels beside the object cost as much as those of the object.
void fan(GlslGlue& glue, const Scene& scene, const Camera& camera, bool sphere) {
  if (!sphere && scene.perspective) return;  // the square may be anywhere in the picture
  const int corners = sphere || camera.turned() ? 32 : 4;
  const double reach = (sphere ? 1 : std::sqrt(2.0)) + 2 * camera.pixel();
  const double radius = reach / (corners == 4 ? 1 : math::cos(std::numbers::pi / corners)) / camera.pixel();
  glue.text.corners = corners;
  place_fan(glue, scene, camera, radius, corners);
}

// Draws a strip from a polygon inside the sphere, where the object hides the backdrop, to one that is larger than
// the picture.
void ring(GlslGlue& glue, const Scene& scene, const Camera& camera) {
  const double radius = std::max(0.0, 1 - 2 * camera.pixel()) / camera.pixel();
  if (radius < 1) return;
  place_fan(glue, scene, camera, radius, ring_corners);
  // The picture reaches from -1 to 1, in both directions, wherever the centre is.
  const double w = scene.width / 2.0, h = scene.height / 2.0;
  const double farthest =
      std::abs(camera.centre_column() / w - 1) + std::abs(1 - camera.centre_row() / h) + 2;
  const double least = radius / std::max(w, h) * math::cos(std::numbers::pi / ring_corners);
  glue.vertex_uniform({"ring_factor", 1, 1, false, {static_cast<float>(farthest / least)}});
  glue.text.ring = true;
  glue.text.corners = 2 * (ring_corners + 1);
}

// Writes the variable `behind`, from the variable `at`.
void backdrop(GlslGlue& glue, const Scene& scene, const Camera& camera) {
  if (!has_backdrop(scene)) return;
  const BackdropRays rays(camera);
  glue.uniform("backdrop_rays", rays.distance, rays.slope);
  const auto in_scene = [&](const std::string& seen) {
    return scene.view ? "out_of_camera(" + seen + ", camera_axes[0], camera_axes[1], camera_axes[2])" : seen;
  };
  glue.line("  vec3 sight = " + in_scene("normalize(vec3(at * backdrop_rays.y, -1.0))") + ";");
  glue.line("  vec3 behind = background;");
  if (scene.backdrop.environment && !scene.lights.environment.empty()) {
    glue.line("  behind = environment_behind(" + in_environment_map(scene, "sight") + ");");
    glue.use("backdrop", "the environment");
  }
  if (scene.backdrop.ground && scene.shape == Shape::sphere) {
    glue.line("  behind *= ground_light(" + in_scene("vec3(0.0, 0.0, backdrop_rays.x)") + ", sight);");
    glue.use("ground", "with the sphere's shadow");
  }
}

// Writes main() up to the position, the normal and the viewer of the pixel, for a camera at the front.
void seen_from_the_front(GlslGlue& glue, const Scene& scene, const Camera& camera, bool sphere) {
  glue.line("void main() {");
  glue.line("  float pixel = 2.2 / picture_size.y;");
  glue.line("  vec2 at = (gl_FragCoord.xy - picture_size * 0.5) * pixel;");
  if (!sphere)
    glue.line(scene.perspective ? "  float side = 1.0 / (camera_spread * camera_distance);"
                                : "  float side = 1.0;");
  glue.line(sphere ? "  float coverage = disc_coverage(at, pixel);"
                   : "  float coverage = square_coverage(at, side, pixel);");
  backdrop(glue, scene, camera);
  glue.line("  vec3 color = " + backdrop_name(scene) + ";\n  if (coverage > 0.0) {");
  if (sphere) {
    glue.line(scene.perspective ? "    vec3 p = sphere_perspective(at, camera_distance, camera_spread);"
                                : "    vec3 p = sphere_orthographic(at);");
    glue.line("    vec3 n = p;");
  } else {
    glue.line(scene.perspective ? "    vec3 p = vec3(clamp(at / side, -1.0, 1.0), 0.0);"
                                : "    vec3 p = vec3(clamp(at, -1.0, 1.0), 0.0);");
    glue.line("    vec3 n = vec3(0.0, 0.0, 1.0);");
  }
  if (!scene.perspective)
    glue.line("    vec3 v = vec3(0.0, 0.0, 1.0);");
  else
    glue.line(sphere ? "    vec3 v = viewer_perspective(drawn_in(at), camera_spread);"
                     : "    vec3 v = viewer_perspective(clamp(at, -side, side), camera_spread);");
}

// Declares where the picture lies in its target, and the camera's axes.
void view_uniforms(GlslGlue& glue, const Scene& scene, const Camera& camera) {
  glue.declare("vec2", "picture_origin");
  glue.uniform("picture_pixel", camera.pixel());
  // The rows of the target count from the bottom.
  glue.uniform("picture_centre", camera.centre_column(), scene.height - camera.centre_row());
  std::vector<float> axes;
  for (const Vec3& axis : camera.axes()) append_floats(axes, axis);
  glue.uniforms("camera_axes", 3, axes);
}
constexpr const char* view_place = "  vec2 at = (gl_FragCoord.xy - picture_origin - picture_centre) * pixel;";

// The sight of a camera at any direction, which uniforms set.
void seen_from_anywhere(GlslGlue& glue, const Scene& scene, const Camera& camera, bool sphere,
                        bool backdrop_apart) {
  view_uniforms(glue, scene, camera);
  std::vector<float> plane;
  for (const Vec3& row : camera.plane()) append_floats(plane, row);
  // Where there is a backdrop, every pixel is drawn.
  if (backdrop_apart || !has_backdrop(scene)) fan(glue, scene, camera, sphere);
  if (!sphere) glue.uniforms("square_rows", 3, plane);
  const std::string out_of = "out_of_camera(", by = ", camera_axes[0], camera_axes[1], camera_axes[2])";
  glue.line("void main() {");
  glue.line("  float pixel = picture_pixel;");
  glue.line(view_place);
  if (sphere) {
    glue.line("  float coverage = disc_coverage(at, pixel);");
  } else {
    glue.line("  vec3 place = plane_place(at, square_rows[0], square_rows[1], square_rows[2]);");
    glue.line(
        "  float coverage = plane_coverage(place, camera_axes[2].z, square_rows[0], square_rows[1], square_rows[2], pixel);");
  }
  backdrop(glue, scene, camera);
  glue.line("  vec3 color = " + backdrop_name(scene) + ";\n  if (coverage > 0.0) {");
  if (sphere) {
    glue.line("    vec3 p = " + out_of +
              (scene.perspective ? "sphere_perspective(at, camera_distance, camera_spread)"
                                 : "sphere_orthographic(at)") +
              by + ";");
    glue.line("    vec3 n = p;");
    glue.line(scene.perspective
                  ? "    vec3 v = " + out_of + "viewer_perspective(drawn_in(at), camera_spread)" + by + ";"
                  : "    vec3 v = camera_axes[2];");
  } else {
    glue.line("    vec3 p = vec3(clamp(place.xy / max(place.z, 1e-6), -1.0, 1.0), 0.0);");
    glue.line("    vec3 n = vec3(0.0, 0.0, camera_axes[2].z < 0.0 ? -1.0 : 1.0);");
    glue.line(scene.perspective ? "    vec3 v = normalize(camera_axes[2] * camera_distance - p);"
                                : "    vec3 v = camera_axes[2];");
  }
}

}  // namespace

bool has_backdrop(const Scene& scene) {
  return (scene.backdrop.environment && !scene.lights.environment.empty()) ||
         (scene.backdrop.ground && scene.shape == Shape::sphere);
}

std::string in_environment_map(const Scene& scene, const std::string& direction) {
  const bool turned = scene.view || scene.environment_turn_deg != 0;
  return turned ? "turned_to_map(" + direction + ", environment_turn)" : direction;
}

void beside_text(GlslGlue& glue, const Scene& scene, const Camera& camera) {
  view_uniforms(glue, scene, camera);
  if (scene.shape == Shape::sphere) ring(glue, scene, camera);
  glue.line("void main() {\n  float pixel = picture_pixel;");
  glue.line(view_place);
  backdrop(glue, scene, camera);
  glue.line("  vec3 color = behind;");
}

void camera_text(GlslGlue& glue, const Scene& scene, const Camera& camera, bool backdrop_apart) {
  const bool sphere = scene.shape == Shape::sphere;
  if (scene.view)
    seen_from_anywhere(glue, scene, camera, sphere, backdrop_apart);
  else
    seen_from_the_front(glue, scene, camera, sphere);
}

}  // namespace etak
