// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/pack.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <tuple>

#include "core/atlas/apply_variants.h"
#include "core/atlas/compose.h"
#include "core/atlas/compose_floats.h"
#include "core/atlas/content_hash.h"
#include "core/atlas/defines.h"
#include "core/atlas/floats.h"
#include "core/atlas/gltf_pack.h"
#include "core/atlas/page_stream.h"
#include "core/atlas/resolution.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/number.h"
#include "core/base/parallel.h"
#include "core/image/mips.h"

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
          const MaterialLibrary& library, const Project* project = nullptr)
      : input_(input), output_(output), options_(options), library_(library), project_(project) {
    report_.input = input;
    report_.output = output;
    report_.dry_run = options.dry_run;
  }

  PackReport run() {
    timed("inputs", [&] { read_inputs(); });
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
    if (!options_.previous.empty()) previous_ = parse_layout(read_file(options_.previous), options_.previous);
    for (report_.passes = 1;; ++report_.passes) {
      timed("layout", [&] { decide(); });
      if (make_pages() || report_.passes == most_passes) break;
    }
    finish();
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

  void stop_if_cancelled() const {
    if (options_.cancelled && options_.cancelled()) throw PackCancelled();
  }

  void take_project(const Project& project) {
    std::vector<std::string> remarks;
    inputs_ = resolve_manifest(with_methods(manifest_of(project, library_, remarks), variants()), library_,
                               options_.gloss, options_.door, options_.open_space, options_.spaces);
    inputs_.remarks.insert(inputs_.remarks.begin(), remarks.begin(), remarks.end());
    // How the project is looked at changes no texel.
    Project materials = project;
    materials.view = {};
    inputs_.settings += format_project(materials, "");
  }

  void read_inputs() {
    std::error_code failure;
    if (project_ != nullptr) {
      take_project(*project_);
    } else if (fs::is_directory(input_, failure)) {
      inputs_ =
          resolve_manifest(with_methods(manifest_of_folder(input_, options_.pattern), variants()), library_,
                           options_.gloss, options_.door, options_.open_space, options_.spaces);
      inputs_.settings += options_.pattern;
    } else if (input_.ends_with(".gltf") || input_.ends_with(".glb")) {
      scene_ = std::make_unique<ScenePack>(input_, options_);
      inputs_ = scene_->inputs();
    } else {
      const std::string text = read_file(input_);
      if (is_project(text)) {
        take_project(parse_project(text, input_));
      } else {
        inputs_ = resolve_manifest(with_methods(parse_manifest(text, input_), variants()), library_,
                                   options_.gloss, options_.door, options_.open_space, options_.spaces);
        inputs_.settings += text;
      }
    }
    if (options_.variants)
      apply_variants(*options_.variants, options_.keep.contains("constant"), input_, inputs_);
    if (!scene_ && (options_.texel_density > 0 || options_.view_height > 0))
      throw Error::at(options_.texel_density > 0 ? "--texel-density" : "--view-height",
                      input_ + " says nothing of sizes in a world", "a glTF scene");
    if (scene_ && !options_.spaces.empty())
      throw Error::at("--space-of", "a glTF scene, which says what space its pictures are of",
                      "a manifest or a folder");
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

  std::string settings_hash() const {
    ContentHash hash;
    std::string text = options_.version + '|' + inputs_.settings + '|' + options_.check_settings + '|';
    for (const std::string& each : options_.keep) text += each + ',';
    for (const std::string& each : options_.write.formats) text += each + ',';
    for (const GltfForm form : options_.forms) text += std::to_string(static_cast<int>(form)) + ',';
    const auto number = [&](auto value) { text += std::to_string(value) + '|'; };
    number(static_cast<int>(inputs_.gloss));
    number(options_.form ? static_cast<int>(*options_.form) : -1);
    number(static_cast<int>(options_.write.png_level));
    number(options_.write.zstd_level);
    number(options_.page);
    number(int{options_.rotate} + 2 * int{options_.islands} + 4 * int{options_.bleed});
    number(options_.effort);
    number(options_.max_seconds);
    number(options_.gutter.value_or(-1));
    number(options_.mips.value_or(-1));
    number(options_.most_extra_area);
    number(options_.scene.scene.value_or(-1));
    number(int{options_.scene.all_scenes} + 2 * int{options_.scene.variants});
    number(options_.max_error.value_or(-1));
    number(options_.texel_density);
    number(options_.view_height);
    for (const auto& [role, space] : options_.spaces) text += role + '=' + space + '|';
    hash.add(text);
    return hash.hex();
  }

  std::string content_hash() const {
    std::vector<std::string> files;
    for (const PackInput& m : inputs_.materials) {
      files.insert(files.end(), m.files.begin(), m.files.end());
      if (m.normal.is_image()) files.push_back(m.normal.path);
    }
    if (scene_) scene_->add_files(files);
    if (!options_.space_config.empty()) files.push_back(options_.space_config);
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    std::vector<std::string> hashes(files.size());
    std::vector<FileBytes> memory(options_.threads);
    parallel_chunks(files.size(), options_.threads, 1, [&](std::size_t begin, std::size_t, unsigned worker) {
      memory[worker].load(files[begin]);
      ContentHash hash;
      hash.add(memory[worker].view());
      hashes[begin] = hash.hex();
    });
    ContentHash all;
    std::string text;
    for (const std::string& each : hashes) text += each;
    all.add(text);
    return all.hex();
  }

  bool up_to_date() {
    if (!old_ || old_->settings_hash != settings_hash()) return false;
    for (const std::string& name : owned_)
      if (!exists(output_ + '/' + name)) return false;
    content_hash_ = content_hash();
    return old_->content_hash == content_hash_;
  }

  // ---- what goes where

  void decide() {
    std::vector<MaterialFacts> facts;
    for (const PackInput& m : inputs_.materials) facts.push_back(m.facts);
    left_out_ = leave_out(facts, {options_.keep, options_.islands});
    regions_ = regions();
    for (Region& region : regions_) region.shrink = resolution(region).shrink;
    for (Region& region : regions_)
      if (region.levels > 0) region.levels = std::max(1, region.levels - region.shrink);
    std::vector<std::string> names;
    for (const PackInput& m : inputs_.materials) names.push_back(m.name);
    const AtlasLayout* previous = previous_ ? &*previous_ : nullptr;
    plan_ = plan_pages(regions_, names, plan_options(), previous);
  }

  std::vector<Region> regions() const {
    std::vector<Region> out;
    for (std::size_t i = 0; i < left_out_.fates.size(); ++i) {
      const MaterialFate& fate = left_out_.fates[i];
      if (!fate.texels || fate.owner != i) continue;
      std::array<bool, 2> in{false, false};
      int levels = 1;
      users(i, [&](const PackInput& m, const MaterialFate& user) {
        for (std::size_t t = 0; t < 2; ++t) in[t] = in[t] || user.varies[t];
        levels = levels == 0 || m.facts.levels == 0 ? 0 : std::max(levels, m.facts.levels);
      });
      if (options_.keep.contains("textures")) in = {true, true};
      if (options_.keep.contains("mips")) levels = 0;
      for (const PixelBox& box : fate.boxes)
        out.push_back({i, box, in, inputs_.materials[i].own_page, levels, 0});
    }
    return out;
  }

  // Every material that uses the texels of `owner`.
  template <class Act>
  void users(std::size_t owner, Act act) const {
    for (std::size_t j = 0; j < left_out_.fates.size(); ++j)
      if (left_out_.fates[j].texels && left_out_.fates[j].owner == owner)
        act(inputs_.materials[j], left_out_.fates[j]);
  }

  // With how many texels a region is stored; found once.
  const Resolution& resolution(const Region& region) {
    const PackInput& m = inputs_.materials[region.material];
    const PixelBox& box = region.box;
    int unseen = 15;
    bool mask = false;
    users(region.material, [&](const PackInput& user, const MaterialFate&) {
      unseen = std::min(unseen, user.facts.unseen);
      mask = mask || user.alpha_mode == AlphaMode::mask;
    });
    const auto [found, fresh] = resolutions_.try_emplace(std::array{
        static_cast<int>(region.material), box.x, box.y, box.width, box.height, unseen, int{mask}});
    const bool asked = options_.max_error || unseen > 0;
    if (!fresh || !asked || options_.keep.contains("resolution")) return found->second;
    std::vector<std::string> ignored;
    const MaterialPair pair = load_pair(m, ignored);
    MipOptions mips;
    mips.levels = options_.max_error ? 0 : unseen + 1;
    if (mask) mips.alpha_cutoff = m.alpha_cutoff;
    const MipPair chain = region_chain(part_of(pair.diffuse_alpha, box), part_of(pair.specular_gloss, box),
                                       mips, inputs_.gloss, options_.threads);
    const bool whole = box == PixelBox{0, 0, m.width, m.height};
    found->second = resolution_of(chain, mask, whole ? m.wrap : WrapBoth{Wrap::clamp, Wrap::clamp}, unseen,
                                  options_.max_error, options_.threads);
    return found->second;
  }

  int levels() const {
    if (options_.mips) return *options_.mips;
    if (options_.variants && !mips_are_read(*options_.variants, inputs_)) return 1;
    const auto& formats = options_.write.formats;
    const bool container = std::any_of(formats.begin(), formats.end(), [](const std::string& format) {
      return format == "ktx2" || format == "dds";
    });
    return container ? 0 : 1;
  }

  PlanOptions plan_options() const {
    PlanOptions out;
    out.rects.form = options_.form.value_or(PageForm::mixed);
    out.rects.side = options_.page;
    out.rects.largest_side = options_.page;
    out.rects.rotate = options_.rotate;
    out.rects.effort = options_.effort;
    out.rects.max_seconds = options_.max_seconds;
    out.rects.threads = options_.threads;
    out.levels = levels();
    out.gutter = options_.gutter;
    out.split_textures = !options_.keep.contains("textures");
    out.most_extra_area = options_.most_extra_area;
    if (scene_) {
      // Viewers make the mips that samplers ask for by themselves, and UVs cannot be inset without shrinking
      // the picture.
      out.may_inset = false;
      out.free_first = !options_.form;
      out.least_gutter = 1;
      out.levels = scene_->sampled_levels(out.levels);
    }
    return out;
  }

  int offered_levels(int p) const {
    const Page& page = plan_.pages[static_cast<std::size_t>(p)];
    const int full = full_mip_levels(page.width, page.height), wanted = levels();
    return wanted == 0 ? full : std::min(wanted, full);
  }

  // Of those the ones that a sampler reads, and in which some region has a texel of its own.
  int page_levels(int p) const {
    const int offered = offered_levels(p);
    if (options_.keep.contains("mips")) return offered;
    int read = 1;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (plan_.places[r].page != p) continue;
      const int own = full_mip_levels(regions_[r].width(), regions_[r].height());
      read = std::max(read, regions_[r].levels == 0 ? own : std::min(own, regions_[r].levels));
    }
    return std::min(offered, read);
  }

  // ---- pages

  // False: what the texels taught changes the layout, and nothing was kept.
  bool make_pages() {
    std::optional<OutputFolder> folder;
    if (!options_.dry_run) folder.emplace(output_, true);
    ComposeOptions compose;
    compose.threads = options_.threads;
    compose.bleed = options_.bleed;
    compose.gloss = inputs_.gloss;
    Composer composer(inputs_.materials, regions_, plan_, compose);
    PagePixels pixels;
    std::size_t done = 0;
    std::mutex lock;
    const auto region_done = [&] {
      stop_if_cancelled();
      if (!options_.progress) return;
      const std::lock_guard guard(lock);
      options_.progress(++done, 2 * regions_.size());
    };
    for (int p = 0; p < static_cast<int>(plan_.pages.size()); ++p) {
      const Page& page = plan_.pages[static_cast<std::size_t>(p)];
      check_memory(p);
      if (const std::vector<int> cuts = cuts_of(composer, p); cuts.size() > 2) {
        WriteOptions write = options_.write;
        write.threads = options_.threads;
        pixels.release();
        timed("texels, mips and files", [&] {
          stream_page(composer, regions_, plan_, p, page_levels(p), cuts, learned_,
                      folder ? &*folder : nullptr, write, region_done);
        });
        if (learn()) return false;
        if (options_.check_page && folder) check_written(p, *folder);
        continue;
      }
      pixels.start(page, page_levels(p));
      timed("texels", [&] { composer.texels(p, pixels, learned_, region_done); });
      if (learn()) return false;
      timed("gutters and mips", [&] { composer.mips(p, pixels); });
      check(p, pixels);
      if (!folder) continue;
      WriteOptions write = options_.write;
      write.threads = options_.threads;
      timed("write", [&] {
        for (const Texture texture : both_textures) {
          stop_if_cancelled();
          if (page.has[static_cast<std::size_t>(texture)]) write_page(*folder, p, texture, pixels, write);
        }
        if (scene_) scene_->write_page(*folder, p, pixels, write);
      });
      if (writes_floats()) timed("floats", [&] { write_floats(*folder, p, compose); });
    }
    check(static_cast<int>(plan_.pages.size()), pixels);
    pixels.release();
    timed("table", [&] {
      layout_ = make_layout();
      layout_.settings_hash = good_ ? settings_hash() : not_good;
      layout_.content_hash = content_hash_.empty() ? content_hash() : content_hash_;
    });
    if (folder) timed("commit", [&] { commit(*folder); });
    return true;
  }

  // Where a page can be made slab by slab: what else is written of it, and the check, need
  // it whole.
  std::vector<int> cuts_of(const Composer& composer, int p) const {
    if (options_.check_page && (!options_.check_written_page || options_.dry_run)) return {};
    if (scene_ || options_.write.formats != std::vector<std::string>{"png"}) return {};
    return page_cuts(composer, regions_, plan_, p, page_levels(p), options_.bleed);
  }

  void check(int page, const PagePixels& pixels) {
    if (page == 0) good_ = true;
    if (!options_.check_page) return;
    timed("validate", [&] { good_ = options_.check_page(make_layout(), page, pixels) && good_; });
  }

  void check_written(int page, const OutputFolder& folder) {
    if (page == 0) good_ = true;
    const auto path = [&](Texture texture) {
      return folder.path_until_commit(page_file(page, texture, "png"));
    };
    timed("validate", [&] { good_ = options_.check_written_page(make_layout(), page, path) && good_; });
  }

  void check_memory(int p) const {
    const Page& page = plan_.pages[static_cast<std::size_t>(p)];
    std::size_t bytes = 0;
    const std::size_t texel = writes_floats() ? 8 + 32 : 8;
    for (int l = 0; l < page_levels(p); ++l)
      bytes += texel * static_cast<std::size_t>(std::max(1, page.width >> l)) *
               static_cast<std::size_t>(std::max(1, page.height >> l));
    if (options_.memory != 0 && bytes > options_.memory)
      throw Error::at("--memory",
                      "a page of " + std::to_string(page.width) + " x " + std::to_string(page.height) +
                          " takes " + std::to_string((bytes >> 20) + 1) + " MiB",
                      "more memory, or a smaller --page");
  }

  bool writes_floats() const {
    const auto& formats = options_.write.formats;
    return std::any_of(formats.begin(), formats.end(), [](const auto& each) { return holds_floats(each); });
  }

  void write_floats(OutputFolder& folder, int p, const ComposeOptions& compose) {
    const FloatPage page = compose_floats(p, page_levels(p), inputs_.materials, regions_, plan_, compose);
    for (const std::string& format : options_.write.formats)
      if (holds_floats(format)) write_float_page(folder, p, page, format, options_.door);
  }

  // Takes what the texels taught into the facts; true when it changes which regions there are.
  bool learn() {
    for (std::size_t i = 0; i < learned_.size(); ++i) {
      const Learned& from = learned_[i];
      MaterialFacts& to = inputs_.materials[i].facts;
      if (to.learned || !from.seen[0] || !from.seen[1]) continue;
      to.learned = true;
      to.range = from.range;
      to.color_hash = from.hash[0];
      to.specular_hash = from.hash[1];
    }
    // The same files read in the same way were read once.
    std::map<std::string, const MaterialFacts*> known;
    for (const PackInput& m : inputs_.materials)
      if (m.facts.learned) known.try_emplace(m.facts.source, &m.facts);
    std::vector<MaterialFacts> facts;
    for (PackInput& m : inputs_.materials) {
      if (const auto same = known.find(m.facts.source); !m.facts.learned && same != known.end()) {
        m.facts.learned = true;
        m.facts.range = same->second->range;
        m.facts.color_hash = same->second->color_hash;
        m.facts.specular_hash = same->second->specular_hash;
      }
      facts.push_back(m.facts);
    }
    left_out_ = leave_out(facts, {options_.keep, options_.islands});
    const std::vector<Region> now = regions();
    return now.size() != regions_.size() ||
           !std::equal(now.begin(), now.end(), regions_.begin(), [](const Region& a, const Region& b) {
             return std::tie(a.material, a.box, a.in, a.own_page) ==
                    std::tie(b.material, b.box, b.in, b.own_page);
           });
  }

  AtlasLayout make_layout() {
    AtlasLayout out;
    out.gloss = inputs_.gloss;
    out.diffuse_reduced = scene_ != nullptr;
    for (int p = 0; p < static_cast<int>(plan_.pages.size()); ++p) {
      const Page& page = plan_.pages[static_cast<std::size_t>(p)];
      AtlasPage row{page.width, page.height, {}};
      out.levels = std::max(out.levels, page_levels(p));
      for (const Texture texture : both_textures)
        if (page.has[static_cast<std::size_t>(texture)])
          row.files[static_cast<std::size_t>(texture)] =
              page_files(p, texture, page_levels(p), options_.write.formats);
      out.pages.push_back(std::move(row));
    }
    for (std::size_t i = 0; i < inputs_.materials.size(); ++i) {
      const PackInput& m = inputs_.materials[i];
      const MaterialFate& fate = left_out_.fates[i];
      if (!m.facts.reached && !fate.texels) continue;
      AtlasMaterialRow row{m.name, fate.texels, m.alpha_mode, m.alpha_cutoff, fate.constant, {}, {}};
      for (std::size_t c = 0; c < channel_count && m.facts.floats; ++c)
        if (fate.constant[c]) row.value[c] = c == alpha_channel && m.facts.opaque ? 1 : m.facts.exact[c];
      row.defines = material_defines(fate, m.alpha_mode);
      if (const MaterialVariant* variant = variants() ? variants()->find(m.name) : nullptr)
        row.defines.insert(row.defines.end(), variant->defines.begin(), variant->defines.end());
      out.materials.push_back(std::move(row));
      if (fate.texels) add_rects(m, fate.owner, out);
    }
    return out;
  }

  void add_rects(const PackInput& m, std::size_t owner, AtlasLayout& out) const {
    int island = 0;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (regions_[r].material != owner) continue;
      const PixelBox& box = regions_[r].box;
      const Place& at = plan_.places[r];
      AtlasRect rect;
      rect.name = m.name;
      rect.island = island++;
      rect.page = at.page;
      rect.x = at.x;
      rect.y = at.y;
      rect.width = at.rotated ? regions_[r].height() : regions_[r].width();
      rect.height = at.rotated ? regions_[r].width() : regions_[r].height();
      rect.rotated = at.rotated;
      rect.crop = box;
      rect.source_width = m.width;
      rect.source_height = m.height;
      rect.gutter = at.gutter;
      rect.mips = at.clean_levels;
      rect.inset = plan_.inset ? 0.5 * (1 << (at.clean_levels - 1)) : 0;
      rect.repeats = inputs_.materials[owner].own_page;
      const bool whole = box == PixelBox{0, 0, m.width, m.height};
      rect.source_gutter = at.gutter > 0 && !(whole && m.wrap == std::array{Wrap::clamp, Wrap::clamp});
      out.rects.push_back(rect);
    }
  }

  void commit(OutputFolder& folder) {
    if (scene_)
      for (const std::string& name : scene_->write_scene(folder, layout_, plan_, regions_, left_out_))
        layout_.other_files.push_back(name);
    folder.write(layout_name, layout_json(layout_));
    std::set<std::string> files{layout_name};
    for (const AtlasPage& page : layout_.pages)
      for (const auto& names : page.files) files.insert(names.begin(), names.end());
    files.insert(layout_.other_files.begin(), layout_.other_files.end());
    for (const std::string& name : files) {
      const bool owned = std::find(owned_.begin(), owned_.end(), name) != owned_.end();
      if (!owned && !options_.overwrite && exists(output_ + '/' + name))
        throw Error::at(output_ + '/' + name, "exists already and is of no earlier atlas",
                        "another folder, or --force to replace it");
    }
    for (const std::string& name : owned_)
      if (!files.contains(name)) folder.remove_old(name);
    folder.commit();
    report_.files.assign(files.begin(), files.end());
  }

  // ---- report

  void finish() {
    report_.regions = regions_.size();
    report_.pages = plan_.pages;
    report_.method = plan_.method;
    report_.tries = plan_.tries;
    report_.cut_by_time = plan_.cut_by_time;
    report_.kept_previous = plan_.kept_previous;
    report_.moved = plan_.moved;
    report_.inset = plan_.inset;
    if (plan_.clean_limit > 0)
      report_.remarks.push_back("new regions have at most " + std::to_string(plan_.clean_limit) +
                                " mips free of neighbours, so that the others could stay where they were");
    report_.levels = layout_.levels;
    account();
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
    report_.left_out = std::move(left_out_);
    report_.left_out.fates.clear();
  }

  // Texels of regions, gutters and waste; and what pages without one texture saved.
  void account() {
    std::uint64_t cells = 0, regions = 0, single = 0;
    std::size_t singles = 0;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const PixelBox& cell = plan_.places[r].cell;
      const Page& page = plan_.pages[static_cast<std::size_t>(plan_.places[r].page)];
      const auto textures = static_cast<std::uint64_t>(int{page.has[0]} + int{page.has[1]});
      const std::uint64_t area = texels_of(regions_[r].width(), regions_[r].height());
      regions += textures * area;
      cells += textures * static_cast<std::uint64_t>(cell.width) * static_cast<std::uint64_t>(cell.height);
      if (textures == 1) single += area, ++singles;
    }
    report_.region_texels = regions;
    report_.gutter_texels = cells - regions;
    report_.waste_texels = plan_.page_texels() - cells;
    account_resolution();
    account_mips();
    if (singles == 0) return;
    left_out_.lines.push_back({"textures", std::to_string(singles) + " regions need one texture only",
                               singles, single, 0, 4 * single, 0});
    left_out_.after.texels -= single;
  }

  static std::uint64_t texels_of(int width, int height) {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  }

  void account_resolution() {
    LeaveOutLine line;
    line.what = "resolution";
    double worst = 0, seen = 0;
    for (const Region& region : regions_) {
      if (region.shrink == 0) continue;
      const Resolution& found = resolution(region);
      const PixelBox& box = region.box;
      const std::uint64_t gone =
          texels_of(box.width, box.height) - texels_of(region.width(), region.height());
      ++line.materials;
      line.texels += 2 * gone;
      line.channel_texels += left_out_.fates[region.material].channels * gone;
      line.error = std::max(line.error, found.whole.codes);
      worst = std::max(worst, found.whole.delta_e);
      seen = std::max(seen, found.seen.delta_e);
      report_.reduced.push_back({inputs_.materials[region.material].name, box.width, box.height,
                                 region.width(), region.height(), found.seen.delta_e, found.whole.delta_e,
                                 found.whole.codes});
    }
    if (line.materials == 0) return;
    line.bytes = 4 * line.texels;
    line.detail = std::to_string(line.materials) + " regions, up to dE " + number(worst, 3) +
                  " from the full size and " + number(seen, 3) + " from what is seen";
    left_out_.after.texels -= line.texels;
    left_out_.after.channel_texels -= line.channel_texels;
    left_out_.lines.push_back(std::move(line));
  }

  // Levels are no texels of level 0: their bytes alone are counted.
  void account_mips() {
    LeaveOutLine line;
    line.what = "mips";
    int levels = 0;
    for (int p = 0; p < static_cast<int>(plan_.pages.size()); ++p) {
      const Page& page = plan_.pages[static_cast<std::size_t>(p)];
      const auto textures = static_cast<std::uint64_t>(int{page.has[0]} + int{page.has[1]});
      for (int l = page_levels(p); l < offered_levels(p); ++l, ++levels)
        line.bytes += 4 * textures * texels_of(std::max(1, page.width >> l), std::max(1, page.height >> l));
    }
    if (levels == 0) return;
    line.detail = std::to_string(levels) + " levels that nothing reads";
    left_out_.lines.push_back(std::move(line));
  }

  const std::string input_, output_;
  const PackOptions& options_;
  const MaterialLibrary& library_;
  const Project* const project_;  // null: `input_` is what is packed
  PackReport report_;
  PackInputs inputs_;
  std::unique_ptr<ScenePack> scene_;
  std::optional<AtlasLayout> old_, previous_;
  std::vector<std::string> owned_;
  std::string content_hash_;
  bool good_ = true;  // what options_.check_page says of all pages
  std::vector<Learned> learned_;
  LeaveOut left_out_;
  std::vector<Region> regions_;
  std::map<std::array<int, 7>, Resolution> resolutions_;
  Plan plan_;
  AtlasLayout layout_;
};

}  // namespace

PackReport pack(const std::string& input, const std::string& output, const PackOptions& options,
                const MaterialLibrary& library) {
  return Packing(input, output, options, library).run();
}

PackReport pack(const Project& project, const std::string& label, const std::string& output,
                const PackOptions& options, const MaterialLibrary& library) {
  return Packing(label, output, options, library, &project).run();
}

}  // namespace etak
