// SPDX-License-Identifier: Apache-2.0
// Spectra -> F0, whole processes side by side: files read, parsed, converted, written.
//
//   bench_f0 --etak PATH --pages DIR [--plain PATH] [--peer NAME='COMMAND {dir} {out}']... [--database DIR]
//            [--rounds 9]
//
//   --pages     folder of *.yml pages with tabulated n, k or formula 1
//   --plain     plain_yaml_f0: the same job by yaml-cpp and std::stod
//   --peer      any other program that reads the pages of {dir} and writes CSV to {out}; may be repeated
//   --database  a whole database/data tree, for MB/s and for two threads against one
//
// Every round runs every command once, in an order that is rotated. The ratio to quote is the median over the
// rounds of peer / etak within one round, never a ratio of medians: other work on the machine hits both
// alike. The last ratio is of CPU time against `etak -j 1`, the steadier one when others share the cores.
// Each output is compared with ours, so that the error stands beside the time.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "f0_output.h"
#include "process.h"

namespace {

using bench::Run;

struct Options {
  std::string etak, pages, plain, database;
  std::vector<std::pair<std::string, std::string>> peers;
  int rounds = 9;
};

Options parse(int argc, char** argv) {
  Options out;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i], value = argv[i + 1];
    if (option == "--etak")
      out.etak = value;
    else if (option == "--pages")
      out.pages = value;
    else if (option == "--plain")
      out.plain = value;
    else if (option == "--database")
      out.database = value;
    else if (option == "--rounds")
      out.rounds = std::stoi(value);
    else if (const auto equals = value.find('='); option == "--peer" && equals != std::string::npos)
      out.peers.emplace_back(value.substr(0, equals), value.substr(equals + 1));
    else
      throw std::runtime_error(option + " " + value + ": unknown option");
  }
  if (argc % 2 == 0 || out.etak.empty() || (out.pages.empty() && out.database.empty()))
    throw std::runtime_error(
        "usage: bench_f0 --etak PATH --pages DIR [--plain PATH] [--peer NAME=COMMAND]... [--database DIR] [--rounds N]");
  return out;
}

struct Case {
  std::string name;
  std::vector<std::string> command;
  std::string output;
  std::string result = "";
  std::vector<Run> runs = {};
};

Case etak_case(const Options& options, const std::string& pages, int threads, const std::string& output) {
  return {
      "etak -j " + std::to_string(threads),
      {options.etak, "f0", pages, "--format", "csv", "-o", output, "--force", "-j", std::to_string(threads)},
      output};
}

/// One untimed run each fills the file cache and leaves the outputs to check; a command that fails is not
/// timed. The first case is the truth of the comparison.
void warm_and_check(std::vector<Case>& cases) {
  bench::F0Output ours;
  for (auto& each : cases) {
    try {
      // etak's exit code 1 says that some page was refused; the others are answered all the same.
      if (const int code = bench::run(each.command).exit_code; code > 1)
        throw std::runtime_error("exit code " + std::to_string(code));
      auto output = bench::read_f0_csv(each.output);
      if (ours.empty()) ours = std::move(output);
      each.result = text(deviation(ours, &each == cases.data() ? ours : output));
    } catch (const std::exception& error) {
      each.result = std::string("FAILED: ") + error.what();
      each.command.clear();
    }
  }
  if (ours.empty()) throw std::runtime_error("etak: " + cases[0].result);
}

void time_rounds(std::vector<Case>& cases, int rounds) {
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < cases.size(); ++i) {
      auto& each = cases[(i + static_cast<std::size_t>(round)) % cases.size()];
      if (!each.command.empty()) each.runs.push_back(bench::run(each.command));
    }
}

template <class Value>
double median_of(const Case& one, Value value) {
  std::vector<double> values;
  for (const auto& run : one.runs) values.push_back(value(run));
  return bench::median(values);
}

double ratio(const Case& peer, const Case& base, double Run::*value) {
  std::vector<double> values;
  for (std::size_t i = 0; i < std::min(peer.runs.size(), base.runs.size()); ++i)
    values.push_back(peer.runs[i].*value / base.runs[i].*value);
  return bench::median(values);
}

