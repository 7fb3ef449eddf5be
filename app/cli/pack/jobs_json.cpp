// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "app/cli/pack/jobs.h"
#include "core/base/node_json.h"

namespace etak::cli {
namespace {

double in_range(const JsonNode& node, double least, double most) {
  const double value = node.number();
  if (value < least || value > most) node.fail_type("a number within the option's range");
  return value;
}

}  // namespace

std::vector<PackArguments> parse_jobs(std::string_view text, const std::string& file,
                                      const PackArguments& line) {
  constexpr int most_depth = 6;
  const JsonDocument document = parse_json_strictly(text, file, most_depth, "a file of pack jobs");
  const JsonNode root{document, file, {}};
  root.expect_object({"schema", "jobs"});
  if (root.has("schema") && root.at("schema").text() != "etak-pack-jobs/1")
    root.at("schema").fail_type("\"etak-pack-jobs/1\"");
  const JsonNode jobs = root.at("jobs");
  jobs.expect_array();
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::vector<PackArguments> out;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const JsonNode job = jobs.at(i);
    job.expect_object({"input",     "out",   "page",      "page-form",     "rotate",      "effort",
                       "gutter",    "mips",  "previous",  "extra-area",    "keep",        "islands",
                       "pattern",   "gloss", "bleed",     "scene",         "gltf-form",   "format",
                       "png-level", "zstd",  "max-error", "texel-density", "view-height", "space-of",
                       "ocio",      "choice"});
    PackArguments a = line;
    const auto text_of = [&](const char* key, std::string& value) {
      if (job.has(key)) value = job.at(key).text();
    };
    const auto path_of = [&](const char* key, std::string& value) {
      if (job.has(key)) value = (folder / job.at(key).text()).string();
    };
    const auto number_of = [&](const char* key, int& value, int least, int most) {
      if (job.has(key)) value = job.at(key).integer(least, most);
    };
    const auto flag_of = [&](const char* key, bool& value) {
      if (job.has(key)) value = job.at(key).boolean();
    };
    // "8" and 8 alike, because some options take a word as well.
    const auto word_of = [&](const char* key, std::string& value) {
      if (!job.has(key)) return;
      const JsonNode node = job.at(key);
      value = node.value.is_number() ? std::to_string(node.integer(0)) : node.text();
    };
    a.input = (folder / job.at("input").text()).string();
    a.out = (folder / job.at("out").text()).string();
    number_of("page", a.page, 1, 16384);
    number_of("effort", a.effort, 1, 1000000);
    number_of("zstd", a.zstd, 0, 22);
    number_of("scene", a.scene, 0, 1000000);
    if (job.has("extra-area")) a.extra_area = job.at("extra-area").number();
    if (job.has("max-error")) a.max_error = in_range(job.at("max-error"), 0, 1000);
    if (job.has("texel-density")) a.texel_density = in_range(job.at("texel-density"), 1e-9, 1e12);
    number_of("view-height", a.view_height, 1, 1000000);
    if (job.has("space-of")) a.space_of = job.at("space-of").texts();
    path_of("ocio", a.ocio);
    text_of("page-form", a.page_form);
    text_of("pattern", a.pattern);
    text_of("gloss", a.gloss);
    text_of("gltf-form", a.gltf_form);
    text_of("format", a.formats);
    text_of("png-level", a.png_level);
    path_of("previous", a.previous);
    path_of("choice", a.choice);
    word_of("gutter", a.gutter);
    word_of("mips", a.mips);
    flag_of("rotate", a.rotate);
    flag_of("islands", a.islands);
    flag_of("bleed", a.bleed);
    if (job.has("keep")) a.keep = job.at("keep").texts();
    for (const auto& [key, value, words] :
         {std::tuple{"page-form", a.page_form, "auto mixed pages square pot free"},
          std::tuple{"png-level", a.png_level, "fast small smallest"},
          std::tuple{"gloss", a.gloss, "schueler one_minus_roughness roughness"}})
      if (job.has(key) && (" " + std::string(words) + " ").find(" " + value + " ") == std::string::npos)
        job.at(key).fail_type(words);
    out.push_back(std::move(a));
  }
  if (out.empty()) jobs.fail("no job", "at least one");
  return out;
}

}  // namespace etak::cli
