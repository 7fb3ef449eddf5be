// SPDX-License-Identifier: Apache-2.0
#include "core/render/ambient/accuracy.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/render/ambient/accuracy_file.h"

namespace etak {
namespace {

// The accuracy of the moving and of the refined picture, by gloss.
using AccuracyRows = std::array<std::array<AmbientAccuracy, 2>, measured_glosses.size()>;

// Lines of model, gloss, and mean, picture, p99 of both pictures behind a header, the glosses of a model in order.
std::map<std::string, AccuracyRows, std::less<>> accuracy_rows() {
  std::map<std::string, AccuracyRows, std::less<>> out;
  std::istringstream lines(accuracy_file);
  std::string line;
  std::size_t row = 0;
  for (std::getline(lines, line); std::getline(lines, line); ++row) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    std::string model;
    double gloss = 0;
    std::array<AmbientAccuracy, 2> each{};
    const std::size_t at = row % measured_glosses.size();
    fields >> model >> gloss;
    for (AmbientAccuracy& form : each) fields >> form.mean >> form.picture >> form.p99;
    if (!fields || gloss != measured_glosses[at])
      throw Error::at("<built-in ambient errors>", line,
                      "model,gloss and mean,picture,p99 of two pictures, at the measured glosses");
    out[model][at] = each;
  }
  return out;
}

}  // namespace

std::optional<AmbientAccuracy> ambient_accuracy(std::string_view model, double gloss, bool refined) {
  static const auto table = accuracy_rows();
  const auto found = table.find(model);
  if (found == table.end()) return std::nullopt;
  const double held = std::clamp(gloss, measured_glosses.front(), measured_glosses.back());
  std::size_t i = 0;
  while (i + 2 < measured_glosses.size() && held > measured_glosses[i + 1]) ++i;
  const double share = (held - measured_glosses[i]) / (measured_glosses[i + 1] - measured_glosses[i]);
  const AmbientAccuracy &a = found->second[i][refined], &b = found->second[i + 1][refined];
  return AmbientAccuracy{std::lerp(a.mean, b.mean, share), std::lerp(a.picture, b.picture, share),
                         std::lerp(a.p99, b.p99, share)};
}

std::string ambient_accuracy_text(std::string_view model, double gloss, bool refined) {
  const auto found = ambient_accuracy(model, gloss, refined);
  if (!found) return "";
  return "mean dE2000 " + number(found->mean, 2) + " (worst picture " + number(found->picture, 2) +
         "), 1 % of its pixels above " + number(found->p99, 2);
}

}  // namespace etak
