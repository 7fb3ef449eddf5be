// SPDX-License-Identifier: Apache-2.0
#include "app/demo/figures.h"

#include <array>
#include <filesystem>
#include <string_view>

#include "core/base/bytes/base64.h"
#include "core/base/files/file.h"
#include "core/base/text/text.h"
#include "core/pages/page_style.h"

namespace etak::demo {
namespace {

// A figure of a source: where it stands there, how etak draws it, and what it shows, in etak's own words.
struct Figure {
  std::string_view name, place, words, text;
};

// The lights are files of ./dev demo: a window and a lamp behind a table.
constexpr std::array figures{
    Figure{
        "desk", "Schüler, figure 2.5.4",
        "f0=0.04 --model ggx-schlick --texture scene/wood_colour.png --gloss 0.7 --quad --perspective --sweep tilt=20:80:4 --lights figures/window.json --size 300",
        "A varnished desk before a window. From above its wood is seen; the lower the eye, the more of the window: F rises from 0.04 to 1 at grazing angles."},
    Figure{
        "wet", "Schüler, plate 3",
        "f0=0.04 --model ggx-schlick --texture scene/stone_wet.png --gloss-texture scene/stone_wet_f0_gloss.png --sweep orbit=0:270:4 --size 300",
        "Wet and dry stone in one pair of textures, from four sides: where it is wet it is darker, has an F0 of 0.02 and a high gloss, and mirrors the lights that the dry stone scatters."},
    Figure{"glass", "Schüler, plate 2", "--sweep material=fused_silica,granite,pmma,concrete --size 256",
           "Glass and stone under one light: F0 tells them from metals, gloss and body from each other."},
    Figure{
        "gloss", "Schüler, section on energy conservation; Hoffman, rows of roughness",
        "gold --sweep gloss=0:1:7 --size 220",
        "Gloss from 0 to 1 at one F0. The highlight grows smaller and brighter at once, since the lobe keeps its energy."},
    Figure{"pottery", "Schüler, one F0 and varied gloss",
           "f0=0.05 diffuse=0.35,0.12,0.05 --sweep gloss=0:1:6 --size 256",
           "From bare clay to glaze by gloss alone. F0 and body are the same in all six."},
    Figure{
        "brushed", "Hoffman, anisotropic surfaces",
        "aluminum --model ashikhmin-shirley-specular --set nv=10 --sweep nu=10,100,900 --size 256",
        "Aluminium brushed in one direction: the highlight stretches across the scratches as the exponent along them grows."},
    Figure{
        "plane", "TU Graz, Phong beside Blinn-Phong",
        "f0=0.04 diffuse=0.05,0.05,0.08 --quad --perspective --tilt 65 --lights figures/lamp.json --gloss 0.6 --sweep model=phong,blinn-phong,beckmann-smith --size 300",
        "A lamp behind a table. Phong's highlight stays round; those about the half vector stretch towards the eye, as on a wet road, and masking and Fresnel's term make them brighter."},
    Figure{"metals", "Hoffman, table of metals from dark to bright",
           "--sweep material=titanium,iron,nickel,platinum,copper,gold,aluminum,silver --size 200",
           "Metals of his table by their published spectra."},
    Figure{
        "bodies", "TU Graz, diffuse models",
        "f0=0.04 diffuse=0.5 --model none --sweep diffuse-model=lambert,oren-nayar,lambert-tradeoff --lights 1 --size 256",
        "Rough bodies darken less towards the rim than Lambert's."},
};

std::string path_of(const Figure& figure) {
  return "figures/" + std::string(figure.name) + ".png";
}

}  // namespace

std::string figure_commands() {
  std::string out;
  for (const Figure& figure : figures) append(out, figure.name, " ", figure.words, "\n");
  return out;
}

std::string figures_page() {
  std::string out;
  for (const Figure& figure : figures) {
    if (!std::filesystem::exists(path_of(figure))) continue;
    append(out, "<article id=\"", figure.name, "\"><h3>", escape_html(std::string(figure.place)), "</h3><p>",
           escape_html(std::string(figure.text)), "</p><div class=\"scroll\"><img alt=\"",
           escape_html(std::string(figure.text)), "\" src=\"data:image/png;base64,",
           base64(read_file(path_of(figure))), "\"></div><p class=\"policy\"><code>etak render ",
           escape_html(std::string(figure.words)), " -o ", figure.name, ".png</code></p></article>\n");
  }
  if (out.empty()) return {};
  std::string page;
  append(
      page,
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"><title>etak: figures of the sources</title>\n<style>",
      page_css,
      "article img { display: block; max-width: 100%; height: auto; }\narticle code { overflow-wrap: anywhere; }</style></head>\n<body>\n<header><h1>Figures of the sources</h1>\n<p class=\"lead\">What "
      "Schüler, Hoffman and the lecture of TU Graz show, drawn by etak from published spectra and its own textures.</p></header>\n<main>\n",
      out, "</main></body></html>\n");
  return page;
}

}  // namespace etak::demo
