// SPDX-License-Identifier: Apache-2.0
#include "app/cli/usage.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>

#include "app/cli/output/output.h"
#include "core/base/error.h"
#include "core/base/system.h"
#include "core/base/text/edit_distance.h"
#include "core/base/text/text.h"
#include "core/base/text/wrap.h"

namespace etak::cli {

std::string listed(const std::vector<std::string>& words, const char* between, const char* last) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? last : between) + words[i];
  return out;
}

namespace {

// What the declaration of an option says; of an option that the parser adds itself, nothing.
const OptionTraits& traits_of(const TraitsOfOptions& all, const CLI::Option& option) {
  static const OptionTraits nothing;
  const auto found = all.find(&option);
  return found == all.end() ? nothing : found->second;
}

// The name of a value in the help, in place of the parser's name of its type.
std::string plain_name(const std::string& type) {
  if (type == "INT" || type == "UINT") return "N";
  if (type == "FLOAT") return "NUMBER";
  return type;
}

std::string expected_of(const OptionTraits& option) {
  if (!option.words.empty()) return listed(option.words, ", ", " or ");
  const bool whole =
      option.value == "INT" || option.value == "UINT" || (option.value == "N" && option.range.empty());
  const std::string kind = whole ? "a whole number" : option.value == "FLOAT" ? "a number" : "";
  if (option.range.empty()) return !kind.empty() ? kind : option.value == "TEXT" ? "a value" : option.value;
  return kind.empty() ? option.range : kind + ", " + option.range;
}

// The group of options that the short help shows: those that were given no heading of their own.
constexpr const char* first_group = "Options";

// Headings in the order of the help: what many verbs share comes last.
std::vector<std::string> groups_of(const CLI::App& app) {
  std::vector<std::string> out = app.get_groups();
  std::stable_partition(out.begin(), out.end(), [](const std::string& g) { return g != common_group; });
  std::erase(out, "");
  return out;
}

std::vector<const CLI::Option*> options_under(const CLI::App& app, const std::string& group) {
  return app.get_options(
      [&](const CLI::Option* option) { return option->get_group() == group && option->nonpositional(); });
}

class PlainFormatter : public CLI::Formatter {
 public:
  explicit PlainFormatter(const TraitsOfOptions& traits) : traits_(traits) {}

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
    return make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) +
           groups_text(app, mode == CLI::AppFormatMode::All) + make_subcommands(app, mode) + '\n' +
           make_footer(app);
  }

  // The short help ends with what the long one has besides.
  std::string groups_text(const CLI::App* app, bool whole) const {
    std::string out;
    std::vector<std::string> left_out;
    std::size_t count = 0;
    for (const std::string& group : groups_of(*app)) {
      const std::vector<const CLI::Option*> options = options_under(*app, group);
      if (options.empty()) continue;
      if (whole || group == first_group) {
        out += make_group(group, false, options);
      } else {
        left_out.push_back(group);
        count += options.size();
      }
    }
    if (left_out.empty()) return out;
    return out + "\n" +
           wrapped("etak " + app->get_name() + " --help-all lists " + std::to_string(count) +
                       " more: " + listed(left_out, ", ", " and ") + ".",
                   0, columns_of(sys::standard_output));
  }

  // As the parser does, and no line longer than the terminal's.
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string name = "  " + make_option_name(option, is_positional) + make_option_opts(option);
    const std::size_t indent = get_column_width();
    const std::string text = wrapped(make_option_desc(option), indent, columns_of(sys::standard_output));
    if (text.empty() || name.size() >= indent) return name + "\n" + text;
    return name + text.substr(name.size());
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    if (!option->get_option_text().empty() || option->get_type_size() == 0)
      return CLI::Formatter::make_option_opts(option);
    const OptionTraits& values = traits_of(traits_, *option);
    std::string out;
    const auto add = [&](const std::string& part) {
      if (!part.empty()) out += " " + part;
    };
    if (values.value != "TEXT" || values.words.empty()) add(plain_name(values.value));
    add(listed(values.words, value_separator, value_separator));
    if (!values.range.empty()) add("(" + values.range + ")");
    if (!option->get_default_str().empty()) add("[" + option->get_default_str() + "]");
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) add("...");
    if (option->get_required()) add("(needed)");
    std::vector<std::string> others;
    for (const CLI::Option* other : option->get_excludes()) others.push_back(other->get_name());
    if (!others.empty()) add("(not with " + listed(others, ", ", " or ") + ")");
    return out;
  }

 private:
  const TraitsOfOptions& traits_;
};

OptionRow option_row(const CLI::Option& option, const OptionTraits& traits) {
  OptionRow out;
  static_cast<OptionTraits&>(out) = traits;
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  out.help = option.get_description();
  out.repeats = option.get_expected_max() == CLI::detail::expected_max_vector_size;
  if (!option.get_positional()) out.group = option.get_group();
  if (option.get_type_size() == 0) return out;
  out.value = plain_name(out.value);
  if (option.get_positional() && out.value.empty()) out.value = option.get_name(true, false);
  out.standard = option.get_default_str();
  return out;
}

