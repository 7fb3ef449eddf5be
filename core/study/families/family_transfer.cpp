// SPDX-License-Identifier: Apache-2.0
// Family e: shortcuts for the sRGB curve, and their errors in codes and in linear light.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/color/srgb.h"
#include "core/math/functions.h"
#include "core/study/families/families.h"
#include "core/study/measure.h"

namespace etak {
namespace {

// The formula texts that shaders get, in float.
namespace formulas {
#include "core/math/real_f32.h"

#include "core/light/transfer.glsl"
}  // namespace formulas

struct Curve {
  const char* id;
  const char* title;
  double (*in_double)(double);
  float (*in_float)(float);
};

constexpr std::array encoders{Curve{"srgb", "sRGB, exact", srgb_encode, formulas::srgb_encode},
                              Curve{"power_045", "power 0.45 (Schüler)",
                                    [](double x) { return math::pow(x, 0.45); }, formulas::power045_encode},
                              Curve{"power_1_22", "power 1/2.2",
                                    [](double x) { return math::pow(x, 1 / 2.2); }, formulas::power22_encode},
                              Curve{"root", "square root (Schüler, 2.0)",
                                    [](double x) { return std::sqrt(x); }, formulas::root_encode}};

constexpr std::array decoders{
    Curve{"srgb", "sRGB, exact", srgb_decode, formulas::srgb_decode},
    Curve{"power_22", "power 2.2 (Schüler)", [](double y) { return math::pow(y, 2.2); },
          formulas::power22_decode},
    Curve{"square", "squaring (Schüler, 2.0)", [](double y) { return y * y; }, formulas::square_decode}};

constexpr std::array shown_codes{10, 39, 56, 128, 188};

double encode_error(const Curve& curve, double linear) {
  return 255 * (curve.in_double(linear) - srgb_encode(linear));
}

// The largest error over a fine sweep of linear light, with its sign.
double worst_encode_error(const Curve& curve) {
  double worst = 0;
  for (int i = 0; i <= 100000; ++i) {
    const double error = encode_error(curve, i / 100000.0);
    if (std::abs(error) > std::abs(worst)) worst = error;
  }
  return worst;
}

// How many of the 256 codes change on the way through a decoder and an encoder.
int moved_codes(const Curve& decode, const Curve& encode) {
  int moved = 0;
  for (int code = 0; code < 256; ++code)
    moved +=
        std::lround(255 * std::clamp(encode.in_double(decode.in_double(code / 255.0)), 0.0, 1.0)) != code;
  return moved;
}

TimedCase timed(const Curve& curve) {
  const auto values = random_floats(4096, 0.001f, 1);
  return {curve.id, values->size(),
          [values, out = std::make_shared<std::vector<float>>(values->size()), &curve] {
            for (std::size_t i = 0; i < values->size(); ++i) (*out)[i] = curve.in_float((*values)[i]);
            keep(out->data());
          }};
}

template <std::size_t N>
TimedSet timed_set(const ErrorTimeTable& table, const std::array<Curve, N>& curves) {
  std::vector<TimedCase> cases;
  for (const Curve& curve : curves) cases.push_back(timed(curve));
  return {{table.id}, std::move(cases)};
}

ErrorTimeTable encode_table(std::vector<TimedSet>& timings) {
  ErrorTimeTable table;
  table.id = "encode";
  table.title = "Linear light to codes";
  table.metrics = {{"max_codes", "largest error", "codes"},
                   {"codes_at_004", "error at F0 0.04", "codes"},
                   {"codes_at_05", "error at 0.5", "codes"}};
  table.base = "srgb";
  for (const Curve& curve : encoders)
    table.rows.push_back(
        {curve.id,
         curve.title,
         {std::abs(worst_encode_error(curve)), encode_error(curve, 0.04), encode_error(curve, 0.5)}});
  timings.push_back(timed_set(table, encoders));
  return table;
}

ErrorTimeTable decode_table(std::vector<TimedSet>& timings) {
  ErrorTimeTable table;
  table.id = "decode";
  table.title = "Codes to linear light";
  table.metrics = {{"max_linear", "largest error of linear light", ""}};
  for (const int code : shown_codes)
    table.metrics.push_back(
        {"relative_at_" + std::to_string(code), "error at code " + std::to_string(code), "%"});
  table.base = "srgb";
  for (const Curve& curve : decoders) {
    ErrorTimeRow row;
    row.id = curve.id;
    row.title = curve.title;
    double worst = 0;
    for (int code = 0; code < 256; ++code)
      worst = std::max(worst, std::abs(curve.in_double(code / 255.0) - srgb_decode(code / 255.0)));
    row.errors.push_back(worst);
    for (const int code : shown_codes)
      row.errors.push_back(100 * (curve.in_double(code / 255.0) / srgb_decode(code / 255.0) - 1));
    table.rows.push_back(row);
  }
  timings.push_back(timed_set(table, decoders));
  return table;
}

}  // namespace

ErrorTimeFamily transfer_family(const ReportOptions&) {
  ErrorTimeFamily family;
  family.id = "transfer";
  family.letter = "e";
  family.title = "Transfer curves";
  family.reference = "IEC 61966-2-1 (sRGB), piecewise, in double";
  family.grid = "encoding: 100,001 values in [0, 1]; decoding: all 256 codes";
  family.advice =
      "Use the exact curve, from a table of 256 entries or the GPU's sRGB formats: the shortcuts move dark dielectrics by whole codes, and 2.2 in with 0.45 out is not even its own inverse.";
  family.tables = {encode_table(family.timed), decode_table(family.timed)};
  family.picks = {
      {"codes of linear light", "encode", "srgb", "shortcuts move dark dielectrics by whole codes"},
      {"linear light of codes", "decode", "srgb", "a table of 256 entries or the GPU does it"}};
  family.notes = {
      "2.2 in and 0.45 out moves " + std::to_string(moved_codes(decoders[1], encoders[1])) +
          " of 256 codes; squaring in and root out " + std::to_string(moved_codes(decoders[2], encoders[3])) +
          "; sRGB in and out " + std::to_string(moved_codes(decoders[0], encoders[0])) + ".",
      "Times are of the float formulas that shaders get, with the C library's pow, 4096 values in cache."};
  return family;
}

}  // namespace etak
