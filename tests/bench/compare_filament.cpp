// SPDX-License-Identifier: Apache-2.0
// Filament's specular-color (Debian: libfilament-tools) beside etak on three spectra that tell them apart: a
// flat reflector, gold, and tables that end inside the visible range.
//
//   compare_filament [SPECULAR_COLOR]      the program; default: specular-color from PATH
//
// Its input is a text file: a line "wl<TAB>n" and rows, then "wl<TAB>k" and rows at the same wavelengths in
// micrometres. It prints three decimals, so a deviation below 0.0005 says nothing.
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/color/srgb.h"
#include "core/material/f0.h"
#include "core/material/library.h"
#include "process.h"

namespace {

/// n = 1 and k = 2 at all wavelengths: R = 1/2.
etak::OpticalConstants flat(double first_nm, double last_nm) {
  etak::Spectrum n, k;
  for (double nm = first_nm; nm <= last_nm; nm += 10) {
    n.wavelength_nm.push_back(nm);
    n.value.push_back(1);
    k.wavelength_nm.push_back(nm);
    k.value.push_back(2);
  }
  return {n, k};
}

/// The preferred table of gold, with only the rows in [first_nm, last_nm].
etak::OpticalConstants gold(double first_nm, double last_nm) {
  const auto material = etak::MaterialLibrary::builtin().find("gold");
  if (!material) throw std::runtime_error("no gold in the library");
  const auto constants = std::get<etak::OpticalConstants>(material->preferred_dataset().optics);
  const auto cut = [&](const etak::Spectrum& all) {
    etak::Spectrum out;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all.wavelength_nm[i] >= first_nm && all.wavelength_nm[i] <= last_nm) {
        out.wavelength_nm.push_back(all.wavelength_nm[i]);
        out.value.push_back(all.value[i]);
      }
    return out;
  };
  return {cut(std::get<etak::Spectrum>(constants.n)), cut(constants.k.value())};
}

void write_input(const std::string& file, const etak::OpticalConstants& constants) {
  std::ofstream out(file);
  out.precision(9);
  const auto block = [&](const char* column, const etak::Spectrum& spectrum) {
    out << "wl\t" << column << '\n';
    for (std::size_t i = 0; i < spectrum.size(); ++i)
      out << spectrum.wavelength_nm[i] / 1000 << '\t' << spectrum.value[i] << '\n';
  };
  block("n", std::get<etak::Spectrum>(constants.n));
  block("k", constants.k.value());
}

struct Printed {
  bool answered = false;
  std::array<double, 3> linear{};
  std::array<int, 3> codes{};
  std::string other;  // lines that are no part of its usual answer: a warning would be here
};

/// Its first "linear: r, g, b" and "sRGB: R, G, B" (whole numbers) are those at 0 degrees.
Printed read_answer(const std::string& output, const std::string& errors) {
  Printed out;
  bool has_codes = false;
  std::ifstream in(output);
  for (std::string line; std::getline(in, line);) {
    auto& l = out.linear;
    auto& c = out.codes;
    if (!out.answered && std::sscanf(line.c_str(), " linear: %lf, %lf, %lf", &l[0], &l[1], &l[2]) == 3)
      out.answered = true;
    else if (!has_codes && line.find('.') == std::string::npos &&
             std::sscanf(line.c_str(), " sRGB: %d, %d, %d", &c[0], &c[1], &c[2]) == 3)
      has_codes = true;
    else if (line.find("warn") != std::string::npos || line.find("rror") != std::string::npos)
      out.other += line + "; ";
  }
  std::ifstream messages(errors);
  for (std::string line; std::getline(messages, line);) out.other += line + "; ";
  return out;
}

void compare(const char* title, const etak::OpticalConstants& constants, const std::string& program,
             const bench::TemporaryFolder& folder) {
  const std::string input = folder.file("input.txt"), output = folder.file("out.txt"),
                    errors = folder.file("err.txt");
  write_input(input, constants);
  const auto run = bench::run({program, input}, output, errors);
  const Printed peer = read_answer(output, errors);
  const auto ours = etak::F0Solver({}).solve(constants);

  std::printf("\n%s\n", title);
  if (ours.refused())
    std::printf("  etak            refused: %s\n", ours.refusal.c_str());
  else
    std::printf("  etak            %8.5f %8.5f %8.5f   u8 %3d %3d %3d\n", ours.linear.r, ours.linear.g,
                ours.linear.b, ours.srgb8.r, ours.srgb8.g, ours.srgb8.b);
  std::string flags;
  ours.flags.for_each([&](etak::Flag flag) { flags += " " + std::string(name(flag)); });
  if (!flags.empty()) std::printf("    flags        %s\n", flags.c_str());
  if (!peer.answered) {
    std::printf("  specular-color  no answer, exit code %d %s\n", run.exit_code, peer.other.c_str());
    return;
  }
  std::printf("  specular-color  %8.3f %8.3f %8.3f   u8 %3d %3d %3d   exit code %d, says: %s\n",
              peer.linear[0], peer.linear[1], peer.linear[2], peer.codes[0], peer.codes[1], peer.codes[2],
              run.exit_code, peer.other.empty() ? "nothing more" : peer.other.c_str());
  if (ours.refused()) return;
  const auto truth = vec(ours.linear);
  std::printf("  deviation       ");
  for (std::size_t c = 0; c < 3; ++c) std::printf("%+7.1f%% ", 100 * (peer.linear[c] / truth[c] - 1));
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string program = argc > 1 ? argv[1] : "specular-color";
    const bench::TemporaryFolder folder;
    compare("flat reflector, n = 1, k = 2, 300-900 nm: R = 1/2, no hue is due", flat(300, 900), program,
            folder);
    compare("gold of the library, as far as its table goes", gold(0, 1e9), program, folder);
    compare("flat reflector, 400-700 nm only: ends have to be held", flat(400, 700), program, folder);
    compare("gold, 400-700 nm only", gold(400, 700), program, folder);
    compare("gold, 500-600 nm only: half of the visible range is missing", gold(500, 600), program, folder);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_filament: %s\n", error.what());
    return 2;
  }
}
