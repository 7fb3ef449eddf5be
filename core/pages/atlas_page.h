// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/atlas/layout.h"
#include "core/atlas/leave_out.h"
#include "core/findings/report.h"
#include "core/pack/blocks/compress_options.h"

namespace etak {

/// Pictures of one page of an atlas, as PNG files of the same aspect ratio: the diffuse colour over a checker
/// pattern that shows where alpha hides it, F0, and gloss as grey. Empty where the page lacks that texture.
struct AtlasPagePictures {
  std::string diffuse, specular, gloss;
};

struct AtlasPageData {
  std::string title;
  AtlasLayout layout;
  std::vector<AtlasPagePictures> pictures;  // one for each page; empty: none are shown
  std::vector<LeaveOutLine> left_out;
  TexelAccount before, after;                  // of leave_out()
  std::vector<BlockLevel> blocks;              // of compression; empty: textures are not in blocks
  std::vector<BlockPicture> block_pictures;    // of the materials that it changed most
  const ValidationReport* findings = nullptr;  // null: the pages were not checked
  std::vector<std::pair<std::string, std::string>> links;  // text and target, for the head of the page
};

/// A plan of one page as an SVG element for an HTML page: every region with its gutter. A region's name is
/// written into it where there is room; its tooltip always gives name, size and place.
///   page   index into layout.pages
std::string layout_svg(const AtlasLayout& layout, int page);

/// The way back: where the regions of some materials lie on their own picture.
///   materials   names of those that share the texels
///   svg         an SVG element for an HTML page; every region is numbered, and its tooltip gives its place on
///               the picture and on the page
struct SourceMap {
  std::string materials, svg;
};
/// The maps of every picture that is not on a page whole.
std::vector<SourceMap> source_maps(const AtlasLayout& layout);

/// What compression changed, as a section of an HTML page: a table of textures and of their materials on level 0, and
/// the pictures.
std::string blocks_section(const std::vector<BlockLevel>& blocks, const std::vector<BlockPicture>& pictures);

/// An HTML page of an atlas: textures, layout, texels that were left out, what compression changed, findings, and the defines of each
/// material. The page is one file without scripts, fonts or links to the network, so that it opens from disk.
std::string atlas_page(const AtlasPageData& data);

}  // namespace etak