std::vector<std::string> verbs_of(const CLI::App& app) {
  std::vector<std::string> out;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    out.push_back(verb->get_name());
  return out;
}

std::vector<std::string> options_of(const CLI::App& verb) {
  std::vector<std::string> out;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& name : option->get_lnames()) out.push_back("--" + name);
  return out;
}

// The option that a message of the parser names; null where it names none.
const CLI::Option* option_in(const CLI::App& verb, std::string_view text) {
  const CLI::Option* found = nullptr;
  std::size_t length = 0;
  for (const CLI::Option* option : verb.get_options()) {
    const std::string name = option->get_name();
    const std::size_t at = text.find(name), behind = at + name.size();
    const bool whole = at != text.npos && (at == 0 || text[at - 1] == ' ') &&
                       (behind == text.size() || text[behind] == ':' || text[behind] == ' ');
    if (!whole || name.size() <= length) continue;
    found = option;
    length = name.size();
  }
  return found;
}

// The value that does not fit: the first that is not in the option's set of words; all values where the
// option has no such set.
std::string misfit(const CLI::Option& option, const std::vector<std::string>& words) {
  const std::vector<std::string>& typed = option.results();
  for (const std::string& each : typed)
    if (!words.empty() && std::ranges::count(words, each) == 0) return each;
  return listed(typed, " ", " ");
}

std::string unknown_argument(const CLI::App& app, const CLI::App& verb) {
  std::vector<std::string> left = verb.remaining();
  if (left.empty()) left = app.remaining();
  const std::string first = left.empty() ? "" : left.front();
  const std::string called = &verb == &app ? "etak" : "etak " + verb.get_name();
  if (first.starts_with('-') && first.size() > 1) {
    const std::string name = first.substr(0, first.find('='));
    return Error::at(printable(name), "no option of " + called,
                     "one that " + called + " --help-all lists" + did_you_mean(name, options_of(verb)))
        .what();
  }
  if (&verb == &app) return unknown_verb(first, verbs_of(app)).what();
  return Error::at(printable(first, 200), "one argument more than " + called + " takes",
                   "what " + called + " --help lists")
      .what();
}

}  // namespace

Error unknown_verb(std::string_view typed, const std::vector<std::string>& verbs) {
  return Error::at(printable(typed), "no verb of etak",
                   "one that etak --help lists" + did_you_mean(typed, verbs));
}

void use_plain_help(CLI::App& app, const TraitsOfOptions& traits) {
  const auto formatter = std::make_shared<PlainFormatter>(traits);
  app.formatter(formatter);
  for (CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; })) verb->formatter(formatter);
}

std::string message_of(const CLI::App& app, const TraitsOfOptions& all, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& verb = chosen.empty() ? app : *chosen.front();
  const std::string text = error.what(), kind = error.get_name();
  // The name of this error is the name of the verb, so its type tells it.
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return unknown_argument(app, verb);
  const CLI::Option* option = option_in(verb, text);
  if (option == nullptr) return text;
  const std::string name = option->get_name();
  const OptionTraits& traits = traits_of(all, *option);
  if (kind == "RequiredError") return Error::at(name, "is missing", option->get_description()).what();
  if (kind == "ValidationError" || kind == "ConversionError") {
    const std::string found = misfit(*option, traits.words);
    return Error::at(name, printable(found, 80), expected_of(traits) + did_you_mean(found, traits.words))
        .what();
  }
  if (kind == "ArgumentMismatch") {
    const int least = option->get_items_expected_min();
    const std::string wanted = expected_of(traits);
    const std::string count =
        option->results().empty() ? "no value" : std::to_string(option->results().size()) + " values";
    return Error::at(name, count, least > 1 ? std::to_string(least) + " of " + wanted : wanted).what();
  }
  if (kind == "ExcludesError") {
    const std::size_t word = text.find(" excludes ");
    return Error::at(text.substr(0, word), "given beside " + text.substr(word + 10), "one of the two").what();
  }
  return text;
}

std::string verb_help(const CLI::App& app, const std::string& name, bool whole) {
  const auto mode = whole ? CLI::AppFormatMode::All : CLI::AppFormatMode::Normal;
  if (name.empty()) return app.get_formatter()->make_help(&app, "etak", mode);
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    if (verb->get_name() == name) return verb->help("etak", mode);
  throw unknown_verb(name, verbs_of(app));
}

std::vector<VerbRow> option_table(const CLI::App& app, const TraitsOfOptions& traits) {
  std::vector<VerbRow> out;
  const auto add = [&](const CLI::App& verb) {
    VerbRow& row = out.emplace_back();
    row.name = &verb == &app ? "" : verb.get_name();
    row.help = verb.get_description();
    row.footer = verb.get_footer();
    for (const CLI::Option* option :
         verb.get_options([](const CLI::Option* o) { return o->get_positional(); }))
      row.options.push_back(option_row(*option, traits_of(traits, *option)));
    for (const std::string& group : groups_of(verb))
      for (const CLI::Option* option : options_under(verb, group))
        row.options.push_back(option_row(*option, traits_of(traits, *option)));
  };
  add(app);
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) add(*verb);
  return out;
}

}  // namespace etak::cli
