// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "core/base/bytes/decimal_bytes.h"
#include "core/base/bytes/member_bytes.h"
#include "core/material/material.h"

// The members of a material as bytes (core/base/bytes/member_bytes.h): in the built-in library, and for whoever keeps
// materials elsewhere. Functions are found beside the structs, so they are in their namespace.
namespace etak {

/// Struct or const Struct.
template <class S, class Struct>
concept Like = std::same_as<std::remove_const_t<S>, Struct>;

template <class To, class... Members>
void all_members(To& to, Members&... values) {
  (to.member(values), ...);
}

template <class Enum>
requires std::is_enum_v<Enum>
void members(MemberReader& to, Enum& value) {
  int read = 0;
  to.member(read);
  value = static_cast<Enum>(read);
}

inline void members(MemberWriter& to, const Flags& f) {
  to.member(std::uint64_t{f.bits()});
}
inline void members(MemberReader& to, Flags& f) {
  std::uint64_t bits = 0;
  to.member(bits);
  f = Flags::from_bits(static_cast<std::uint32_t>(bits));
}

template <class... Types>
void members(MemberWriter& to, const std::variant<Types...>& v) {
  to.member(std::uint64_t{v.index()});
  std::visit([&](const auto& value) { to.member(value); }, v);
}
// Anything but the index of an earlier type is the last one.
template <std::size_t At, class... Types>
void read_as(MemberReader& to, std::uint64_t index, std::variant<Types...>& v) {
  if constexpr (At + 1 < sizeof...(Types))
    if (index != At) return read_as<At + 1>(to, index, v);
  to.member(v.template emplace<At>());
}
template <class... Types>
void members(MemberReader& to, std::variant<Types...>& v) {
  std::uint64_t index = 0;
  to.member(index);
  read_as<0>(to, index, v);
}

// ---- materials

// Wavelengths that their source printed in micrometres take fewer digits so.
inline void members(MemberWriter& to, const Spectrum& s) {
  std::string wavelengths = decimal_bytes(s.wavelength_nm);
  const auto um = in_micrometres(s.wavelength_nm);
  std::string shorter = um ? decimal_bytes(*um) : wavelengths;
  to.member(shorter.size() < wavelengths.size());
  to.member(shorter.size() < wavelengths.size() ? shorter : wavelengths);
  to.member(decimal_bytes(s.value));
}
inline void members(MemberReader& to, Spectrum& s) {
  bool micrometres = false;
  std::string wavelengths, values;
  all_members(to, micrometres, wavelengths, values);
  if (!read_decimal_bytes(wavelengths, s.wavelength_nm) || !read_decimal_bytes(values, s.value))
    return to.fail();
  if (micrometres)
    for (double& wavelength : s.wavelength_nm) wavelength *= 1000;
}
template <class To, Like<DispersionFormula> S>
void members(To& to, S& s) {
  all_members(to, s.number, s.coefficients, s.first_nm, s.last_nm);
}
// The wavelengths of k are not written a second time where n has the same.
inline void members(MemberWriter& to, const OpticalConstants& c) {
  const auto* n = std::get_if<Spectrum>(&c.n);
  std::optional<Spectrum> k = c.k;
  const bool shared = n != nullptr && k && n->wavelength_nm == k->wavelength_nm;
  if (shared) k->wavelength_nm.clear();
  all_members(to, c.n, k, shared);
}
inline void members(MemberReader& to, OpticalConstants& c) {
  bool shared = false;
  all_members(to, c.n, c.k, shared);
  const auto* n = std::get_if<Spectrum>(&c.n);
  if (shared && (n == nullptr || !c.k)) return to.fail();
  if (shared) c.k->wavelength_nm = n->wavelength_nm;
}
template <class To, Like<Reflectance> S>
void members(To& to, S& s) {
  all_members(to, s.spectrum);
}
template <class To, Like<Citation> S>
void members(To& to, S& s) {
  all_members(to, s.authors, s.title, s.published_in, s.year, s.doi, s.url, s.licence, s.via);
}
template <class To, Like<StackMedium> S>
void members(To& to, S& s) {
  all_members(to, s.id, s.dataset, s.citation, s.constants);
}
template <class To, Like<StackLayer> S>
void members(To& to, S& s) {
  all_members(to, s.medium, s.thickness_nm, s.coherent);
}
template <class To, Like<Stack> S>
void members(To& to, S& s) {
  all_members(to, s.text, s.media, s.layers, s.base);
}
template <class To, Like<Dataset> S>
void members(To& to, S& s) {
  all_members(to, s.id, s.optics, s.origin, s.sample, s.temperature_kelvin, s.axis, s.citation, s.flags,
              s.note, s.doubtful);
}
template <class To, Like<AliasNote> S>
void members(To& to, S& s) {
  all_members(to, s.alias, s.note);
}
template <class To, Like<Material> S>
void members(To& to, S& s) {
  all_members(to, s.id, s.name, s.aliases, s.alias_notes, s.bodies, s.body, s.material_class, s.class_by,
              s.group, s.common, s.datasets, s.preferred, s.preferred_reason);
}

}  // namespace etak
