// SPDX-License-Identifier: Apache-2.0
// What a coarser integration saves and what it costs: run time per spectrum and error of F0 for every method,
// over all datasets of the built-in library that give a colour.
//
//   bench_methods [ROUNDS]      ROUNDS: 15
//
// Time is of the whole F0Solver::solve (coverage, interpolation, Fresnel at 0 degrees and at cos 1/7, sum,
// colour); error is against `exact`, the quadrature on every knot of data and weights.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "core/material/f0.h"
#include "core/material/library.h"
#include "process.h"

namespace {

using Clock = std::chrono::steady_clock;

struct Sample {
  std::string name;
  etak::Optics optics;
};

std::vector<Sample> usable_samples() {
  std::vector<Sample> out;
  const auto library = etak::MaterialLibrary::builtin();
  const etak::F0Solver solver({});
  for (std::size_t i = 0; i < library.ids().size(); ++i) {
    const auto material = library.at(i);
    for (const auto& dataset : material.datasets)
      if (!solver.solve(dataset.optics).refused())
        out.push_back({material.id + "/" + dataset.id, dataset.optics});
  }
  return out;
}

std::vector<etak::F0Result> solve_all(const etak::F0Solver& solver, const std::vector<Sample>& samples) {
  std::vector<etak::F0Result> out;
  out.reserve(samples.size());
  for (const auto& sample : samples) out.push_back(solver.solve(sample.optics));
  return out;
}

struct Error {
  double most = 0, mean = 0;
  std::size_t codes_changed = 0, worst = 0;
};

Error error(const std::vector<etak::F0Result>& truth, const std::vector<etak::F0Result>& got) {
  Error out;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto a = vec(truth[i].srgb_linear), b = vec(got[i].srgb_linear);
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
    out.mean += largest / static_cast<double>(truth.size());
    if (truth[i].srgb8 != got[i].srgb8) ++out.codes_changed;
    if (largest > out.most) {
      out.most = largest;
      out.worst = i;
    }
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
    const auto samples = usable_samples();
    std::vector<etak::F0Solver> solvers;
    for (const auto method : etak::all_methods) {
      etak::F0Options options;
      options.method = method;
      solvers.emplace_back(options);
    }

    std::array<std::vector<double>, etak::all_methods.size()> nanoseconds;
    double sink = 0;  // keeps the compiler from dropping the work
    for (int round = 0; round < rounds; ++round)
      for (std::size_t m = 0; m < solvers.size(); ++m) {
        const auto start = Clock::now();
        for (const auto& sample : samples) sink += solvers[m].solve(sample.optics).luminance;
        nanoseconds[m].push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count() /
                                 static_cast<double>(samples.size()));
      }

    const auto exact = std::find(etak::all_methods.begin(), etak::all_methods.end(), etak::Method::exact);
    const auto truth =
        solve_all(solvers[static_cast<std::size_t>(exact - etak::all_methods.begin())], samples);
    std::printf("%zu spectra of the built-in library, %d rounds, load %.2f, mean Y %.4f\n", samples.size(),
                rounds, bench::load_average(),
                sink / static_cast<double>(samples.size() * solvers.size()) / rounds);
    std::printf("%-18s %12s %10s %10s %12s  %s\n", "method", "ns/spectrum", "max |dF0|", "mean |dF0|",
                "u8 changed", "worst");
    for (std::size_t m = 0; m < solvers.size(); ++m) {
      const Error e = error(truth, solve_all(solvers[m], samples));
      std::printf("%-18s %12.0f %10.1e %10.1e %11.1f%%  %s\n",
                  std::string(name(etak::all_methods[m])).c_str(), bench::median(nanoseconds[m]), e.most,
                  e.mean, 100 * static_cast<double>(e.codes_changed) / static_cast<double>(samples.size()),
                  e.most > 0 ? samples[e.worst].name.c_str() : "");
    }
    return 0;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "bench_methods: %s\n", failure.what());
    return 2;
  }
}
