// SPDX-License-Identifier: Apache-2.0
// How near renderers come to 1,000 stacks of an oxide or salt on a metal: 10 films, 10 metals, 10 thicknesses from 10 to
// 400 nm.
//   fit_films [FORM] [--threads N] [--every N]
//   FORM     as core/iridescence has it; default gltf
//   --every  only each Nth stack
// For each stack whose fitted numbers miss by more than dE2000 3 on the mean a line with both errors and the numbers; then
// a summary. All but the times is the same from run to run and for any number of threads.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/iridescence/parameters.h"
#include "core/material/library.h"
#include "core/material/stack.h"

namespace etak {
namespace {

constexpr const char* films[] = {"magnesium_fluoride",
                                 "fused_silica",
                                 "sapphire",
                                 "yttria",
                                 "silicon_nitride",
                                 "hafnia",
                                 "tantala",
                                 "niobia",
                                 "anatase",
                                 "hematite"};
constexpr const char* metals[] = {"titanium", "niobium",  "tantalum", "iron",   "chromium",
                                  "tungsten", "aluminum", "copper",   "silver", "gold"};
constexpr int thicknesses = 10;

struct Result {
  std::string text;
  FilmInForm values;
  double ms = 0;
};

std::string stack_text(std::size_t index) {
  const double thickness = 10 * std::pow(40.0, double(index % thicknesses) / (thicknesses - 1));
  char number[32];
  std::snprintf(number, sizeof number, "%.1f", thickness);
  return std::string(films[index / 100]) + ":" + number + "nm/" + metals[index / 10 % 10];
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::size_t(share * double(values.size() - 1))];
}

void print_errors(const char* what, const std::vector<double>& errors) {
  double sum = 0;
  std::size_t near = 0;
  for (const double error : errors) {
    sum += error;
    near += error <= 3;
  }
  std::printf("%s: mean %.2f, median %.2f, 95 %% within %.2f, worst %.2f; at most 3: %.1f %%\n", what,
              sum / double(errors.size()), quantile(errors, 0.5), quantile(errors, 0.95), quantile(errors, 1),
              100 * double(near) / double(errors.size()));
}

int run(const FilmForm& form, unsigned threads, std::size_t every) {
  const MaterialLibrary library = MaterialLibrary::builtin();
  std::vector<Result> all((1000 + every - 1) / every);
  parallel_chunks(all.size(), threads, 1, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      Result& out = all[i];
      out.text = stack_text(i * every);
      const Material material =
          stack_material(out.text, [&](std::string_view name, const std::string& place) {
            return library_part(library, name, place);
          });
      const auto start = std::chrono::steady_clock::now();
      const FilmForm* const one = &form;
      const FilmParameters parameters = film_parameters(std::get<Stack>(material.preferred_dataset().optics),
                                                        FilmBase::metal, {}, {&one, 1});
      out.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      out.values = parameters.forms.at(0);
    }
  });
  std::vector<double> honest, fitted, ms;
  for (const Result& each : all) {
    honest.push_back(each.values.honest->error.mean);
    fitted.push_back(each.values.fitted.error.mean);
    ms.push_back(each.ms);
    if (!(fitted.back() > 3)) continue;
    std::printf("%s: %.2f, honest %.2f;", each.text.c_str(), fitted.back(), honest.back());
    for (std::size_t i = 0; i < form.numbers.size(); ++i)
      std::printf(" %s %.4g", std::string(form.numbers[i].name).c_str(), each.values.fitted.numbers[i]);
    std::printf("\n");
  }
  std::printf("%zu stacks, %s\n", all.size(), std::string(form.title).c_str());
  print_errors("honest", honest);
  print_errors("fitted", fitted);
  std::fprintf(stderr, "a stack takes %.0f ms, at most %.0f\n", quantile(ms, 0.5), quantile(ms, 1));
  return 0;
}

}  // namespace
}  // namespace etak

int main(int count, char** arguments) {
  using namespace etak;
  const FilmForm* form = film_form("gltf");
  unsigned threads = 1;
  std::size_t every = 1;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    if (word == "--threads" && i + 1 < count)
      threads = thread_count(unsigned(std::atoi(arguments[++i])));
    else if (word == "--every" && i + 1 < count)
      every = std::size_t(std::max(1, std::atoi(arguments[++i])));
    else
      form = film_form(word);
  }
  if (form == nullptr) {
    std::fprintf(stderr, "fit_films: no such form; one of:");
    for (const FilmForm* each : film_forms()) std::fprintf(stderr, " %s", std::string(each->id).c_str());
    std::fprintf(stderr, "\n");
    return 2;
  }
  try {
    return run(*form, threads, every);
  } catch (const Error& error) {
    std::fprintf(stderr, "fit_films: %s\n", error.what());
    return 2;
  }
}
