// SPDX-License-Identifier: Apache-2.0
// Family k: what renderers show of films on metals, against the exact stack.
#include <algorithm>
#include <string>
#include <vector>

#include "core/base/number.h"
#include "core/image/files/png.h"
#include "core/study/families/families.h"
#include "core/study/film_ways.h"
#include "core/study/measure.h"

namespace etak {
namespace {

// A table of stacks, and strips where they are one film of growing thickness.
struct Group {
  std::string id, title;
  std::vector<std::string> stacks;
  bool sweep = true;
};

std::vector<Group> groups(int count) {
  return {{"mixed",
           "Twelve stacks",
           {"anatase:25nm/titanium", "anatase:50nm/titanium", "anatase:120nm/titanium",
            "tantala:60nm/tantalum", "niobia:90nm/niobium", "fused_silica:100nm/silicon",
            "fused_silica:300nm/silicon", "sapphire:4nm/aluminum", "hematite:30nm/iron",
            "fused_silica:150nm/gold", "magnesium_fluoride:100nm/aluminum", "silicon_nitride:80nm/copper"},
           false},
          {"titanium", "Titania on titanium, 10 to 400 nm", thicker_films("anatase", "titanium", count)},
          {"niobium", "Niobia on niobium, 10 to 400 nm", thicker_films("niobia", "niobium", count)},
          {"silicon", "Silica on silicon, 10 to 400 nm", thicker_films("fused_silica", "silicon", count)}};
}

ErrorTimeTable table_of(const Group& group, const std::vector<FilmWays>& films,
                        std::vector<TimedSet>& timings) {
  ErrorTimeTable table;
  table.id = group.id;
  table.title = group.title;
  table.metrics = {{"mean_de", "mean colour difference", "\u0394E2000"},
                   {"worst_mean_de", "the same of the worst stack", "\u0394E2000"},
                   {"max_de", "largest at one angle", "\u0394E2000"},
                   {"normal_de", "at normal incidence, mean", "\u0394E2000"}};
  table.base = "gltf_honest";
  std::vector<TimedCase> cases;
  const auto angles = std::make_shared<std::vector<double>>(films.front().truth.cosines);
  for (std::size_t w = 0; w < films.front().ways.size(); ++w) {
    const FilmWay& first = films.front().ways[w];
    ErrorTimeRow row;
    row.id = first.id;
    row.title = first.title;
    row.truth = first.within;
    row.errors = {0, 0, 0, 0};
    for (const FilmWays& film : films) {
      const FilmError error = film_error(film.ways[w].seen, film.truth);
      row.points.push_back({film.text, error.mean, false});
      if (error.mean > row.errors[1]) row.note = "worst: " + film.text;
      row.errors[0] += error.mean / double(films.size());
      row.errors[1] = std::max(row.errors[1], error.mean);
      row.errors[2] = std::max(row.errors[2], error.largest);
      row.errors[3] += error.normal / double(films.size());
    }
    table.rows.push_back(std::move(row));
    cases.push_back({first.id, angles->size(), [seen = first.seen, angles] {
                       double sum = 0;
                       for (const double cosine : *angles) sum += seen(cosine)[1];
                       keep(&sum);
                     }});
  }
  timings.push_back({{table.id}, std::move(cases)});
  return table;
}

}  // namespace

ErrorTimeFamily film_family(const ReportOptions& options) {
  const MaterialLibrary library = MaterialLibrary::builtin();
  const int count = options.full ? 40 : 20;
  ErrorTimeFamily family;
  family.id = "films";
  family.letter = "k";
  family.title = "Films on metals";
  family.reference = "the exact stack, every nanometre, clipped to sRGB, D65";
  family.grid =
      "0 to 84 degrees in steps of 6, weighted by cos sin; " + std::to_string(count) + " thicknesses a film";
  for (const Group& group : groups(count)) {
    const std::vector<FilmWays> films = film_ways(library, group.stacks, options.threads);
    family.tables.push_back(table_of(group, films, family.timed));
    if (group.sweep)
      family.strips.push_back(film_strips(group.title, films, [](const Pixels<std::uint8_t>& picture) {
        return png_bytes(picture, {.srgb = true});
      }));
  }
  const auto error = [&](std::size_t table, std::string_view id) {
    const auto& rows = family.tables[table].rows;
    return number(
        std::find_if(rows.begin(), rows.end(), [&](const ErrorTimeRow& row) { return row.id == id; })
            ->errors[0],
        2);
  };
  family.advice =
      "Never type the index and thickness of an oxide into glTF or OpenPBR: on titanium glTF's colours are off by \u0394E2000 " +
      error(1, "gltf_honest") + ", more than without any film (" + error(1, "bare") + "), and OpenPBR's by " +
      error(1, "openpbr-metal_honest") + ". Fitted numbers in the same fields are off by " +
      error(1, "gltf_fitted") + " and " + error(1, "openpbr-metal_fitted") +
      "; where a renderer takes a table over the angle, 16 colours are exact for every eye (" +
      error(1, "curve") + ").";
  family.picks = {{"films in glTF", "mixed", "gltf_fitted",
                   "the film's index, thickness, factor and the base colour are free",
                   "etak export anodised_titanium_50nm --to gltf"},
                  {"films in a shader of one's own", "mixed", "curve",
                   "exact for the eye, and one text for every stack", "etak render 'anatase:40nm/titanium'"}};
  family.notes = {
      "Honest: F0 and F82 of the bare metal, and index (550 nm) and thickness of the film, as they are measured. Fitted: the numbers within the target's ranges that miss least on the mean.",
      "glTF's form has a base of a real index, which shifts the light's phase by nothing or by half a wave; a metal shifts it by what is between. MaterialX's Schlick form shares this, and gives each polarisation "
      "half of the base's reflectance before it takes the mean of both, so that metals under a film lose half of their light.",
      "Times are of F at one angle."};
  return family;
}

}  // namespace etak
