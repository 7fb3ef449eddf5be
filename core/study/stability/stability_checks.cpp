// SPDX-License-Identifier: Apache-2.0
// Checks of the readers and solvers that etak uses, with data that no material has and with spectra that are
// hard to integrate.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/brdf/integrals/normalise.h"
#include "core/color/srgb.h"
#include "core/exchange/rii/rii_page.h"
#include "core/exchange/table.h"
#include "core/light/functions.h"
#include "core/material/f0.h"
#include "core/study/stability/stability_rows.h"

namespace etak {
namespace {

using std::string;
using std::string_view;

// The result of a user's table as text: its F0 and flags, or the message by which it is refused.
string read_table(const string& rows, bool& refused, F0Result* result = nullptr) {
  try {
    const Table table = parse_table("wavelength_nm,n,k\n" + rows, "table.csv", {});
    const F0Result solved = F0Solver({}).solve(table.optics, table.flags);
    refused = solved.refused();
    if (result != nullptr) *result = solved;
    string out = refused ? "refused: " + solved.refusal : "F0 " + number(solved.luminance, 6);
    solved.flags.for_each([&](Flag flag) { out += ", " + string(name(flag)); });
    return out;
  } catch (const Error& error) {
    refused = true;
    return string("refused: ") + error.what();
  }
}

bool refuses_table(const string& rows, string& found, string_view names = {}) {
  bool refused = false;
  found = read_table(rows, refused);
  return refused && found.find(names) != string::npos;
}

// Whether a page of a database gets the flag and gives F0: in pages doubtful values are flagged, not refused.
bool page_has(const string& rows, Flag flag, string& found) {
  RiiPage page;
  parse_rii_page("REFERENCES: |\n    none\nDATA:\n  - type: tabulated nk\n    data: |\n" + rows, "page.yml",
                 page);
  const F0Result result = F0Solver({}).solve(page.optics, page.flags);
  found = result.refused() ? "refused: " + result.refusal : "F0 " + number(result.luminance, 6);
  result.flags.for_each([&](Flag one) { found += ", " + string(name(one)); });
  return !result.refused() && result.flags.has(flag);
}

bool function_gives(const string& id, std::initializer_list<NamedText> inputs, double expected, double most,
                    string& found) {
  const Function* function = find_function(id);
  if (function == nullptr) {
    found = "no such function";
    return false;
  }
  const double value = evaluate(*function, std::vector<NamedText>(inputs), id);
  found = number(value, 12);
  return std::abs(value - expected) <= most * std::max(std::abs(expected), 1e-300) || value == expected;
}

bool function_refuses(const string& id, std::initializer_list<NamedText> inputs, string& found) {
  try {
    found = number(evaluate(*find_function(id), std::vector<NamedText>(inputs), id), 12);
    return false;
  } catch (const Error& error) {
    found = string("refused: ") + error.what();
    return true;
  }
}

bool refuses_gloss(const char* gloss, string& found) {
  return function_refuses(
      "schueler_simplified",
      {{"theta_l", "30"}, {"theta_v", "30"}, {"phi_v", "180"}, {"K", "0.04"}, {"g", gloss}}, found);
}

constexpr const char* glass_rows = "380,1.5,0\n500,1.5,0\n780,1.5,0\n";

constexpr StabilityCheck rows[] = {
    {"overflow", "k so large that k^4 leaves single precision", "k = 1e10", "refused",
     "k of data is at most 1e6",
     [](string& found) {
       return function_refuses("fresnel_exact", {{"n", "1"}, {"k", "1e10"}, {"cos", "1"}}, found);
     }},
    {"overflow_n", "an index that no material has", "n = 1e20", "refused", "n of data is at most 1e4",
     [](string& found) {
       return function_refuses("fresnel_exact", {{"n", "1e20"}, {"k", "0"}, {"cos", "1"}}, found);
     }},
    {"n_0_data", "an index of nothing in a table", "n = 0", "refused, line named", "n is above 0",
     [](string& found) { return refuses_table("400,1.5,0\n500,0,0\n700,1.5,0\n", found, "table.csv:3"); }},
    {"negative_n", "a negative index in a table", "n = -1", "refused, line named", "n is above 0",
     [](string& found) { return refuses_table("400,1.5,0\n500,-1,0\n700,1.5,0\n", found, "table.csv:3"); }},
    {"negative_k_data", "the other sign convention in a table", "k = -0.5", "refused, line named",
     "k is at least 0",
     [](string& found) {
       return refuses_table("400,1.5,0\n500,1.5,-0.5\n700,1.5,0\n", found, "table.csv:3");
     }},
    {"negative_k_page", "the same in a database page", "k = -0.01", "taken as 0 and flagged",
     "it is noise there",
     [](string& found) {
       return page_has("        0.36 1.5 0.0\n        0.5 1.5 -0.01\n        0.83 1.5 0.0\n",
                       Flag::negative_k, found);
     }},
    {"not_a_number", "NaN in a table", "n = nan", "refused, line named", "a number",
     [](string& found) { return refuses_table("400,1.5,0\n500,nan,0\n700,1.5,0\n", found, "table.csv:3"); }},
    {"infinite", "infinity in a table", "n = inf", "refused, line named", "a finite number",
     [](string& found) { return refuses_table("400,1.5,0\n500,inf,0\n700,1.5,0\n", found, "table.csv:3"); }},
    {"unsorted", "wavelengths out of order", "700, 400, 500 nm", "sorted and flagged", "order says nothing",
     [](string& found) {
       bool refused = false;
       F0Result result;
       found = read_table("780,1.5,0\n380,1.5,0\n500,1.5,0\n", refused, &result);
       return !refused && result.flags.has(Flag::unsorted) && std::abs(result.luminance - 0.04) < 1e-12;
     }},
    {"duplicate_same", "a row twice", "500 nm twice, equal", "dropped", "says nothing new",
     [](string& found) {
       bool refused = false;
       F0Result result;
       found = read_table("380,1.5,0\n500,1.5,0\n500,1.5,0\n780,1.5,0\n", refused, &result);
       return !refused && result.flags.has(Flag::duplicate_dropped) &&
              std::abs(result.luminance - 0.04) < 1e-12;
     }},
    {"duplicate_other", "two values for one wavelength in a table", "500 nm: n = 1.5 and 1.6",
     "refused, rows named", "which one is meant is the user's to say",
     [](string& found) {
       return refuses_table("380,1.5,0\n500,1.5,0\n500,1.6,0\n780,1.5,0\n", found, "500");
     }},
    {"duplicate_page", "the same in a database page", "0.5 um: n = 1.5 and 1.6", "averaged and flagged",
     "a page is answered",
     [](string& found) {
       return page_has(
           "        0.36 1.5 0.0\n        0.5 1.5 0.0\n        0.5 1.6 0.0\n        0.83 1.5 0.0\n",
           Flag::duplicate_wavelength, found);
     }},
    {"wide_gap", "a gap in the middle of the visible", "500 to 780 nm", "flagged, not refused",
     "a straight line is drawn",
     [](string& found) {
       bool refused = false;
       F0Result result;
       found = read_table(glass_rows, refused, &result);
       return !refused && result.flags.has(Flag::gap);
     }},
    {"ends_inside", "data that end inside the visible", "450 to 600 nm",
     "refused: more than 5 % of Y is missing", "share of the luminous weight",
     [](string& found) { return refuses_table("450,1.5,0\n500,1.5,0\n600,1.5,0\n", found); }},
    {"one_sample", "a single row", "550 nm", "refused by the coverage rule", "nothing is known of the rest",
     [](string& found) { return refuses_table("550,1.5,0\n", found); }},
    {"wrong_unit", "micrometres given as nanometres", "0.4 to 0.7 nm",
     "refused, with the unit that would fit", "no row inside 300 to 900 nm",
     [](string& found) { return refuses_table("0.38,1.5,0\n0.5,1.5,0\n0.78,1.5,0\n", found, "um"); }},
    {"reflectance_above_1", "more light than comes in", "R = 1.1", "refused, line named", "R is at most 1.02",
     [](string& found) {
       try {
         parse_table("wavelength_nm,R\n380,0.9\n500,1.1\n780,0.9\n", "table.csv", {});
         found = "accepted";
         return false;
       } catch (const Error& error) {
         found = error.what();
         return found.find("table.csv:3") != string::npos;
       }
     }},
    {"gloss_below", "a gloss below its range", "g = -0.1", "refused", "g in [0, 1]",
     [](string& found) { return refuses_gloss("-0.1", found); }},
    {"gloss_above", "a gloss above its range", "g = 1.1", "refused", "g in [0, 1]",
     [](string& found) { return refuses_gloss("1.1", found); }},
    {"alpha_0", "a width of nothing", "alpha = 0", "refused", "the lobe is a point",
     [](string& found) {
       return function_refuses("D_ggx", {{"alpha", "0"}, {"nm", "1"}}, found);
     }},
    {"abc_pole_1", "ABC beside a2 = 1", "a1 = 10, a2 = 1 + 1e-9", "as at a2 = 1, to 1e-7", "continuous",
     [](string& found) {
       const double at = abc_norm(10, 1), beside = abc_norm(10, 1 + 1e-9);
       found = number(beside / at - 1, 3) + " apart";
       return std::abs(beside / at - 1) < 1e-7;
     }},
    {"abc_pole_2", "ABC beside a2 = 2", "a1 = 10, a2 = 2 + 1e-9", "as at a2 = 2, to 1e-7", "continuous",
     [](string& found) {
       const double at = abc_norm(10, 2), beside = abc_norm(10, 2 + 1e-9);
       found = number(beside / at - 1, 3) + " apart";
       return std::abs(beside / at - 1) < 1e-7;
     }},
    {"abc_flat", "ABC that is flat", "a1 = 1e-9, a2 = 1", "1 / pi",
     "the integral of nm over the hemisphere is pi",
     [](string& found) {
       const double value = abc_norm(1e-9, 1) * 3.14159265358979323846;
       found = number(value, 12);
       return std::abs(value - 1) < 1e-8;
     }},
    {"schueler_loss", "Schueler's printed D at g = 0", "e = 1: integral of D nm / pi",
     "2/3: as printed, unnormalised", "(1 + e) / (2 + e)",
     [](string& found) {
       return function_gives("integral_D_schueler_over_pi", {{"param", "1"}}, 2.0 / 3, 1e-9, found);
     }},
    {"beckmann_integral", "the lecture's 1 / (4 m^2) in place of 1 / (pi m^2)", "m = 0.3: integral of D nm",
     "1", "every facet counts once",
     [](string& found) {
       string printed;
       counts_every_facet_once("integral_D_beckmann_printed", printed);
       const bool one = counts_every_facet_once("integral_D_beckmann", found);
       found += "; printed form " + printed.substr(0, 5);
       return one;
     }},
    {"rounding", "8 bit by rounding, not by truncation", "the code of its own decoded value, all 256",
     "none moved", "floor(255 v + 1/2)",
     [](string& found) {
       string truncated;
       gives_every_code_back(
           [](double linear) { return static_cast<std::uint8_t>(255 * srgb_encode(linear)); }, truncated);
       const bool all = gives_every_code_back([](double linear) { return srgb_u8(linear); }, found);
       found += "; " + truncated + " when truncated";
       return all;
     }},
    {"codes_round_trip", "every 8-bit and 16-bit code there and back", "decode, encode, round", "all equal",
     "IEC 61966-2-1",
     [](string& found) {
       int moved = 0;
       for (int code = 0; code < 256; ++code) moved += srgb_u8(srgb_decode(code / 255.0)) != code;
       for (int code = 0; code < 65536; ++code)
         moved += std::lround(65535 * srgb_encode(srgb_decode(code / 65535.0))) != code;
       found = std::to_string(moved) + " moved";
       return moved == 0;
     }},
    {"subnormal", "a colour below the normal numbers", "linear 1e-310", "code 0", "rounds to nothing",
     [](string& found) {
       found = "code " + std::to_string(srgb_u8(1e-310));
       return srgb_u8(1e-310) == 0;
     }},
    {"spike", "a resonance narrower than the grid", "n = 3 within 0.5 nm at 550.25 nm, else 1.5",
     "the exact method, to 1e-6 of a sum at 0.001 nm", "trapezoids over the same knots",
     [](string& found) {
       Spectrum n{{360, 549.999, 550, 550.5, 550.501, 830}, {1.5, 1.5, 3, 3, 1.5, 1.5}};
       OpticalConstants optics;
       optics.n = n;
       F0Options exact;
       exact.method = Method::exact;
       const double ours = F0Solver(exact).solve(optics).luminance;
       const double grid = F0Solver(F0Options{}).solve(optics).luminance;
       // F0 is 0.04 but in the spike, where it is 0.25: 0.501 nm of the luminous weight at 550.25 nm.
       const auto weight = weight_inside({}, 549, 551)[1] / 3;  // per nm: three grid points
       const double expected = 0.04 + 0.21 * 0.501 * weight;
       found = "exact " + number(ours, 7) + ", 1 nm " + number(grid, 7) + ", expected " + number(expected, 7);
       return std::abs(ours - expected) < 2e-6;
     }},
};

}  // namespace

bool counts_every_facet_once(std::string_view integral, std::string& found) {
  return function_gives(string(integral), {{"param", "0.3"}}, 1, 1e-9, found);
}

bool gives_every_code_back(std::uint8_t (*code_of)(double linear), std::string& found) {
  int moved = 0;
  for (int code = 0; code < 256; ++code) moved += code_of(srgb_decode(code / 255.0)) != code;
  found = std::to_string(moved) + " moved";
  return moved == 0;
}

std::span<const StabilityCheck> stability_checks() {
  return rows;
}

}  // namespace etak
