// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/number.h"
#include "core/base/text.h"
#include "core/report/choose.h"

namespace etak {
namespace {

std::string cell(std::string text, std::size_t width) {
  text.append(width - std::min(width, display_width(text)), ' ');
  return text + "  ";
}

std::string looked_at(const std::vector<Candidate>& candidates) {
  std::string out;
  for (const Candidate& each : candidates)
    append(out, out.empty() ? "" : ", ", each.id, " ", number(each.error, 3), each.within ? "" : " (over)");
  return out;
}

}  // namespace

std::string choice_text(const std::vector<Choice>& choices, const CostTable& costs) {
  std::size_t widest = 8;
  for (const Choice& each : choices) widest = std::max(widest, each.material.size());
  std::string out = cell("material", widest) + cell("fresnel", 18) + cell("masking", 24) +
                    cell("integration", 18) + cell("worst pixel", 11) + cell("any angle", 9) +
                    "ns, everything -> chosen\n";
  for (const Choice& each : choices)
    out += cell(each.material, widest) + cell(std::string(each.fresnel->id), 18) + cell(each.visibility, 24) +
           cell(each.method, 18) + cell(number(each.picture_error, 3), 11) +
           cell(number(each.fresnel_error, 3), 9) + number(each.everything_ns, 3) + " -> " +
           number(each.chosen_ns, 3) + "\n";
  if (choices.size() == 1) {
    const Choice& one = choices[0];
    append(out, "\nlooked at, cheapest first, with the largest ΔE2000:\n  fresnel      ",
           looked_at(one.fresnel_candidates));
    append(out, "\n  masking      ", looked_at(one.visibility_candidates), "\n  integration  ",
           looked_at(one.method_candidates), "\n");
    append(out, "\nshader: etak shader ", one.material, " --model ", one.model, "\n");
  }
  if (!choices.empty())
    append(out, "\nbudget ", number(choices[0].budget, 6),
           " ΔE2000 for F at every angle and every pixel of the sphere; everything: F at every nanometre, "
           "GGX, Smith masking "
           "by height, exact integration\ncosts: ",
           costs.header, "\n");
  return out;
}

}  // namespace etak
