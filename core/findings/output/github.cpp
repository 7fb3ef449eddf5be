// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <map>

#include "core/base/bytes/hex.h"
#include "core/base/number.h"
#include "core/base/text/text.h"
#include "core/findings/output/formats.h"

namespace etak {
namespace {

// The text on one line, with the escapes of GitHub's workflow commands. In a property ':' and ',' are escaped
// as well, because they would end it.
std::string escaped(std::string_view text, bool property) {
  std::string out;
  for (const char c : text) {
    if (c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ','))) {
      out += '%';
      append_hex(out, c, hex_upper);
    } else {
      out += c;
    }
  }
  return line_text(out);
}

struct Level {
  Severity severity;
  std::string_view command, word;
};
constexpr std::array levels{Level{Severity::error, "error", "errors"},
                            Level{Severity::warning, "warning", "warnings"},
                            Level{Severity::info, "notice", "infos"}};
constexpr std::size_t most_per_level = 10;

}  // namespace

std::string validation_github(const ValidationReport& report) {
  std::string out;
  for (const Level& level : levels) {
    std::size_t shown = 0, dropped = 0;
    std::map<std::string, std::size_t> dropped_by_rule;
    for (const CheckedFile& file : report.files)
      for (const Finding& finding : file.findings) {
        if (!counts(finding) || finding.severity != level.severity) continue;
        if (shown == most_per_level) {
          ++dropped;
          ++dropped_by_rule[finding.rule];
          continue;
        }
        ++shown;
        std::string message = place_of(finding) + ": " + sentence_of(finding) + '.';
        if (!finding.fix.empty()) message += " Fix: " + finding.fix;
        out += "::" + std::string(level.command) + " file=" + escaped(finding.file, true) +
               ",title=" + escaped(finding.rule + ' ' + finding.slug, true) + "::" + escaped(message, false) +
               '\n';
      }
    if (dropped == 0) continue;
    out += grouped(dropped) + " more " + std::string(level.word) + " without annotation:";
    for (const auto& [rule, count] : dropped_by_rule) out += ' ' + rule + " x " + grouped(count);
    out += '\n';
  }
  return out + verdict_of(report) + '\n';
}

}  // namespace etak
