// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/plan/engines.h"
#include "app/cli/plan/plan.h"
#include "app/cli/verbs.h"
#include "core/runs/shards.h"

namespace etak::cli {

void add_plan(CommandLine& line) {
  const auto arguments = std::make_shared<PlanArguments>();
  PlanArguments& a = *arguments;
  Command verb = line.verb("plan", "a run cut into tasks, as commands for an engine that starts them");
  verb.option("run", a.words, "-- and the run: validate or pack --batch with its arguments")
      .value_name("-- VERB ARGUMENT...");
  verb.option("--tasks", a.tasks, "how many shards the run is cut into")
      .range(1U, static_cast<unsigned>(most_shards))
      .value_name("N")
      .required();
  verb.option("--format", a.format, "the engine: " + plan_engines_text()).one_of(plan_engines()).required();
  verb.option("-o,--output,--out", a.out, "folder for the plan, and for what the tasks write")
      .value_name("DIR")
      .required();
  verb.option("--program", a.program, "etak on the machines of the engine").value_name("PATH").show_default();
  verb.flag("--force", a.force, "replace an earlier plan; ETAK_FORCE=1 says the same");
  verb.flag("-q,--quiet", a.quiet, "no remarks; errors still appear");
  verb.footer(
      "The result of validate has the form of --format or -o of the run, else JSON, and lies where -o of the "
      "run says, else in DIR. No task is started.\n"
      "Exit status: 0 the plan is written, 2 bad input, option or output.\n"
      "Example:\n  etak plan --tasks 4 --format slurm -o plan -- validate textures --format sarif");
  verb.runs([arguments] { return plan_run(*arguments); });
}

}  // namespace etak::cli
