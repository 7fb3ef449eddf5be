// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <set>

#include "core/base/json/node_json.h"
#include "core/base/system.h"
#include "core/pack/setting_reader.h"

namespace etak {
namespace {

constexpr int jobs_depth = 6;

PackSettings read_job(const JsonNode& job, const std::filesystem::path& folder, PackSettings out,
                      std::vector<std::string>& remarks) {
  job.expect_object();
  out.input = sys::path_text(folder / job.at("input").text());
  out.out = sys::path_text(folder / job.at("out").text());
  std::set<const PackSettingRow*> given;
  for (const auto& [key, ignored] : job.value.items()) {
    if (key == "input" || key == "out") continue;
    std::string remark;
    const PackSettingRow* const row = find_pack_setting(key, remark);
    if (row == nullptr || row->is(PackSettingRow::line_only)) job.fail("unknown key " + in_quotes(key));
    if (!given.insert(row).second) job.at(key).fail("given under another name too", "one of the two");
    if (!remark.empty()) remarks.push_back(std::string(job.file) + '#' + job.pointer + '/' + remark);
    read_pack_setting(*row, job.at(key), folder, out);
  }
  return out;
}

}  // namespace

std::vector<PackSettings> parse_pack_jobs(std::string_view text, const std::string& file,
                                          const PackSettings& usual, std::vector<std::string>& remarks) {
  const JsonDocument document = parse_json_strictly(text, file, jobs_depth, "a file of pack jobs");
  const JsonNode root{document, file, {}};
  root.expect_object({"schema", "jobs"});
  if (root.has("schema")) root.at("schema").expect_text("etak-pack-jobs/1");
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::vector<PackSettings> out =
      root.at("jobs").each([&](const JsonNode& job) { return read_job(job, folder, usual, remarks); });
  if (out.empty()) root.at("jobs").fail("no job", "at least one");
  return out;
}

}  // namespace etak
