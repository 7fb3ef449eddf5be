// SPDX-License-Identifier: Apache-2.0
#include "core/base/hash/content_hash.h"

#include <xxhash.h>

#include <new>

#include "core/base/bytes/hex.h"
#include "core/base/files/input.h"

namespace etak {
namespace {

XXH3_state_t* of_library(void* state) {
  return static_cast<XXH3_state_t*>(state);
}

}  // namespace

void ContentHash::Release::operator()(void* state) const {
  XXH3_freeState(of_library(state));
}

ContentHash::ContentHash(std::string_view secret) : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  if (secret.empty())
    XXH3_128bits_reset(of_library(state_.get()));
  else
    XXH3_128bits_reset_withSecret(of_library(state_.get()), secret.data(), secret.size());
}

void ContentHash::add(const void* data, std::size_t count) {
  // The library takes a null pointer for an error, even where no byte comes with it.
  if (count > 0) XXH3_128bits_update(of_library(state_.get()), data, count);
}

std::array<std::uint64_t, 2> ContentHash::value() const {
  const XXH128_hash_t digest = XXH3_128bits_digest(of_library(state_.get()));
  return {digest.high64, digest.low64};
}

std::string ContentHash::hex() const {
  const auto [high, low] = value();
  return etak::hex(high) + etak::hex(low);
}

std::string content_hash_of_file(const std::string& path) {
  ContentHash hash;
  sys::FileInfo info;
  const auto add = [&](std::string_view bytes) { hash.add(bytes); };
  return take_bytes(path, info, SeenAsFile::no, add) ? hash.hex() : "";
}

}  // namespace etak
