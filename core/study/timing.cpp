// SPDX-License-Identifier: Apache-2.0
// The only source that includes Google Benchmark.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <list>
#include <map>
#include <mutex>

#include "core/study/error_time.h"
#include "core/study/measure.h"

namespace etak {
namespace {

// Which time of a repeat counts: that of the wall clock, or the processor time of the thread that runs it.
enum class Clock { wall, thread };

double seconds_by(Clock clock) {
  timespec now{};
  clock_gettime(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Keeps the shortest time of every case; prints nothing.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(Clock clock) : clock_(clock) {}
  std::map<std::string, double> seconds;  // of one iteration, by case

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double all = clock_ == Clock::wall ? run.real_accumulated_time : run.cpu_accumulated_time;
      const double once = all / static_cast<double>(run.iterations);
      const auto [at, added] = seconds.try_emplace(run.run_name.function_name, once);
      if (!added) at->second = std::min(at->second, once);
    }
  }

 private:
  Clock clock_;
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

// Calls of a case in one repeat, and how long a call takes.
struct Calls {
  benchmark::IterationCount count = 1;
  double seconds = 0;
};

// The calls in a repeat of that many seconds. Each number of calls is tried twice, and the shorter time
// counts, because one try may have been interrupted; a call that takes longer than a repeat is tried once.
Calls calls_in(double seconds, Clock clock, const std::function<void()>& body) {
  double least = std::numeric_limits<double>::infinity();
  for (benchmark::IterationCount calls = 1;; calls *= 4) {
    for (int tries = 0; tries < 1 || (tries < 2 && least < seconds); ++tries) {
      const double start = seconds_by(clock);
      for (benchmark::IterationCount i = 0; i < calls; ++i) body();
      least = std::min(least, (seconds_by(clock) - start) / static_cast<double>(calls));
    }
    if (4 * least * static_cast<double>(calls) >= seconds) break;
  }
  return {static_cast<benchmark::IterationCount>(std::clamp(std::ceil(seconds / least), 1.0, 1e8)), least};
}

// Repeats cases in rounds and keeps the shortest repeat of each round.
class Rounds {
 public:
  Rounds(std::span<const TimedCase> cases, const TimingOptions& options, Clock clock)
      : cases_(cases), options_(options), clock_(clock), least_ns_(cases.size()) {
    const std::size_t repeats = std::max<std::size_t>(1, options.repeats);
    const double seconds = options.seconds_a_case / static_cast<double>(repeats);
    double once = 0;  // seconds for a repeat of every case
    for (const TimedCase& each : cases) {
      calls_.push_back(calls_in(seconds, clock, each.body));
      once += static_cast<double>(calls_.back().count) * calls_.back().seconds;
    }
    // For long calls, rounds of a single repeat tell more than fewer rounds of several.
    const auto fit = static_cast<std::size_t>(
        std::clamp(options.most_seconds / std::max(once, 1e-9), 1.0, static_cast<double>(repeats)));
    repeats_ = fit < repeats ? 1 : std::min(repeats, repeats_a_round);
    first_rounds_ = std::max<std::size_t>(1, (fit + repeats_ - 1) / repeats_);
    all_ = first_rounds_ * repeats_ * cases.size();
  }

  /// How many rounds there should be in which all cases take part.
  std::size_t first_rounds() const { return first_rounds_; }

