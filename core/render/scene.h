// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/brdf/models.h"
#include "core/color/gloss.h"
#include "core/fresnel/curve.h"
#include "core/image/image.h"
#include "core/light/lights.h"
#include "core/material/f0.h"
#include "core/material/material.h"

namespace etak {

class MeshShape;  // core/render/mesh/mesh_shape.h

/// What goes through layers on a clear base.
///   n       of the base against the outside
///   twice   the light that passes two such surfaces, where it enters the body and leaves it, over the cosine outside; what
///           the body absorbs is left out
struct ClearLayers {
  double n = 1.5;
  FresnelCurve twice;
  friend bool operator==(const ClearLayers&, const ClearLayers&) = default;
};

/// The optical values of a surface, for each channel of linear sRGB. The role of a model's parameter says
/// which of them it takes.
struct SurfaceValues {
  Vec3 diffuse{0, 0, 0};
  Vec3 f0{0.04, 0.04, 0.04};
  Vec3 f82{1, 1, 1};                  // absolute reflectance at cos 1/7
  Vec3 n{1.5, 1.5, 1.5}, k{0, 0, 0};  // solved from F0 and F82 for each channel
  // Schueler's g: e = 2^(12 g) and alpha = m = sqrt(2 / (e + 2)). Where a perceptual roughness was given,
  // alpha = roughness^2 and g is the nearest one.
  Gloss gloss = 0.75;
  double opacity = 1;      // alpha of the body
  Vec3 emission{0, 0, 0};  // radiance that the surface sends out by itself, to all sides; >= 0
  double occlusion = 1;    // share of the light of hemispheres and environment that reaches it, [0, 1]
  // For clear bodies: what is left of D65 behind clear_ball_m of them, linear sRGB, above 0. A ball of that
  // diameter bends its environment; where there is none, and on a quad, the background is seen unbent.
  std::optional<Vec3> passing;
  std::optional<ClearLayers> layers;  // of a stack with `passing`, in place of Fresnel's equations for its n
  std::optional<Optics> optics;  // n and k or a stack, for the spectral reference; none: n and k as given
  std::optional<FresnelCurve> curve;  // F over the angle of a stack of layers
  // The larger of the differences between f0 and the F0 of n, k and between f82 and the F82 of n, k. An F0
  // above 1 has no n and k.
  Vec3 nk_residual{0, 0, 0};
  friend bool operator==(const SurfaceValues&, const SurfaceValues&) = default;
};

/// The diameter in metres of the sphere, where a body is clear and its size decides how much it absorbs: a
/// marble.
inline constexpr double clear_ball_m = 0.02;

/// The surface of a library material. F0, F82 and n, k for each channel come from its spectrum. The diffuse
/// colour is black for conductors and semiconductors, and `diffuse` for dielectrics. For materials of kind
/// "surface", the measured reflectance is divided into a diffuse colour and an F0 of 0.04, or less where the
/// body is darker than that (divided() in core/material/appearance.h). A stack of layers has a curve of
/// its F. Throws Error for data that give no F0.
SurfaceValues surface_of(const Material& material, const Dataset& dataset, const Vec3& diffuse,
                         const Gloss& gloss);

/// The surface by an F0 result that was computed with other options (another outside medium, illuminant or
/// observer); its linear sRGB and F82 are taken as they are. Throws Error for a refused result.
///   f0        the result for `dataset`, with linear sRGB as output space
///   options   of that result
SurfaceValues surface_of(const Material& material, const Dataset& dataset, const F0Result& f0,
                         const Vec3& diffuse, const Gloss& gloss, const F0Options& options = {});

/// F of a surface over the angle: its own curve, else that of its optics or of n and k.
FresnelCurve curve_of(const SurfaceValues& surface);

/// The luminance of F0 that decides how much is seen through a surface: of layers what they do not let pass.
double unseen_luminance(const SurfaceValues& surface);

/// What is to be said of a curve: how far it is off.
std::string curve_note(const FresnelCurve& curve);

/// The specular model by which a surface is drawn. F of a surface that has a curve is that curve, also where another F was
/// chosen: in place of the default model GGX is taken, and a model of three terms keeps D and V. Models with a text of their
/// own keep it.
///   model   null: none
const Model* drawn_model(const Model* model, const SurfaceValues& surface);

/// Sets f82, n and k of a surface whose f0 alone is known. Below the forbidden zone they are those of the
/// dielectric with that F0; above, f82 is that of Schlick's curve, and n and k are those of a metal.
void complete_from_f0(SurfaceValues& surface);

/// Sets n and k of `surface` to those that give its f0 and f82, and nk_residual to the difference that is
/// left.
void solve_index(SurfaceValues& surface);

/// A value of a surface that was outside of the range of a model's parameter.
///   wanted   the value of the surface
///   used     the value in range that was taken instead
struct ClampedValue {
  std::string name;  // "K.r"
  double wanted, used;
};

/// The values of a model's parameters: from `surface` by role, then from `overrides` by name. Throws Error
/// for unknown names and for overrides outside of the parameter's range.
///   overrides   name and value: "m"; "K.r", "K.g" and "K.b" for single channels, or "K" for all three
///   clamped     where given, gets the values of `surface` that were brought into range. F0 and diffuse
///               colours are not clamped (gold's red in sRGB is above 1)
std::vector<double> model_values(const Model& model, const SurfaceValues& surface,
                                 const std::vector<std::pair<std::string, double>>& overrides,
                                 std::vector<ClampedValue>* clamped = nullptr);

/// Whether the model has diffuse parameters and all of them are 0, so that it gives no diffuse light.
bool body_is_black(const Model& model, const std::vector<double>& values);

/// The models of a surface with their parameters' values, for a scene or a viewport.
struct FittedModels {
  const Model *specular = nullptr, *diffuse = nullptr;
  std::vector<double> specular_values, diffuse_values;
  std::vector<ClampedValue> clamped;
};

/// Computes the values of both models by model_values(). An override goes to the specular model where that
/// has a parameter of its name, else to the diffuse model. Where a model was overridden, the colours and the
/// gloss of `surface` become those of the model, so that hemispheres and environment use them too. The specular model is
/// that of drawn_model(). Beside a specular model of kind both, the diffuse model is left out. Throws Error for models of the wrong kind and
/// for overrides that neither model has.
FittedModels fit_models(const Model* specular, const Model* diffuse,
                        const std::vector<std::pair<std::string, double>>& overrides, SurfaceValues& surface);

/// The position of the camera, and the part of its picture that is shown.
struct View {
  double turn_deg = 0;          // around y; at 90 the camera looks from +x
  double rise_deg = 0;          // above the horizon, -90 to 90
  double pan_x = 0, pan_y = 0;  // place of the picture's middle, in radii of the sphere
  double zoom = 1;              // above 0
  friend bool operator==(const View&, const View&) = default;
};

/// The textures of a surface, with four channels each in linear light. They are looked up bilinearly with
/// repeated edges. On the quad they begin at the top left corner; on the sphere they lie in latitude and
/// longitude, with the seam at the back. Their sizes may differ. One that holds nothing may have no texels.
///   has        the quantities that the textures hold; the others are those of the scene's surface, so that a
///              number can change while the textures stay as they are
///   emission   factors of the surface's emission and, in the fourth channel, of its occlusion, as in glTF
///   normal     three components of -1 to 1 in the frame of the surface, x along its tangent and y along its bitangent
///              (OpenGL's convention); the fourth channel says nothing. On a mesh its UVs tell both. References are drawn without it
struct SurfaceTextures {
  /// Which quantities of a surface come from its textures.
  struct Quantities {
    bool diffuse = true, opacity = true, f0 = true, gloss = true, emission = false, occlusion = false,
         normal = false;
    /// Whether models take some value from a texture.
    bool values() const { return diffuse || opacity || f0 || gloss; }
  };
  Image body;   // diffuse colour and opacity
  Image gloss;  // F0 and gloss
  Quantities has = {};
  Image emission = {};
  Image normal = {};
  std::shared_ptr<const SurfaceTextures> half =
      {};  // the same with half the sides, by add_halves(); null: none
};

enum class Shape { sphere, quad };
enum class Transfer { srgb, power_22, power_045, square_root, linear };
/// What is done to exposed light before the transfer: core/light/tone.glsl.
enum class Tone { plain, neutral, agx_like, filament, false_color };

/// What is seen beside and below the object.
///   environment   the environment instead of the background's colour, as from a camera whose rays part: in
///                 orthographic pictures one backdrop_distance away
///   blur          of the environment, [0, 1]: as it is, to as dull as it is mirrored at gloss 0
///   ground        a sphere lies on a level ground, which shows its shadow alone (core/light/ground.glsl)
struct Backdrop {
  bool environment = false;
  double blur = 0.3;
  bool ground = false;
  friend bool operator==(const Backdrop&, const Backdrop&) = default;
};

/// The contents of a picture: one object, its models, the light and the camera. The CPU and OpenGL draw it by
/// the same rules:
///   pixel         (i, j) with rows from the top lies at x = (i + 1/2 - width/2) s,
///                 y = (height/2 - j - 1/2) s, with s = 2.2 / height
///   camera        orthographic: looks along -z, viewer direction +z. Perspective: at (0, 0, d) with
///                 d^2 = 1 + (1.1 / tan(fov/2))^2, so that the silhouette keeps its radius of 1 at x, y
///   sphere        coverage of a pixel = clamp(1/2 + (1 - r) / s, 0, 1), r^2 = x^2 + y^2; a pixel is shaded
///                 at its centre, moved inwards where that lies beyond r = 0.9999
///   quad          the square |x|, |y| <= 1 in the plane z = 0, normal +z; coverage = product of the sphere's
///                 expression for r = |x| and for r = |y|
///   mesh          drawn on the CPU alone; a pixel is the mean of 4 x 4 samples, of which those of one surface are
///                 shaded once (mesh_view.h). It keeps light from itself: of lights by rays, of hemispheres and
///                 environment by its vertices' share of open sky (mesh_shape.h)
///   frame         tangent t = normalize(cross(y, n)), the x axis where |cross|^2 < 1e-12; bitangent
///                 b = cross(n, t)
///   light         sum of f_r E nl, times pi where `pi_scaled`; hemispheres and environment use diffuse, f0
///                 and gloss of `surface`
///   emission      added to what is reflected; opacity does not reduce it
///   occlusion     factor of what is reflected of hemispheres and environment (Schueler's visibility); areas and
///                 discrete lights stay as they are
///   opacity < 1   specular + opacity * diffuse + (1 - opacity)(1 - F(nv)) * background, where F is
///                 Schueler's of the luminance of surface.f0; specular is never multiplied by opacity. A
///                 sphere with `passing` shows instead of the background the environment through itself
///                 (core/light/clear_ball.glsl, with n of green), prefiltered for its gloss
///   backdrop      background is that of the pixel's ray, where a backdrop is asked for (backdrop.h)
///   stripes       over the object, 6 pixels wide at 45 degrees: 0.6 of their colour is magenta (zone) or,
///                 with the other slant, yellow (energy), bright enough to show under the exposure. With
///                 textures both are decided for each pixel, and energy stripes show where diffuse colour
///                 plus F0 is above 1
///   tints         over the object: blue where the angle between normal and viewer is 45 to 75 degrees, orange
///                 from there on
///   output        transfer(max(tone(exposure * mix(background, object, coverage)), 0)); the fourth channel is
///                 the coverage
struct Scene {
  Shape shape = Shape::sphere;
  std::shared_ptr<const MeshShape> mesh;  // in place of the sphere; null: none
  SurfaceValues surface;
  const Model* specular = nullptr;  // may be of kind both; null: no specular part
  std::vector<double> specular_values;
  const Model* diffuse = nullptr;  // null: no diffuse part, or `specular` is of kind both
  std::vector<double> diffuse_values;
  // These replace what they hold of the surface's diffuse, opacity, f0 and gloss, and multiply its emission and
  // occlusion; null: none.
  std::shared_ptr<const SurfaceTextures> textures;
  std::array<double, 2> texture_scale{1, 1};  // how often they repeat over the surface along u and v, above 0
  bool mark_zone = false;                     // stripes where the luminance of F0 is in the forbidden zone
  bool mark_angles = false;        // tints of Hoffman's zones of the angle between normal and viewer
  std::vector<float> mark_energy;  // by quick_albedo(): stripes where it is above 1; empty: no stripes
  LightSetup lights;
  double environment_turn_deg = 0;  // around y
  std::optional<View> view;         // none: the whole object from the front
  bool perspective = false;         // orthographic otherwise
  double field_of_view_deg = 30;    // perspective: vertical
  // Hemispheres and environment are seen by samples of the model's lobe, not by the few round lobes of a moving picture.
  bool refined = false;
  bool bright_apart = false;  // set by with_bright_lights()
  double exposure = 1;        // linear factor
  Tone tone = Tone::plain;
  Transfer transfer = Transfer::srgb;
  Vec3 background{0.18, 0.18, 0.18};  // linear
  Backdrop backdrop;
  int width = 512, height = 512;

  /// The quantities that the surface's textures hold.
  SurfaceTextures::Quantities textured() const {
    return textures ? textures->has : SurfaceTextures::Quantities{false, false, false, false};
  }
};

/// The values of the scene's specular model. In a model of kind both, the diffuse colour is multiplied by the
/// surface's opacity, since every model is linear in it; nothing else is ever multiplied by opacity.
std::vector<double> seen_specular_values(const Scene& scene);

/// Whether the surface is a sphere of a clear body that is not opaque. In an environment it bends the view.
bool is_clear_ball(const Scene& scene);

/// Whether some of what is behind the object is seen through it, unbent.
bool is_seen_through(const Scene& scene);

/// Throws Error for scenes that cannot be drawn: sides outside of 1..16384 pixels, NaN, n <= 0, k < 0, lists
/// of values that do not fit their models, no model at all, a light setup that validate() of
/// core/light/lights.h refuses, and a mesh where none can be drawn.
void validate(const Scene& scene, bool meshes_drawn = false);

}  // namespace etak
