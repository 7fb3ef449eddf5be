// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/cli/f0/run.h"
#include "app/cli/inputs/inputs.h"
#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/output/progress.h"
#include "app/cli/verbs.h"

namespace etak::cli {

void add_f0(CommandLine& line) {
  const auto arguments = std::make_shared<F0Arguments>();
  Command verb = line.verb("f0", "reflectance at normal incidence as a colour");
  add_input_options(verb, arguments->inputs);
  verb.option("--files-from", arguments->files_from,
              "read more inputs from LIST, one per line or NUL-separated")
      .reads_file()
      .value_name("LIST");
  add_allow_empty_option(verb, arguments->allow_empty);
  verb.flag("--all", arguments->inputs.all, "every material of the library");
  add_all_datasets_option(verb, arguments->inputs);
  verb.option("--dataset", arguments->inputs.dataset,
              "dataset to take instead of the preferred one: its id or unique beginning")
      .value_name("ID");
  add_compute_options(verb, arguments->compute);
  add_table_options(verb, arguments->tables);
  add_library_options(verb, arguments->library);
  add_output_options(verb, arguments->output, {"table", "csv", "json", "jsonl", "html", "svg"});
  add_progress_option(verb, arguments->output.progress);
  add_thread_option(verb, arguments->threads);
  verb.option("--sort", arguments->sort,
              "order of the rows, in place of that of the inputs: Y, from dark to bright")
      .words({"Y"});
  verb.option(
          "--aperture", arguments->compute.aperture,
          "numerical aperture of an objective, below the index outside: the mean over its cone, pupil filled; no F82")
      .value_name("NA");
  verb.option("--scatter", arguments->compute.scatter,
              "share of the reflectance that scatter takes away, 0 to 1")
      .value_name("SHARE");
  verb.option(
          "--coat", arguments->coat,
          "a clear layer over the material: an index, or a clear material, which absorbs through a thickness (1.5, pmma, water:2mm); tells F0 and F82 under it and of the whole")
      .value_name("N|MATERIAL[:THICKNESS]");
  verb.option(
          "--sweep", arguments->sweep,
          "one stack with thicknesses of a layer (1 is the outermost): LAYER=FIRST:LAST:COUNT, as in "
          "1=0nm:400nm:81, or LAYER=VALUE,VALUE,...; with --format svg a strip of colours over thickness and angle")
      .value_name("LAYER=THICKNESSES");
  add_without_option(verb, arguments->without);
  verb.flag(
      "--bands", arguments->bands,
      "columns of the CSV that say how far a new publication would lie from F0 (publications, de50, de90)");
  verb.flag("-v,--verbose", arguments->verbose,
            "below a table, what its flags mean and the policy that its numbers were computed by");
  verb.flag("--stats", arguments->stats, "time per stage and MB/s on standard error");
  verb.footer(
      "A folder gives one row per page, in path order; a refractiveindex.info database tree is recognised.\n"
      "Exit status: 0 done, 1 an input named by itself was refused by the rules, 2 an input failed.\n"
      "Example:\n  etak f0 gold silver --format csv");
  verb.runs([arguments] { return answer_f0(*arguments); });
}

}  // namespace etak::cli
