// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "app/cli/inputs/inputs.h"
#include "core/base/files/file.h"

namespace etak::cli {

ListedNames::ListedNames(const std::string& path)
    : text_(read_file(path)), separator_(text_.find('\0') != std::string::npos ? '\0' : '\n') {}

std::vector<std::string> ListedNames::take(std::size_t most) {
  std::vector<std::string> out;
  while (out.size() < most && at_ < text_.size()) {
    const std::size_t end = std::min(text_.find(separator_, at_), text_.size());
    std::string name = text_.substr(at_, end - at_);
    if (separator_ == '\n' && name.ends_with('\r')) name.pop_back();
    if (!name.empty()) out.push_back(std::move(name));
    at_ = end + 1;
  }
  return out;
}

std::size_t ListedNames::count() const {
  const bool open_end = !text_.empty() && text_.back() != separator_;
  return static_cast<std::size_t>(std::count(text_.begin(), text_.end(), separator_)) + (open_end ? 1 : 0);
}

}  // namespace etak::cli
