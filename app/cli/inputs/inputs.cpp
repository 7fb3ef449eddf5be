// SPDX-License-Identifier: Apache-2.0
#include "app/cli/inputs/inputs.h"

#include <algorithm>

#include "app/cli/options/shard.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/hash/content_hash.h"
#include "core/base/system.h"

namespace etak::cli {

void add_input_options(Command verb, InputNames& names) {
  verb.option("INPUT", names.names,
              "material (gold), dataset (gold/ID, its unique beginning, or gold/* for all), file "
              "(.yml page, .json material, .csv .tsv .txt .dat table), folder, pipe, or - for "
              "standard input")
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

ShardOutput keep_inputs(std::vector<MaterialInput>& inputs, const Shard& shard) {
  std::vector<std::uint64_t> bytes;
  ContentHash hash;
  for (const MaterialInput& input : inputs) {
    const bool is_file = input.kind == MaterialInput::Kind::file;
    if (is_file) refuse_pipes_of_shard({input.path});
    sys::FileInfo info;
    bytes.push_back(is_file && sys::file_info(input.path, info) ? info.size : 0);
    hash.add_part(input.kind == MaterialInput::Kind::material ? input.material->id : input.label());
    hash.add_part(input.dataset);
  }
  const auto [first, last] = items_of(shard, bytes);
  const auto at = [&](std::size_t i) { return inputs.begin() + static_cast<std::ptrdiff_t>(i); };
  ShardOutput out;
  out.shard = {shard.index, shard.count, std::pair(first, last)};
  out.version = ETAK_VERSION;
  out.list = hash.hex();
  out.items = inputs.size();
  inputs.erase(at(last), inputs.end());
  inputs.erase(inputs.begin(), at(first));
  return out;
}

ListedNames::ListedNames(const std::string& path)
    : text_(read_file(path)), separator_(text_.find('\0') != std::string::npos ? '\0' : '\n') {}

std::vector<std::string> ListedNames::take(std::size_t most) {
  std::vector<std::string> out;
  while (out.size() < most && at_ < text_.size()) {
    const std::size_t end = std::min(text_.find(separator_, at_), text_.size());
    std::string name = text_.substr(at_, end - at_);
    if (separator_ == '\n' && name.ends_with('\r')) name.pop_back();
    if (!name.empty()) out.push_back(std::move(name));
    at_ = end + 1;
  }
  return out;
}

std::size_t ListedNames::count() const {
  const bool open_end = !text_.empty() && text_.back() != separator_;
  return static_cast<std::size_t>(std::count(text_.begin(), text_.end(), separator_)) + (open_end ? 1 : 0);
}

}  // namespace etak::cli
