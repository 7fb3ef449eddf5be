// SPDX-License-Identifier: Apache-2.0
// The only source that includes Google Benchmark.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "core/study/error_time.h"

namespace etak {
namespace {

// Keeps the shortest time of every case; prints nothing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  std::map<std::string, double> seconds;  // of one iteration, by case

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double once = run.real_accumulated_time / static_cast<double>(run.iterations);
      const auto [at, added] = seconds.try_emplace(run.run_name.function_name, once);
      if (!added) at->second = std::min(at->second, once);
    }
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

// How often the body is called in a repeat of that many seconds. Each number of calls is tried twice, and the
// shorter time counts, because one try may have been interrupted.
benchmark::IterationCount calls_in(double seconds, const std::function<void()>& body) {
  using Clock = std::chrono::steady_clock;
  double least = std::numeric_limits<double>::infinity();
  for (benchmark::IterationCount calls = 1;; calls *= 4) {
    for (int tries = 0; tries < 2; ++tries) {
      const auto start = Clock::now();
      for (benchmark::IterationCount i = 0; i < calls; ++i) body();
      const std::chrono::duration<double> took = Clock::now() - start;
      least = std::min(least, took.count() / static_cast<double>(calls));
    }
    if (4 * least * static_cast<double>(calls) >= seconds) break;
  }
  return static_cast<benchmark::IterationCount>(std::clamp(std::ceil(seconds / least), 1.0, 1e8));
}

// Repeats cases in rounds and keeps the shortest repeat of each round.
class Rounds {
 public:
  Rounds(std::span<const TimedCase> cases, const TimingOptions& options)
      : cases_(cases),
        options_(options),
        repeats_(std::clamp<std::size_t>(options.repeats, 1, repeats_a_round)),
        all_(std::max<std::size_t>(1, (options.repeats + repeats_ - 1) / repeats_) * repeats_ * cases.size()),
        calls_(cases.size()),
        least_ns_(cases.size()) {
    const double seconds =
        options.seconds_a_case / static_cast<double>(std::max<std::size_t>(1, options.repeats));
    for (std::size_t i = 0; i < cases.size(); ++i)
      calls_[i] = seconds > 0 ? calls_in(seconds, cases[i].body) : 1;
  }

  std::size_t first_rounds() const { return all_ / (repeats_ * cases_.size()); }

  /// Repeats the cases of `which` a few times in a changing order; the other cases get NaN.
  void add_round(const std::vector<bool>& which) {
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (which[i])
        enlist(std::to_string(i), calls_[i], [this, &body = cases_[i].body](benchmark::State& state) {
          if (options_.progress) options_.progress(std::min(done_, all_), all_);
          ++done_;
          for ([[maybe_unused]] auto _ : state) body();
        });
    const auto seconds = run();
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      const double to_ns = 1e9 / static_cast<double>(cases_[i].evaluations);
      least_ns_[i].push_back(which[i] ? seconds.at(std::to_string(i)) * to_ns
                                      : std::numeric_limits<double>::quiet_NaN());
    }
  }

  double empty_loop_ns() const {
    enlist("empty", 1000000, [](benchmark::State& state) {
      for ([[maybe_unused]] auto _ : state) benchmark::ClobberMemory();
    });
    return run().at("empty") * 1e9;
  }

  std::vector<RunTime> times() const {
    std::vector<RunTime> out;
    for (const std::vector<double>& rounds : least_ns_) {
      std::vector<double> timed, ratios;
      for (std::size_t r = 0; r < rounds.size(); ++r) {
        if (std::isfinite(rounds[r])) timed.push_back(rounds[r]);
        if (const double ratio = rounds[r] / least_ns_[0][r]; std::isfinite(ratio)) ratios.push_back(ratio);
      }
      out.push_back({quantile(timed, 0.5), quantile(timed, 0.25), quantile(timed, 0.75),
                     quantile(ratios, 0.5), quantile(timed, 0), rounds});
    }
    return out;
  }

 private:
  template <class Loop>
  void enlist(const std::string& name, benchmark::IterationCount calls, Loop loop) const {
    benchmark::RegisterBenchmark(name.c_str(), loop)
        ->Repetitions(static_cast<int>(repeats_))
        ->Iterations(calls)
        ->UseRealTime();
  }
  static std::map<std::string, double> run() {
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    benchmark::ClearRegisteredBenchmarks();
    return collector.seconds;
  }

  std::span<const TimedCase> cases_;
  const TimingOptions& options_;
  std::size_t repeats_;  // of a case in a round
  std::size_t all_, done_ = 0;
  std::vector<benchmark::IterationCount> calls_;
  std::vector<std::vector<double>> least_ns_;  // by case and round
};

}  // namespace

std::vector<RunTime> time_cases(std::span<const TimedCase> cases, const TimingOptions& options,
                                const OpenCases& open, double* empty_loop_ns) {
  if (cases.empty()) return {};
  set_flag_of_library();
  Rounds rounds(cases, options);
  const std::vector<bool> every(cases.size(), true);
  for (std::size_t r = 0; r < rounds.first_rounds(); ++r) rounds.add_round(every);
  if (open) {
    for (std::size_t r = 0;; ++r) {
      const std::vector<bool> which = open(rounds.times());
      if (std::find(which.begin(), which.end(), true) == which.end() || r == options.more_rounds ||
          (options.until && std::chrono::steady_clock::now() > *options.until))
        break;
      rounds.add_round(which);
    }
  }
  if (empty_loop_ns != nullptr) *empty_loop_ns = rounds.empty_loop_ns();
  return rounds.times();
}

}  // namespace etak
