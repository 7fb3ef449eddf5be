// SPDX-License-Identifier: Apache-2.0
#include "core/glsl/glsl_transfer.h"

#include <string>

namespace etak {
namespace {

void tone_text(GlslGlue& glue, const Scene& scene) {
  const char* function = nullptr;
  switch (scene.tone) {
    case Tone::neutral:
      function = "tone_neutral";
      break;
    case Tone::agx_like:
      function = "tone_agx_like";
      break;
    case Tone::filament:
      function = "tone_filament";
      break;
    case Tone::false_color:
      function = "tone_false_color";
      break;
    case Tone::plain:
      break;
  }
  // Most scenes have none: no use telling everybody.
  if (function == nullptr) return;
  glue.line("  color = " + std::string(function) + "(color);");
  glue.use("tone", function);
}

}  // namespace

void transfer_text(GlslGlue& glue, const Scene& scene, const GlslDisplay* display) {
  if (scene.exposure != 1 || scene.view) {
    glue.uniform("exposure", scene.exposure);
    glue.line("  color *= exposure;");
    glue.use("exposure", "a factor");
  } else {
    glue.leave_out("exposure", "the factor is 1");
  }
  if (display != nullptr) {
    glue.line("  color = " + display->function + "(color);");
    return glue.use("transfer", display->name);
  }
  tone_text(glue, scene);
  const char* curve = nullptr;
  switch (scene.transfer) {
    case Transfer::srgb:
      curve = "srgb_encode";
      break;
    case Transfer::power_22:
      curve = "power22_encode";
      break;
    case Transfer::power_045:
      curve = "power045_encode";
      break;
    case Transfer::square_root:
      curve = "root_encode";
      break;
    case Transfer::linear:
      break;
  }
  if (curve == nullptr) return glue.leave_out("transfer", "values stay linear");
  const std::string call = curve;
  glue.line("  color = max(color, vec3(0.0));");
  glue.line("  color = vec3(" + call + "(color.x), " + call + "(color.y), " + call + "(color.z));");
  glue.use("transfer", call);
}

}  // namespace etak
