// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack/pack.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "core/atlas/compose.h"
#include "core/atlas/compose_floats.h"
#include "core/atlas/pack/decision.h"
#include "core/atlas/pack/gltf_pack.h"
#include "core/atlas/pack/identity.h"
#include "core/atlas/pack/progress.h"
#include "core/atlas/pack/table.h"
#include "core/atlas/page_stream.h"
#include "core/atlas/sources/apply_variants.h"
#include "core/atlas/sources/floats.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/input.h"
#include "core/base/files/output_target.h"
#include "core/base/files/steady_file.h"

namespace etak {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* layout_name = "layout.json";
// Stands for the hash of the settings where the pages' check failed: no settings have it.
constexpr const char* not_good = "00000000000000000000000000000000";
// What the texels teach once can teach more only where a material that another one had hidden comes to light.
constexpr int most_passes = 4;

bool exists(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0;
}

class Packing {
 public:
  Packing(const std::string& input, const std::string& output, const PackOptions& options,
          const MaterialLibrary& library, const PackManifest* manifest = nullptr)
      : input_(input), output_(output), options_(options), library_(library), manifest_(manifest) {
    report_.input = input;
    report_.output = output;
    report_.dry_run = options.dry_run;
  }

  PackReport run() {
    timed("inputs", [&] { read_inputs(); });
    for (const std::string& file : input_files(options_, inputs_, scene_.get()))
      stamps_.emplace_back(file, stamp_of(file));
    timed("earlier result", [&] { look_at_target(); });
    if (options_.update && up_to_date()) {
      report_.up_to_date = true;
      report_.files = owned_;
      return std::move(report_);
    }
    if (writes_floats() && !scene_)
      timed("float values", [&] {
        for (PackInput& m : inputs_.materials)
          if (!m.facts.learned || m.files.empty())  // else somebody said that its texels count as equal
            look_at_floats(load_floats(m), nullptr, m.facts.opaque, m.facts);
      });
    if (!options_.dry_run) check_place();
    if (!options_.previous.empty()) previous_ = parse_layout(read_file(options_.previous), options_.previous);
    for (report_.passes = 1;; ++report_.passes) {
      timed("layout", [&] { decision_->decide(previous_ ? &*previous_ : nullptr); });
      if (make_pages()) break;
      folder_.reset();
      if (report_.passes == most_passes) throw std::logic_error("the layout does not settle");
    }
    finish();
    put_all_in_place();
    return std::move(report_);
  }

 private:
  template <class Act>
  void timed(const char* name, Act act) {
    stop_if_cancelled();
    const auto begin = Clock::now();
    act();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    for (PackStage& stage : report_.stages)
      if (stage.name == name) {
        stage.seconds += seconds;
        return;
      }
    report_.stages.push_back({name, seconds});
  }

  const ShadingVariants* variants() const { return options_.variants ? &*options_.variants : nullptr; }

  const std::vector<Region>& regions() const { return decision_->regions(); }
  const PackingPlan& plan() const { return decision_->plan(); }
  AtlasLayout table() const { return layout_table(options_, inputs_, *decision_, scene_ != nullptr); }

  void stop_if_cancelled() const {
    if (options_.cancelled && options_.cancelled()) throw PackCancelled();
  }

  void take_manifest(const PackManifest& of) {
    inputs_ = resolve_manifest(with_methods(of.manifest, variants()), library_, options_.gloss, options_.door,
                               options_.open_space, options_.spaces);
    inputs_.remarks.insert(inputs_.remarks.begin(), of.remarks.begin(), of.remarks.end());
    inputs_.settings += of.settings;
  }

