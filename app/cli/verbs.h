// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/arguments.h"

namespace etak::cli {

// Each adds its verb with options, help and work to `line`.
void add_f0(CommandLine& line);
void add_list(CommandLine& line);
void add_show(CommandLine& line);
void add_nearest(CommandLine& line);
void add_import(CommandLine& line);
void add_explain(CommandLine& line);
void add_eval(CommandLine& line);
void add_export(CommandLine& line);
void add_choose(CommandLine& line);
void add_report(CommandLine& line);
void add_stability(CommandLine& line);
void add_models(CommandLine& line);
void add_pack(CommandLine& line);
void add_render(CommandLine& line);
void add_shader(CommandLine& line);
void add_validate(CommandLine& line);

}  // namespace etak::cli
