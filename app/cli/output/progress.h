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

/// What long work tells of itself on standard error, the one way for all verbs. With -q nothing.
///   auto   on a terminal, after two seconds of work, one line that is rewritten: a bar, how much is done,
///          the stage, the seconds; elsewhere nothing
///   json   for programs around etak: an object a line (resources/schema/progress.schema.json), the first
///          with the first news, then at most two a second, the last when the work ends
class Progress {
 public:
  ///   total   what `done` ends at; 0: not known yet
  ///   task    the verb
  Progress(const OutputArguments& arguments, std::size_t total, std::string_view task);
  /// Takes the line away, or writes the last object.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Adds `count` finished items. Any thread may call; only worker 0 draws.
  void advance(std::size_t count, unsigned worker);

  /// So much is done, of so much. One thread at a time, not beside advance().
  void set(std::size_t done, std::size_t total);

  /// What is being done now ("fresnel", a material's name). One thread at a time.
  void stage(std::string_view text);

  /// Takes the line away, so that messages can be written where it stood. The next news bring it back.
  void take_away();

  /// Whether a line is or will be drawn: remarks of the same content are then left out.
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
