// SPDX-License-Identifier: Apache-2.0
#include "app/cli/options/files.h"

#include "core/base/files/input.h"
#include "core/base/files/links.h"

namespace etak::cli {

void add_follow_links(Command verb) {
  verb.flag(
          "--follow-links", [] { set_follow_links(true); },
          "follow links that lead out of the folder of a scene, manifest, layout or search")
      .common();
}

void add_input_timeout(CommandLine& line) {
  constexpr double longest = 1e6;
  for (Command verb : line.verbs())
    verb.option("--input-timeout", std::function<void(double)>(set_input_timeout),
                "how long a named pipe may be silent at first (default 60); standard input may for ever")
        .value_name("SECONDS")
        .range(0.0, longest)
        .in_shards(InShards::free)
        .common();
}

}  // namespace etak::cli
