// SPDX-License-Identifier: Apache-2.0
// The JSON forms of an F0 report, as resources/schema/f0.schema.json describes them. No JSON library writes
// them: std::to_chars gives the shortest text that reads back equal, and a colour stays on one line.
#include <array>

#include "core/base/json/json_text.h"
#include "core/base/text/text.h"
#include "core/color/colorspace.h"
#include "core/color/srgb.h"
#include "core/exchange/export_values.h"
#include "core/fresnel/fresnel.h"
#include "core/pages/f0/report.h"
#include "core/spectrum/integration.h"

namespace etak {
namespace {

constexpr std::string_view schema_name = "etak-f0/1";

// ---- values as text

// Overloads for colours, beside those of json_text.h for numbers and text.
using etak::json;

std::string json(const LinearRgb& c) {
  return json_object({{"r", json(c.r)}, {"g", json(c.g)}, {"b", json(c.b)}}, -1);
}

std::string json(const Xyz& c) {
  return json_object({{"x", json(c.x)}, {"y", json(c.y)}, {"z", json(c.z)}}, -1);
}

template <std::size_t N>
std::string array(const std::array<double, N>& values) {
  std::array<std::string, N> items;
  for (std::size_t i = 0; i < N; ++i) items[i] = json(values[i]);
  return json_array(items);
}

template <std::size_t Rows, std::size_t N>
std::string array(const std::array<std::array<double, N>, Rows>& rows) {
  std::array<std::string, Rows> items;
  for (std::size_t i = 0; i < Rows; ++i) items[i] = array(rows[i]);
  return json_array(items);
}

using Member = JsonMember;

// ---- policy

std::vector<Member> policy_members(const F0Options& o) {
  const Viewing d65{o.viewing.observer, Illuminant::d65};
  // The white of the exact method does not depend on the knots of the data, but for rounding.
  const auto white_of = [&](Viewing viewing) {
    if (o.method == Method::exact) return to_xyz(make_exact_quadrature(viewing, {}).white());
    return to_xyz(make_quadrature(samples_rgb(o.method) ? Method::nm1 : o.method, viewing).white());
  };
  const Xyz white = white_of(o.viewing);
  std::string matrix = "null", chromaticities = "null";
  if (!o.custom_space) {
    matrix = array(xyz_to_rgb(o.space, white, white_of(d65)));
    if (o.space != RgbSpace::xyz) chromaticities = array(primaries(o.space));
  }
  const auto* outside_n = std::get_if<double>(&o.outside.index);
  const Member outside[] = {{"label", json(o.outside.label)}, {"n", outside_n ? json(*outside_n) : "null"}};
  const bool power = o.method == Method::legacy_schueler;
  std::vector<Member> members{
      {"text", json(policy(o))},
      {"observer", json(name(o.viewing.observer))},
      {"illuminant", json(name(o.viewing.illuminant))},
      {"interpolation", json(name(o.interpolation))},
      {"method", json(name(o.method))},
      {"range_nm",
       samples_rgb(o.method) ? "null" : array(std::array<double, 2>{grid_first_nm, grid_last_nm})},
      {"white", json(white)},
      {"space", json(space_name(o))},
      {"primaries", chromaticities},
      {"xyz_to_linear", matrix},
      {"encoding", json(power ? "power-1/2.2" : "srgb")},
      {"rounding", json("half-up")},
      {"outside", json_object(outside, -1)},
      {"f82_cosine", json(f82_cosine)},
      {"forbidden_zone", array(std::array{forbidden_zone_first, forbidden_zone_last})},
      {"allow_extrapolation", json(o.allow_extrapolation)}};
  if (o.method == Method::automatic) members.push_back({"integration_bound", json(o.integration_bound)});
  return members;
}

// ---- results

std::string json_coverage(const Coverage& c) {
  if (c.last_nm <= 0) return "null";  // the data were refused before their range was known
  return json_object({{"x", json(c.weight[0])},
                      {"y", json(c.weight[1])},
                      {"z", json(c.weight[2])},
                      {"first_nm", json(c.first_nm)},
                      {"last_nm", json(c.last_nm)},
                      {"formula", json(c.is_formula)}},
                     -1);
}

std::string json_zone(const F0Result& r) {
  if (!r.zone) return "null";
  constexpr std::array<std::string_view, 3> letters{"r", "g", "b"};
  std::vector<std::string> inside;
  for (std::size_t c = 0; c < 3; ++c)
    if (r.channel_in_zone[c]) inside.push_back(json(letters[c]));
  return json_object({{"verdict", json(name(*r.zone))}, {"channels_inside", json_array(inside)}}, -1);
}

std::string json_gamut(const F0Result& r) {
  return json_object({{"in", json(!r.out_of_gamut())}, {"excess", json(to_rgb(r.gamut_excess))}}, -1);
}

std::string json_f82(const F0Result& r) {
  if (!r.f82) return "null";
  return json_object({{"absolute", json(*r.f82)}, {"tint", r.f82_tint ? json(*r.f82_tint) : "null"}}, -1);
}

std::string json_band(const Band& band) {
  return json_object({{"publications", json(band.publications)},
                      {"class", json(name(band.kind))},
                      {"de50", json(band.de50)},
                      {"de90", json(band.de90)},
                      {"low90", json(band.low90)},
                      {"high90", json(band.high90)},
                      {"y90", array(band.y90)}},
                     -1);
}

std::string json_integration(const IntegrationStep& step) {
  return json_object({{"method", json(name(step.method))},
                      {"estimated_error", json(step.error)},
                      {"within_bound", json(step.within_bound)}},
                     -1);
}

// The mean over a diffuse hemisphere: of the reflectance itself, and of F82's curve through F0 and F82.
std::string json_mean(const F0Result& r) {
  const auto closed = mean_of_f82(r);
  return json_object({{"exact", json(*r.mean)}, {"f82", closed ? json(*closed) : "null"}}, -1);
}

std::vector<Member> result_members(const F0Row& row, const Instrument& instrument) {
  const F0Result& r = row.result;
  const bool has = !r.refused();
  const bool is_table = r.coverage.last_nm > 0 && !r.coverage.is_formula;
  std::vector<std::string> flags;
  r.flags.for_each([&](Flag flag) { flags.push_back(json(name(flag))); });
  const std::array<double, 3> codes{double(r.srgb8.r), double(r.srgb8.g), double(r.srgb8.b)};
  const std::string null = "null";
  std::vector<Member> members{{"path", json(row.path)},
                              {"name", json(row.name)},
                              {"class", json(row.material_class)},
                              {"dataset", json(row.dataset)},
                              {"source", json(row.source)},
                              {"linear", has ? json(r.linear) : null},
                              {"srgb_linear", has ? json(r.srgb_linear) : null},
                              {"srgb8", has ? array(codes) : null},
                              {"hex", has ? json(hex(r.srgb8)) : null},
                              {"xyz", has ? json(r.xyz) : null},
                              {"Y", has ? json(r.luminance) : null},
                              {"f82", has ? json_f82(r) : null},
                              {"zone", has ? json_zone(r) : null},
                              {"gamut", has ? json_gamut(r) : null},
                              {"coverage", json_coverage(r.coverage)},
                              {"samples_400_700", is_table ? json(r.coverage.samples_400_700) : null},
                              {"largest_gap_nm", is_table ? json(r.coverage.largest_gap_nm) : null},
                              {"flags", json_array(flags)},
                              {"kind", row.kind.empty() ? null : json(row.kind)},
                              {"doubtful", row.doubt.empty() ? null : json(row.doubt)},
                              {"clear", json_clear(row.clear, json)},
                              {"band", row.band ? json_band(*row.band) : null},
                              {"band_reason", row.band ? null : json(row.band_reason)},
                              {"refused", has ? null : json(r.refusal)}};
  if (r.mean) members.push_back({"mean", json_mean(r)});
  if (instrument.any())
    members.push_back(
        {"instrument",
         json_object({{"aperture", json(instrument.aperture)}, {"scatter", json(instrument.scatter)}}, -1)});
  if (row.coat) {
    std::vector<Member> coat = coat_members(*row.coat, json);
    coat.push_back({"energy_left", json(row.coat->energy_left.linear)});
    members.push_back({"coat", json_object(coat, -1)});
  }
  if (!row.layers.empty()) {
    std::vector<std::string> layers;
    for (const F0Layer& layer : row.layers)
      layers.push_back(json_object({{"id", json(layer.id)},
                                    {"dataset", json(layer.dataset)},
                                    {"thickness_nm", layer.thickness_nm ? json(*layer.thickness_nm) : null},
                                    {"coherent", layer.thickness_nm ? json(layer.coherent) : null}},
                                   -1));
    members.push_back({"stack", json_array(layers)});
  }
  if (!row.alias_note.empty()) members.push_back({"alias_note", json(row.alias_note)});
  if (has && r.integration) members.push_back({"integration", json_integration(*r.integration)});
  return members;
}

}  // namespace

std::string f0_json(std::span<const F0Row> rows, const F0Options& options) {
  const auto result = [&](const F0Row& row) {
    return json_object(result_members(row, options.instrument), 4);
  };
  return json_document(schema_name, {{"policy", json_object(policy_members(options), 2)},
                                     {"results", json_lines_of(rows, 2, result)}});
}

std::string f0_jsonl(std::span<const F0Row> rows, const F0Options& options) {
  const std::string shared_policy = json_object(policy_members(options), -1);
  std::string out;
  for (const F0Row& row : rows) {
    std::vector<Member> members{{"schema", json(schema_name)}};
    for (Member& member : result_members(row, options.instrument)) members.push_back(std::move(member));
    members.push_back({"policy", shared_policy});
    append(out, json_object(members, -1), '\n');
  }
  return out;
}

}  // namespace etak
