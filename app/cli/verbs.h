// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace etak::cli {

/// What a verb does once its arguments are read: returns the exit status (see Exit in output.h), throws
/// Error.
using Verb = std::function<int()>;

// Each adds its verb with options and help to `app`; when the verb is on the line, `chosen` is set to its
// work.
void add_f0(CLI::App& app, Verb& chosen);
void add_list(CLI::App& app, Verb& chosen);
void add_show(CLI::App& app, Verb& chosen);
void add_nearest(CLI::App& app, Verb& chosen);
void add_import(CLI::App& app, Verb& chosen);
void add_explain(CLI::App& app, Verb& chosen);
void add_eval(CLI::App& app, Verb& chosen);
void add_export(CLI::App& app, Verb& chosen);
void add_choose(CLI::App& app, Verb& chosen);
void add_report(CLI::App& app, Verb& chosen);
void add_stability(CLI::App& app, Verb& chosen);
void add_models(CLI::App& app, Verb& chosen);
void add_pack(CLI::App& app, Verb& chosen);
void add_render(CLI::App& app, Verb& chosen);
void add_shader(CLI::App& app, Verb& chosen);
void add_validate(CLI::App& app, Verb& chosen);

}  // namespace etak::cli
