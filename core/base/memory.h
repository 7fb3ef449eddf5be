// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace etak {

/// "12 MiB", without the fraction; "300 bytes" of what is smaller than one.
inline std::string mebibytes(std::size_t bytes) {
  const std::size_t whole = bytes >> 20;
  return whole > 0 ? std::to_string(whole) + " MiB" : std::to_string(bytes) + " bytes";
}

/// The Error of memory that does not suffice.
///   place   the file that the memory was needed for
///   what    the part of the file that was too large, with its size: "its text of 12 MiB"
inline Error out_of_memory(std::string_view place, std::string_view what) {
  return Error::at(place, "needs more memory than there is, for " + std::string(what),
                   "a smaller file, or more memory");
}

/// Returns work(). An allocation that fails in work() is reported as out_of_memory(place, what()), because a
/// std::bad_alloc names neither the file nor the size.
template <class What, class Work>
decltype(auto) with_memory_for(std::string_view place, const What& what, Work&& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw out_of_memory(place, what());
  }
}

/// Keeps a value until the system takes back all memory of the program at its end. To free a hundred thousand
/// findings one by one takes a tenth of a second, in which a program that ends anyway does nothing else. For
/// the last step of a program, by one thread. The module for browsers goes on to other work, and keeps nothing.
template <class Value>
void keep_to_end([[maybe_unused]] Value value) {
#ifndef __wasm__
  static auto* const kept = new std::vector<std::unique_ptr<Value>>;
  kept->push_back(std::make_unique<Value>(std::move(value)));
#endif
}

}  // namespace etak
