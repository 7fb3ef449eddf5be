// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The command line's parser behind a door of etak's own: CLI11's headers take 20 s of compiling in each source that
// includes them, so arguments.cpp and usage.cpp alone do.

#include "app/cli/option_table.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace etak::cli {

/// What a verb does once its arguments are read: returns the exit status (see Exit in output/output.h), throws
/// Error.
using Work = std::function<int()>;

/// An option or argument of a verb. Each setter returns the option, so that setters chain.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option group(const std::string& name);               // heading of --help-all that the option stands under
  Option common();                                     // the same, of what many verbs share
  Option value_name(const std::string& name);          // what stands for the value in the help: FILE, R,G,B
  Option help(const std::string& text);                // in place of the text that the option was added with
  Option show_default();                               // the help shows the value that the variable has now
  Option show_default(const std::string& text);        // the help shows `text` as the value
  Option one_of(const std::vector<std::string>& all);  // other values are refused
  Option words(
      const std::vector<std::string>& all);  // the help shows these values; the verb refuses others itself
  Option range(int least, int most);         // values outside are refused
  Option range(unsigned least, unsigned most);
  Option range(double least, double most);
  Option separated_by(char separator);  // one argument holds several values
  Option one_at_a_time();               // a list of which each value follows a mention of the option
  Option values(int count);             // so many, no less and no more
  Option may_lack_value();              // the name of the option alone is complete
  Option required();
  Option excludes(const Option& other);                       // refused beside the other
  Option each(std::function<void(const std::string&)> hear);  // called with each value as typed

  /// The values name files to read: a pipe that is named there may be read, - and /dev/stdin among them
  /// (core/base/files/input.h). A second standard input on the line throws Error.
  Option reads_file();

  /// Whether the option is on the line; known once the line is read.
  bool given() const;

 private:
  CLI::Option* option_;
};

/// A verb, or what stands before the verb, as the parser knows it. The variables that options are bound to must
/// outlive the reading of the line.
class Command {
 public:
  Command(CLI::App* app, Work* chosen) : app_(app), chosen_(chosen) {}

  /// An option whose names are given as "-o,--output", or an argument without dashes ("INPUT").
  ///   Value  text, number, truth (a word behind the option, such as 1), optional number, list of texts or numbers; an
  ///          instance of each type stands in arguments.cpp
  template <class Value>
  Option option(const std::string& names, Value& value, const std::string& help);
  Option option(const std::string& names, std::function<void(double)> hear, const std::string& help);

  /// An option without value.
  Option flag(const std::string& names, bool& value, const std::string& help);
  Option flag(const std::string& names, std::function<void()> hear, const std::string& help);

  /// The option that was added under this name, with its dashes.
  std::optional<Option> find(const std::string& name) const;

  std::string name() const;
  void footer(const std::string& text);        // last lines of the help
  void when_read(std::function<void()> call);  // called once the arguments of this verb are read
  void runs(Work work);                        // what the verb does

 private:
  CLI::App* app_;
  Work* chosen_;
};

/// The whole line: `etak [OPTIONS] VERB ...`.
class CommandLine {
 public:
  CommandLine(const std::string& title, const std::string& name);
  ~CommandLine();

  Command top();
  Command verb(const std::string& name, const std::string& help);
  std::vector<Command> verbs();

  /// etak itself and its verbs with all they take, in the order of the help: for what is generated from them.
  std::vector<VerbRow> table() const;

  /// Adds `help [VERB]`.
  void add_help_verb();

  /// Reads the line. Returns the verb's work, or that of --help; empty where the line names no verb. Throws Error of
  /// the form "PLACE: FOUND; expected EXPECTED" for a mistake on the line.
  Work read(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
  Work chosen_;
};

}  // namespace etak::cli
