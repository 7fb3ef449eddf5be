// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/csv.h"

namespace CLI {
class App;
}

namespace etak::cli {

/// Exit status of every verb.
enum Exit : int { exit_ok = 0, exit_findings = 1, exit_failure = 2 };

/// Where the data of a run go, and in which form.
struct OutputArguments {
  std::string format;
  std::string form_asked_by = "--format";  // or "-o FILE", where its ending tells the form
  std::string file;                        // empty or "-": standard output
  bool force = false;
  bool quiet = false;
  std::string color = "auto";
};

/// Adds --format (one of `formats`; by default that of the ending of -o, else the first), -o, --force, -q and
/// --color.
void add_output_options(CLI::App& verb, OutputArguments& arguments, const std::vector<std::string>& formats);

/// Whether 24-bit colour may go into the output: asked for, or a terminal that NO_COLOR does not rule out.
bool use_color(const OutputArguments& arguments);

/// Writes the data of the run: atomically to the file of -o, else to standard output. Throws Error.
void write_output(const OutputArguments& arguments, std::string_view bytes);

/// One line on standard error, "etak: " before it.
void complain(std::string_view message);

/// The same for remarks that -q silences.
void remark(const OutputArguments& arguments, std::string_view message);

/// A swatch of two character cells in 24-bit colour.
std::string swatch(int r, int g, int b);

/// `text` as a JSON string with its quotes.
std::string json_string(std::string_view text);

/// `text` padded with blanks to `width` characters (UTF-8 sequences count once).
std::string padded(std::string_view text, std::size_t width);

/// A bar on standard error while long work runs: only on a terminal, only after a third of a second, not with
/// -q.
class Progress {
 public:
  Progress(const OutputArguments& arguments, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Adds `count` finished items. Any thread may call; only worker 0 draws.
  void advance(std::size_t count, unsigned worker);

 private:
  const bool shown_;
  const std::size_t total_;
  std::atomic<std::size_t> done_{0};
  std::chrono::steady_clock::time_point next_draw_;
  bool drawn_ = false;
};

}  // namespace etak::cli
