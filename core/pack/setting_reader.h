// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/system.h"
#include "core/pack/settings.h"

namespace etak {

/// Reads the value of a setting of `etak pack` from where a program keeps values with types: a key of a job, a
/// keyword of a call.
///   Source   has number(), integer(least, most), boolean(), text() and texts(), which throw Error for a value
///            of another type; fail_type(expected), which throws the Error of a value that is refused; and
///            is_number()
template <class Source>
class PackSettingReader {
 public:
  ///   folder   that the names of files are relative to; empty: the working folder
  PackSettingReader(const PackSettingRow& row, const Source& from, const std::filesystem::path& folder,
                    PackSettings& to)
      : row_(row), from_(from), folder_(folder), to_(to) {}

  void operator()(int PackSettings::*member) const {
    to_.*member = from_.integer(static_cast<int>(row_.least), static_cast<int>(row_.most));
  }
  void operator()(double PackSettings::*member) const { to_.*member = number(); }
  void operator()(std::optional<double> PackSettings::*member) const { to_.*member = number(); }
  void operator()(bool PackSettings::*member) const { to_.*member = from_.boolean(); }
  void operator()(std::vector<std::string> PackSettings::*member) const { to_.*member = from_.texts(); }
  void operator()(std::string PackSettings::*member) const {
    // "8" and 8 alike, because some settings take a word as well.
    std::string text = row_.is(PackSettingRow::or_number) && from_.is_number()
                           ? std::to_string(from_.integer(0, 1000000))
                           : from_.text();
    const std::vector<std::string> words = row_.word_list();
    if (!words.empty() && std::find(words.begin(), words.end(), text) == words.end())
      from_.fail_type(row_.words);
    to_.*member = row_.is(PackSettingRow::file) ? sys::path_text(folder_ / text) : std::move(text);
  }

 private:
  double number() const {
    const double value = from_.number();
    if (row_.least < row_.most && (value < row_.least || value > row_.most))
      from_.fail_type("a number within the option's range");
    return value;
  }

  const PackSettingRow& row_;
  const Source& from_;
  const std::filesystem::path& folder_;
  PackSettings& to_;
};

/// Sets the member of `to` that `row` is about.
template <class Source>
void read_pack_setting(const PackSettingRow& row, const Source& from, const std::filesystem::path& folder,
                       PackSettings& to) {
  std::visit(PackSettingReader<Source>(row, from, folder, to), row.value);
}

}  // namespace etak
