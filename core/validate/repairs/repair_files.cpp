// SPDX-License-Identifier: Apache-2.0
#include "core/validate/repairs/repair_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/input.h"
#include "core/base/files/steady_file.h"
#include "core/base/system.h"
#include "core/image/files/png_chunks.h"
#include "core/image/files/png_keep.h"
#include "core/image/load.h"
#include "core/judge/rules.h"
#include "core/validate/files/check.h"
#include "core/validate/files/check_maps.h"
#include "core/validate/repairs/repair.h"

namespace etak {
namespace {

namespace fs = std::filesystem;

constexpr const char* no_repair = "etak has no repair for this rule";

// Errors that say that a picture holds something else than its name says. What a repair would make of it may pass, and
// be no less wrong.
constexpr std::array<std::string_view, 3> rules_of_other_content{"ETK004", "ETK116", "ETK710"};

Image8 codes8(const RepairPicture& picture) {
  Image8 out(picture.codes.width, picture.codes.height, picture.codes.channels);
  std::ranges::transform(picture.codes.values, out.values.begin(), [&](std::uint16_t code) {
    return picture.most == 255 ? static_cast<std::uint8_t>(code) : rounded_code(code);
  });
  return out;
}

std::size_t texels_apart(const Image16& a, const Image16& b) {
  const auto channels = static_cast<std::size_t>(a.channels);
  std::size_t apart = 0;
  for (std::size_t i = 0; i < a.values.size(); i += channels)
    apart += !std::equal(a.values.begin() + static_cast<std::ptrdiff_t>(i),
                         a.values.begin() + static_cast<std::ptrdiff_t>(i + channels),
                         b.values.begin() + static_cast<std::ptrdiff_t>(i));
  return apart;
}

// A file of a target as it is on the disk, with its codes where it is a picture of codes.
struct Original {
  std::string bytes;
  unsigned mode = 0;  // its permissions
  std::optional<RepairPicture> picture;
};

Original original_of(const TargetFile& file, const PictureDoor& door) {
  Original out{SteadyFile(file.path, largest_picture_bytes).all(), strictest_mode({&file.path, 1}),
               std::nullopt};
  Picture loaded = load_picture(out.bytes, file.label, door);
  if (loaded.header.floating) return out;
  RepairPicture& picture = out.picture.emplace();
  picture.file = file;
  picture.header = loaded.header;
  if (auto* wide = std::get_if<Image16>(&loaded.pixels)) {
    picture.most = 65535;
    picture.codes = std::move(*wide);
  } else {
    const auto& codes = std::get<Image8>(loaded.pixels);
    picture.codes = Image16(codes.width, codes.height, codes.channels);
    std::ranges::copy(codes.values, picture.codes.values.begin());
  }
  return out;
}

PngWithChunks file_of(const RepairPicture& picture, const std::string& original, unsigned threads) {
  PngOptions options;
  options.threads = threads;
  const std::string made = picture.most == 255 ? png_bytes(PngRows(codes8(picture)), options)
                                               : png_bytes(PngRows(picture.codes), options);
  BytesInMemory bytes(original);
  if (has_png_signature(bytes)) return with_chunks_of(made, bytes);
  return {made, {}};
}

// The traits that a copy lacks and its original has, besides chunks.
std::vector<std::string> losses(const RepairPicture& picture, const std::string& original) {
  std::vector<std::string> out;
  BytesInMemory bytes(original);
  if (!has_png_signature(bytes))
    out.push_back("the format " + picture.header.format + ", of which PNG has the texels alone");
  else if (picture.header.palette)
    out.emplace_back("the palette");
  else if (const auto header = png_header(bytes); header && !header->strips)
    out.emplace_back("interlacing, transparent colour or a depth below 8 bits");
  return out;
}

using Place = std::pair<std::string, std::string>;  // rule and file
Place place_of_rule(const Finding& finding) {
  return {finding.rule, finding.file};
}

// The repair of one target: its pictures, and the findings that its last check left.
class TargetRepair {
 public:
  TargetRepair(const CheckTarget& target, std::vector<Finding> findings, const RepairRequest& request)
      : request_(request), now_(target), findings_(std::move(findings)) {
    for (const Finding& finding : findings_) {
      begin_.insert(place_of_rule(finding));
      if (finding.suppressed) why_[place_of_rule(finding)] = "allowed: " + finding.suppression;
      if (finding.baseline) why_[place_of_rule(finding)] = "known from the baseline";
    }
  }

