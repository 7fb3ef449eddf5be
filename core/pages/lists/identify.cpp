// SPDX-License-Identifier: Apache-2.0
#include "core/pages/lists/identify.h"

#include <algorithm>
#include <span>

#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/base/text/text_table.h"
#include "core/color/srgb.h"
#include "core/pages/swatch.h"

namespace etak {
namespace {

constexpr std::string_view identify_schema = "etak-identify/1";
constexpr int json_digits = 6;
constexpr std::size_t most_shown = 8;  // rows of a table; JSON has all

std::string json_number(double value) {
  return number(value, json_digits);
}

std::string json_pair(const std::array<double, 2>& pair) {
  return "[" + json_number(pair[0]) + ", " + json_number(pair[1]) + "]";
}

const std::string& id_of(const Identified& answer, std::size_t index) {
  return answer.candidates[index].entry->id;
}

std::string candidate_object(const PossibleMaterial& each) {
  return json_object({{"id", json(each.entry->id)},
                      {"p", json_number(each.p)},
                      {"delta_e", json_number(each.delta_e)},
                      {"band_share", json_number(each.band_share)}},
                     -1);
}

std::string color_object(const IdentifiedColor& each) {
  std::vector<std::string> groups;
  for (const auto& group : each.answer.groups) {
    std::vector<std::string> ids;
    for (const std::size_t index : group) ids.push_back(json(id_of(each.answer, index)));
    groups.push_back(json_array(ids));
  }
  std::vector<JsonMember> out{{"input", json(valid_utf8(each.input))},
                              {"verdict", json(name(each.answer.verdict))},
                              {"candidates", json_lines_of(each.answer.candidates, 6, candidate_object)},
                              {"groups", json_array(groups)}};
  if (each.area_share) out.insert(out.begin() + 1, {"area_share", json_number(*each.area_share)});
  return json_object(out, 4);
}

std::string film_object(const FilmOnMetal& each) {
  return json_object({{"film", json(each.film)},
                      {"metal", json(each.metal)},
                      {"thickness_nm", json_number(each.fit.thickness_nm)},
                      {"interval_nm", json_pair(each.fit.interval_nm)},
                      {"delta_e", json_number(each.fit.misfit)}},
                     -1);
}

std::string_view verdict_of(std::size_t answers) {
  return name(answers == 0   ? ColourVerdict::none
              : answers == 1 ? ColourVerdict::sure
                             : ColourVerdict::ambiguous);
}

std::string films_object(const IdentifiedFilm& each) {
  return json_object({{"input", json(valid_utf8(each.input))},
                      {"verdict", json(verdict_of(each.answers.size()))},
                      {"answers", json_lines_of(each.answers, 6, film_object)}},
                     4);
}

std::string fit_members(const FittedThickness& fit) {
  return json_object({{"thickness_nm", json_number(fit.thickness_nm)},
                      {"interval_nm", json_pair(fit.interval_nm)},
                      {"rms", json_number(fit.misfit)}},
                     -1);
}

std::string thickness_object(const IdentifiedThickness& answer) {
  const SpectrumFit& fit = answer.fit;
  return json_object({{"input", json(valid_utf8(answer.input))},
                      {"stack", json(answer.stack)},
                      {"thickness_nm", json_number(fit.best.thickness_nm)},
                      {"interval_nm", json_pair(fit.best.interval_nm)},
                      {"rms", json_number(fit.best.misfit)},
                      {"delta_e", fit.delta_e ? json_number(*fit.delta_e) : "null"},
                      {"others", json_lines_of(fit.others, 6, fit_members)}},
                     4);
}

std::string nm(double value) {
  return fixed(value, 1) + " nm";
}

std::string interval_text(const FittedThickness& fit) {
  return nm(fit.thickness_nm) + " (" + fixed(fit.interval_nm[0], 1) + " to " + nm(fit.interval_nm[1]) + ")";
}

std::string_view words_of(ColourVerdict verdict) {
  constexpr std::array<std::string_view, 3> words{
      "sure", "ambiguous",
      "none fits: the colour lies outside of what nine of ten publications of any material would give"};
  return words[static_cast<std::size_t>(verdict)];
}

}  // namespace

std::string identify_text(std::span<const IdentifiedColor> answers, bool color) {
  std::string out;
  for (const IdentifiedColor& each : answers) {
    append(out, out.empty() ? "" : "\n", line_text(each.input),
           each.area_share ? ", " + number(100 * *each.area_share, 3) + " % of the texels: " : ": ",
           words_of(each.answer.verdict), '\n');
    std::vector<TextRow> rows{
        {{"p", "dE", "of band", "sRGB   ", "id", "name", "class"}, color ? "     " : "  "}};
    const std::vector<PossibleMaterial>& all = each.answer.candidates;
    const std::size_t shown = std::min(all.size(), most_shown);
    double left = 0;
    for (std::size_t i = shown; i < all.size(); ++i) left += all[i].p;
    for (const PossibleMaterial& candidate : std::span(all).first(shown)) {
      const Hypothesis& known = *candidate.entry;
      rows.push_back({{fixed(candidate.p, 2), fixed(candidate.delta_e, 1), fixed(candidate.band_share, 2),
                       hex(known.codes), known.id, known.name, known.material_class},
                      color ? swatch(known.codes, 2) + "   " : "  "});
    }
    out += text_table(rows);
    if (all.size() > shown)
      append(out, "  and ", std::to_string(all.size() - shown), " more, ", fixed(left, 2), " together\n");
    for (const auto& group : each.answer.groups) {
      std::vector<std::string> ids;
      for (const std::size_t index : group)
        if (index < shown) ids.push_back(id_of(each.answer, index));
      if (ids.size() > 1) append(out, "  not told apart: ", joined(ids), '\n');
    }
  }
  return out;
}

std::string identify_json(std::span<const IdentifiedColor> answers) {
  return json_document(identify_schema, {{"results", json_lines_of(answers, 2, color_object)}});
}

std::string identify_text(std::span<const IdentifiedFilm> answers) {
  std::string out;
  for (const IdentifiedFilm& each : answers) {
    append(out, out.empty() ? "" : "\n", line_text(each.input), ": ",
           each.answers.empty() ? "no thickness up to 1 um of these films has this colour"
                                : verdict_of(each.answers.size()),
           '\n');
    if (each.answers.empty()) continue;
    std::vector<TextRow> rows{{{"dE", "film", "metal", "thickness"}, "  "}};
    for (const FilmOnMetal& answer : each.answers)
      rows.push_back(
          {{fixed(answer.fit.misfit, 2), answer.film, answer.metal, interval_text(answer.fit)}, "  "});
    out += text_table(rows);
  }
  return out;
}

std::string identify_json(std::span<const IdentifiedFilm> answers) {
  return json_document(identify_schema, {{"results", json_lines_of(answers, 2, films_object)}});
}

std::string identify_text(const IdentifiedThickness& answer) {
  const SpectrumFit& fit = answer.fit;
  std::string out = line_text(answer.input) + " as " + line_text(answer.stack) + ": " +
                    interval_text(fit.best) + ", rms " + number(fit.best.misfit, 3) +
                    (fit.delta_e ? ", dE " + fixed(*fit.delta_e, 1) : "") + '\n';
  for (const FittedThickness& each : fit.others)
    append(out, "  or ", interval_text(each), ", rms ", number(each.misfit, 3), '\n');
  return out;
}

std::string identify_json(const IdentifiedThickness& answer) {
  return json_document(identify_schema,
                       {{"results", json_lines_of(std::span(&answer, 1), 2, thickness_object)}});
}

}  // namespace etak
