// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/pages/choose_report.h"

namespace etak {
namespace {

std::string cell(std::string_view text, std::size_t width) {
  return padded(text, width) + "  ";
}

std::string looked_at(const std::vector<Candidate>& candidates) {
  std::string out;
  for (const Candidate& each : candidates)
    append(out, out.empty() ? "" : ", ", each.id, " ", number(each.error, 3), each.within ? "" : " (over)");
  return out;
}

std::string saving(double everything, double chosen) {
  const double less = 100 * (1 - chosen / everything);
  return number(everything, 3) + " -> " + number(chosen, 3) + " (" + number(std::abs(less), 2) +
         (less < 0 ? " % more)" : " % less)");
}

// The saving over all choices: evaluations per millisecond, and milliseconds to integrate the spectra.
std::string saved(const std::vector<Choice>& choices) {
  double everything = 0, chosen = 0, everything_solve = 0, chosen_solve = 0;
  for (const Choice& each : choices) {
    everything += each.everything_ns / static_cast<double>(choices.size());
    chosen += each.chosen_ns / static_cast<double>(choices.size());
    everything_solve += each.everything_solve_ns;
    chosen_solve += each.chosen_solve_ns;
  }
  std::string out =
      "million evaluations a millisecond " + number(1 / everything, 3) + " -> " + number(1 / chosen, 3);
  if (everything_solve > 0)
    append(out, "; ms for the spectra ", number(everything_solve * 1e-6, 3), " -> ",
           number(chosen_solve * 1e-6, 3));
  return out;
}

std::string png_line(const CostTable& costs) {
  const std::vector<Candidate> levels = png_levels(costs);
  std::string out =
      "texture files: PNG level " + levels.front().id + "; all levels are lossless, ns a texel:";
  for (const Candidate& each : levels) append(out, " ", each.id, " ", number(each.cost_ns, 3));
  return out;
}

}  // namespace

std::string choice_text(const std::vector<Choice>& choices, const CostTable& costs, std::string_view scene) {
  if (choices.empty()) return {};
  std::size_t widest = 8, pixels = 0;
  bool textured = false;
  for (const Choice& each : choices) {
    widest = std::max(widest, cell_width(each.material));
    pixels += each.pixels;
    textured = textured || each.textured;
  }
  const auto filter_cell = [&](std::string_view text) { return textured ? cell(text, 11) : ""; };
  std::string out = cell("material", widest) + cell("fresnel", 18) + cell("masking", 24) +
                    filter_cell("filter") + cell("integration", 18) + cell("worst pixel", 11) +
                    cell("any angle", 9) + "ns, everything -> chosen\n";
  for (const Choice& each : choices)
    out +=
        cell(each.material, widest) +
        (each.whole_model ? cell(each.model, 42) : cell(each.fresnel->id, 18) + cell(each.visibility, 24)) +
        filter_cell(each.textured ? name(each.filter) : "-") +
        cell(each.method.empty() ? "-" : each.method, 18) + cell(number(each.picture_error, 3), 11) +
        cell(number(each.fresnel_error, 3), 9) + saving(each.everything_ns, each.chosen_ns) +
        (each.met ? "" : ", over the budget: the least that can be reached") + "\n";
  std::string remarks;
  for (const Choice& each : choices)
    if (const std::string why = saving_remark(each); !why.empty())
      append(remarks, "  ", line_text(why), "\n");
  if (!remarks.empty()) append(out, "\nsavings:\n", remarks);
  if (choices.size() == 1) {
    const Choice& one = choices[0];
    append(out, "\nlooked at, cheapest first, with the largest error in ", name(one.unit),
           ":\n  fresnel      ", looked_at(one.fresnel_candidates));
    append(out, "\n  masking      ", looked_at(one.visibility_candidates));
    if (one.textured) append(out, "\n  filter       ", looked_at(one.filter_candidates));
    if (!one.method.empty()) append(out, "\n  integration  ", looked_at(one.method_candidates));
    append(out, "\n  whole models ",
           one.model_candidates.empty() ? "none is cheaper" : looked_at(one.model_candidates));
    if (!one.film_candidates.empty()) append(out, "\n  in renderers ", looked_at(one.film_candidates));
    append(out, "\n");
    if (scene.empty())
      append(out, "\nshader: etak shader ",
             one.film_candidates.empty() ? line_text(one.material) : '\'' + line_text(one.library) + '\'',
             " --model ", one.model, "\n");
  }
  append(
      out, "\nsaved: ", saved(choices), "\nbudget ", number(choices[0].budget, 6), " ", name(choices[0].unit),
      " for F at every angle and for each of the ", std::to_string(pixels),
      " pixels that were drawn both ways; everything: F at every nanometre (where F0 is all that is known, exact for dielectrics, Schlick for metals), GGX, Smith masking by height, trilinear textures, exact integration\n");
  if (textured) append(out, png_line(costs), "\n");
  append(out, "costs: ", line_text(costs.header), "\n");
  return out;
}

}  // namespace etak
