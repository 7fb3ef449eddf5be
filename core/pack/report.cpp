// SPDX-License-Identifier: Apache-2.0
#include "core/base/json/json_text.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"
#include "core/image/texture_bytes.h"
#include "core/pack/blocks/report_blocks.h"
#include "core/pack/pack.h"

namespace etak {
namespace {

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

// 12345678 as "12.35 M".
std::string count(std::uint64_t value) {
  const double v = static_cast<double>(value);
  if (v >= 1e6) return fixed(v / 1e6, 2) + " M";
  if (v >= 1e4) return fixed(v / 1e3, 1) + " k";
  return std::to_string(value);
}

std::string right(const std::string& text, std::size_t width) {
  const std::size_t have = display_width(text);
  return have < width ? std::string(width - have, ' ') + text : text;
}

std::string account_json(const TexelAccount& account) {
  return "{\"texels\": " + json(account.texels) + ", \"channel_texels\": " + json(account.channel_texels) +
         "}";
}

// The first parts of a list: all are in the report's JSON.
std::string short_of(const LeaveOutLine& line) {
  constexpr std::size_t most = 3;
  if (line.parts.size() <= most) return line.detail;
  return joined(std::vector(line.parts.begin(), line.parts.begin() + most), ", ") + ", ...";
}

std::string line_json(const LeaveOutLine& line) {
  return "{\"what\": " + json(line.what) + ", \"materials\": " + json(line.materials) +
         ", \"detail\": " + json(line.detail) + ", \"texels\": " + json(line.texels) +
         ", \"channel_texels\": " + json(line.channel_texels) + ", \"bytes\": " + json(line.bytes) +
         ", \"error\": " + json(line.error) + "}";
}

std::string reduced_json(const ReducedRegion& r) {
  const auto size = [](int width, int height) {
    return "[" + std::to_string(width) + ", " + std::to_string(height) + "]";
  };
  return "{\"material\": " + json(r.material) + ", \"size\": " + size(r.width, r.height) +
         ", \"stored\": " + size(r.stored_width, r.stored_height) +
         ", \"seen_delta_e\": " + json(r.seen_delta_e) + ", \"delta_e\": " + json(r.delta_e) +
         ", \"codes\": " + json(r.codes) + "}";
}

std::string page_json(const PlannedPage& page) {
  return "{\"width\": " + std::to_string(page.width) + ", \"height\": " + std::to_string(page.height) +
         ", \"diffuse_alpha\": " + json(page.has[0]) + ", \"specular_gloss\": " + json(page.has[1]) + "}";
}

template <class Items, class Form>
std::string list_json(const Items& items, Form form) {
  return '[' + joined(items, ", ", form) + ']';
}

std::string totals_json(const TextureTotals& totals) {
  return "{\"files\": " + json(totals.files) + ", \"disk\": " + json(totals.disk) +
         ", \"gpu\": " + json(totals.gpu) + "}";
}

std::string side_json(const std::vector<RoleTotals>& roles) {
  return "{\"all\": " + totals_json(PackTotals::all(roles)) +
         ", \"material\": " + totals_json(PackTotals::of_materials(roles)) + ", \"roles\": " +
         list_json(roles,
                   [](const RoleTotals& each) {
                     return "{\"role\": " + json(each.role) + ", \"material\": " + json(each.material) +
                            ", \"totals\": " + totals_json(each.totals) + "}";
                   }) +
         "}";
}

std::string totals_json(const PackTotals& totals) {
  std::string out = "{\"input\": " + side_json(totals.input) + ", \"output\": " + side_json(totals.output);
  out += ", \"lossy_input\": " + totals_json(totals.lossy);
  if (totals.scene) out += ", \"scene\": " + totals_json(*totals.scene);
  return out + "}";
}

std::string megabytes(std::uint64_t bytes) {
  return fixed(static_cast<double>(bytes) / 1e6, 2) + " MB";
}

// A row of the table of textures, with shares of `whole` where there is one.
std::string totals_row(const std::string& what, const TextureTotals& totals, const TextureTotals* whole) {
  const auto share = [](std::uint64_t part, std::uint64_t all) {
    return right(all == 0 ? "" : fixed(percent(part, all), 0) + " %", 7);
  };
  return padded(what, 34) + right(std::to_string(totals.files), 6) + right(megabytes(totals.disk), 13) +
         share(totals.disk, whole ? whole->disk : 0) + right(megabytes(totals.gpu), 13) +
         (whole && whole->gpu > 0 ? share(totals.gpu, whole->gpu) : "") + "\n";
}

// The totals that people pay for in the end: all textures of the folder beside all of the input.
std::string totals_text(const PackTotals& totals) {
  const TextureTotals input = PackTotals::all(totals.input), output = PackTotals::all(totals.output);
  if (input.files + output.files == 0) return "";
  std::string out = "\n" + padded("textures", 34) + right("files", 6) + right("on disk", 13) + right("", 7) +
                    right("on the GPU, with mips", 21) + "\n";
  out += totals_row("the input", input, nullptr);
  for (const RoleTotals& each : totals.input) out += totals_row("  " + each.role, each.totals, nullptr);
  out += totals_row("this folder", output, &input);
  for (const RoleTotals& each : totals.output) out += totals_row("  " + each.role, each.totals, &input);
  if (totals.scene) out += totals_row("  of these, what scene.gltf reads", *totals.scene, &input);
  const TextureTotals before = PackTotals::of_materials(totals.input);
  const TextureTotals pair = PackTotals::of_materials(totals.output);
  if (before.gpu > 0 && (before != input || pair != output))
    out += "the pair's pages alone, which is what an engine loads with layout.json: " +
           fixed(percent(pair.gpu, before.gpu), 0) +
           " % of the input's colour and material textures on the GPU\n";
  if (totals.lossy.files > 0)
    out +=
        std::to_string(totals.lossy.files) + (totals.lossy.files == 1 ? " file" : " files") + " of " +
        megabytes(totals.lossy.disk) +
        " of the input lost detail to compression (JPEG, ...); what is made of them is lossless PNG, which mostly takes more\n";
  return out;
}

struct FormText {
  const char *name, *remark;
};
FormText text_of(GltfForm form) {
  if (form == GltfForm::specular_ior) return {"specular-ior", "a grey texture for roughness beside the pair"};
  if (form == GltfForm::specular_glossiness) return {"specular-glossiness", "not every viewer reads it"};
  return {"metal-rough", "base colour and metal-rough pages instead of the pair"};
}

std::string form_json(const FormCost& form) {
  return "{\"form\": " + json(text_of(form.form).name) + ", \"textures\": " + json(form.textures) +
         ", \"gpu\": " + json(form.gpu) + (form.disk ? ", \"disk\": " + json(*form.disk) : "") +
         ", \"exact\": " + json(form.exact) + ", \"written\": " + json(form.written) + "}";
}

std::string goal_json(const GoalCost& cost) {
  return "{\"goal\": " + json(name(cost.goal)) + ", \"form\": " + json(text_of(cost.form).name) +
         ", \"totals\": " + totals_json(cost.totals) + "}";
}

// What the scene's textures take in each form that glTF has for them.
std::string forms_text(const PackResult& r) {
  if (r.forms.empty()) return "";
  const bool disk = weighs_disk(r.goal);
  std::string out = "\nscene.gltf in each form: its textures ";
  out += disk ? "on disk and on the GPU" : "on the GPU";
  out += r.goal == PackGoal::gpu ? "\n" : " (weighed: " + std::string(name(r.goal)) + ")\n";
  const TextureTotals input = r.totals ? PackTotals::all(r.totals->input) : TextureTotals{};
  const auto share = [](std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? "" : right(fixed(percent(part, whole), 0) + " %", 7);
  };
  for (const FormCost& each : r.forms) {
    const FormText text = text_of(each.form);
    out += padded(each.written ? "* " + std::string(text.name) : "  " + std::string(text.name), 34);
    if (disk)
      out += each.disk ? right(megabytes(*each.disk), 13) + share(*each.disk, input.disk)
                       : right("not weighed", input.disk > 0 ? 20 : 13);
    out += right(megabytes(each.gpu), 13) + share(each.gpu, input.gpu);
    if (input.gpu > 0) out += " of the input";
    out += " in " + std::to_string(each.textures) + (each.textures == 1 ? " texture; " : " textures; ") +
           text.remark + (each.exact ? "" : "; not exact in this scene") + "\n";
  }
  return out;
}

// What was chosen for a scene, and what other goals would give.
std::string choice_text(const PackResult& r) {
  const auto written = std::ranges::find(r.forms, true, &FormCost::written);
  if (r.other_goals.empty() || written == r.forms.end() || !r.totals || !r.totals->scene) return "";
  const TextureTotals input = PackTotals::all(r.totals->input);
  const auto said = [&](GltfForm form, const TextureTotals& totals) {
    return std::string(text_of(form).name) + ", " + fixed(percent(totals.gpu, input.gpu), 0) +
           " % on the GPU, " + fixed(percent(totals.disk, input.disk), 0) + " % on the disk, " +
           std::to_string(totals.files) + (totals.files == 1 ? " texture" : " textures");
  };
  std::string out = "chosen: " + r.way + ": " + said(written->form, *r.totals->scene);
  for (const GoalCost& each : r.other_goals)
    out += "; " + setting("goal") + ' ' + name(each.goal) + ": " + said(each.form, each.totals);
  return out + "; " + setting("goal") + " one-page: one pair for all, without scene.gltf\n";
}

std::uint64_t pages_gpu(const PackResult& r) {
  std::uint64_t out = 0;
  for (const PlannedPage& page : r.pages) out += 2 * texture_bytes({page.width, page.height, 4}, true);
  return out;
}

// Bytes against binds: what one page for all materials takes, and what pages of their own would.
std::string one_page_text(const PackResult& r) {
  if (r.goal != PackGoal::one_page) return "";
  const auto bytes_of = [](std::uint64_t gpu) { return megabytes(gpu) + " on the GPU"; };
  std::string out = "\none page: " + std::to_string(r.materials) + " materials, one pair to bind, " +
                    bytes_of(pages_gpu(r)) + "; ";
  if (!r.apart) return out + "apart they fit no pages of that size\n";
  out += "apart, by " + setting("goal") + " gpu: " + std::to_string(r.apart->pages) +
         (r.apart->pages == 1 ? " pair, " : " pairs, ") + bytes_of(r.apart->gpu);
  if (r.apart->without_texels > 0)
    out += ", and " + std::to_string(r.apart->without_texels) + " without texels, by numbers";
  return out + "\n";
}

std::string pages_text(const PackResult& r) {
  std::string out;
  for (const PlannedPage& page : r.pages) {
    out += (out.empty() ? "" : ", ") + std::to_string(page.width) + "x" + std::to_string(page.height);
    if (!page.has[0] || !page.has[1]) out += page.has[0] ? " (diffuse_alpha only)" : " (specular_gloss only)";
  }
  return out;
}

}  // namespace

std::string report_text(const PackResult& r, bool stages) {
  if (r.up_to_date) return line_text(r.output) + ": up to date\n";
  std::string out = std::to_string(r.materials) + (r.materials == 1 ? " material, " : " materials, ") +
                    std::to_string(r.regions) + (r.regions == 1 ? " region" : " regions") + " on " +
                    std::to_string(r.pages.size()) + (r.pages.size() == 1 ? " page" : " pages");
  if (!r.pages.empty()) out += ": " + pages_text(r);
  out += "\nregions " + count(r.region_texels) + " texels, gutters " + count(r.gutter_texels) +
         ", page waste " + count(r.waste_texels) + "; gloss is " + std::string(name(r.gloss)) + "\n";
  if (r.inset) out += "no gutters: UVs must stay inside by each region's inset (layout.json)\n";
  if (r.mixed_from)
    out += "gutters keep regions apart below level " + std::to_string(*r.mixed_from) +
           "; viewers that make mips from PNG mix them from there on (" + setting("gutter") + " " +
           std::to_string(1 << *r.mixed_from) + " keeps one level more)\n";
  if (!r.left_out.lines.empty()) {
    out += "\n" + padded("left out", 12) + right("texels", 10) + right("channels", 11) + right("bytes", 10) +
           right("error", 7) + "  what\n";
    for (const LeaveOutLine& line : r.left_out.lines)
      out += padded(line.what, 12) + right(count(line.texels), 10) + right(count(line.channel_texels), 11) +
             right(count(line.bytes), 10) + right(number(line.error, 3), 7) + "  " +
             line_text(short_of(line)) + "\n";
  }
  const TexelAccount &before = r.left_out.before, &after = r.left_out.after;
  // Two counts of level 0: a byte for each channel that varies, and the four of each RGBA texel.
  out += "left of two full-size textures, gutters and page waste apart: " +
         fixed(percent(after.channel_texels, before.channel_texels), 1) + " % by channel, " +
         fixed(percent(after.texels, before.texels), 1) + " % as RGBA texels\n";
  for (const ReducedRegion& each : r.reduced)
    out += line_text(each.material) + ": " + std::to_string(each.width) + "x" + std::to_string(each.height) +
           " stored as " + std::to_string(each.stored_width) + "x" + std::to_string(each.stored_height) +
           ", dE " + number(each.delta_e, 3) + ", " + number(each.seen_delta_e, 3) + " of what is seen\n";
  if (r.totals) out += totals_text(*r.totals);
  out += blocks_text(r.blocks);
  out += forms_text(r) + choice_text(r) + one_page_text(r);
  if (stages)
    for (const PackStage& stage : r.stages)
      out += padded(stage.name, 18) + right(fixed(1000 * stage.seconds, 1), 9) + " ms\n";
  return out;
}

std::string report_json(const PackResult& r, bool stages) {
  std::vector<JsonMember> members{
      {"schema", json("etak-pack-report/1")},
      {"input", json(r.input)},
      {"output", json(r.output)},
      {"up_to_date", json(r.up_to_date)},
      {"dry_run", json(r.dry_run)},
      {"materials", json(r.materials)},
      {"regions", json(r.regions)},
      {"pages", list_json(r.pages, page_json)},
      {"texels", "{\"regions\": " + json(r.region_texels) + ", \"gutters\": " + json(r.gutter_texels) +
                     ", \"waste\": " + json(r.waste_texels) + "}"},
      {"gloss", json(name(r.gloss))},
      {"layout",
       "{\"method\": " + json(r.method) + ", \"tries\": " + std::to_string(r.tries) +
           ", \"cut_by_time\": " + json(r.cut_by_time) + ", \"kept_previous\": " + json(r.kept_previous) +
           ", \"moved\": " + json(r.moved) + ", \"inset\": " + json(r.inset) +
           (r.mixed_from ? ", \"mixed_from\": " + std::to_string(*r.mixed_from) : "") +
           ", \"levels\": " + std::to_string(r.levels) + ", \"passes\": " + std::to_string(r.passes) + "}"},
      {"left_out", list_json(r.left_out.lines, line_json)},
      {"reduced", list_json(r.reduced, reduced_json)},
      {"before", account_json(r.left_out.before)},
      {"after", account_json(r.left_out.after)},
      {"files", json_array_of(r.files)},
      {"remarks", json_array_of(r.remarks)},
  };
  if (!r.forms.empty()) {
    members.push_back({"goal", json(name(r.goal))});
    if (!r.way.empty()) members.push_back({"way", json(r.way)});
    if (!r.other_goals.empty()) members.push_back({"other_goals", list_json(r.other_goals, goal_json)});
    members.push_back({"forms", list_json(r.forms, form_json)});
  }
  if (r.goal == PackGoal::one_page) {
    std::string apart = "null";
    if (r.apart)
      apart = "{\"binds\": " + json(r.apart->pages) + ", \"gpu\": " + json(r.apart->gpu) +
              ", \"without_texels\": " + json(r.apart->without_texels) + "}";
    members.push_back(
        {"one_page", "{\"binds\": 1, \"gpu\": " + json(pages_gpu(r)) + ", \"apart\": " + apart + "}"});
  }
  if (r.totals) members.push_back({"totals", totals_json(*r.totals)});
  if (!r.blocks.empty())
    members.push_back({"blocks", list_json(r.blocks, [&](const BlockLevel& level) {
                         return block_level_json(level, stages);
                       })});
  if (!r.validation.empty()) members.push_back({"validation", r.validation});
  if (stages)
    members.push_back({"stages", list_json(r.stages, [](const PackStage& stage) {
                         return "{\"name\": " + json(stage.name) + ", \"seconds\": " + json(stage.seconds) +
                                "}";
                       })});
  return json_object(members, 0) + "\n";
}

}  // namespace etak
