// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "core/pack/settings.h"
#include "tests/core/atlas/pack_support.h"

using namespace etak;
using namespace etak::test;

namespace {

// A job that says one thing beside input and output.
std::string job_with(std::string_view key, const std::string& value) {
  return R"({"jobs": [{"input": "a.json", "out": "b", ")" + std::string(key) + "\": " + value + "}]}";
}

std::vector<PackSettings> jobs_with(std::string_view key, const std::string& value,
                                    std::vector<std::string> expected_remarks = {}) {
  std::vector<std::string> remarks;
  std::vector<PackSettings> out = parse_pack_jobs(job_with(key, value), "dir/jobs.json", {}, remarks);
  CHECK(remarks == expected_remarks);
  return out;
}

std::string fault_of_job(std::string_view key, const std::string& value) {
  return error_of([&] { (void)jobs_with(key, value); });
}

// Something that a job may say of the setting.
std::string value_for(const PackSettingRow& row) {
  if (std::holds_alternative<bool PackSettings::*>(row.value)) return "true";
  if (std::holds_alternative<std::vector<std::string> PackSettings::*>(row.value)) return R"(["x"])";
  if (std::holds_alternative<std::string PackSettings::*>(row.value))
    return '"' + (row.words.empty() ? "x" : row.word_list().back()) + '"';
  return row.least < row.most && row.most < 7 ? std::to_string(static_cast<int>(row.most)) : "7";
}

}  // namespace

TEST_CASE("every setting of a job is read into its own place, and what is for the line alone is refused") {
  std::set<std::string_view> names;
  for (const PackSettingRow& row : pack_setting_rows()) {
    INFO(row.name);
    CHECK(names.insert(row.name).second);
    if (row.is(PackSettingRow::line_only)) {
      CHECK(contains(fault_of_job(row.name, value_for(row)), "unknown key"));
      continue;
    }
    const auto jobs = jobs_with(row.name, value_for(row));
    REQUIRE(jobs.size() == 1);
    PackSettings plain;
    plain.input = "dir/a.json";
    plain.out = "dir/b";
    CHECK_FALSE(jobs[0] == plain);
    std::visit([&](auto member) { plain.*member = jobs[0].*member; }, row.value);
    CHECK(jobs[0] == plain);
  }
  CHECK(names.size() == 33);
}

TEST_CASE("a job's numbers and words keep to the ranges and words of the table") {
  for (const PackSettingRow& row : pack_setting_rows()) {
    INFO(row.name);
    if (row.least < row.most && !row.is(PackSettingRow::line_only)) {
      CHECK_FALSE(fault_of_job(row.name, "-1").empty());
      CHECK_FALSE(fault_of_job(row.name, "2e12").empty());
    }
    if (!row.words.empty()) CHECK(contains(fault_of_job(row.name, "\"no such word\""), row.words));
  }
  const auto of = [](const char* key, const char* value) { return jobs_with(key, value).at(0); };
  CHECK(of("gutter", "8").gutter == of("gutter", R"("8")").gutter);
  CHECK(of("previous", R"("old.json")").previous == "dir/old.json");
}

TEST_CASE(
    "jobs name settings as the command line does; older names work with a remark, and not beside the newer ones") {
  const std::string place = "dir/jobs.json#/jobs/0/";
  CHECK(jobs_with("gloss-channel", R"("roughness")") ==
        jobs_with("gloss", R"("roughness")", {place + "gloss: is now called gloss-channel"}));
  CHECK(jobs_with("textures", R"("png,dds")") ==
        jobs_with("format", R"("png,dds")", {place + "format: is now called textures"}));
  CHECK(jobs_with("gloss_channel", R"("roughness")") == jobs_with("gloss-channel", R"("roughness")"));
  CHECK(fault_of_job("format", R"("png", "textures": "dds")") ==
        place + "textures: given under another name too; expected one of the two");
}

TEST_CASE("faults of settings, and the help, name settings without dashes where no command line was named") {
  const auto fault_of = [](auto change) {
    PackSettings settings;
    change(settings);
    return error_of([&] { (void)pack_options(settings); });
  };
  CHECK(fault_of([](PackSettings& s) { s.keep = {"nothing"}; }).starts_with("keep: nothing; expected "));
  CHECK(fault_of([](PackSettings& s) { s.gltf_form = "x"; }).starts_with("gltf form: x; expected "));
  CHECK(fault_of([](PackSettings& s) {
          s.goal = "disk";
          s.gltf_form = "metal-rough,specular-glossiness";
        }) == "goal: disk beside two forms in one file; expected one gltf form, or smallest");
  CHECK(fault_of([](PackSettings& s) { s.space_of = {"gloss=srgb"}; }).starts_with("space of: gloss=srgb;"));
  CHECK(fault_of([](PackSettings& s) { s.gutter = "-1"; }) == "gutter: -1; expected auto, or 0 to 4096");
  CHECK(fault_of([](PackSettings& s) { s.format = "gif"; }).starts_with("textures: gif; expected png"));
  for (const PackSettingRow& row : pack_setting_rows()) {
    const std::string help = row.help_text();
    INFO(help);
    CHECK(help.find_first_of("{}") == help.npos);
    if (row.name == "page-form") CHECK(contains(help, "powers of two up to page,"));
  }
}

TEST_CASE("pack() returns the layout that it wrote, and the one in place where nothing was done") {
  const TempFolder folder;
  add_noise_material(folder, "a", 24, 16, 1);
  PackOptions options;
  options.output.update = true;
  const PackResult first = pack_text(folder, manifest_of({manifest_entry("a")}), options);
  CHECK_FALSE(first.up_to_date);
  CHECK(first.layout == packed_layout(folder));
  const PackResult second = pack_text(folder, manifest_of({manifest_entry("a")}), options);
  CHECK(second.up_to_date);
  CHECK(second.layout == first.layout);
}
