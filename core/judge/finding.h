// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/members.h"
#include "core/image/pixels_view.h"

namespace etak {

enum class Severity { off, info, warning, error };
std::string_view name(Severity severity);  // "off", "info", "warning", "error"
std::optional<Severity> severity_named(std::string_view text);
constexpr Severity last_of(Severity) {
  return Severity::error;
}

/// A material of the library, and its distance from a colour.
struct NearestMaterial {
  std::string id, dataset;
  double bytes = 0;    // largest channel difference in 8-bit codes
  double delta_e = 0;  // CIEDE2000 of the colours clipped to [0, 1]
  friend bool operator==(const NearestMaterial&, const NearestMaterial&) = default;
};

/// A box in UVs: left, top, right and bottom in the whole texture, [0,1].
using UvBox = std::array<double, 4>;

/// One of the islands of an atlas that a finding is about.
struct FindingIsland {
  std::string tile;  // name of the island's own tile; of a scene, of its material
  std::optional<PixelBox> box;
  std::size_t area_px = 0;
  std::optional<UvBox> uv = {};  // as of a finding
  friend bool operator==(const FindingIsland&, const FindingIsland&) = default;
};

/// A defect that a rule has found. A rule sums up the places in one picture and tile in one finding. Where
/// the texels of a material lie in several islands, the finding is one for all of them: `tile` is the name of
/// the material, values, box and area are those of the worst island (while a scene is packed, the area is that
/// of all islands), and `islands` lists all islands with the defect.
struct Finding {
  std::string rule;  // "ETK101"
  std::string slug;  // "f0-forbidden-zone"
  Severity severity = Severity::warning;
  std::string file;                    // relative to the run's root
  std::string tile;                    // of an atlas; else empty
  std::vector<FindingIsland> islands;  // two or more; else empty
  std::string material;                // where it is named
  std::string pointer;                 // JSON pointer, for materials and scenes
  std::optional<PixelBox> box;
  std::optional<UvBox> uv;  // of a scene's material: the box in its own textures, also where they were packed
  std::size_t area_px = 0;
  double area_share = 0;                        // of the tile
  std::optional<std::array<double, 3>> linear;  // the value found
  std::optional<std::array<int, 3>> byte;
  std::optional<double> luminance;
  std::string value, limit;  // "F0 0.22", "20-45 %"
  std::vector<NearestMaterial> nearest;
  std::string message;  // one sentence: value, place, area
  std::string cause;    // "possible cause: ..."; empty when not known
  std::string fix;
  std::string source;       // of the rule
  bool suppressed = false;  // by an [[allow]] entry
  std::string suppression;  // its reason
  bool baseline = false;    // known from the baseline
  friend bool operator==(const Finding&, const Finding&) = default;
};

/// The work of a check, for --stats. The times differ from run to run, so they are in no report.
struct CheckStats {
  std::size_t pictures_decoded = 0, pictures_left_out = 0;  // left out: no rule needs their texels
  std::size_t texels = 0;                                   // of one picture
  std::size_t passes = 0;                                   // over the texels
  double decode_seconds = 0, byte_seconds = 0, region_seconds = 0;
};

struct CheckTarget;

/// A file, relative, and the name of its role.
struct RoleOfFile {
  std::string file, role;
  friend bool operator==(const RoleOfFile&, const RoleOfFile&) = default;
};

/// The measured material whose F0 is nearest.
struct NearestId {
  std::string id;
  double delta_e = 0;  // CIEDE2000 of F0, clipped to [0, 1]
  friend bool operator==(const NearestId&, const NearestId&) = default;
};
/// A surface of a material document; `nearest` is none where its F0 is not known (a picture gives it, or a film lies on
/// it).
struct JudgedSurface {
  std::string name, model, place;
  std::optional<NearestId> nearest = {};
  friend bool operator==(const JudgedSurface&, const JudgedSurface&) = default;
};

/// One checked file, or one pair or set of files that belong together.
struct CheckedFile {
  std::string path;                     // relative
  std::vector<std::string> companions;  // other files of the set, relative
  std::string sha256;
  int width = 0, height = 0;
  std::vector<RoleOfFile> roles;
  std::vector<JudgedSurface> surfaces;  // of a material document
  std::vector<Finding> findings;        // in the order of rule, tile, box
  std::size_t plateau_px = 0, transition_px = 0;
  bool unreadable = false;  // exit status 2
  // Exact texel counts of the byte pass, in a fixed order: "forbidden_any_channel_px", "gloss_min", ...
  std::vector<std::pair<std::string, std::int64_t>> counts;
  CheckStats stats;
  std::shared_ptr<const CheckTarget> target;  // what was checked; null where no file was, as in ETK903's
  // All tiles of a UDIM set; `target` is the first of them. `tile` of a finding is the number of its tile.
  std::vector<std::shared_ptr<const CheckTarget>> tiles;
  bool is_set = false;    // a UDIM set: `path` stands for its tiles and is no file
  std::size_t place = 0;  // in a shard: index among the results of the whole run, before they are sorted

