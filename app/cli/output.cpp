// SPDX-License-Identifier: Apache-2.0
#include "app/cli/output.h"

#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "app/cli/output_form.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"

namespace etak::cli {
namespace {

using Clock = std::chrono::steady_clock;

// False with errno set when the bytes could not be written whole.
bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t wrote = ::write(descriptor, bytes.data(), bytes.size());
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(wrote));
  }
  return true;
}

bool is_standard_output(const OutputArguments& arguments) {
  return arguments.file.empty() || arguments.file == "-";
}

std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return count;
}

}  // namespace

void add_output_options(CLI::App& verb, OutputArguments& arguments, const std::vector<std::string>& formats) {
  arguments.format = formats.front();
  if (formats.size() > 1) {
    const CLI::Option* format =
        verb.add_option("--format", arguments.format, "form of the output; else the ending of -o tells it")
            ->check(CLI::IsMember(formats))
            ->capture_default_str();
    verb.parse_complete_callback([&verb, &arguments, formats, format] {
      settle_form(arguments, formats, "etak " + verb.get_name(), format->count() > 0);
    });
  }
  verb.add_option("-o,--output", arguments.file, "file to write instead of standard output")
      ->type_name("FILE");
  verb.add_flag("--force", arguments.force, "let -o replace a file");
  verb.add_flag("-q,--quiet", arguments.quiet, "no remarks and no progress bar; errors still appear");
  verb.add_option("--color", arguments.color,
                  "colour swatches: auto (on a terminal without NO_COLOR), always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}));
}

bool use_color(const OutputArguments& arguments) {
  if (arguments.color != "auto") return arguments.color == "always";
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return is_standard_output(arguments) && ::isatty(STDOUT_FILENO) != 0 &&
         (no_color == nullptr || *no_color == '\0') &&
         (terminal == nullptr || std::strcmp(terminal, "dumb") != 0);
}

void write_output(const OutputArguments& arguments, std::string_view bytes) {
  if (!is_standard_output(arguments)) return write_file(arguments.file, bytes, arguments.force);
  if (!write_all(STDOUT_FILENO, bytes))
    throw Error::at("<stdout>", std::string("cannot be written: ") + std::strerror(errno));
}

void complain(std::string_view message) {
  // A lost message on standard error has nowhere left to be reported.
  (void)write_all(STDERR_FILENO, "etak: " + std::string(message) + "\n");
}

void remark(const OutputArguments& arguments, std::string_view message) {
  if (!arguments.quiet) complain(message);
}

std::string swatch(int r, int g, int b) {
  return "\x1b[48;2;" + std::to_string(r) + ";" + std::to_string(g) + ";" + std::to_string(b) + "m  \x1b[0m";
}

std::string json_string(std::string_view text) {
  return json(text);
}

std::string padded(std::string_view text, std::size_t width) {
  std::string out(text);
  const std::size_t have = characters(text);
  if (have < width) out.append(width - have, ' ');
  return out;
}

Progress::Progress(const OutputArguments& arguments, std::size_t total)
    : shown_(!arguments.quiet && ::isatty(STDERR_FILENO) != 0),
      total_(total),
      next_draw_(Clock::now() + std::chrono::milliseconds(333)) {}

Progress::~Progress() {
  if (drawn_) (void)write_all(STDERR_FILENO, "\r\x1b[K");
}

void Progress::advance(std::size_t count, unsigned worker) {
  const std::size_t done = done_.fetch_add(count, std::memory_order_relaxed) + count;
  if (!shown_ || worker != 0) return;
  const auto now = Clock::now();
  if (now < next_draw_) return;
  next_draw_ = now + std::chrono::milliseconds(100);
  drawn_ = true;
  constexpr std::size_t width = 40;
  const std::size_t filled = total_ == 0 ? width : done * width / total_;
  (void)write_all(STDERR_FILENO, "\r[" + std::string(filled, '#') + std::string(width - filled, '.') + "] " +
                                     std::to_string(done) + "/" + std::to_string(total_));
}

}  // namespace etak::cli
