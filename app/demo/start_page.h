// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/judge/finding.h"
#include "core/pages/f0/report.h"
#include "core/study/error_time.h"

namespace etak {

// The page that ./dev demo begins with: what etak is, in pictures.

/// A sphere as one way to compute its reflectance shows it (sphere_looks() in core/study/sphere_looks.h).
struct StartSphere {
  std::string title;  // "Schlick"
  std::string png;
  double mean_de = 0, worst_de = 0;  // against the first sphere of the material
};

/// A material with its spheres, the measured one first, and its values for other programs: the title of a
/// target and what is pasted there.
struct StartMaterial {
  std::string id, name;
  std::vector<StartSphere> spheres;
  std::vector<std::pair<std::string, std::string>> values;
};

/// A way to compute reflectance, for the chart of error against time.
///   ns                         of one evaluation
///   mean_de, least_de, most_de of the mean errors of the materials' spheres: their mean, least and largest
struct StartPoint {
  std::string title;
  double ns = 0, mean_de = 0, least_de = 0, most_de = 0;
};

/// A picture with its size in texels, which may be more than the pixels of the PNG.
struct StartPicture {
  std::string png, label;
  int width = 0, height = 0;
};

/// A finding of the validator, with the picture it is in where there is one.
struct StartFinding {
  Finding finding;
  StartPicture picture;
};

/// Another page.
///   picture   PNG; empty: none
struct StartCard {
  std::string target, title, text, picture;
};

struct StartPageData {
  ErrorTimeStrips films;  // what renderers show of an oxide; no ways: none
  std::vector<StartMaterial> materials;
  std::span<const MaterialReport> library;
  std::string library_page;  // address of the F0 page, which the dots of the zone plot lead to
  std::vector<StartPoint> points;
  std::string costs;  // where the times of the points were measured
  std::vector<StartPicture> before, after;
  std::uint64_t texels_before = 0, texels_after = 0;
  std::string verdict;
  std::vector<StartFinding> findings;
  std::vector<StartCard> cards;
  bool element = false;  // whether etak-element.js of ./dev web is beside the page
};

/// The page. It is one file that loads nothing but etak-element.js where that is beside it, and nothing needs a script
/// to be read: scripts add that a click copies values, and the section of materials computed in the page.
std::string start_page(const StartPageData& data);

/// The chart of the points as an SVG element: time across, error up, both logarithmic; a line from the least
/// to the largest error of a material. Empty without points.
std::string start_chart(std::span<const StartPoint> points);

}  // namespace etak
