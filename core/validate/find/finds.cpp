// SPDX-License-Identifier: Apache-2.0
#include "core/validate/find/finds.h"

#include "core/judge/rules.h"

namespace etak {

void Finds::fail(const std::string& path, const std::string& message, const std::string& fix) {
  // A file that fails here may be found again as a companion.
  if (!failed.insert(path).second) return;
  CheckedFile& file = found.failed.emplace_back();
  file.path = label(path);
  file.unreadable = true;
  Finding& finding = file.findings.emplace_back(
      finding_of(rule_of_unreadable(message), Severity::error, file.path, message));
  if (!fix.empty()) finding.fix = fix;
  list(file.path, "", ListedAs::unreadable, message);
}

void Finds::list(const std::string& label, std::string_view role, ListedAs as, const std::string& note) {
  if (!request.list_files) return;
  ListedFile& row = found.listing.files.emplace_back();
  row.file = label;
  row.role = role;
  row.as = as;
  row.note = note;
}

}  // namespace etak
