// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/material/embedded/material_members.h"
#include "core/material/f0.h"
#include "core/pages/f0/report.h"

// The members that a pickle holds beyond those of materials.
namespace etak {

// ---- F0

template <class To, Like<LinearRgb> S>
void members(To& to, S& s) {
  all_members(to, s.r, s.g, s.b);
}
template <class To, Like<Xyz> S>
void members(To& to, S& s) {
  all_members(to, s.x, s.y, s.z);
}
inline void members(MemberWriter& to, const Srgb8& c) {
  to.member(std::array{int{c.r}, int{c.g}, int{c.b}});
}
inline void members(MemberReader& to, Srgb8& c) {
  std::array<int, 3> codes{};
  to.member(codes);
  c = {static_cast<std::uint8_t>(codes[0]), static_cast<std::uint8_t>(codes[1]),
       static_cast<std::uint8_t>(codes[2])};
}
template <class To, Like<Coverage> S>
void members(To& to, S& s) {
  all_members(to, s.weight, s.first_nm, s.last_nm, s.samples_400_700, s.largest_gap_nm, s.is_formula);
}
template <class To, Like<IntegrationStep> S>
void members(To& to, S& s) {
  all_members(to, s.method, s.error, s.within_bound);
}
template <class To, Like<F0Result> S>
void members(To& to, S& s) {
  all_members(to, s.xyz, s.linear, s.srgb_linear, s.srgb8, s.luminance, s.f82, s.f82_tint, s.mean, s.zone,
              s.channel_in_zone, s.gamut_excess, s.coverage, s.flags, s.integration, s.refusal);
}
template <class To, Like<ClearBody> S>
void members(To& to, S& s) {
  all_members(to, s.color, s.depth_m, s.n_d, s.v_d);
}
template <class To, Like<CoatedF0> S>
void members(To& to, S& s) {
  all_members(to, s.label, s.n, s.under, s.whole, s.energy_left, s.passes);
}
template <class To, Like<Band> S>
void members(To& to, S& s) {
  all_members(to, s.publications, s.kind, s.de50, s.de90, s.low90, s.high90, s.y90, s.farthest, s.disagree);
}
template <class To, Like<F0Row> S>
void members(To& to, S& s) {
  all_members(to, s.path, s.name, s.material_class, s.dataset, s.source, s.result, s.alias_note, s.kind,
              s.doubt, s.clear, s.coat, s.band, s.band_reason);
}
template <class To, Like<Spread> S>
void members(To& to, S& s) {
  all_members(to, s.count, s.least, s.most, s.least8, s.most8);
}

}  // namespace etak
