// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <unordered_map>
#include <utility>

namespace etak {

/// Names that are taken. A free one near a wanted name is found without going through all numbers again, so
/// that n equal names take time in proportion to n log n.
class FreeNames {
 public:
  void take(std::string name) { taken_.insert(std::move(name)); }

  /// `wanted` where it is free, else the first free one of numbered(2), numbered(3), ... It is taken then.
  ///   numbered   the name with a number behind it; always the same for the same `wanted`
  template <class Numbered>
  std::string free(const std::string& wanted, const Numbered& numbered) {
    if (taken_.insert(wanted).second) return wanted;
    // Names are never given back: below the number that was found last none is free.
    int& number = next_.try_emplace(wanted, 2).first->second;
    for (;; ++number)
      if (const auto [name, is_free] = taken_.insert(numbered(number)); is_free) return *name;
  }

 private:
  std::set<std::string> taken_;
  std::unordered_map<std::string, int> next_;  // by wanted name: no lower number is free
};

}  // namespace etak