  /// Repeats the cases of `which` a few times in a changing order; the other cases get NaN.
  void add_round(const std::vector<bool>& which) {
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (which[i])
        enlist(std::to_string(i), calls_[i].count, [this, &body = cases_[i].body](benchmark::State& state) {
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

  /// The seconds that a round of these cases takes.
  double seconds_of(const std::vector<bool>& which) const {
    double out = 0;
    for (std::size_t i = 0; i < which.size(); ++i)
      if (which[i])
        out += static_cast<double>(repeats_) * static_cast<double>(calls_[i].count) * calls_[i].seconds;
    return out;
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
      std::vector<double> timed;
      for (const double each : rounds)
        if (std::isfinite(each)) timed.push_back(each);
      out.push_back({quantile(timed, 0.5), quantile(timed, 0.25), quantile(timed, 0.75), 1,
                     quantile(timed, 0), rounds});
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
  std::map<std::string, double> run() const {
    Collector collector(clock_);
    benchmark::RunSpecifiedBenchmarks(&collector);
    benchmark::ClearRegisteredBenchmarks();
    return std::move(collector.seconds);
  }

  std::span<const TimedCase> cases_;
  const TimingOptions& options_;
  Clock clock_;
  std::size_t repeats_ = 1;  // of a case in a round
  std::size_t first_rounds_ = 1, all_ = 0, done_ = 0;
  std::vector<Calls> calls_;
  std::vector<std::vector<double>> least_ns_;  // by case and round
};

/// A set of cases of a family while it is timed.
class SetTimer {
 public:
  SetTimer(ErrorTimeFamily& family, const TimedSet& set, const TimingOptions& options)
      : family_(family),
        set_(set),
        rounds_(set.cases, options, set.starts_threads ? Clock::wall : Clock::thread),
        open_(set.cases.size(), true) {
    add_round();
  }

  bool settled() const { return std::find(open_.begin(), open_.end(), true) == open_.end(); }
  /// Whether it had the rounds in which all cases take part.
  bool had_first() const { return done_ >= rounds_.first_rounds(); }
  /// The seconds of the next round.
  double seconds() const { return rounds_.seconds_of(open_); }
  void add_round() {
    rounds_.add_round(open_);
    put(rounds_.times());
    if (++done_ < rounds_.first_rounds()) open_.assign(open_.size(), true);
  }

 private:
  // Sets the times and verdicts of the tables, and which cases are open.
  void put(std::span<const RunTime> times) {
    open_.assign(set_.cases.size(), false);
    for (ErrorTimeTable& table : family_.tables) {
      if (std::find(set_.tables.begin(), set_.tables.end(), table.id) == set_.tables.end()) continue;
      for (ErrorTimeRow& row : table.rows)
        if (const std::size_t i = case_of(row); i < times.size()) row.time = in_unit(times[i], set_.scale);
      set_ratios(table);
      set_verdicts(table);
      const std::vector<bool> rows = open_rows(table);
      for (std::size_t r = 0; r < rows.size(); ++r)
        if (rows[r]) open_.at(case_of(table.rows[r])) = true;
    }
  }
  std::size_t case_of(const ErrorTimeRow& row) const {
    const auto& cases = set_.cases;
    return static_cast<std::size_t>(
        std::find_if(cases.begin(), cases.end(), [&](const TimedCase& each) { return each.id == row.id; }) -
        cases.begin());
  }

  ErrorTimeFamily& family_;
  const TimedSet& set_;
  Rounds rounds_;
  std::vector<bool> open_;  // which cases take part in the next round
  std::size_t done_ = 0;    // rounds
};

}  // namespace

std::vector<RunTime> time_cases(std::span<const TimedCase> cases, const TimingOptions& options,
                                double* empty_loop_ns) {
  if (cases.empty()) return {};
  set_flag_of_library();
  Rounds rounds(cases, options, Clock::thread);
  const std::vector<bool> every(cases.size(), true);
  for (std::size_t r = 0; r < rounds.first_rounds(); ++r) rounds.add_round(every);
  if (empty_loop_ns != nullptr) *empty_loop_ns = rounds.empty_loop_ns();
  return rounds.times();
}

void time_families(std::span<ErrorTimeFamily> families, const TimingOptions& options) {
  set_flag_of_library();
  std::size_t begun = 0, all = 0;
  for (const ErrorTimeFamily& family : families) all += family.timed.size();
  TimingOptions own = options;
  if (options.progress) own.progress = [&](std::size_t, std::size_t) { options.progress(begun, all); };
  std::list<SetTimer> timers;
  for (ErrorTimeFamily& family : families)
    for (const TimedSet& set : family.timed) {
      if (!set.cases.empty()) timers.emplace_back(family, set, own);
      ++begun;
    }
  const auto late = [&] { return options.until && std::chrono::steady_clock::now() > *options.until; };
  for (std::size_t round = 0; round < options.repeats + options.more_rounds; ++round) {
    timers.remove_if([&](const SetTimer& each) { return each.settled() || (each.had_first() && late()); });
    timers.sort([](const SetTimer& a, const SetTimer& b) { return a.seconds() < b.seconds(); });
    for (SetTimer& each : timers)
      if (!each.had_first() || !late()) each.add_round();
  }
  timers.clear();
  for (ErrorTimeFamily& family : families) family.timed.clear();
}

}  // namespace etak
