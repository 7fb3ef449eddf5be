// SPDX-License-Identifier: Apache-2.0
// The only source that includes Google Benchmark.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "core/study/error_time.h"

namespace etak {
namespace {

// Keeps the time of every repeat; prints nothing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  // Seconds of one iteration, by case, in the order of the repeats.
  std::map<std::string, std::vector<double>> seconds;

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration && !run.error_occurred)
        seconds[run.run_name.function_name].push_back(run.real_accumulated_time /
                                                      static_cast<double>(run.iterations));
  }
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

void set_flag_of_library() {
  // The library offers interleaving only as a flag of its command line.
  static std::once_flag once;
  std::call_once(once, [] {
    char name[] = "etak", interleave[] = "--benchmark_enable_random_interleaving=true";
    char quiet[] = "--v=0";  // else an environment variable V would make the library print
    char* arguments[] = {name, interleave, quiet, nullptr};
    int count = 3;
    benchmark::Initialize(&count, arguments);
  });
}

}  // namespace

std::vector<RunTime> time_cases(std::span<const TimedCase> cases, const TimingOptions& options,
                                double* empty_loop_ns) {
  if (cases.empty()) return {};
  set_flag_of_library();
  const double seconds_a_repeat =
      std::max(1e-6, options.seconds_a_case / static_cast<double>(std::max<std::size_t>(1, options.repeats)));
  const auto enlist = [&](const std::string& name, auto loop) {
    benchmark::RegisterBenchmark(name.c_str(), loop)
        ->Repetitions(static_cast<int>(options.repeats))
        ->MinTime(seconds_a_repeat)
        ->UseRealTime();
  };
  // The library calls each case a few times more than it repeats it, to find the number of iterations of a
  // repeat. These calls are no progress.
  std::vector<std::size_t> calls(cases.size());
  std::size_t done = 0;
  const auto tell = [&](std::size_t i) {
    if (!options.progress) return;
    done += calls[i]++ < options.repeats;
    options.progress(done, options.repeats * cases.size());
  };
  for (std::size_t i = 0; i < cases.size(); ++i)
    enlist(std::to_string(i), [&, i, &body = cases[i].body](benchmark::State& state) {
      tell(i);
      for ([[maybe_unused]] auto _ : state) body();
    });
  if (empty_loop_ns != nullptr)
    enlist("empty", [](benchmark::State& state) {
      for ([[maybe_unused]] auto _ : state) benchmark::ClobberMemory();
    });
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();

  const auto& base = collector.seconds.at("0");
  std::vector<RunTime> out;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& seconds = collector.seconds.at(std::to_string(i));
    const double to_ns = 1e9 / static_cast<double>(cases[i].evaluations);
    RunTime time{quantile(seconds, 0.5) * to_ns, quantile(seconds, 0.25) * to_ns,
                 quantile(seconds, 0.75) * to_ns, 1, quantile(seconds, 0) * to_ns};
    std::vector<double> ratios;
    for (std::size_t r = 0; r < std::min(seconds.size(), base.size()); ++r)
      ratios.push_back(seconds[r] / static_cast<double>(cases[i].evaluations) /
                       (base[r] / static_cast<double>(cases[0].evaluations)));
    time.ratio = quantile(ratios, 0.5);
    out.push_back(time);
  }
  if (empty_loop_ns != nullptr) *empty_loop_ns = quantile(collector.seconds.at("empty"), 0.5) * 1e9;
  return out;
}

}  // namespace etak
