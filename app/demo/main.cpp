// SPDX-License-Identifier: Apache-2.0
// etak-start-page --figures: prints which figures of the sources `./dev demo` draws, a line each: NAME and words of
// etak render.
// etak-start-page DEMO: writes DEMO/index.html, the first page of `./dev demo`, and DEMO/sources.html where figures/ of
// these is there. DEMO holds scene/ as
// etak-demo-scene makes it, with mistakes/, and atlas/ as etak pack makes it; other pages of the demo that are there
// get cards, and where etak-element.js of ./dev web is there, materials are computed in the page. Not installed.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string_view>
#include <thread>

#include "app/demo/figures.h"
#include "app/demo/parts.h"
#include "core/base/files/file.h"
#include "core/base/parallel.h"
#include "core/image/files/png.h"
#include "core/material/quality.h"
#include "core/study/film_ways.h"

namespace {

// The library with the F0 of all its datasets.
std::vector<etak::MaterialReport> library_reports(const etak::MaterialLibrary& library, unsigned threads) {
  const etak::F0Solver solver({});
  std::vector<etak::MaterialReport> out(library.ids().size());
  etak::parallel_chunks(out.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      out[i].material = library.at(i);
      for (const etak::Dataset& dataset : out[i].material.datasets)
        out[i].results.push_back(etak::solve(solver, out[i].material, dataset));
    }
  });
  return out;
}

void write_start_page(const std::string& folder) {
  std::filesystem::current_path(folder);
  const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1u, 256u);
  const etak::MaterialLibrary library = etak::MaterialLibrary::builtin();
  const std::vector<etak::MaterialReport> reports = library_reports(library, threads);
  etak::StartPageData data;
  data.library = reports;
  data.library_page = "f0.html";
  etak::demo::add_spheres(library, threads, data);
  data.films = etak::film_strips(
      "Titania on titanium",
      etak::film_ways(library, etak::thicker_films("anatase", "titanium", 40), threads),
      [](const etak::Pixels<std::uint8_t>& picture) { return etak::png_bytes(picture, {.srgb = true}); });
  etak::demo::add_scene(threads, data);
  if (const std::string figures = etak::demo::figures_page(); !figures.empty())
    etak::write_file("sources.html", figures, true);
  etak::demo::add_cards(data);
  data.element = std::filesystem::exists("etak-element.js");
  etak::write_file("index.html", etak::start_page(data), true);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: etak-start-page --figures | DEMO\n");
    return 2;
  }
  try {
    if (std::string_view(argv[1]) == "--figures") {
      std::fputs(etak::demo::figure_commands().c_str(), stdout);
      return 0;
    }
    write_start_page(argv[1]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "etak-start-page: %s\n", e.what());
    return 1;
  }
}
