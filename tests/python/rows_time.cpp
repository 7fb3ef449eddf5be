// SPDX-License-Identifier: Apache-2.0
// The time that C++ takes for the F0 of many spectra, which test_batch.py compares Python with: the same numbers, by the
// same solver, on as many threads.
//   rows_time FILE THREADS REPEATS
// FILE holds two 64-bit counts, of rows and of samples, then doubles: wavelengths, n of every row, k of every row.
// Prints the seconds of the fastest repeat and the sum of all colours.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "core/base/parallel.h"
#include "core/material/f0.h"

namespace {

std::vector<double> read_doubles(std::ifstream& file, std::uint64_t count) {
  std::vector<double> out(count);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): doubles as bytes
  file.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(count * sizeof(double)));
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::ifstream file(argv[1], std::ios::binary);
  std::uint64_t counts[2]{};
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): counts as bytes
  file.read(reinterpret_cast<char*>(counts), sizeof counts);
  const std::uint64_t rows = counts[0], samples = counts[1];
  const std::vector<double> nm = read_doubles(file, samples);
  std::vector<etak::Optics> optics;
  for (std::uint64_t i = 0; i < rows; ++i)
    optics.emplace_back(etak::OpticalConstants{etak::Spectrum{nm, read_doubles(file, samples)}, {}});
  for (std::uint64_t i = 0; i < rows; ++i)
    std::get<etak::OpticalConstants>(optics[i]).k = etak::Spectrum{nm, read_doubles(file, samples)};
  if (!file) return 2;
  const auto threads = static_cast<unsigned>(std::atoi(argv[2]));
  const int repeats = std::atoi(argv[3]);
  double best = 1e9, sum = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    std::vector<etak::LinearRgb> out(rows);
    const auto begin = std::chrono::steady_clock::now();
    const etak::F0Solver solver(etak::F0Options{});
    etak::parallel_chunks(rows, threads, 8, [&](std::size_t first, std::size_t last, unsigned) {
      for (std::size_t i = first; i < last; ++i) out[i] = solver.solve(optics[i]).linear;
    });
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    sum = 0;
    for (const etak::LinearRgb& c : out) sum += c.r + c.g + c.b;
  }
  std::printf("%.9f %.15g\n", best, sum);
}