  void run(bool unreadable) {
    const std::string whole = unreadable ? "not everything of the set could be checked" : why_nothing();
    if (!whole.empty()) {
      for (const Finding& finding : findings_) why_.try_emplace(place_of_rule(finding), whole);
      return;
    }
    for (const TargetFile& file : now_.files) {
      originals_.push_back(original_of(file, request_.door));
      if (originals_.back().picture) pictures_.push_back(*originals_.back().picture);
    }
    const bool floats = pictures_.size() < originals_.size();
    while (const Finding* finding = next()) {
      if (floats) {
        why_[place_of_rule(*finding)] = "the set has a picture of floats: copies are made of 8 and 16 bits";
        continue;
      }
      try_repair(Finding(*finding));
    }
  }

  bool changed() const { return !steps_.empty(); }

  // Adds what was left to the report.
  void tell_left(RepairReport& report) const {
    std::set<Place> told;
    for (const Finding& finding : findings_) {
      const Place place = place_of_rule(finding);
      if (!told.insert(place).second) continue;
      const auto why = why_.find(place);
      const bool is_new = begin_.count(place) == 0;
      report.left.push_back({finding.rule, finding.slug, finding.file,
                             why != why_.end() ? why->second
                             : is_new ? "seen only now that the set was repaired; " + std::string(no_repair)
                                      : no_repair});
    }
  }

  // Writes the files of the set.
  void write(const std::function<std::string(const std::string& label)>& place_of_copy, OutputTree& copies,
             RepairReport& report) const {
    for (std::size_t i = 0; i < now_.files.size(); ++i) {
      const TargetFile& file = now_.files[i];
      RepairedFile out;
      out.file = file.label;
      out.copy = place_of_copy(file.label);
      const auto steps = steps_.find(file.label);
      if (steps == steps_.end()) {
        copies.write(out.copy, originals_[i].bytes, originals_[i].mode);
        report.files.push_back(std::move(out));
        continue;
      }
      const RepairPicture& before = *originals_[i].picture;
      const RepairPicture& after = *picture_of(pictures_, file.label);
      out.steps = steps->second;
      out.texels = texels_apart(before.codes, after.codes);
      out.of = before.codes.pixel_count();
      out.not_kept = losses(after, originals_[i].bytes);
      const auto& chunks = left_out_.at(file.label);
      out.not_kept.insert(out.not_kept.end(), chunks.begin(), chunks.end());
      if (BytesInMemory bytes(originals_[i].bytes); !has_png_signature(bytes))
        out.copy = sys::path_text(fs::path(out.copy).replace_extension(".png"));
      copies.write(out.copy, *file.bytes, originals_[i].mode);
      if (request_.shown) request_.shown(out, codes8(before), codes8(after));
      report.files.push_back(std::move(out));
    }
  }

 private:
  static const RepairPicture* picture_of(const std::vector<RepairPicture>& pictures,
                                         const std::string& label) {
    const auto found =
        std::ranges::find(pictures, label, [](const RepairPicture& picture) { return picture.file.label; });
    return found == pictures.end() ? nullptr : &*found;
  }

  // Why nothing of the target is repaired; empty: it can be.
  std::string why_nothing() const {
    if (!now_.manifest.tiles.empty()) return "a page of an atlas: repair its sources and pack them again";
    if (now_.files.empty()) return no_repair;
    for (const TargetFile& file : now_.files) {
      if (file.role == FileRole::scene) return "of a scene: repair its textures by their own names";
      if (file.role == FileRole::layout || file.role == FileRole::material || file.role == FileRole::spectrum)
        return no_repair;
      if (is_pipe_input(file.path)) return "from a pipe, of which there is no copy to make";
    }
    for (const Finding& finding : findings_)
      if (finding.severity == Severity::error && !is_map_set(now_) && !finding.suppressed &&
          !finding.baseline &&
          std::ranges::find(rules_of_other_content, finding.rule) != rules_of_other_content.end())
        return finding.rule + " (" + finding.slug + ") says that " +
               sys::path_text(fs::path(finding.file).filename()) +
               " holds something else: a repair would hide it";
    for (const Finding& finding : findings_)
      if (find_repair(finding.rule) != nullptr && why_.count(place_of_rule(finding)) == 0) return {};
    return no_repair;
  }

