// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The parser of the command line. It hides CLI11, whose headers take 20 s to compile in each source that
// includes them: only arguments.cpp and usage.cpp do.

#include "app/cli/option_table.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace etak::cli {

/// The work of a verb, which is done once its arguments are read. Returns the exit status (Exit in
/// output/output.h) or throws Error.
using Work = std::function<int()>;

/// An option or argument of a verb. Each setter returns the option, so that setters chain.
class Option {
 public:
  Option(CLI::Option* option, OptionTraits* traits) : option_(option), traits_(traits) {}

  Option group(const std::string& name);               // --help-all lists the option under this heading
  Option common();                                     // the heading of options that many verbs share
  Option value_name(const std::string& name);          // name of the value in the help: FILE, R,G,B
  Option help(const std::string& text);                // replaces the text that the option was added with
  Option show_default();                               // the help shows the value that the variable has now
  Option show_default(const std::string& text);        // the help shows `text` as the value
  Option one_of(const std::vector<std::string>& all);  // other values are refused
  Option words(
      const std::vector<std::string>& all);  // the help shows these values; the verb refuses others itself
  Option range(int least, int most);         // values outside are refused
  Option range(unsigned least, unsigned most);
  Option range(double least, double most);
  Option separated_by(char separator);  // one argument holds several values
  Option one_at_a_time();               // for lists: the name of the option stands before each value
  Option values(int count);             // takes exactly `count` values
  Option may_lack_value();              // the option may stand without a value
  Option required();
  Option in_shards(InShards part);                            // without it: InShards::same
  Option excludes(const Option& other);                       // refused where the other is given too
  Option each(std::function<void(const std::string&)> hear);  // called with each value as typed

  /// The values name files to read. Pipes that the user names so may be read, among them - and /dev/stdin
  /// (core/base/files/input.h). Reading the line throws Error where it names standard input twice.
  Option reads_file();

  /// Whether the option is on the line; known once the line is read.
  bool given() const;

 private:
  CLI::Option* option_;
  OptionTraits* traits_;
};

/// An option or argument that is on the line.
///   name     with its dashes; empty for an argument
///   values   of the line, in its order; "true" for a flag
///   standard   that the value is the same as without the option
struct GivenOption {
  std::string name;
  std::vector<std::string> values;
  bool flag = false, standard = false;
  OptionTraits traits;
};

/// A verb with its options, or etak itself with the options before the verb. The variables that options are
/// bound to must live until the line is read.
class Command {
 public:
  /// What all verbs of a line share: the work of the one that is on it, and what options were declared to be.
  struct Line {
    Work chosen;
    TraitsOfOptions traits;
  };
  Command(CLI::App* app, Line* line) : app_(app), line_(line) {}

  /// An option whose names are given as "-o,--output", or an argument without dashes ("INPUT").
  ///   Value  text, number, truth (written as a word behind the option, such as 1), optional number, or list
  ///          of texts or numbers; arguments.cpp instantiates the template for each of these types
  template <class Value>
  Option option(const std::string& names, Value& value, const std::string& help);
  Option option(const std::string& names, std::function<void(double)> hear, const std::string& help);

  /// An option without a value.
  Option flag(const std::string& names, bool& value, const std::string& help);
  Option flag(const std::string& names, std::function<void()> hear, const std::string& help);

  /// An option of other verbs that this one cannot have. The help does not show it; given, it is an Error.
  void refuse(const std::string& names, const std::string& why, const std::string& expected);

  /// The option that was added under this name, with its dashes.
  std::optional<Option> find(const std::string& name) const;

  /// What the line gives, in the order of declaration; known once the line is read.
  std::vector<GivenOption> given() const;

  std::string name() const;
  void footer(const std::string& text);        // last lines of the help
  void when_read(std::function<void()> call);  // called once the arguments of this verb are read
  void runs(Work work);                        // what the verb does

 private:
  Option declared(CLI::Option* option) const;

  CLI::App* app_;
  Line* line_;
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

  /// The help of a verb, or of etak itself: `whole` with all options. Throws Error for a verb that does not exist.
  std::string help(const std::string& verb = "", bool whole = false) const;

  /// Reads the line. Returns the work of the verb, or of --help; empty where the line names no verb. Throws
  /// Error with a text "PLACE: FOUND; expected EXPECTED" for a mistake on the line.
  ///   words   the name of the program and its arguments
  Work read(const std::vector<std::string>& words);

 private:
  std::unique_ptr<CLI::App> app_;
  Command::Line line_;
};

}  // namespace etak::cli
