// SPDX-License-Identifier: Apache-2.0
// Makes resources/bands.json of the publications of tests/data/publications.csv, and says how the rule does.
//   fit_bands PUBLICATIONS.csv OUT.json [DATE [PLOT.svg]]
// Each publication is left out once, with its material left out of the table that judges it. The rule stands beside
// Student's t and the plain range of the known publications, both where two or more are known.
#include <cstdio>
#include <exception>

#include "core/base/files/file.h"
#include "core/plot/plot_file.h"
#include "core/plot/svg_plot.h"
#include "tests/bench/calibration.h"

namespace etak {
namespace {

void print(const char* what, const BandCover& cover) {
  const double count = double(cover.count);
  std::printf(
      "%-14s %4zu   50 %%: %5.1f %% inside, mean radius %5.2f   90 %%: %5.1f %% inside, mean radius %5.2f\n",
      what, cover.count, 100 * double(cover.inside50) / count, cover.de50 / count,
      100 * double(cover.inside90) / count, cover.de90 / count);
}

// Coverage against nominal share, all and by class.
std::string plot(const std::vector<PublishedMaterial>& materials) {
  LinePlot out;
  out.title = "Coverage of the bands";
  out.description = "Share of left-out publications inside of the band against its nominal share";
  out.x = nice_axis("nominal share", 0, 1);
  out.left = nice_axis("share inside", 0, 1);
  out.curves = {{{}, {}, "c1", "all"},
                {{}, {}, "c2", "metal"},
                {{}, {}, "c3", "semiconductor"},
                {{}, {}, "c4", "clear"}};
  out.keys = {{"c1", "all"}, {"c2", "metals"}, {"c3", "semiconductors"}, {"c4", "clear materials"}};
  for (int percent = 5; percent <= 95; percent += 5) {
    const CoverAt at = cover_at(materials, percent / 100.0);
    const std::array<double, 4> shares{at.all, at.by_class[0], at.by_class[1], at.by_class[2]};
    for (std::size_t i = 0; i < shares.size(); ++i) {
      out.curves[i].x.push_back(at.nominal);
      out.curves[i].y.push_back(shares[i]);
    }
    std::printf("nominal %.2f   all %.3f   metal %.3f   semiconductor %.3f   clear %.3f\n", at.nominal,
                shares[0], shares[1], shares[2], shares[3]);
  }
  return svg_file(out, false);
}

void run(const std::string& in, const std::string& out, const std::string& date, const std::string& picture) {
  const std::vector<PublishedMaterial> materials = parse_publications(read_file(in), in);
  std::size_t count = 0, several = 0, publications = 0;
  for (const PublishedMaterial& material : materials) {
    count += material.colours.size() >= 2 ? 1 : 0;
    several += material.colours.size() >= 3 ? 1 : 0;
    if (material.colours.size() >= 2) publications += material.colours.size();
  }
  std::printf("%zu materials with two publications or more, %zu with three or more, %zu publications\n",
              count, several, publications);
  const BandRules rules = leave_one_out(materials);
  print("conformal", rules.conformal);
  for (std::size_t kind = 0; kind < band_class_count; ++kind)
    print(std::string(name(static_cast<BandClass>(kind))).c_str(), rules.by_class[kind]);
  print("Student's t", rules.student);
  print("plain range", rules.range);
  BandTable table = band_table(materials, residuals(materials));
  table.made = (date.empty() ? "" : date + ", ") + std::to_string(count) + " materials, " +
               std::to_string(publications) + " publications of refractiveindex.info";
  write_file(out, format_bands(table), true);
  if (!picture.empty()) write_file(picture, plot(materials), true);
}

}  // namespace
}  // namespace etak

int main(int count, char** arguments) {
  if (count < 3) {
    std::fputs("usage: fit_bands PUBLICATIONS.csv OUT.json [DATE [PLOT.svg]]\n", stderr);
    return 2;
  }
  try {
    etak::run(arguments[1], arguments[2], count > 3 ? arguments[3] : "", count > 4 ? arguments[4] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fit_bands: %s\n", error.what());
    return 2;
  }
}
