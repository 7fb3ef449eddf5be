// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>

#include "core/image/image_io.h"
#include "core/validate/validate.h"

namespace etak::test {

/// What is found in targets whose files lie on the disk.
inline ValidationReport report_on(std::vector<CheckTarget> targets, const Settings& settings = {},
                                  unsigned threads = 1) {
  ValidationRequest request;
  request.inputs.targets = std::move(targets);
  request.config.settings = settings;
  request.run.door = picture_door();
  request.run.threads = threads;
  return validate(std::move(request));
}

inline CheckedFile checked(const CheckTarget& target, const Settings& settings = {}, unsigned threads = 1) {
  return report_on({target}, settings, threads).files.at(0);
}

/// One picture alone.
inline CheckTarget single(FileRole role, const std::string& path, const std::string& label) {
  CheckTarget target;
  target.files = {{role, path, label, false}};
  return target;
}

/// The first finding of a rule; null: none.
inline const Finding* find(const CheckedFile& file, std::string_view rule) {
  const auto found = std::ranges::find(file.findings, rule, &Finding::rule);
  return found == file.findings.end() ? nullptr : &*found;
}

}  // namespace etak::test
