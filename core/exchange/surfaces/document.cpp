// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/surfaces/document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/color/colorspace.h"
#include "core/color/srgb.h"
#include "core/exchange/surfaces/models.h"
#include "core/math/functions.h"

namespace etak {
namespace {

double signed_power(double value, double exponent) {
  return std::copysign(math::pow(std::abs(value), exponent), value);
}
double linear(double value) {
  return value;
}

// Colour spaces by the names of MaterialX 1.39, of OpenColorIO's studio config, and of USD.
struct NamedSpace {
  std::string_view name;
  RgbSpace primaries;
  double (*decode)(double);
};
constexpr std::array spaces{
    NamedSpace{"", RgbSpace::srgb, linear},
    NamedSpace{"lin_rec709", RgbSpace::srgb, linear},
    NamedSpace{"lin_rec709_scene", RgbSpace::srgb, linear},
    NamedSpace{"lin_srgb", RgbSpace::srgb, linear},
    NamedSpace{"none", RgbSpace::srgb, linear},
    NamedSpace{"raw", RgbSpace::srgb, linear},
    NamedSpace{"srgb_texture", RgbSpace::srgb, srgb_decode},
    NamedSpace{"srgb_rec709_scene", RgbSpace::srgb, srgb_decode},
    NamedSpace{"sRGB", RgbSpace::srgb, srgb_decode},
    NamedSpace{"g18_rec709", RgbSpace::srgb, [](double x) { return signed_power(x, 1.8); }},
    NamedSpace{"g22_rec709", RgbSpace::srgb, [](double x) { return signed_power(x, 2.2); }},
    NamedSpace{"acescg", RgbSpace::acescg, linear},
    NamedSpace{"lin_ap1", RgbSpace::acescg, linear},
    NamedSpace{"lin_ap1_scene", RgbSpace::acescg, linear},
    NamedSpace{"g22_ap1", RgbSpace::acescg, [](double x) { return signed_power(x, 2.2); }},
    NamedSpace{"lin_displayp3", RgbSpace::display_p3, linear},
    NamedSpace{"srgb_displayp3", RgbSpace::display_p3, srgb_decode},
    NamedSpace{"lin_rec2020", RgbSpace::rec2020, linear}};

Mat3 to_srgb(RgbSpace space) {
  constexpr Xyz d65{0.95047, 1, 1.08883};
  return xyz_to_rgb(RgbSpace::srgb, d65, d65) * inverse(xyz_to_rgb(space, d65, d65));
}

}  // namespace

const SurfaceInput* DocumentSurface::input(std::string_view input_name) const {
  for (const SurfaceInput& each : inputs)
    if (each.name == input_name) return &each;
  return nullptr;
}

void take_color_space(SurfaceInput& input, std::string_view space) {
  const auto found = std::ranges::find(spaces, space, &NamedSpace::name);
  if (found == spaces.end()) {
    input.problem = "the colour space " + in_quotes(space) + " is not known";
    input.values.clear();
    return;
  }
  // Numbers that are no colours stay as they are: a power of them may have no value.
  constexpr double most = 1e6;
  std::vector<double> rgb = input.values;
  if (std::ranges::any_of(rgb, [](double channel) { return std::abs(channel) > most; })) return;
  for (double& channel : rgb) channel = found->decode(channel);
  if (found->primaries != RgbSpace::srgb) {
    const Vec3 out = to_srgb(found->primaries) * Vec3{rgb[0], rgb[1], rgb[2]};
    rgb = {out[0], out[1], out[2]};
  }
  if (rgb != input.values) input.written = std::exchange(input.values, rgb);
}

bool is_surface_document(std::string_view head) {
  if (head.starts_with("#usda") || head.starts_with("PXR-USDC") || is_value_table(head)) return true;
  return head.starts_with('<') && head.find("<materialx") != head.npos;
}

void require_inside(std::string_view file, std::string_view place) {
  const auto refuse = [&](std::string_view why) {
    throw Error::at(place, in_quotes(file, 80) + ", " + std::string(why),
                    "a file in the document's folder or below it");
  };
  if (file.starts_with('/') || file.starts_with('\\')) refuse("an absolute path");
  std::string_view rest = file;
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find_first_of("/\\"));
    if (part == "..") refuse("outside of the document's folder");
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  }
  const std::size_t colon = file.find(':');
  if (colon != file.npos && std::all_of(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(colon),
                                        [](char c) { return is_letter(c) || is_digit(c) || c == '+'; }))
    refuse("no file beside the document");
}

// Nodes that read nothing any more are taken away until none is left; what stays reads each other.
void require_no_loop(const std::vector<NodeLinks>& nodes, std::string_view file) {
  std::vector<std::size_t> open(nodes.size()), ready;
  std::vector<std::vector<std::size_t>> readers(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    open[i] = nodes[i].reads.size();
    for (const std::size_t source : nodes[i].reads) readers[source].push_back(i);
    if (open[i] == 0) ready.push_back(i);
  }
  std::size_t done = 0;
  while (!ready.empty()) {
    const std::size_t node = ready.back();
    ready.pop_back();
    ++done;
    for (const std::size_t reader : readers[node])
      if (--open[reader] == 0) ready.push_back(reader);
  }
  if (done == nodes.size()) return;
  // From a node that is left, its first open source again and again: after as many steps as there are nodes, the walk is in
  // the circle.
  std::size_t at = 0;
  while (open[at] == 0) ++at;
  for (std::size_t step = 0; step < nodes.size(); ++step)
    at = *std::find_if(nodes[at].reads.begin(), nodes[at].reads.end(),
                       [&](std::size_t source) { return open[source] != 0; });
  throw Error::at(std::string(file) + ", " + nodes[at].place,
                  "the node " + in_quotes(nodes[at].name) + " reads itself through others",
                  "nodes without a circle");
}

}  // namespace etak
