// SPDX-License-Identifier: Apache-2.0
#include "app/cli/arguments.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstddef>
#include <sstream>
#include <utility>

#include "app/cli/output/output.h"
#include "app/cli/usage.h"
#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/text/text.h"

namespace etak::cli {
Option Option::group(const std::string& name) {
  option_->group(name);
  return *this;
}

Option Option::common() {
  return group(common_group);
}

Option Option::value_name(const std::string& name) {
  traits_->value = name;
  return *this;
}

Option Option::help(const std::string& text) {
  option_->description(text);
  return *this;
}

Option Option::show_default() {
  option_->capture_default_str();
  return *this;
}

Option Option::show_default(const std::string& text) {
  option_->default_str(text);
  return *this;
}

Option Option::one_of(const std::vector<std::string>& all) {
  option_->transform(CLI::IsMember(all, CLI::ignore_case));
  traits_->words = all;
  return *this;
}

Option Option::words(const std::vector<std::string>& all) {
  traits_->value = "TEXT";
  traits_->words = all;
  return *this;
}

namespace {

template <class Number>
void limit(CLI::Option& option, OptionTraits& traits, Number least, Number most) {
  option.check(CLI::Range(least, most));
  std::ostringstream range;
  range << least << " to " << most;
  traits.range = range.str();
}

}  // namespace

Option Option::range(int least, int most) {
  limit(*option_, *traits_, least, most);
  return *this;
}

Option Option::range(unsigned least, unsigned most) {
  limit(*option_, *traits_, least, most);
  return *this;
}

Option Option::range(double least, double most) {
  limit(*option_, *traits_, least, most);
  return *this;
}

Option Option::separated_by(char separator) {
  option_->delimiter(separator);
  return one_at_a_time();
}

Option Option::one_at_a_time() {
  option_->allow_extra_args(false);
  return *this;
}

Option Option::values(int count) {
  option_->expected(count);
  return *this;
}

Option Option::may_lack_value() {
  option_->expected(0, 1);
  return *this;
}

Option Option::required() {
  option_->required();
  return *this;
}

Option Option::in_shards(InShards part) {
  traits_->in_shards = part;
  return *this;
}

Option Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option Option::each(std::function<void(const std::string&)> hear) {
  option_->each(std::move(hear));
  return *this;
}

Option Option::reads_file() {
  option_->transform(accept_input, "");
  traits_->reads_file = true;
  return *this;
}

bool Option::given() const {
  return option_->count() > 0;
}

Option Command::declared(CLI::Option* option) const {
  OptionTraits& traits = line_->traits[option];
  traits.value = option->get_type_size() == 0 ? "" : option->get_type_name();
  return Option(option, &traits);
}

template <class Value>
Option Command::option(const std::string& names, Value& value, const std::string& help) {
  return declared(app_->add_option(names, value, help));
}

template Option Command::option(const std::string&, std::string&, const std::string&);
template Option Command::option(const std::string&, int&, const std::string&);
template Option Command::option(const std::string&, unsigned&, const std::string&);
template Option Command::option(const std::string&, std::size_t&, const std::string&);
template Option Command::option(const std::string&, double&, const std::string&);
template Option Command::option(const std::string&, bool&, const std::string&);
template Option Command::option(const std::string&, std::optional<std::size_t>&, const std::string&);
template Option Command::option(const std::string&, std::optional<double>&, const std::string&);
template Option Command::option(const std::string&, std::vector<double>&, const std::string&);
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&);

Option Command::option(const std::string& names, std::function<void(double)> hear, const std::string& help) {
  return declared(app_->add_option_function<double>(names, std::move(hear), help));
}

Option Command::flag(const std::string& names, bool& value, const std::string& help) {
  return declared(app_->add_flag(names, value, help));
}

Option Command::flag(const std::string& names, std::function<void()> hear, const std::string& help) {
  return declared(app_->add_flag_callback(names, std::move(hear), help));
}

void Command::refuse(const std::string& names, const std::string& why, const std::string& expected) {
  app_->add_option_function<std::vector<std::string>>(names,
                                                      [=](const std::vector<std::string>&) {
                                                        throw Error::at(names.substr(0, names.find(',')), why,
                                                                        expected);
                                                      })
      ->expected(0, 1)
      ->group("");
}

std::optional<Option> Command::find(const std::string& name) const {
  CLI::Option* const option = app_->get_option_no_throw(name);
  if (option == nullptr) return std::nullopt;
  return Option(option, &line_->traits[option]);
}

std::vector<GivenOption> Command::given() const {
  std::vector<GivenOption> out;
  for (const CLI::Option* option : app_->get_options()) {
    if (option->count() == 0) continue;
    const bool argument = option->get_positional();
    out.push_back({argument ? "" : option->get_name(), option->results(), option->get_expected_max() == 0,
                   option->results() == std::vector{option->get_default_str()}, line_->traits[option]});
  }
  return out;
}

std::string Command::name() const {
  return app_->get_name();
}

void Command::footer(const std::string& text) {
  app_->footer(text);
}

void Command::when_read(std::function<void()> call) {
  app_->parse_complete_callback(std::move(call));
}

void Command::runs(Work work) {
  app_->callback([line = line_, work = std::move(work)] { line->chosen = work; });
}

CommandLine::CommandLine(const std::string& title, const std::string& name)
    : app_(std::make_unique<CLI::App>(title, name)) {
  app_->require_subcommand(0, 1);
  // Before the verbs, which take these three over.
  app_->allow_windows_style_options(false);  // /a is a path, on Windows too
  app_->set_help_flag("-h,--help", "help with the options that are used most");
  app_->set_help_all_flag("--help-all", "help with all options");
}

CommandLine::~CommandLine() = default;

Command CommandLine::top() {
  return Command(app_.get(), &line_);
}

Command CommandLine::verb(const std::string& name, const std::string& help) {
  CLI::App* const app = app_->add_subcommand(name, help);
  line_.traits[app->get_help_ptr()].in_shards = InShards::one_file;
  line_.traits[app->get_help_all_ptr()].in_shards = InShards::one_file;
  return Command(app, &line_);
}

std::vector<Command> CommandLine::verbs() {
  std::vector<Command> out;
  for (CLI::App* verb : app_->get_subcommands([](CLI::App*) { return true; })) out.emplace_back(verb, &line_);
  return out;
}

std::vector<VerbRow> CommandLine::table() const {
  return option_table(*app_, line_.traits);
}

std::string CommandLine::help(const std::string& verb, bool whole) const {
  return verb_help(*app_, verb, whole);
}

Work CommandLine::read(const std::vector<std::string>& words) {
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  use_plain_help(*app_, line_.traits);
  try {
    app_->parse(static_cast<int>(pointers.size()), pointers.data());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw Error(message_of(*app_, line_.traits, error));
    // --help and --help-all. The text is written as the work of the line, so that standard output that cannot be
    // written is reported as for all other output.
    const bool whole = dynamic_cast<const CLI::CallForAllHelp*>(&error) != nullptr;
    return [text = app_->help("", whole ? CLI::AppFormatMode::All : CLI::AppFormatMode::Normal)] {
      write_output({}, text);
      return exit_ok;
    };
  }
  return line_.chosen;
}

}  // namespace etak::cli
