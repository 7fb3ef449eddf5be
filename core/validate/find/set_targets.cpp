// SPDX-License-Identifier: Apache-2.0
#include "core/validate/find/set_targets.h"

#include <cstddef>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/base/text/ascii.h"
#include "core/judge/engine.h"
#include "core/judge/rules.h"
#include "core/validate/files/load.h"

namespace etak {

FoundTarget target_of_set(const PictureSet& set, const Manifest& manifest, PictureNamer& namer) {
  FoundTarget found;
  found.plain = true;
  found.target.manifest = manifest;
  CheckTarget& target = found.target;
  for (auto [pictures, files] :
       {std::pair(&set.members, &target.files), std::pair(&set.beside, &target.beside)}) {
    files->reserve(pictures->size());
    for (const NamedPicture* member : *pictures) {
      files->push_back({member->name.role, member->path, namer.label(member->path), member->guessed,
                        member->name.channels, member->name.green});
      found.depends.push_back(member->path);
      found.plain = found.plain && member->plain;
    }
  }
  target.label = target.files.front().label;
  const ParsedName& name = set.members.front()->name;
  if (set.missing.empty() && !name.tile.empty()) {
    target.tile = name.tile;
    target.udim = target.label;
    const std::size_t at = lower_case(target.label).rfind(name.tile);
    target.udim.replace(at, name.tile.size(), "<UDIM>");
  }
  return found;
}

namespace {

// Adds what cannot be read of a set that is not judged.
void add_unreadable(const CheckTarget& target, const PictureDoor& door, CheckedFile& file) {
  for (const TargetFile& part : target.files) {
    try {
      (void)open_target_file(part, door);
    } catch (const Error& error) {
      std::string message = error.what();
      if (const std::string begin = part.path + ": "; message.starts_with(begin))
        message.erase(0, begin.size());
      file.findings.push_back(finding_of(rule_of_unreadable(message), Severity::error, part.label, message));
      file.findings.back().value = "unreadable";
      file.unreadable = true;
    }
  }
}

}  // namespace

CheckedFile lone_set(const CheckTarget& target, const std::string& missing, const Settings& settings,
                     const PictureDoor* door) {
  const Rule& rule = *find_rule("ETK002");
  CheckedFile file = checked_file_of(target);
  if (door != nullptr) add_unreadable(target, *door, file);
  if (const Severity severity = severity_of(rule, settings); severity != Severity::off) {
    Finding& finding = file.findings.emplace_back(
        finding_of(rule, severity, file.path, missing + ": nothing of it was judged"));
    finding.value = missing;
    finding.limit = "the whole set";
    finding.fix =
        "Add the missing picture under the name of its set, or say in [names] of etak.toml what the endings of the names mean; etak validate --list-files shows what was understood.";
  }
  return file;
}

void settle_tiles(std::vector<FoundTarget>& targets) {
  std::unordered_map<std::string, std::size_t> tiles;
  for (const FoundTarget& found : targets)
    if (!found.target.udim.empty()) ++tiles[found.target.udim];
  for (FoundTarget& found : targets)
    if (!found.target.udim.empty() && tiles[found.target.udim] < 2) {
      found.target.udim.clear();
      found.target.tile.clear();
    }
}

}  // namespace etak