  void read_inputs() {
    std::error_code failure;
    if (manifest_ != nullptr) {
      take_manifest(*manifest_);
    } else if (fs::is_directory(input_, failure)) {
      std::vector<std::string> skipped;
      AtlasManifest manifest = manifest_of_folder(input_, options_.pattern, &skipped);
      inputs_ = resolve_manifest(with_methods(std::move(manifest), variants()), library_, options_.gloss,
                                 options_.door, options_.open_space, options_.spaces);
      std::sort(skipped.begin(), skipped.end());
      if (!skipped.empty()) inputs_.remarks.push_back(skipped_remark(skipped));
      inputs_.settings += options_.pattern;
    } else if (is_gltf_file(input_)) {
      scene_ = std::make_unique<ScenePack>(input_, options_);
      inputs_ = scene_->inputs();
    } else {
      const std::string text = read_file(input_);
      std::optional<PackManifest> other;
      if (options_.other_manifest) other = options_.other_manifest(text, input_);
      take_manifest(other ? std::move(*other) : PackManifest{parse_manifest(text, input_), {}, text});
    }
    if (options_.variants)
      apply_variants(*options_.variants, options_.keep.contains("constant"), input_, inputs_);
    if (!scene_ && (options_.texel_density > 0 || options_.view_height > 0))
      throw Error::at(options_.texel_density > 0 ? "--texel-density" : "--view-height",
                      input_ + " says nothing of sizes in a world", "a glTF scene");
    if (scene_ && !options_.spaces.empty())
      throw Error::at("--space-of", "a glTF scene, which says what space its pictures are of",
                      "a manifest or a folder");
    decision_.emplace(options_, inputs_, scene_.get());
    learned_.resize(inputs_.materials.size());
    report_.materials = inputs_.materials.size();
    report_.gloss = inputs_.gloss;
    report_.remarks = inputs_.remarks;
  }

  // ---- the result in place

  void look_at_target() {
    const std::string path = output_ + '/' + layout_name;
    if (!exists(path)) return;
    try {
      old_ = parse_layout(read_file(path), path);
    } catch (const Error&) {
      return;  // no layout of ours, so nothing there is ours to replace
    }
    owned_.push_back(layout_name);
    for (const AtlasPage& page : old_->pages)
      for (const auto& files : page.files) owned_.insert(owned_.end(), files.begin(), files.end());
    owned_.insert(owned_.end(), old_->other_files.begin(), old_->other_files.end());
  }

  // Before the work: whether the folder can be made or changed, and files that are not ours stay.
  void check_place() const {
    check_folder_target(output_, {}, may_replace());
    refuse_stranger(layout_name);
  }

  void refuse_stranger(const std::string& name) const {
    const bool owned = std::find(owned_.begin(), owned_.end(), name) != owned_.end();
    if (!owned && !options_.overwrite && exists(output_ + '/' + name))
      throw Error::at(output_ + '/' + name, "exists already and is of no earlier atlas",
                      "another folder, or --force to replace it");
  }

  bool up_to_date() {
    if (!old_ || old_->settings_hash != settings_hash(options_, inputs_)) return false;
    for (const std::string& name : owned_)
      if (!exists(output_ + '/' + name)) return false;
    content_hash_ = content_hash(options_, inputs_, scene_.get());
    return old_->content_hash == content_hash_;
  }

  // ---- pages

  // Files of an earlier atlas are replaced; which others may be says refuse_stranger().
  Replace may_replace() const { return options_.overwrite ? Replace::anything : Replace::files; }