void print_table(const std::vector<Case>& cases, std::size_t bases) {
  std::printf("%-26s %8s %8s %8s %8s", "", "wall ms", "best ms", "cpu ms", "peak MB");
  for (std::size_t b = 0; b < bases; ++b) std::printf(" %13s", ("/ " + cases[b].name).c_str());
  std::printf(" %8s  compared with ours\n", "cpu");
  for (const auto& each : cases) {
    std::printf("%-26s", each.name.c_str());
    if (!each.runs.empty()) {
      double best = each.runs[0].wall_s, peak = 0;
      for (const auto& run : each.runs) {
        best = std::min(best, run.wall_s);
        peak = std::max(peak, run.peak_mb);
      }
      std::printf(" %8.1f %8.1f %8.1f %8.1f", 1e3 * median_of(each, [](const Run& r) { return r.wall_s; }),
                  1e3 * best, 1e3 * median_of(each, [](const Run& r) { return r.cpu_s; }), peak);
      for (std::size_t b = 0; b < bases; ++b) std::printf(" %13.2f", ratio(each, cases[b], &Run::wall_s));
      std::printf(" %8.2f", ratio(each, cases[0], &Run::cpu_s));
    }
    std::printf("  %s\n", each.result.c_str());
  }
}

void print_stats(const Options& options, const std::string& pages, const bench::TemporaryFolder& folder) {
  const std::string errors = folder.file("stats.txt");
  auto command = etak_case(options, pages, 1, folder.file("stats.csv")).command;
  command.emplace_back("--stats");
  bench::run(command, {}, errors);
  std::ifstream in(errors);
  std::printf("etak -j 1 --stats:\n");
  for (std::string line; std::getline(in, line);) std::printf("  %s\n", line.c_str());
}

void bench_pages(const Options& options, const bench::TemporaryFolder& folder) {
  std::vector<Case> cases{etak_case(options, options.pages, 1, folder.file("etak1.csv")),
                          etak_case(options, options.pages, 2, folder.file("etak2.csv"))};
  if (!options.plain.empty())
    cases.push_back({"yaml-cpp + std::stod",
                     {options.plain, options.pages, folder.file("plain.csv")},
                     folder.file("plain.csv")});
  for (const auto& [name, line] : options.peers) {
    const std::string output = folder.file("peer" + std::to_string(cases.size()) + ".csv");
    const auto command = bench::fill(bench::split_command(line), "{dir}", options.pages);
    cases.push_back({name, bench::fill(command, "{out}", output), output});
  }
  warm_and_check(cases);
  time_rounds(cases, options.rounds);
  std::printf("\n%s: %d rounds, load %.2f\n", options.pages.c_str(), options.rounds, bench::load_average());
  print_table(cases, 2);
  print_stats(options, options.pages, folder);
}

double megabytes_of_pages(const std::string& tree) {
  double bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(tree))
    if (entry.is_regular_file() && entry.path().extension() == ".yml")
      bytes += static_cast<double>(entry.file_size());
  return bytes / 1e6;
}

void bench_database(const Options& options, const bench::TemporaryFolder& folder) {
  std::vector<Case> cases{etak_case(options, options.database, 1, folder.file("all1.csv")),
                          etak_case(options, options.database, 2, folder.file("all2.csv"))};
  warm_and_check(cases);
  time_rounds(cases, options.rounds);
  const double megabytes = megabytes_of_pages(options.database);
  std::printf("\n%s: %.1f MB, %d rounds, load %.2f\n", options.database.c_str(), megabytes, options.rounds,
              bench::load_average());
  print_table(cases, 1);
  for (const auto& each : cases)
    std::printf("%s: %.0f MB/s\n", each.name.c_str(),
                megabytes / median_of(each, [](const Run& r) { return r.wall_s; }));
  std::printf("two threads against one: %.2f times faster\n", ratio(cases[0], cases[1], &Run::wall_s));
  print_stats(options, options.database, folder);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = parse(argc, argv);
    const bench::TemporaryFolder folder;
    if (!options.pages.empty()) bench_pages(options, folder);
    if (!options.database.empty()) bench_database(options, folder);
    std::printf("(peaks start from this program's own %.1f MB)\n", bench::own_peak_mb());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_f0: %s\n", error.what());
    return 2;
  }
}
