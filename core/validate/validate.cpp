// SPDX-License-Identifier: Apache-2.0
#include "core/validate/validate.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <set>

#include "core/base/bytes/member_bytes.h"
#include "core/base/files/between_files.h"
#include "core/base/files/links.h"
#include "core/base/hash/content_hash.h"
#include "core/base/hash/sha256.h"
#include "core/base/parallel.h"
#include "core/base/system.h"
#include "core/findings/report.h"
#include "core/findings/shards/report_shard.h"
#include "core/judge/deciding_members.h"
#include "core/validate/files/check.h"
#include "core/validate/files/cut_targets.h"
#include "core/validate/files/project_check.h"
#include "core/validate/files/result_text.h"
#include "core/validate/files/tiles.h"
#include "core/validate/find/find_targets.h"

namespace etak {
namespace {

// The checks of a run, one for each target and each material, in that order.
class Checks {
 public:
  Checks(const ValidationRequest& request, std::vector<FoundTarget>& targets)
      : request_(request),
        targets_(targets),
        files_(targets.size() + request.inputs.materials.materials.size()) {
    done_.resize(files_.size());
    keys_.resize(targets.size());
  }

  void run() {
    const std::string settings = settings_hash(request_.config.settings) + (follows_links() ? " links" : "");
    if (request_.memory.before) look_back(settings);
    if (!request_.memory.cache.path.empty()) look_up(settings);
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < files_.size(); ++i)
      if (done_[i] == 0) left.push_back(i);
    // Many checks run side by side, one thread each; fewer checks than threads use several threads inside.
    const std::size_t lanes = std::clamp<std::size_t>(left.size(), 1, std::max(1u, request_.run.threads));
    const unsigned inside = std::max(1u, request_.run.threads / static_cast<unsigned>(lanes));
    std::atomic<std::size_t> finished{0};
    parallel_chunks(left.size(), static_cast<unsigned>(lanes), 1,
                    [&](std::size_t begin, std::size_t, unsigned worker) {
                      if (stopped_ || (request_.run.stop && request_.run.stop())) {
                        stopped_ = true;
                        return;
                      }
                      check_one(left[begin], inside);
                      const std::size_t now = ++finished;
                      if (worker == 0 && request_.run.progress) request_.run.progress(now, left.size());
                    });
    if (request_.run.progress && !left.empty() && !stopped_) request_.run.progress(left.size(), left.size());
    if (request_.memory.before) request_.memory.before->end();
  }

  bool stopped() const { return stopped_; }
  std::optional<CacheUse> cache_use() {
    return cache_ ? std::optional(cache_->folder().use()) : std::nullopt;
  }
  std::size_t from_cache() const { return from_cache_; }
  std::size_t unchanged() const { return unchanged_; }

  /// The results of the checks that were made, each with its target.
  std::vector<CheckedFile> take_files() {
    if (std::ranges::count(done_, 0) == 0) return std::move(files_);
    std::vector<CheckedFile> out;
    for (std::size_t i = 0; i < files_.size(); ++i)
      if (done_[i] != 0) out.push_back(std::move(files_[i]));
    return out;
  }

 private:
  // Keeps the result of a target and moves the target there. What only its check needed is freed here, by the
  // thread that has made it.
  void finish(std::size_t i, CheckedFile file) {
    FoundTarget& found = targets_[i];
    if (request_.hashes) file.sha256 = keys_[i].sha256;
    file.place = found.place;
    file.target = std::make_shared<const CheckTarget>(std::move(found.target));
    files_[i] = std::move(file);
    found.depends = {};
    keys_[i] = {};
    done_[i] = 1;
  }

  // The facts of a target's files before they are read, where its result is kept for the next run.
  std::vector<sys::FileInfo> known_files(const FoundTarget& found) const {
    return request_.memory.before ? look_at(found.depends) : std::vector<sys::FileInfo>();
  }

  void keep_before(const FoundTarget& found, const std::vector<sys::FileInfo>& known,
                   const CheckedFile& file) {
    if (!request_.memory.before || file.unreadable) return;
    CheckedFile kept = file;
    kept.target = nullptr;
    kept.stats = {};  // of work that the next run does not do
    request_.memory.before->keep(identity_of(found), found.depends, known, std::move(kept));
  }