  // The finding whose repair is tried next; null: none is left.
  const Finding* next() const {
    for (const Repair* repair : repairs())
      for (const Finding& finding : findings_)
        if (finding.rule == repair->rule && why_.count(place_of_rule(finding)) == 0) return &finding;
    return nullptr;
  }

  void try_repair(const Finding& finding) {
    std::vector<RepairPicture> pictures = pictures_;
    const Pictures seen = is_map_set(now_) ? Pictures{} : load_pictures(now_, request_.door);
    Settings settings = request_.settings;
    settings.transfer = now_.manifest.transfer.value_or(settings.transfer);
    const RepairOutcome outcome =
        find_repair(finding.rule)->apply(RepairBench(pictures, now_, settings, finding, seen));
    std::string& why = why_[place_of_rule(finding)];
    why = outcome.left;
    if (outcome.what.empty()) return;
    std::map<std::string, std::size_t> texels;
    CheckTarget candidate = now_;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      const std::size_t apart = texels_apart(pictures[i].codes, pictures_[i].codes);
      if (apart == 0) continue;
      texels[pictures[i].file.label] = apart;
      renew_bytes(candidate, pictures[i]);
    }
    if (texels.empty()) {
      why = "its texels need no change that rounding leaves";
      return;
    }
    CheckedFile checked = check(candidate, request_.door, request_.settings, request_.threads);
    if (checked.unreadable) fail_unchecked(checked);
    const std::string refused = why_refused(finding, checked, !outcome.left.empty());
    if (!refused.empty()) {
      why = refused;
      return;
    }
    for (const auto& [label, count] : texels)
      steps_[label].push_back(
          {finding.rule, finding.slug, outcome.what, count, gone_with(finding, checked.findings)});
    pictures_ = std::move(pictures);
    now_ = std::move(candidate);
    findings_ = std::move(checked.findings);
  }

  // A target that could not be checked, because a file or memory has gone meanwhile, says nothing of the repair.
  [[noreturn]] static void fail_unchecked(const CheckedFile& checked) {
    const auto found =
        std::ranges::find_if(checked.findings, [](const Finding& each) { return is_of_the_tool(each.rule); });
    throw Error::at(found->file, found->message, "a set that can be checked again once it is repaired");
  }

  void renew_bytes(CheckTarget& candidate, const RepairPicture& picture) {
    for (std::size_t i = 0; i < candidate.files.size(); ++i) {
      if (candidate.files[i].label != picture.file.label) continue;
      PngWithChunks copy = file_of(picture, originals_[i].bytes, request_.threads);
      candidate.files[i].bytes = std::make_shared<const std::string>(std::move(copy.file));
      auto& chunks = left_out_[picture.file.label];
      chunks.clear();
      for (const std::string& type : copy.left_out) chunks.push_back("the chunk " + type);
    }
  }

  // The rules besides that of the finding that found something before a repair, and do not after it.
  std::vector<std::string> gone_with(const Finding& finding, const std::vector<Finding>& after) const {
    std::set<std::string> gone;
    for (const Finding& before : findings_)
      if (before.rule != finding.rule && std::ranges::find(after, before.rule, &Finding::rule) == after.end())
        gone.insert(before.rule);
    return {gone.begin(), gone.end()};
  }

  // Whether a finding of the check of repaired pictures is an error that was not there, or one of a rule
  // that had found something in the file, but not there.
  bool is_worse(const Finding& after) const {
    const auto holds = [](const std::optional<PixelBox>& box, const std::optional<PixelBox>& part) {
      return !box || !part ||
             (part->x >= box->x && part->y >= box->y && part->x + part->width <= box->x + box->width &&
              part->y + part->height <= box->y + box->height);
    };
    bool same_rule = false;
    for (const Finding& before : findings_) {
      if (place_of_rule(before) != place_of_rule(after)) continue;
      if (before.severity >= after.severity && holds(before.box, after.box)) return false;
      same_rule = true;
    }
    return after.severity == Severity::error || (same_rule && after.severity == Severity::warning);
  }

