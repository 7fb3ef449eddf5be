// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/atlas/layout.h"
#include "core/atlas/leave_out.h"
#include "core/validate/finding.h"

namespace etak {

/// What a page of an atlas holds, as PNG files of the same shape: diffuse over a checker pattern where alpha
/// hides it, F0, gloss as grey. Empty where the page does without that texture.
struct AtlasPagePictures {
  std::string diffuse, specular, gloss;
};

struct AtlasPageData {
  std::string title;
  AtlasLayout layout;
  std::vector<AtlasPagePictures> pictures;  // one for each page
  std::vector<LeaveOutLine> left_out;
  TexelAccount before, after;
  const ValidationReport* findings = nullptr;              // null: not checked
  std::vector<std::pair<std::string, std::string>> links;  // text and target, for the head of the page
};

/// Where the regions of a page lie: the page, every region with its gutter, and names where they fit; others
/// are in the tooltip. SVG to stand in a page.
std::string layout_svg(const AtlasLayout& layout, int page);

/// Textures, layout, what was left out, findings and the materials' defines as one HTML page that works from
/// disk: no script, no font, nothing from a network.
std::string atlas_page(const AtlasPageData& data);

}  // namespace etak
