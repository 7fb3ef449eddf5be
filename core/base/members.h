// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <type_traits>

// A struct is described once for all who write or read it: a function members(to, value), found beside the struct,
// hands each member to to.member(name, value, how), and members that JSON puts into an object of their own to
// to.object(name, there, act), which calls act(to) for them. The names are those of the JSON, in its order. Bytes
// (bytes/member_bytes.h) need none of this but the order.

namespace etak {

/// How JSON shows a member.
enum class Said {
  always,
  as_label,     // a name of a file, or several, which some readers want as their user typed it
  or_null,      // null where it is empty
  where_there,  // left out where it is empty
  in_shard,     // in the JSON of a shard alone; false is left out
};

/// Whether a function members() for `Type` takes this, its value or a constant one.
template <class Value, class Type>
concept MembersOf = std::same_as<std::remove_const_t<Value>, Type>;

}  // namespace etak
