// SPDX-License-Identifier: Apache-2.0
#include "app/cli/inputs/inputs.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/text/ascii.h"
#include "core/certainty/publications.h"
#include "core/material/find.h"
#include "core/material/names.h"

namespace etak::cli {

void add_input_options(Command verb, InputNames& names) {
  verb.option(
          "INPUT", names.names,
          "material (gold), dataset (gold/ID, its unique beginning, or gold/* for all), file (.yml page, .json material, .csv .tsv .txt .dat table), folder, pipe, or - for standard input")
      .reads_file()
      .value_name("");
  verb.option("--stdin-format", names.pipe_format,
              "what - and pipes without an ending hold; auto: told by the first bytes")
      .one_of({"auto", "table", "page", "json"})
      .show_default();
}

void add_all_datasets_option(Command verb, InputNames& names) {
  verb.flag("--all-datasets", names.all_datasets,
            "every dataset of each material, in place of the preferred one");
}

void add_without_option(Command verb, std::vector<std::string>& without) {
  verb.option("--without", without,
              "leave a publication out, as if it were not known; may be repeated: titanium/johnson-1974")
      .one_at_a_time()
      .value_name("ID/DATASET");
}

std::vector<MaterialInput> find_tables(const InputNames& names, Library& library, unsigned threads,
                                       const OutputArguments& output) {
  std::vector<std::string> remarks;
  std::vector<MaterialInput> inputs = find_inputs(names, library.when_asked(), threads, &remarks);
  const auto prose = [](const MaterialInput& input) {
    if (!input.from_folder || input.file != MaterialFileKind::table) return false;
    try {
      return is_prose(input, read_head(input.path, content_head));
    } catch (const Error&) {
      return false;  // the verb that reads the file reports the reason
    }
  };
  if (const auto count = std::erase_if(inputs, prose); count > 0)
    remarks.push_back(std::to_string(count) + (count == 1 ? " text is no table" : " texts are no tables"));
  for (const std::string& each : remarks) remark(output, each);
  return inputs;
}

}  // namespace etak::cli
