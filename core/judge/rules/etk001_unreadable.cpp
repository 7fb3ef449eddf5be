// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules.h"
#include "core/judge/rules/rows.h"
#include "core/judge/rules/unreadable.h"

namespace etak {

void report_unreadable(RuleCheck& check, const Rule& rule) {
  for (const std::string& message : check.evidence.unreadable) {
    if (&rule_of_unreadable(message) != &rule) continue;
    Finding& finding = check.report();
    finding.message = message;
    // Messages of readers begin with the name of the file, which the finding has itself.
    for (const TargetFile& file : check.target.files)
      if (message.starts_with(file.label + ": ")) {
        finding.file = file.label;
        finding.message = message.substr(file.label.size() + 2);
      }
    finding.value = "unreadable";
  }
}

constinit const Rule etk001_unreadable{
    .id = "ETK001",
    .slug = "unreadable",
    .title = "A file cannot be read",
    .severity = Severity::error,
    .source = "glTF-Validator, IO_ERROR and IMAGE_UNEXPECTED_EOS",
    .what = "A file is missing, empty, truncated, damaged, or in a format that etak does not read.",
    .why =
        "What cannot be read was not checked, and must not pass for clean: the run ends with exit status 2.",
    .example = "A PNG cut short by a full disk; a texture named in a layout that was never exported.",
    .fix = "Export the file again; compare its size with that of the source.",
    .check = [](RuleCheck& check) { report_unreadable(check, etk001_unreadable); }};

}  // namespace etak
