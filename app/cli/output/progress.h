// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include "app/cli/arguments.h"
#include "app/cli/output/output.h"

namespace etak::cli {

/// Adds --progress: auto, json or none.
void add_progress_option(Command verb, std::string& progress);

/// The progress of long work on standard error, the same for all verbs. With -q nothing is written.
///   auto   on a terminal, after two seconds of work, one line that is rewritten: a bar, how much is done,
///          the stage, the seconds; elsewhere nothing
///   json   for programs that call etak: one JSON object per line (resources/schema/progress.schema.json),
///          the first at the first call, then at most two a second, the last when the work ends
class Progress {
 public:
  ///   total   number of items; 0: not known yet
  ///   task    name of the verb
  Progress(const OutputArguments& arguments, std::size_t total, std::string_view task);
  /// Erases the line, or writes the last object.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Adds `count` finished items. Any thread may call it; only worker 0 writes.
  void advance(std::size_t count, unsigned worker);

  /// Sets the number of finished items and of all items. Only one thread at a time may call it, and none may
  /// call advance() at the same time.
  void set(std::size_t done, std::size_t total);

  /// Names the work that is done now ("fresnel", a material's name). Only one thread at a time may call it.
  void stage(std::string_view text);

  /// Erases the line, so that messages can be written in its place. The next update draws it again.
  void take_away();

  /// Whether a line is or will be drawn. Remarks with the same content are then not needed.
  bool draws_line() const { return mode_ == Mode::line; }

 private:
  enum class Mode { none, line, json };
  using Clock = std::chrono::steady_clock;

  static Mode mode_of(const OutputArguments& arguments);
  void show(bool at_once);
  void draw_line() const;
  void write_object(bool ended) const;
  double seconds() const;

  const Mode mode_;
  const std::string task_;
  const Clock::time_point start_ = Clock::now();
  std::atomic<std::size_t> done_{0};
  std::size_t total_;
  std::string stage_;
  Clock::time_point next_;
  bool shown_ = false;
};

}  // namespace etak::cli
