// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace etak {

/// How to pack, as a person writes it on the command line or in a file of jobs. pack_options()
/// (core/pack/pack.h) turns the words into values; pack_setting_rows() holds ranges, words and help.
struct PackSettings {
  std::string input, out;
  // layout
  int page = 4096, effort = 100;
  std::string page_form = "auto", gutter = "auto", mips = "auto", previous;
  bool rotate = false;
  double max_seconds = 0, extra_area = 5;
  // leaving out
  std::vector<std::string> keep;
  std::string choice;
  bool islands = false;  // asked for; they are taken of scenes anyhow where nothing stands against it
  std::optional<double> max_error;
  double texel_density = 0;
  int view_height = 0;
  // content
  std::string pattern, gloss, ocio, gltf_form = "smallest", goal = "auto";
  std::string gltf_container = "gltf", gltf_pictures = "png";
  std::vector<std::string> space_of;
  bool bleed = false, all_scenes = false, drop_variants = false;
  int scene = -1;  // the file's own
  // output
  std::string format = "png", png_level, compress = "none", block_error = "1";
  int zstd = 0, compress_effort = 2;

  friend bool operator==(const PackSettings&, const PackSettings&) = default;
};

/// One setting for every reader: an option of the command line, a key of a job.
///   least, most   of numbers; equal: any
///   value_name    in the help; empty: as the type has it
///   words         with ' ' between: all that there are; empty: any text
struct PackSettingRow {
  /// The member of PackSettings that the row sets.
  using Value = std::variant<int PackSettings::*, double PackSettings::*,
                             std::optional<double> PackSettings::*, bool PackSettings::*,
                             std::string PackSettings::*, std::vector<std::string> PackSettings::*>;
  /// What the readers of settings must know of a row, as bits of `traits`.
  enum Trait : unsigned {
    shown = 1,       // the help shows the default; where that is empty, the first word
    file = 2,        // the name of a file that is read; in a job relative to the file of jobs
    flag = 4,        // takes no value: the name alone means yes
    or_number = 8,   // a text that a job may give as a whole number
    commas = 16,     // on the command line one text holds several, with ',' between
    line_only = 32,  // no key of a job
  };
  std::string_view group, name;
  Value value;
  double least, most;
  std::string_view value_name;
  unsigned traits;
  std::string_view help;  // {page} stands for the setting of that name
  std::string_view words = {};
  std::string_view older = {};  // an older name, which is still known

  bool is(Trait trait) const { return (traits & trait) != 0; }
  std::vector<std::string> word_list() const;
  /// `help` with the names of other settings as setting() (core/base/setting.h) writes them.
  std::string help_text() const;
};

/// Every setting but input and output, in the order of the help.
std::span<const PackSettingRow> pack_setting_rows();

/// The setting of that name, in which '_' stands for '-' too, or of that older name; null: none.
///   remark   tells of an older name how it is called now; else it stays as it is
const PackSettingRow* find_pack_setting(std::string_view name, std::string& remark);

/// All settings but input and output as text, which is equal for equal settings only.
std::string settings_text(const PackSettings& settings);

/// Reads a file of jobs: {"jobs": [{"input", "out", and settings by their names}, ...]}. Paths are
/// relative to the file. Throws Error with the JSON pointer.
///   usual     the settings that a job does not name
///   remarks   gets what is to be said of names that are now called otherwise
std::vector<PackSettings> parse_pack_jobs(std::string_view text, const std::string& file,
                                          const PackSettings& usual, std::vector<std::string>& remarks);

}  // namespace etak