  // Why a repair does not count; empty: it does.
  std::string why_refused(const Finding& finding, const CheckedFile& checked, bool partly) const {
    for (const Finding& after : checked.findings) {
      if (place_of_rule(after) == place_of_rule(finding) && (!partly || after.area_px >= finding.area_px))
        return "the repair does not remove it";
      if (is_worse(after))
        return "the repair would bring " + after.rule + " (" + after.slug + "), so the cause is another";
    }
    return {};
  }

  const RepairRequest& request_;
  CheckTarget now_;
  std::vector<Finding> findings_;
  std::vector<Original> originals_;                           // one for each file
  std::vector<RepairPicture> pictures_;                       // as they are now
  std::map<Place, std::string> why_;                          // what was tried, or must not be; empty: done
  std::set<Place> begin_;                                     // found in the originals
  std::map<std::string, std::vector<RepairStep>> steps_;      // by label
  std::map<std::string, std::vector<std::string>> left_out_;  // chunks, by label
};

std::vector<const CheckTarget*> targets_in(const CheckedFile& file) {
  std::vector<const CheckTarget*> out;
  for (const auto& tile : file.tiles) out.push_back(tile.get());
  if (out.empty() && file.target) out.push_back(file.target.get());
  return out;
}

// The deepest folder that holds all checked files, by their labels.
fs::path common_folder(const ValidationReport& report) {
  std::optional<fs::path> common;
  for (const CheckedFile& file : report.files)
    for (const CheckTarget* target : targets_in(file))
      for (const TargetFile& part : target->files) {
        const fs::path folder = fs::path(part.label).parent_path();
        if (!common) {
          common = folder;
          continue;
        }
        const auto [end, ignored] =
            std::mismatch(common->begin(), common->end(), folder.begin(), folder.end());
        fs::path shared;
        for (auto at = common->begin(); at != end; ++at) shared /= *at;
        common = shared;
      }
  return common.value_or(fs::path());
}

// A label as a path below the folder of copies. Folders above the common one, which only labels of different
// roots have, lose their "..".
std::string path_of_copy(const std::string& label, const fs::path& common) {
  fs::path out;
  const fs::path whole(label);
  auto at = whole.begin();
  for (auto part = common.begin(); part != common.end(); ++part) ++at;
  for (; at != whole.end(); ++at)
    if (*at != ".." && *at != "." && *at != "/") out /= *at;
  return sys::path_text(out);
}

}  // namespace

RepairReport repair_files(const ValidationReport& report, const RepairRequest& request, OutputTree& copies) {
  RepairReport out;
  out.folder = request.folder;
  const fs::path common = common_folder(report);
  for (const CheckedFile& file : report.files) {
    if (targets_in(file).empty())
      for (const Finding& finding : file.findings)
        out.left.push_back({finding.rule, finding.slug, finding.file, no_repair});
    for (const CheckTarget* target : targets_in(file)) {
      std::vector<Finding> findings;
      for (const Finding& finding : file.findings)
        if (&file.target_of(finding) == target) findings.push_back(finding);
      if (findings.empty()) continue;
      TargetRepair repair(*target, std::move(findings), request);
      repair.run(file.unreadable);
      repair.tell_left(out);
      if (repair.changed())
        repair.write([&](const std::string& label) { return path_of_copy(label, common); }, copies, out);
    }
  }
  return out;
}

std::shared_ptr<const ReadPlaces> refuse_inputs_below(const std::string& folder,
                                                      std::span<const std::string> inputs) {
  auto out = std::make_shared<const ReadPlaces>(inputs);
  sys::FileInfo info;
  if (const std::string* const input = sys::file_info(folder, info) ? out->find(info) : nullptr)
    throw Error::at(folder, "is or holds " + printable(*input, 200) + ", which is checked",
                    "a folder of its own for repaired copies");
  return out;
}

std::vector<std::string> checked_paths(const ValidationReport& report) {
  std::vector<std::string> out;
  for (const CheckedFile& file : report.files)
    for (const CheckTarget* target : targets_in(file))
      for (const TargetFile& part : target->files) out.push_back(part.path);
  return out;
}

}  // namespace etak
