// SPDX-License-Identifier: Apache-2.0
#include "core/validate/files/result_text.h"

#include <utility>

#include "core/base/bytes/member_bytes.h"
#include "core/judge/deciding_members.h"

namespace etak {

std::string identity_of(const FoundTarget& found) {
  MemberWriter out;
  out.bytes.reserve(512);
  out.member(found.target);
  return std::move(out.bytes);
}

std::string result_text(const CheckedFile& file) {
  MemberWriter out;
  out.member(file);
  return std::move(out.bytes);
}

std::optional<CheckedFile> read_result_text(std::string_view bytes) {
  MemberReader in(bytes);
  CheckedFile out;
  in.member(out);
  if (!in.good()) return std::nullopt;
  return out;
}

}  // namespace etak