  void look_back(const std::string& settings) {
    request_.memory.before->begin(settings);
    parallel_chunks(
        targets_.size(), request_.run.threads, 16, [&](std::size_t begin, std::size_t end, unsigned) {
          for (std::size_t i = begin; i < end; ++i) {
            auto file = request_.memory.before->find(identity_of(targets_[i]), targets_[i].depends);
            if (!file) continue;
            finish(i, std::move(*file));
          }
        });
    unchanged_ = static_cast<std::size_t>(std::count(done_.begin(), done_.end(), 1));
  }

  void look_up(const std::string& settings) {
    CacheOptions options = request_.memory.cache;
    options.kind = "validate";
    cache_.emplace(std::move(options), settings, request_.memory.version);
    parallel_chunks(
        targets_.size(), request_.run.threads, 16, [&](std::size_t begin, std::size_t end, unsigned) {
          for (std::size_t i = begin; i < end; ++i) {
            if (done_[i] != 0) continue;
            const FoundTarget& found = targets_[i];
            const auto before = known_files(found);
            const auto& files = found.target.files;
            keys_[i] = cache_->key_of(identity_of(found), found.depends,
                                      found.plain ? SeenAsFile::yes : SeenAsFile::no,
                                      request_.hashes && !files.empty() ? &files.front().path : nullptr);
            const auto text = cache_->find(keys_[i]);
            if (!text) continue;
            auto file = read_result_text(*text);
            if (!file) {
              cache_->folder().refuse_hit();
              continue;
            }
            keep_before(found, before, *file);
            finish(i, std::move(*file));
          }
        });
    from_cache_ = static_cast<std::size_t>(std::count(done_.begin(), done_.end(), 1)) - unchanged_;
  }

  void check_one(std::size_t i, unsigned threads) {
    const Settings& settings = request_.config.settings;
    const MaterialsToCheck& materials = request_.inputs.materials;
    if (i >= targets_.size()) {
      files_[i] = check_material(materials.materials[i - targets_.size()],
                                 {*materials.library, request_.run.door, settings, materials.most_texels,
                                  threads, materials.kept.get()});
    } else {
      const FoundTarget& found = targets_[i];
      const auto before = known_files(found);
      CheckedFile file = check(found.target, request_.run.door, settings, threads);
      keep_before(found, before, file);
      if (cache_ && !file.unreadable) cache_->keep(keys_[i], found.depends, result_text(file));
      return finish(i, std::move(file));
    }
    done_[i] = 1;
  }

  const ValidationRequest& request_;
  std::vector<FoundTarget>& targets_;
  std::vector<CheckedFile> files_;
  std::vector<char> done_;
  std::optional<ResultCache> cache_;
  std::vector<CacheKey> keys_;
  std::size_t from_cache_ = 0, unchanged_ = 0;
  std::atomic<bool> stopped_{false};
};

void add_hashes(ValidationReport& report, unsigned threads) {
  parallel_chunks(report.files.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      CheckedFile& file = report.files[i];
      if (file.sha256.empty() && file.target && !file.target->files.empty())
        file.sha256 = sha256_of_file(file.target->files.front().path);
    }
  });
}

// The results, with the tiles of each UDIM set joined to one.
std::vector<CheckedFile> with_tiles_joined(std::vector<CheckedFile> files) {
  const auto is_tile = [](const CheckedFile& file) { return file.target && !file.target->udim.empty(); };
  if (std::ranges::none_of(files, is_tile)) return files;
  std::vector<CheckedFile> out;
  std::map<std::string, std::vector<CheckedFile>> sets;
  for (CheckedFile& file : files) (is_tile(file) ? sets[file.target->udim] : out).push_back(std::move(file));
  for (auto& [label, tiles] : sets) out.push_back(joined_tiles(std::move(tiles)));
  return out;
}

// Pages of an atlas are judged with the scene that reads them where that is checked too.
void join_scenes(std::vector<FoundTarget>& targets) {
  std::map<std::string, Manifest*> scenes;  // by path
  for (FoundTarget& found : targets)
    for (const TargetFile& file : found.target.files)
      if (file.role == FileRole::scene) scenes.emplace(file.path, &found.target.manifest);
  for (FoundTarget& found : targets) {
    std::string& scene = found.target.manifest.scene;
    const auto read = scenes.find(scene);
    if (read == scenes.end())
      scene.clear();
    else
      read->second->packed = true;
  }
}

bool names_whole_tree(const ValidationRequest& request) {
  sys::FileInfo root, named;
  if (!sys::file_info(request.config.root, root)) return false;
  return std::ranges::any_of(request.inputs.paths, [&](const std::string& path) {
    BetweenFiles::call();
    return sys::file_info(path, named) && named.device == root.device && named.number == root.number;
  });
}