  // False: what the texels taught changes the layout, and nothing was kept.
  bool make_pages() {
    if (!options_.dry_run) folder_.emplace(output_, may_replace());
    ComposeOptions compose;
    compose.threads = options_.threads;
    compose.bleed = options_.bleed;
    compose.gloss = inputs_.gloss;
    // The layout says which pages there are: their files are known before their texels.
    if (folder_)
      for (int p = 0; p < static_cast<int>(plan().pages.size()); ++p)
        for (const Texture texture : both_textures)
          if (plan().pages[static_cast<std::size_t>(p)].has[static_cast<std::size_t>(texture)])
            for (const std::string& name :
                 page_files(p, texture, decision_->page_levels(p), options_.write.formats))
              refuse_stranger(name);
    Composer composer(inputs_.materials, regions(), plan(), compose);
    PagePixels pixels;
    PackProgress progress(options_.progress, plan(), regions().size(), options_.write, folder_.has_value());
    const auto region_done = [&] {
      stop_if_cancelled();
      progress.region();
    };
    for (int p = 0; p < static_cast<int>(plan().pages.size()); ++p) {
      const PlannedPage& page = plan().pages[static_cast<std::size_t>(p)];
      check_memory(p);
      if (const std::vector<int> cuts = cuts_of(composer, p); cuts.size() > 2) {
        WriteOptions write = options_.write;
        write.threads = options_.threads;
        pixels.release();
        timed("texels, mips and files", [&] {
          stream_page(composer, regions(), plan(), p, decision_->page_levels(p), cuts, learned_,
                      folder_ ? &*folder_ : nullptr, write, region_done);
        });
        progress.written(2 * PackProgress::texels_of(page));
        if (decision_->learn(learned_)) return false;
        if (options_.check_page && folder_) check_written(p, *folder_);
        continue;
      }
      pixels.start(page, decision_->page_levels(p));
      timed("texels", [&] { composer.texels(p, pixels, learned_, region_done); });
      if (decision_->learn(learned_)) return false;
      timed("gutters and mips", [&] { composer.mips(p, pixels); });
      check(p, pixels);
      if (!folder_) continue;
      WriteOptions write = options_.write;
      write.threads = options_.threads;
      write.written = [&](std::size_t texels) {
        stop_if_cancelled();
        progress.written(texels);
      };
      timed("write", [&] {
        for (const Texture texture : both_textures) {
          stop_if_cancelled();
          if (page.has[static_cast<std::size_t>(texture)]) write_page(*folder_, p, texture, pixels, write);
        }
        if (scene_) scene_->write_page(*folder_, p, pixels, write);
      });
      if (writes_floats()) timed("floats", [&] { write_floats(*folder_, p, compose); });
    }
    check(static_cast<int>(plan().pages.size()), pixels);
    pixels.release();
    timed("table", [&] {
      layout_ = table();
      layout_.settings_hash = good_ ? settings_hash(options_, inputs_) : not_good;
      layout_.content_hash =
          content_hash_.empty() ? content_hash(options_, inputs_, scene_.get()) : content_hash_;
      check_inputs_unchanged();
    });
    if (folder_) complete(*folder_);
    return true;
  }

  // Where a page can be made slab by slab: what else is written of it, and the check, need
  // it whole.
  std::vector<int> cuts_of(const Composer& composer, int p) const {
    if (options_.check_page && (!options_.check_written_page || options_.dry_run)) return {};
    if (scene_ || options_.write.formats != std::vector<std::string>{"png"}) return {};
    return page_cuts(composer, regions(), plan(), p, decision_->page_levels(p), options_.bleed);
  }

  void check(int page, const PagePixels& pixels) {
    if (page == 0) good_ = true;
    if (!options_.check_page) return;
    timed("validate", [&] { good_ = options_.check_page(table(), page, pixels) && good_; });
  }

  void check_written(int page, const OutputFolder& folder) {
    if (page == 0) good_ = true;
    const auto path = [&](Texture texture) {
      return folder.path_until_commit(page_file(page, texture, "png"));
    };
    timed("validate", [&] { good_ = options_.check_written_page(table(), page, path) && good_; });
  }

  void check_memory(int p) const {
    const PlannedPage& page = plan().pages[static_cast<std::size_t>(p)];
    std::size_t bytes = 0;
    const std::size_t texel = writes_floats() ? 8 + 32 : 8;
    for (int l = 0; l < decision_->page_levels(p); ++l)
      bytes += texel * static_cast<std::size_t>(std::max(1, page.width >> l)) *
               static_cast<std::size_t>(std::max(1, page.height >> l));
    if (options_.memory != 0 && bytes > options_.memory)
      throw Error::at("--memory",
                      "a page of " + std::to_string(page.width) + " x " + std::to_string(page.height) +
                          " takes " + std::to_string((bytes >> 20) + 1) + " MiB",
                      "more memory, or a smaller --page");
  }

  // Files are read more than once: for their header, their texels, and their hash. A picture that is exported
  // anew meanwhile would make pages of two states, or a hash of another one than the pages hold.
  void check_inputs_unchanged() const {
    for (const auto& [file, stamp] : stamps_)
      if (stamp_of(file) != stamp)
        throw Error::at(file, "changed while the atlas was made", "a file that stays as it is");
  }

  bool writes_floats() const {
    const auto& formats = options_.write.formats;
    return std::any_of(formats.begin(), formats.end(), [](const auto& each) { return holds_floats(each); });
  }

