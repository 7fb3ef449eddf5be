// SPDX-License-Identifier: Apache-2.0
#include "core/pack/pack.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "core/atlas/sources/floats.h"
#include "core/atlas/sources/masked.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/output_folder.h"
#include "core/base/files/output_target.h"
#include "core/base/files/read_places.h"
#include "core/base/files/steady_file.h"
#include "core/base/hash/content_hash.h"
#include "core/pack/blocks/page_format.h"
#include "core/pack/decision.h"
#include "core/pack/earlier.h"
#include "core/pack/identity.h"
#include "core/pack/one_page.h"
#include "core/pack/pages.h"
#include "core/pack/scene/scene_facts.h"
#include "core/pack/source.h"
#include "core/pack/stages.h"
#include "core/pack/table.h"

namespace etak {
namespace {

// Stands for the hash of the settings where the pages' check failed: no settings have it.
constexpr const char* not_good = "00000000000000000000000000000000";
// A second pass can teach something new only where texels come to be read that the first pass had left out.
constexpr int most_passes = 4;

using Stamps = std::vector<std::pair<std::string, FileStamp>>;  // of files when they were first looked at

Stamps stamps_of(const std::vector<std::string>& files) {
  Stamps out;
  for (const std::string& file : files) out.emplace_back(file, stamp_of(file));
  return out;
}

// Files are read more than once: for their header, their texels, and their hash. A picture that is exported
// anew meanwhile would make pages of two states, or a hash of another one than the pages hold.
void check_unchanged(const Stamps& stamps) {
  for (const auto& [file, stamp] : stamps)
    if (stamp_of(file) != stamp)
      throw Error::at(file, "changed while the atlas was made", "a file that stays as it is");
}

// The hash of the input's bytes, where the atlas in place has the same settings and all of its files.
std::optional<std::string> content_to_compare(const PackOptions& options, const PackSource& source,
                                              const EarlierAtlas& earlier) {
  if (!options.output.update || !earlier.layout ||
      earlier.layout->settings_hash != settings_hash(options, source) || !earlier.is_whole())
    return std::nullopt;
  return content_hash(options, source);
}

void learn_floats(PackInputs& inputs) {
  for (PackInput& m : inputs.materials) {
    if (m.facts.learned && !m.files.empty()) continue;  // a choice says that its texels count as equal
    PackInput read = m;
    if (m.files.empty()) read.width = read.height = 1;  // one texel of numbers alone says all
    look_at(load_floats(read), nullptr, m.facts.opaque, m.facts);
  }
}

// Writes the files beside the pages and marks files of the earlier atlas that are no longer needed for
// removal. Returns the names of all files of the atlas, sorted.
std::vector<std::string> complete(const PackOptions& options, const PackSource& source,
                                  const EarlierAtlas& earlier, const MadePages& made, PackResult& result) {
  OutputFolder& folder = *made.folder;
  AtlasLayout& layout = result.layout;
  if (source.scene)
    layout.other_files = write_scene(folder, layout, *source.scene, made.scene, made.scene_pictures);
  for (const PackInput& material : source.materials())
    for (const auto& [name, bytes] : mask_files(material)) {
      if (std::ranges::find(layout.other_files, name) != layout.other_files.end())
        throw Error::at(name, "two materials would write it", "names that differ in letters and digits");
      folder.write(name, bytes);
      layout.other_files.push_back(name);
    }
  std::set<std::string> files(layout.other_files.begin(), layout.other_files.end());
  for (const AtlasPage& page : layout.pages)
    for (const auto& names : page.files) files.insert(names.begin(), names.end());
  for (const std::string& name : files) {
    std::string& hash = layout.xxh128[name] = content_hash_of_file(folder.path_until_commit(name));
    if (hash.empty()) throw Error::at(name, "cannot be read again after it was written");
  }
  folder.write(layout_file_name, layout_json(layout));
  files.insert(layout_file_name);
  for (const std::string& name : files) refuse_stranger(earlier, name, options.output.overwrite);
  if (std::string stayed = remove_earlier(folder, earlier, files); !stayed.empty())
    result.remarks.push_back(std::move(stayed));
  return {files.begin(), files.end()};
}

void tell_clamped(const PackInputs& inputs, const std::vector<Learned>& learned,
                  std::vector<std::string>& remarks) {
  for (std::size_t i = 0; i < learned.size(); ++i)
    for (std::size_t t = 0; t < 2; ++t)
      if (const std::size_t clamped = learned[i].clamped[t]; clamped > 0) {
        const double all = static_cast<double>(inputs.materials[i].width) * inputs.materials[i].height;
        char share[32];
        std::snprintf(share, sizeof share, "%.3g", 100 * static_cast<double>(clamped) / all);
        remarks.push_back(inputs.materials[i].name + ": " + share + " % of the texels of " +
                          std::string(name(both_textures[t])) +
                          " lay outside of what it can hold and were brought back to its ends");
      }
}

// The clean levels of the region that has the fewest, of those that share a page; none where none does.
std::optional<int> least_clean_levels(const PackingPlan& plan) {
  std::vector<std::size_t> regions(plan.pages.size());
  for (const PlannedPlace& place : plan.places) ++regions[static_cast<std::size_t>(place.page)];
  std::optional<int> out;
  for (const PlannedPlace& place : plan.places)
    if (regions[static_cast<std::size_t>(place.page)] > 1)
      out = std::min(out.value_or(place.clean_levels), place.clean_levels);
  return out;
}

// How the texels of a scene lie.
std::string words_of(const PackDecision& decision) {
  if (decision.plan.pages.empty()) return "no page";
  const std::string what = decision.outlines  ? "islands by outline"
                           : decision.islands ? "islands by their boxes"
                           : decision.whole   ? "each picture whole on a page of its own"
                                              : "crops";
  const auto& places = decision.plan.places;
  const int least = std::ranges::min_element(places, {}, &PlannedPlace::gutter)->gutter;
  return what +
         (least > 0 ? ", gutters of " + std::to_string(least) + (decision.gutter ? "" : " or more") : "");
}

// Puts what was decided into the result.
void tell(const PackSource& source, const PackDecision& decision, const std::vector<Learned>& learned,
          const SceneChoice& scene, PackResult& result) {
  const PackingPlan& plan = decision.plan;
  result.regions = decision.needed.regions.size();
  result.pages = plan.pages;
  result.method = plan.method;
  result.tries = plan.tries;
  result.cut_by_time = plan.cut_by_time;
  result.kept_previous = plan.kept_previous;
  result.moved = plan.moved;
  result.inset = plan.inset;
  if (source.scene && source.scene->sampled_levels(1) > 1) result.mixed_from = least_clean_levels(plan);
  if (plan.clean_limit > 0)
    result.remarks.push_back("new regions have at most " + std::to_string(plan.clean_limit) +
                             " mips free of neighbours, so that the others could stay where they were");
  result.levels = result.layout.levels;
  result.left_out = decision.left_out;
  account(source.inputs, decision, result);
  if (source.one_page) account_of_parts(*source.one_page, decision, result);
  result.left_out.fates.clear();
  tell_clamped(source.inputs, learned, result.remarks);
  if (source.scene) add_remarks(*source.scene, scene, result.remarks);
  result.forms = scene.costs;
  result.way = words_of(decision);
  result.other_goals = decision.other_goals;
}

void put_all_in_place(const PackOptions& options, OutputFolder* folder, PackStages& stages,
                      PackResult& result) {
  const std::unique_ptr<Output> beside =
      options.check.beside ? options.check.beside(result, folder) : nullptr;
  std::vector<std::string> read{result.input};
  for (const auto& [file, stamp] : result.inputs) read.push_back(file);
  const auto places = std::make_shared<const ReadPlaces>(read);
  // Files that are put into the old folder before the exchange are kept; files put there after it are lost.
  Output* const outputs[] = {folder, beside.get()};
  for (Output* const each : outputs)
    if (each != nullptr) each->keep_off(places);
  stages.timed("commit", [&] { put_in_place(outputs); });
}

// Reads the input, decides what is stored and where, composes the pages, writes the files.
//   manifest   null: the file or folder `input` is packed
PackResult packed(const std::string& input, const PackManifest* manifest, const std::string& output,
                  const PackOptions& options, const MaterialLibrary& library) {
  PackStages stages(options.run.cancelled);
  PackResult result;
  result.input = input;
  result.output = output;
  result.dry_run = options.output.dry_run;

  PackSource source = stages.timed("inputs", [&] { return read_source(input, manifest, options, library); });
  result.materials = source.inputs.materials.size();
  result.gloss = source.inputs.gloss;
  result.remarks = source.inputs.remarks;
  const std::vector<std::string> read = input_files(options, source);
  const Stamps stamps = result.inputs = stamps_of(read);

  EarlierAtlas earlier = stages.timed("earlier result", [&] { return earlier_atlas(output); });
  earlier.inputs = ReadPlaces(read);
  earlier.inputs.add(input);
  const std::optional<std::string> content = content_to_compare(options, source, earlier);
  if (content && *content == earlier.layout->content_hash) {
    result.up_to_date = true;
    if (!options.output.dry_run) remove_remains(output);
    result.layout = *earlier.layout;
    result.files = earlier.files;
    result.stages = stages.all();
    return result;
  }
  if (writes_floats(options.output.write) && !source.scene)
    stages.timed("float values", [&] { learn_floats(source.inputs); });
  if (!options.output.dry_run) check_place(earlier, options.output.overwrite);
  std::optional<AtlasLayout> previous;
  if (const std::string& file = options.layout.previous; !file.empty())
    previous = parse_layout(read_file(file), file);

  if (options.output.goal == PackGoal::one_page)
    stages.timed("shared parts", [&] { source.one_page = share_parts(options, source, result); });
  if (source.scene && options.check.scene) options.check.scene(source.scene->packed());
  PackDecision decision;
  FoundResolutions found;
  std::vector<Learned> learned(source.inputs.materials.size());
  std::optional<MadePages> made;
  for (result.passes = 1;; ++result.passes) {
    std::vector<PackDecision> ways;
    stages.timed("layout", [&] { ways = decide(options, source, previous ? &*previous : nullptr, found); });
    decision = lightest(options, source, std::move(ways), stages);
    made = make_pages(options, source, earlier, decision, learned, stages);
    if (made) break;
    if (result.passes == most_passes) throw std::logic_error("the layout does not settle");
  }

  stages.timed("table", [&] {
    result.layout = layout_table(options, source, decision);
    result.layout.settings_hash = made->good ? settings_hash(options, source) : not_good;
    result.layout.content_hash = content ? *content : content_hash(options, source);
    check_unchanged(stamps);
  });
  result.blocks = made->blocks;
  result.block_pictures = std::move(made->block_pictures);
  tell_channels(result.blocks, options.output.write.formats, result.layout);
  if (made->folder) result.files = complete(options, source, earlier, *made, result);
  tell(source, decision, learned, made->scene, result);
  result.goal = options.output.goal;
  if (made->folder)
    stages.timed("totals", [&] { result.totals = pack_totals(source, options, result, *made->folder); });
  result.stages = stages.all();
  put_all_in_place(options, made->folder.get(), stages, result);
  result.stages = stages.all();
  return result;
}

}  // namespace

PackResult pack(const std::string& input, const std::string& output, const PackOptions& options,
                const MaterialLibrary& library) {
  return packed(input, nullptr, output, options, library);
}

PackResult pack(const PackManifest& manifest, const std::string& label, const std::string& output,
                const PackOptions& options, const MaterialLibrary& library) {
  return packed(label, &manifest, output, options, library);
}

}  // namespace etak
