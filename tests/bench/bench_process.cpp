// SPDX-License-Identifier: Apache-2.0
// What starting etak for one answer costs: `etak f0 gold` as a process, beside a process that does nothing.
//
//   bench_process ETAK [RUNS]      RUNS: 50
//
// A tool that is called once per material in a script lives from this number; one shared library that loads a
// hundred others would multiply it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "process.h"

namespace {

struct Case {
  std::string name;
  std::vector<std::string> command;
  std::vector<double> milliseconds = {};
  double peak_mb = 0;
  int exit_code = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: bench_process ETAK [RUNS]\n");
    return 2;
  }
  const std::string etak = argv[1];
  const int runs = argc == 3 ? std::atoi(argv[2]) : 50;
  std::vector<Case> cases{{"true (nothing)", {"true"}},
                          {"etak --version", {etak, "--version"}},
                          {"etak f0 gold", {etak, "f0", "gold"}},
                          {"etak f0 --all", {etak, "f0", "--all"}}};
  try {
    for (int round = 0; round <= runs; ++round)
      for (auto& each : cases) {
        const auto run = bench::run(each.command);
        each.exit_code = std::max(each.exit_code, run.exit_code);
        each.peak_mb = std::max(each.peak_mb, run.peak_mb);
        if (round > 0)
          each.milliseconds.push_back(1e3 * run.wall_s);  // the first run only fills the file cache
      }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_process: %s\n", error.what());
    return 2;
  }
  std::printf("%d runs each, load %.2f, own size %.1f MB\n", runs, bench::load_average(),
              bench::own_peak_mb());
  std::printf("%-18s %10s %8s %10s %8s\n", "", "median ms", "best ms", "95 % ms", "peak MB");
  for (auto& each : cases) {
    std::sort(each.milliseconds.begin(), each.milliseconds.end());
    const std::size_t last = each.milliseconds.size() - 1;
    std::printf("%-18s %10.2f %8.2f %10.2f %8.1f%s\n", each.name.c_str(), bench::median(each.milliseconds),
                each.milliseconds[0], each.milliseconds[last * 95 / 100], each.peak_mb,
                each.exit_code == 0 ? "" : ("  exit code " + std::to_string(each.exit_code)).c_str());
  }
  return 0;
}