  void write_floats(OutputFolder& folder, int p, const ComposeOptions& compose) {
    const FloatPage page =
        compose_floats(p, decision_->page_levels(p), inputs_.materials, regions(), plan(), compose);
    for (const std::string& format : options_.write.formats)
      if (holds_floats(format)) write_float_page(folder, p, page, format, options_.door);
  }

  void complete(OutputFolder& folder) {
    if (scene_)
      for (const std::string& name :
           scene_->write_scene(folder, layout_, plan(), regions(), decision_->left_out()))
        layout_.other_files.push_back(name);
    folder.write(layout_name, layout_json(layout_));
    std::set<std::string> files{layout_name};
    for (const AtlasPage& page : layout_.pages)
      for (const auto& names : page.files) files.insert(names.begin(), names.end());
    files.insert(layout_.other_files.begin(), layout_.other_files.end());
    for (const std::string& name : files) refuse_stranger(name);
    for (const std::string& name : owned_)
      if (!files.contains(name)) folder.remove_old(name);
    report_.files.assign(files.begin(), files.end());
  }

  void put_all_in_place() {
    const std::unique_ptr<Output> beside =
        options_.beside ? options_.beside(report_, folder_ ? &*folder_ : nullptr) : nullptr;
    // What lies in the old folder before the exchange comes along, and what is put there after it is lost.
    Output* const outputs[] = {beside.get(), folder_ ? &*folder_ : nullptr};
    timed("commit", [&] { put_in_place(outputs); });
  }

  // ---- report

  void finish() {
    const PackingPlan& plan = decision_->plan();
    report_.regions = regions().size();
    report_.pages = plan.pages;
    report_.method = plan.method;
    report_.tries = plan.tries;
    report_.cut_by_time = plan.cut_by_time;
    report_.kept_previous = plan.kept_previous;
    report_.moved = plan.moved;
    report_.inset = plan.inset;
    if (plan.clean_limit > 0)
      report_.remarks.push_back("new regions have at most " + std::to_string(plan.clean_limit) +
                                " mips free of neighbours, so that the others could stay where they were");
    report_.levels = layout_.levels;
    report_.left_out = decision_->left_out();
    account(inputs_, *decision_, report_);
    report_.left_out.fates.clear();
    for (std::size_t i = 0; i < learned_.size(); ++i)
      for (std::size_t t = 0; t < 2; ++t)
        if (const std::size_t clamped = learned_[i].clamped[t]; clamped > 0) {
          const double all = static_cast<double>(inputs_.materials[i].width) * inputs_.materials[i].height;
          char share[32];
          std::snprintf(share, sizeof share, "%.3g", 100 * static_cast<double>(clamped) / all);
          report_.remarks.push_back(inputs_.materials[i].name + ": " + share + " % of the texels of " +
                                    std::string(name(both_textures[t])) +
                                    " lay outside of what it can hold and were brought back to its ends");
        }
    if (scene_) scene_->add_remarks(report_.remarks);
  }

  const std::string input_, output_;
  const PackOptions& options_;
  const MaterialLibrary& library_;
  const PackManifest* const manifest_;  // null: `input_` is what is packed
  PackReport report_;
  PackInputs inputs_;
  std::unique_ptr<ScenePack> scene_;
  std::optional<AtlasLayout> old_, previous_;
  std::vector<std::string> owned_;
  std::string content_hash_;
  std::vector<std::pair<std::string, FileStamp>> stamps_;  // of the inputs when they were first looked at
  bool good_ = true;                                       // what options_.check_page says of all pages
  std::vector<Learned> learned_;
  std::optional<OutputFolder> folder_;    // whole, and not in place yet; none in a dry run
  std::optional<PackDecision> decision_;  // from the inputs on
  AtlasLayout layout_;
};

}  // namespace

PackReport pack(const std::string& input, const std::string& output, const PackOptions& options,
                const MaterialLibrary& library) {
  return Packing(input, output, options, library).run();
}

PackReport pack(const PackManifest& manifest, const std::string& label, const std::string& output,
                const PackOptions& options, const MaterialLibrary& library) {
  return Packing(label, output, options, library, &manifest).run();
}

}  // namespace etak
