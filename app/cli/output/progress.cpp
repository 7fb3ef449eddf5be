// SPDX-License-Identifier: Apache-2.0
#include "app/cli/output/progress.h"

#include <algorithm>

#include "app/cli/output/output.h"
#include "core/base/files/descriptor.h"
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/text/text.h"

namespace etak::cli {
namespace {

constexpr std::chrono::milliseconds first_line{2000}, between_lines{100}, between_objects{500};
constexpr std::size_t bar_width = 30;

// The front of `text` that fits into so many columns.
std::string cut(std::string_view text, std::size_t columns) {
  std::string out = line_text(text);
  out.resize(front_of(out, columns).size());
  return out;
}

}  // namespace

void add_progress_option(Command verb, std::string& progress) {
  verb.option("--progress", progress,
              "of long work, on standard error: auto (a line on a terminal), json (an object a line), none")
      .one_of({"auto", "json", "none"})
      .show_default()
      .in_shards(InShards::free)
      .common();
}

Progress::Mode Progress::mode_of(const OutputArguments& arguments) {
  if (arguments.quiet || arguments.progress == "none") return Mode::none;
  if (arguments.progress == "json") return Mode::json;
  return sys::is_terminal(sys::standard_error) ? Mode::line : Mode::none;
}

Progress::Progress(const OutputArguments& arguments, std::size_t total, std::string_view task)
    : mode_(mode_of(arguments)),
      task_(task),
      total_(total),
      next_(mode_ == Mode::line ? start_ + first_line : start_) {}

Progress::~Progress() {
  if (mode_ == Mode::json && shown_) write_object(true);
  take_away();
}

void Progress::take_away() {
  // Where standard error cannot be written, there is no other place for a message.
  if (mode_ == Mode::line && shown_) (void)write_all(sys::standard_error, "\r\x1b[K");
}

void Progress::advance(std::size_t count, unsigned worker) {
  done_.fetch_add(count, std::memory_order_relaxed);
  if (worker == 0) show(false);
}

void Progress::set(std::size_t done, std::size_t total) {
  done_.store(done, std::memory_order_relaxed);
  total_ = total;
  show(false);
}

void Progress::stage(std::string_view text) {
  stage_ = text;
  show(true);
}

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

// Shows the progress where it is time to. Once the first line has been shown, `at_once` (a new stage) does
// not wait for the time.
void Progress::show(bool at_once) {
  if (mode_ == Mode::none) return;
  const auto now = Clock::now();
  const bool due = now >= next_ || (at_once && shown_);
  if (!due) return;
  next_ = now + (mode_ == Mode::line ? between_lines : between_objects);
  shown_ = true;
  if (mode_ == Mode::line)
    draw_line();
  else
    write_object(false);
}

void Progress::draw_line() const {
  const std::size_t done = done_.load(std::memory_order_relaxed);
  std::string line;
  if (total_ > 0) {
    const std::size_t filled = std::min(done, total_) * bar_width / total_;
    append(line, "[", std::string(filled, '='), std::string(bar_width - filled, '.'), "] ",
           std::to_string(done), "/", std::to_string(total_), " ");
  }
  append(line, task_, stage_.empty() ? "" : " ", stage_, ", ", fixed(seconds(), 0), " s");
  const std::size_t columns = columns_of(sys::standard_error);
  // The last column stays free: a character there would make some terminals begin a new line.
  (void)write_all(sys::standard_error, "\r\x1b[K" + cut(line, columns == 0 ? 79 : columns - 1));
}

void Progress::write_object(bool ended) const {
  const JsonMember members[] = {{"schema", json("etak-progress/1")},
                                {"task", json(task_)},
                                {"stage", json(stage_)},
                                {"done", json(done_.load(std::memory_order_relaxed))},
                                {"total", json(total_)},
                                {"seconds", fixed(seconds(), 3)},
                                {"ended", json(ended)}};
  (void)write_all(sys::standard_error, json_object(members, -1) + "\n");
}

}  // namespace etak::cli
