// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include "core/atlas/pack/setting_reader.h"
#include "core/base/json/node_json.h"
#include "core/base/system.h"

namespace etak {
namespace {

constexpr int jobs_depth = 6;

PackSettings read_job(const JsonNode& job, const std::filesystem::path& folder, PackSettings out) {
  job.expect_object();
  const auto rows = pack_setting_rows();
  for (const auto& [key, ignored] : job.value.items()) {
    const auto is_named = [&name = key](const PackSettingRow& row) {
      return row.name == name && !row.is(PackSettingRow::line_only);
    };
    if (key != "input" && key != "out" && std::none_of(rows.begin(), rows.end(), is_named))
      job.fail("unknown key " + in_quotes(key));
  }
  out.input = sys::path_text(folder / job.at("input").text());
  out.out = sys::path_text(folder / job.at("out").text());
  for (const PackSettingRow& row : rows)
    if (!row.is(PackSettingRow::line_only) && job.has(row.name))
      read_pack_setting(row, job.at(row.name), folder, out);
  return out;
}

}  // namespace

std::vector<PackSettings> parse_pack_jobs(std::string_view text, const std::string& file,
                                          const PackSettings& usual) {
  const JsonDocument document = parse_json_strictly(text, file, jobs_depth, "a file of pack jobs");
  const JsonNode root{document, file, {}};
  root.expect_object({"schema", "jobs"});
  if (root.has("schema")) root.at("schema").expect_text("etak-pack-jobs/1");
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::vector<PackSettings> out =
      root.at("jobs").each([&](const JsonNode& job) { return read_job(job, folder, usual); });
  if (out.empty()) root.at("jobs").fail("no job", "at least one");
  return out;
}

}  // namespace etak
