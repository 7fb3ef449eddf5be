// SPDX-License-Identifier: Apache-2.0
#include "app/cli/file_options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "core/base/input.h"
#include "core/base/links.h"

namespace etak::cli {

CLI::Option* reads_file(CLI::Option* option) {
  return option->transform(accept_input, "");
}

void add_follow_links(CLI::App& verb) {
  verb.add_flag_callback(
      "--follow-links", [] { set_follow_links(true); },
      "follow links that lead out of the folder of a scene, manifest, layout or search");
}

void add_input_timeout(CLI::App& app) {
  constexpr double longest = 1e6;
  for (CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; }))
    verb->add_option_function<double>("--input-timeout", set_input_timeout,
                                      "how long a named pipe may be silent at first (default 60); standard "
                                      "input may for ever")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.0, longest));
}

}  // namespace etak::cli
