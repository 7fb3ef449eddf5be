// SPDX-License-Identifier: Apache-2.0
#include "core/study/film_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/base/text/text.h"
#include "core/color/srgb.h"
#include "core/fresnel/curve.h"
#include "core/fresnel/fresnel.h"
#include "core/material/seen_stack.h"
#include "core/math/functions.h"

namespace etak {
namespace {

constexpr double first_nm = 10, last_nm = 400;

constexpr const char* own_shader = "a shader of one's own";

struct FormName {
  const char *id, *name, *within;
};
constexpr std::array form_names{
    FormName{"gltf", "glTF iridescence", "glTF"},
    FormName{"openpbr-metal", "OpenPBR in MaterialX", "OpenPBR"},
    FormName{"openpbr-adobe-metal", "OpenPBR by Adobe", "OpenPBR by Adobe"},
    FormName{"conductor_bsdf", "n, k of red, green, blue with film", "MaterialX conductor"},
    FormName{"f82", "F0 and F82 of the whole", own_shader}};

void add_form(FilmWays& out, const FilmInForm& values, const FormName& name) {
  const auto add = [&](const FilmValues& each, const char* kind) {
    const FilmForm* form = values.form;
    out.ways.push_back(
        {std::string(form->id) + '_' + kind, std::string(name.name) + ", " + kind, name.within,
         [form, numbers = each.numbers](double cosine) { return form->seen(numbers, cosine); }});
  };
  add(*values.honest, "honest");
  add(values.fitted, "fitted");
}

FilmWays ways_of(const MaterialLibrary& library, const std::string& text) {
  const Material material = *library.find(text);
  const Stack& stack = std::get<Stack>(material.preferred_dataset().optics);
  const auto seen = [&](Method sum) -> std::function<Vec3(double)> {
    return [exact = std::make_shared<SeenStack>(stack, F0Options{}, sum)](double cosine) {
      return (*exact)(cosine);
    };
  };
  FilmWays out{text, {}, {{"exact", "exact, every nanometre", own_shader, seen(Method::nm1)}}};
  const std::function<Vec3(double)> exact = out.ways.front().seen;
  out.truth = film_truth(exact);
  out.ways.push_back({"sum_5nm", "exact, every 5 nm", own_shader, seen(Method::nm5)});
  out.ways.push_back({"sum_10nm", "exact, every 10 nm", own_shader, seen(Method::nm10)});
  out.ways.push_back({"sum_20nm", "exact, every 20 nm", own_shader, seen(Method::nm20)});
  out.ways.push_back({"curve", "curve of 16 colours", own_shader,
                      [curve = fitted_curve(exact)](double cosine) { return curve.at(cosine); }});
  std::vector<const FilmForm*> forms;
  for (const FormName& each : form_names) forms.push_back(film_form(each.id));
  const FilmParameters parameters = film_parameters(stack, FilmBase::metal, {}, forms);
  for (const FormName& each : form_names) add_form(out, *parameters.in(each.id), each);
  Stack bare = stack;
  bare.layers.clear();
  const SeenStack base(bare);
  const FilmFacts facts{.whole_f0 = to_rgb(base(1)), .whole_f82 = to_rgb(base(f82_cosine))};
  const FilmForm* f82 = film_form("f82");
  out.ways.push_back(
      {"bare", "the bare metal, F0 and F82", own_shader,
       [f82, numbers = f82->honest(facts)](double cosine) { return f82->seen(numbers, cosine); }});
  return out;
}

// Thickness from left to right, angle downwards, every 3 degrees.
Pixels<std::uint8_t> strip_of(const std::vector<FilmWays>& films, std::size_t way) {
  Pixels<std::uint8_t> out;
  out.width = int(films.size());
  out.height = 29;
  out.channels = 3;
  for (int y = 0; y < out.height; ++y)
    for (const FilmWays& film : films) {
      const Srgb8 codes = srgb_u8(to_rgb(film.ways[way].seen(math::cos(3.0 * y * std::numbers::pi / 180))));
      out.values.insert(out.values.end(), {codes.r, codes.g, codes.b});
    }
  return out;
}

}  // namespace

std::vector<FilmWays> film_ways(const MaterialLibrary& library, const std::vector<std::string>& stacks,
                                unsigned threads) {
  std::vector<FilmWays> out(stacks.size());
  parallel_chunks(out.size(), threads, 1, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) out[i] = ways_of(library, stacks[i]);
  });
  return out;
}

std::vector<std::string> thicker_films(const std::string& film, const std::string& metal, int count) {
  std::vector<std::string> out;
  for (int i = 0; i < count; ++i)
    out.push_back(film + ':' + number(first_nm + (last_nm - first_nm) * i / (count - 1), 5) + "nm/" + metal);
  return out;
}

ErrorTimeStrips film_strips(std::string title, const std::vector<FilmWays>& films,
                            const std::function<std::string(const Pixels<std::uint8_t>&)>& png) {
  ErrorTimeStrips out{
      std::move(title),
      "thickness of the film from " + number(first_nm, 3) + " to " + number(last_nm, 3) + " nm",
      "angle of incidence from 0\u00b0 down to 84\u00b0",
      {}};
  const std::vector<FilmWay>& ways = films.front().ways;
  for (const char* id :
       {"exact", "gltf_honest", "gltf_fitted", "openpbr-metal_honest", "openpbr-metal_fitted"}) {
    const auto found =
        std::find_if(ways.begin(), ways.end(), [&](const FilmWay& each) { return each.id == id; });
    const auto way = static_cast<std::size_t>(found - ways.begin());
    double mean = 0;
    for (const FilmWays& film : films)
      mean += film_error(film.ways[way].seen, film.truth).mean / double(films.size());
    out.ways.push_back({way == 0 ? "The truth" : found->title, way == 0 ? "" : "\u0394E " + fixed(mean, 1),
                        png(strip_of(films, way))});
  }
  return out;
}

}  // namespace etak
