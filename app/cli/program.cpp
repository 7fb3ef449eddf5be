// SPDX-License-Identifier: Apache-2.0
#include "app/cli/program.h"

#include <exception>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>

#include "app/cli/completion/shells.h"
#include "app/cli/options/common.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/files/paths.h"
#include "core/base/json/json_text.h"
#include "core/base/setting.h"
#include "core/base/system.h"

namespace etak::cli {
namespace {

int print_version(bool as_json) {
  const std::string version = ETAK_VERSION;
  write_output(
      {},
      (as_json
           ? json_object(
                 {{"name", json("etak")}, {"version", json(version)}, {"compiler", json(__VERSION__)}}, -1)
           : "etak " + version) +
          '\n');
  return exit_ok;
}

// Adds `help [VERB]`.
void add_help(CommandLine& line) {
  struct HelpArguments {
    std::string verb;
    bool whole = false, manual = false;
  };
  const auto arguments = std::make_shared<HelpArguments>();
  Command help = line.verb("help", "what etak or one of its verbs takes");
  help.option("VERB", arguments->verb, "a verb").value_name("");
  help.flag("-a,--all", arguments->whole, "all options of the verb, as --help-all does");
  help.flag("--man", arguments->manual, "the manual page, for man -l");
  help.footer("Example:\n  etak help f0");
  help.runs([arguments, &line] {
    write_output({}, arguments->manual ? manual_page(line.table(), arguments->verb)
                                       : line.help(arguments->verb, arguments->whole));
    return exit_ok;
  });
}

// The verb that begins the line, where it needs no other verb: to declare the options of all of them would take
// about half the time of `etak f0 gold`. Empty where the line needs all verbs.
std::string_view only_verb(const std::vector<std::string>& words) {
  constexpr std::string_view needs_all = "completion";
  if (words.size() < 2 || words[1] == needs_all) return {};
  for (const std::string_view verb : {
#define ETAK_VERB(name) #name,
#include "app/cli/verbs.inc"
#undef ETAK_VERB
       })
    if (verb == words[1]) return verb;
  return {};
}

// Hooks, and `*` in a shell, put names on the line that strangers chose, such as --baseline=x.png. Throws Error for an
// option that is also the name of a file. Behind -- such a name gets ./ before it, since options that take a list
// would end at -- and let options follow; the words behind -- of a plan are those of another line.
std::vector<std::string> without_names_as_options(std::vector<std::string> words) {
  bool names = false;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i].size() > 1 && words[i].starts_with('-') && words[1] != "plan" && kind_at(words[i], false)) {
      if (!names)
        throw Error::at(printable(words[i], 200), "is an option and the name of a file",
                        "-- before the names of files");
      words[i].insert(0, "./");
    }
    names = names || words[i] == "--";
  }
  return words;
}

int run(std::vector<std::string> words, CommandLine& line) {
  if (words.size() > 1 && words[1] == "version") words[1] = "--version";
  bool version = false, as_json = false;
  line.top().flag("-V,-v,--version", version, "print the version and stop");
  line.top().flag("--json", as_json, "with --version: as JSON");
  line.top().footer(
      "Exit status: 0 done, 1 a named input was refused, 2 bad input, option or output.\n"
      "Example:\n  etak f0 gold copper");
  const std::string_view only = only_verb(words);
#define ETAK_VERB(name) \
  if (only.empty() || only == #name) add_##name(line);
#include "app/cli/verbs.inc"
#undef ETAK_VERB
  CommonArguments common;
  add_help(line);
  add_common_options(line, common);
  add_input_timeout(line);
  const Work work = line.read(words);
  if (version) return print_version(as_json);
  if (!work) {
    write_output({}, line.help());
    return exit_failure;
  }
  return run_and_tell(work, common);
}

// The message where memory ran out in code that reports no file of its own: it names the largest file of the
// line, which is the likely reason.
std::string out_of_memory(const std::vector<std::string>& words) {
  std::string largest;
  std::uint64_t most = 0;
  for (std::size_t i = 1; i < words.size(); ++i) {
    sys::FileInfo info;
    if (!sys::file_info(words[i], info) || info.kind != sys::FileInfo::Kind::file || info.size < most)
      continue;
    largest = words[i];
    most = info.size;
  }
  if (largest.empty())
    return Error::at(words.size() > 1 ? "etak " + words[1] : "etak", "needs more memory than there is",
                     "fewer or smaller inputs at once")
        .what();
  return Error::at(largest,
                   "needs more memory than there is, for a file of " + std::to_string(most) + " bytes",
                   "a smaller file, or more memory")
      .what();
}

}  // namespace

CommandLine empty_line() {
  return CommandLine("etak: measured optics into materials a renderer can trust", "etak");
}

int run_line(const std::vector<std::string>& words, CommandLine& line) {
  settings_are(SettingStyle::options);
  try {
    return run(without_names_as_options(words), line);
  } catch (const Error& error) {
    complain(error.what());
  } catch (const std::bad_alloc&) {
    complain(out_of_memory(words));
  } catch (const std::exception& error) {
    // A fault of etak. The message holds the library's own text for a bug report.
    const std::string verb = words.size() > 1 ? " " + words[1] : "";
    complain("etak" + verb + ": internal error (" + error.what() + ")");
  }
  return exit_failure;
}

}  // namespace etak::cli