// A digest of everything but the files that decides what a run finds and how it ends: the options of the line,
// and what no option says, which are the configuration and the date.
std::string options_digest(const ValidationRequest& request) {
  const Settings& settings = request.config.settings;
  ContentHash hash;
  hash.add_part(request.part.line_digest);
  MemberWriter bytes;
  bytes.member(settings);
  hash.add_part(bytes.bytes);
  const bool expires =
      std::ranges::any_of(settings.allow, [](const AllowEntry& entry) { return !entry.expires.empty(); });
  if (expires && request.allowed.today.empty()) hash.add_part(today_here());
  hash.add_part(names_whole_tree(request) ? "whole" : "");
  return hash.hex();
}

// Leaves in `found` what the shard of the request checks. The counts stay those of the whole run.
std::shared_ptr<ReportShard> cut(FoundTargets& found, const RunCounts& run,
                                 const ValidationRequest& request) {
  auto out = std::make_shared<ReportShard>();
  const std::vector<TargetGroup> groups = groups_of(found, request.run.threads);
  out->shard = *request.part.shard;
  out->list = digest_of(found, groups);
  out->options = options_digest(request);
  out->groups = groups.size();
  out->run = run;
  out->settings = request.config.settings;
  out->verdict = request.part.verdict;
  out->shard.items = keep_groups(found, groups, out->shard);
  return out;
}

}  // namespace

std::vector<ShardPlan> plan_shards(ValidationRequest request, std::size_t count) {
  FoundTargets found = find_targets(request);
  join_scenes(found.targets);
  const std::vector<TargetGroup> groups = groups_of(found, request.run.threads);
  std::vector<std::uint64_t> bytes;
  for (const TargetGroup& group : groups) bytes.push_back(group.bytes);
  const std::string list = digest_of(found, groups);
  std::vector<ShardPlan> out;
  for (std::size_t i = 1; i <= count; ++i) {
    ShardPlan& plan = out.emplace_back(ShardPlan{{i, count, {}}, list, {}});
    plan.shard.items = items_of(plan.shard, bytes);
    std::set<std::string> files;
    for (std::size_t g = plan.shard.items->first; g < plan.shard.items->second; ++g)
      for (const std::size_t t : groups[g].targets)
        files.insert(found.targets[t].depends.begin(), found.targets[t].depends.end());
    plan.files.assign(files.begin(), files.end());
  }
  return out;
}

FileList list_files(ValidationRequest request) {
  request.list_files = true;
  FoundTargets found = find_targets(request);
  found.listing.typed = std::move(found.typed);
  return std::move(found.listing);
}

ValidationReport validate(ValidationRequest request) {
  FoundTargets found = find_targets(request);
  for (const CheckTarget& target : request.inputs.targets) {
    FoundTarget& added = found.targets.emplace_back(FoundTarget{target, {}, false, 0});
    for (const TargetFile& file : target.files) added.depends.push_back(file.path);
  }
  join_scenes(found.targets);
  RunCounts run{found.files, found.skipped, found.failed.size(),
                found.targets.size() + found.lone.size() + request.inputs.materials.materials.size(), 0};
  const std::shared_ptr<ReportShard> shard = request.part.shard ? cut(found, run, request) : nullptr;
  Checks checks(request, found.targets);
  checks.run();
  run.from_cache = checks.from_cache();
  run.unchanged = checks.unchanged();
  std::vector<CheckedFile> files = with_tiles_joined(checks.take_files());
  std::move(found.lone.begin(), found.lone.end(), std::back_inserter(files));
  std::move(found.failed.begin(), found.failed.end(), std::back_inserter(files));
  ValidationReport report =
      report_of_run(std::move(files), request.config.settings,
                    {request.config.file, request.allowed.today, names_whole_tree(request),
                     request.allowed.known, request.allowed.renew_known, shard.get()});
  report.not_opened = std::move(found.no_files);
  report.run = run;
  report.cache = checks.cache_use();
  report.unknown = std::move(found.unknown);
  report.typed = std::move(found.typed);
  report.stopped = checks.stopped();
  report.nothing_checked = request.must_check && run.checks + run.failed == 0;
  if (report.stopped || report.nothing_checked) {
    report.incomplete = true;
    report.passed = false;
  }
  report.shard = shard;
  if (request.hashes) add_hashes(report, request.run.threads);
  return report;
}

}  // namespace etak
