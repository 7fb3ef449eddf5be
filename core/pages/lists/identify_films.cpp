// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/parallel.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/exchange/table.h"
#include "core/material/names.h"
#include "core/material/stack_text.h"
#include "core/pages/lists/identify.h"

namespace etak {
namespace {

// How far a film's colour may lie from the one that is asked for; of 8-bit codes their step is added.
constexpr double film_tolerance = 1, code_tolerance = 0.5;

Stack stack_named(const StackText& text, const MaterialLibrary& library) {
  const Material material = *library.find(format_stack(text));
  return std::get<Stack>(material.preferred_dataset().optics);
}

}  // namespace

std::span<const std::string_view> usual_films() {
  static constexpr std::array<std::string_view, 7> films{
      "titania_amorphous", "tantala", "niobia", "sapphire", "fused_silica", "hematite", "zincite"};
  return films;
}

std::vector<FilmOnMetal> films_of_color(const FilmQuestion& question, const AskedColour& asked,
                                        const MaterialLibrary& library, const F0Solver& solver,
                                        unsigned threads) {
  std::vector<std::string> films = question.films;
  if (films.empty()) films.assign(usual_films().begin(), usual_films().end());
  std::vector<std::vector<FilmOnMetal>> found(films.size());
  parallel_chunks(films.size(), threads, 1, [&](std::size_t i, std::size_t, unsigned) {
    StackText text{{{films[i], 0.0, true, ":0nm"}}, question.metal};
    const Stack stack = stack_named(text, library);
    const double tolerance = film_tolerance + (asked.eight_bit ? code_tolerance : 0);
    for (const FittedThickness& fit : thickness_of_colour(stack, 0, asked.f0, tolerance, solver.options()))
      found[i].push_back({stack.media[stack.layers[0].medium].id, stack.media[stack.base].id, fit});
  });
  std::vector<FilmOnMetal> out;
  for (const auto& each : found) out.insert(out.end(), each.begin(), each.end());
  std::stable_sort(out.begin(), out.end(),
                   [](const FilmOnMetal& a, const FilmOnMetal& b) { return a.fit.misfit < b.fit.misfit; });
  return out;
}

IdentifiedThickness identified_thickness(const std::string& file, const std::string& stack,
                                         const MaterialLibrary& library, const F0Solver& solver) {
  const std::string place = setting("stack");
  if (stack.empty())
    throw Error::at(setting("measured"), "without " + place,
                    "a stack with one unknown thickness, such as polystyrene:?nm/silicon");
  StackText text = parse_stack(stack, place);
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < text.layers.size(); ++i)
    if (!text.layers[i].thickness_nm) unknown.push_back(i);
  if (unknown.size() != 1)
    throw Error::at(place, std::to_string(unknown.size()) + " unknown thicknesses in " + printable(stack, 80),
                    "one, written ?nm");
  set_thickness(text.layers[unknown[0]], 0);
  const Stack known = stack_named(text, library);
  const Table table = parse_table(read_file(file), file, TableOptions{});
  const auto* reflectance = std::get_if<Reflectance>(&table.optics);
  if (reflectance == nullptr)
    throw Error::at(file, "holds n and k", "a table of wavelength and reflectance R");
  return {file, stack, thickness_of_spectrum(known, unknown[0], reflectance->spectrum, solver.options())};
}

}  // namespace etak
