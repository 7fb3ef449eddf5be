// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/common.h"

#include <cstdlib>

#include "app/cli/output/progress.h"
#include "app/cli/output/replace.h"
#include "core/base/number.h"
#include "core/base/stopwatch.h"
#include "core/validate/config.h"

namespace etak::cli {

std::vector<InForce> in_force(Library& library) {
  std::vector<InForce> out{{"version", ETAK_VERSION, "the program"}};
  const std::vector<std::string> environment = environment_libraries();
  for (const std::string& folder : library.all_folders()) {
    const bool by_variable = static_cast<std::size_t>(out.size() - 1) < environment.size();
    out.push_back({"library", folder, by_variable ? "ETAK_LIBRARY" : "--library"});
  }
  out.push_back({"materials", std::to_string(library.get().ids().size()),
                 out.size() > 1 ? "built-in library and folders" : "built-in library"});
  const std::string file = find_config(".");
  out.push_back({"checks", file.empty() ? "no etak.toml" : file, "this folder or the nearest above"});
  const ReplaceDefault replace = replace_default();
  out.push_back({"force", replace.replace ? "true" : "false", replace.from});
  const char* const ocio = std::getenv("OCIO");
  const bool given = ocio != nullptr && *ocio != '\0';
  out.push_back({"ocio", given ? ocio : "etak's own config", given ? "OCIO" : "default"});
  return out;
}

void add_common_options(CommandLine& line, CommonArguments& arguments) {
  for (Command verb : line.verbs()) {
    if (!verb.find("--jobs")) add_thread_option(verb, arguments.threads);
    if (!verb.find("--progress")) add_progress_option(verb, arguments.progress);
    if (!verb.find("--stats"))
      verb.flag("--stats", arguments.stats, "say on standard error how long the run took")
          .in_shards(InShards::free)
          .common();
    if (!verb.find("--verbose"))
      verb.flag("-v,--verbose", arguments.verbose,
                "say on standard error what configuration is in force, as etak config does")
          .in_shards(InShards::free)
          .common();
  }
}

int run_and_tell(const Work& work, const CommonArguments& arguments) {
  if (arguments.verbose) {
    Library library;
    for (const InForce& each : in_force(library))
      complain(each.name + ": " + each.value + " (" + each.from + ")");
  }
  Stopwatch watch(arguments.stats);
  const int status = work();
  double seconds = 0;
  watch.lap(seconds);
  if (arguments.stats) complain("stats: " + number(seconds * 1e3, 3) + " ms in all");
  return status;
}

}  // namespace etak::cli