  /// The target that a finding is about: in a UDIM set that of its tile.
  const CheckTarget& target_of(const Finding& finding) const;
};

// These values as caches, shards, etak's JSON and the Python module have them (base/members.h). A new member of a
// finding needs a line here, one in validation.schema.json, and one in app/python/etak/documents.py.

template <class To, MembersOf<PixelBox> Value>
void members(To& to, Value& box) {
  to.member("x", box.x);
  to.member("y", box.y);
  to.member("width", box.width);
  to.member("height", box.height);
}

template <class To, MembersOf<NearestMaterial> Value>
void members(To& to, Value& near) {
  to.member("name", near.id);
  to.member("dataset", near.dataset);
  to.member("bytes", near.bytes);
  to.member("delta_e", near.delta_e);
}

template <class To, MembersOf<FindingIsland> Value>
void members(To& to, Value& island) {
  to.member("tile", island.tile);
  to.member("bbox", island.box);
  to.member("areaPx", island.area_px);
  to.member("uv", island.uv, Said::where_there);
}

template <class To, MembersOf<Finding> Value>
void members(To& to, Value& finding) {
  to.member("id", finding.rule);
  to.member("slug", finding.slug);
  to.member("severity", finding.severity);
  to.member("file", finding.file, Said::as_label);
  to.member("message", finding.message);
  to.member("tile", finding.tile);
  to.member("material", finding.material);
  to.member("pointer", finding.pointer);
  to.member("bbox", finding.box);
  to.member("islands", finding.islands, Said::where_there);
  to.member("uv", finding.uv, Said::where_there);
  to.member("areaPx", finding.area_px);
  to.member("areaShare", finding.area_share);
  to.object("value", finding.linear || finding.byte || finding.luminance, [&](auto& colour) {
    colour.member("linear", finding.linear);
    colour.member("byte", finding.byte);
    colour.member("Y", finding.luminance);
  });
  to.member("found", finding.value);
  to.member("limit", finding.limit);
  to.member("nearest", finding.nearest);
  to.member("cause", finding.cause);
  to.member("fix", finding.fix);
  to.member("source", finding.source);
  to.member("suppressed", finding.suppressed);
  to.member("suppression", finding.suppression);
  to.member("baseline", finding.baseline);
}

template <class To, MembersOf<RoleOfFile> Value>
void members(To& to, Value& role) {
  to.member("file", role.file, Said::as_label);
  to.member("role", role.role);
}

template <class To, MembersOf<NearestId> Value>
void members(To& to, Value& near) {
  to.member("id", near.id);
  to.member("delta_e", near.delta_e);
}

template <class To, MembersOf<JudgedSurface> Value>
void members(To& to, Value& surface) {
  to.member("name", surface.name);
  to.member("model", surface.model);
  to.member("place", surface.place);
  to.member("nearest", surface.nearest);
}

template <class To, MembersOf<CheckedFile> Value>
void members(To& to, Value& file) {
  to.member("path", file.path, Said::as_label);
  to.member("companions", file.companions, Said::as_label);
  to.member("sha256", file.sha256, Said::or_null);
  to.member("width", file.width);
  to.member("height", file.height);
  to.member("unreadable", file.unreadable);
  to.member("roles", file.roles);
  to.member("surfaces", file.surfaces, Said::where_there);
  to.member("findings", file.findings);
  to.object("stats", true, [&](auto& stats) {
    stats.member("plateauPx", file.plateau_px);
    stats.member("transitionPx", file.transition_px);
    stats.member("counts", file.counts);
  });
  to.member("place", file.place, Said::in_shard);
  to.member("udim", file.is_set, Said::in_shard);
}

}  // namespace etak
