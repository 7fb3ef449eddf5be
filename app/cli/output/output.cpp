// SPDX-License-Identifier: Apache-2.0
#include "app/cli/output/output.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>

#include "app/cli/output/form.h"
#include "app/cli/output/replace.h"
#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/output_file.h"
#include "core/base/number.h"
#include "core/base/system.h"

namespace etak::cli {
namespace {

void write_standard_output(std::string_view bytes) {
  if (!write_all(sys::standard_output, bytes))
    throw Error::at("<stdout>", "cannot be written: " + reason_of(errno));
}

// Standard output is written in prepare(), before other outputs are put in place, because the program that
// reads a pipe may take long or fail.
class StandardOutput : public Output {
 public:
  explicit StandardOutput(std::string bytes) : bytes_(std::move(bytes)) {}

 private:
  void prepare() override { write_standard_output(bytes_); }
  void place() override {}

  std::string bytes_;
};

}  // namespace

bool is_standard_output(const OutputArguments& arguments) {
  return arguments.file.empty() || arguments.file == "-";
}

void add_output_options(Command verb, OutputArguments& arguments, const std::vector<std::string>& formats) {
  arguments.format = formats.front();
  if (formats.size() > 1) {
    const Option format =
        verb.option("--format", arguments.format, "form of the output; else the ending of -o tells it")
            .one_of(formats)
            .show_default()
            .in_shards(InShards::output);
    verb.when_read([verb, &arguments, formats, format] {
      settle_form(arguments, formats, "etak " + verb.name(), format.given());
    });
  }
  verb.option("-o,--output", arguments.file, "file to write instead of standard output")
      .value_name("FILE")
      .in_shards(InShards::output);
  verb.flag("--force", arguments.force, "let -o replace a file; ETAK_FORCE=1 says the same")
      .in_shards(InShards::output);
  verb.flag("-q,--quiet", arguments.quiet, "no remarks and no progress; errors still appear")
      .in_shards(InShards::output);
  verb.option(
          "--color", arguments.color,
          "colour swatches: auto (on a terminal; NO_COLOR, CLICOLOR and CLICOLOR_FORCE count), always, never")
      .one_of({"auto", "always", "never"})
      .in_shards(InShards::free)
      .common();
}

bool use_color(const OutputArguments& arguments) {
  if (arguments.color != "auto") return arguments.color == "always";
  const auto variable = [](const char* name) -> std::string_view {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  // The order of precedence is that of no-color.org and bixense.com/clicolors.
  if (!is_standard_output(arguments) || !variable("NO_COLOR").empty()) return false;
  if (const auto forced = variable("CLICOLOR_FORCE"); !forced.empty() && forced != "0") return true;
  return sys::is_terminal(sys::standard_output) && variable("CLICOLOR") != "0" && variable("TERM") != "dumb";
}

std::unique_ptr<Output> output(const OutputArguments& arguments, std::string bytes, unsigned most_mode) {
  if (is_standard_output(arguments)) return std::make_unique<StandardOutput>(std::move(bytes));
  refuse_input(arguments.file, arguments.read);
  return std::make_unique<OutputFile>(arguments.file, bytes, may_replace(arguments.force), most_mode);
}

void write_output(const OutputArguments& arguments, std::string_view bytes) {
  if (is_standard_output(arguments)) return write_standard_output(bytes);
  output(arguments, std::string(bytes))->commit();
}

void complain(std::string_view message) {
  // Where standard error cannot be written, there is no other place for the message.
  (void)write_all(sys::standard_error, "etak: " + line_text(message) + "\n");
}

void remark(const OutputArguments& arguments, std::string_view message) {
  if (!arguments.quiet) complain(message);
}

namespace {

// Widths are clamped to this range: nobody reads narrower text, and no terminal is wider.
constexpr double least_columns = 20, most_columns = 10000;

}  // namespace

std::size_t columns_of(int descriptor) {
  const char* const asked = std::getenv("COLUMNS");
  if (double value = 0; asked != nullptr && parse_number(asked, value) && value > 0)
    return static_cast<std::size_t>(std::clamp(value, least_columns, most_columns));
  const unsigned columns = sys::terminal_columns(descriptor);
  return columns == 0 ? 0
                      : static_cast<std::size_t>(std::clamp<double>(columns, least_columns, most_columns));
}

}  // namespace etak::cli
