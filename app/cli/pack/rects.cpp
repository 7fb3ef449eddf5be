// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pack/rects.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "app/cli/options/options.h"
#include "app/cli/output/output.h"
#include "app/cli/output/replace.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/memory.h"
#include "core/base/number.h"
#include "core/rects/rects.h"
#include "core/rects/text.h"

namespace etak::cli {
namespace {

constexpr int exit_not_offered = 3;
constexpr int largest_side = largest_rect_side;

// The form and side that --mode names; none for a mode that is not offered. Throws Error for a bad side.
//   pad   texels between rectangles
std::optional<RectOptions> options_of(const std::string& mode, int pad) {
  RectOptions out;
  out.largest_side = largest_side + pad;
  const std::size_t colon = mode.find(':');
  const std::string name = mode.substr(0, colon);
  const bool with_side = name == "strip" || name == "pages" || name == "mixed";
  if (name == "square") {
    out.form = PageForm::square;
  } else if (name == "pot") {
    out.form = PageForm::power_of_two;
  } else if (name == "free") {
    out.form = PageForm::free;
  } else if (with_side) {
    out.form = name == "strip" ? PageForm::strip : name == "pages" ? PageForm::pages : PageForm::mixed;
  } else {
    return std::nullopt;
  }
  if (with_side != (colon != std::string::npos))
    throw Error::at("--mode", "'" + printable(mode) + "'", "square, pot, free, strip:W, pages:S or mixed:S");
  if (!with_side) return out;
  const std::optional<int> side = whole_number<int>(std::string_view(mode).substr(colon + 1));
  if (!side || *side < 1 || *side > largest_side)
    throw Error::at("--mode", "'" + printable(mode) + "'", "a side of 1 to " + std::to_string(largest_side));
  // Every rectangle has its padding on two sides; the page is larger by one padding, so that its far sides
  // have none. The sides of mixed pages must stay powers of two.
  out.side = *side + (out.form == PageForm::mixed ? 0 : pad);
  return out;
}

}  // namespace

void add_pack_rects_options(Command verb, PackRectsArguments& a) {
  const std::string group = "Bare rectangles";
  verb.flag(
          "--rects", a.asked,
          "pack the rectangles of --in (lines 'w h') and write 'page x y w h rot' lines to -o; --rotate then takes 0 or 1")
      .group(group);
  verb.option("--in", a.in, "file of rectangles").reads_file().value_name("FILE").group(group);
  verb.option("--mode", a.mode, "page: square, pot, free, strip:W, pages:S or mixed:S")
      .value_name("MODE")
      .show_default()
      .group(group);
  verb.option("--pad", a.pad, "between rectangles").range(0, 65536).group(group);

  const auto listen = [&](const char* name, const std::function<void(const std::string&)>& heard) {
    std::optional<Option> option = verb.find(name);
    if (option) option->each(heard);
    return option.has_value();
  };
  if (!listen("--out", [&a](const std::string& text) { a.out = text; }))
    verb.option("-o,--output,--out", a.out, "file to write").value_name("FILE").group(group);
  if (!listen("--effort",
              [&a](const std::string& text) { a.effort = whole_number<int>(text).value_or(a.effort); }))
    verb.option("--effort", a.effort, "tries").range(1, 1000000).show_default().group(group);
  const auto hear_threads = [&a](const std::string& text) {
    a.threads = static_cast<unsigned>(whole_number<int>(text).value_or(0));
  };
  listen("--jobs", hear_threads);
  if (!listen("--threads", hear_threads))
    verb.option("--threads", a.threads, "threads; 0: all cores").group(group);
  // Where --rotate of the verb is a flag, the parser takes the 0 or 1 behind it for the verb's input.
  if (!listen("--rotate", [&a](const std::string& text) { a.rotate = text; }))
    verb.option("--rotate", a.rotate, "0 or 1").group(group);
  listen("input", [&a](const std::string& text) { a.input = text; });
}

namespace {

// Packs the rectangles of the file and writes their places.
void place_rects(const PackRectsArguments& a, const RectOptions& options, std::vector<RectSize>& sizes) {
  sizes = parse_rects(read_file(a.in), a.in);
  for (RectSize& size : sizes) size = {size.width + a.pad, size.height + a.pad};
  const auto begin = std::chrono::steady_clock::now();
  const RectLayout layout = pack_rects(sizes, options);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;

  std::string text = "# pack_ms " + number(spent.count(), 6) + "\n";
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const RectPlace& place = layout.places[i];
    const int w = sizes[i].width - a.pad, h = sizes[i].height - a.pad;
    for (const int value : {place.page, place.x, place.y, place.rotated ? h : w, place.rotated ? w : h})
      text += std::to_string(value) + " ";
    text += place.rotated ? "1\n" : "0\n";
  }
  write_file(a.out, text, true);
}

}  // namespace

int pack_rects_command(const PackRectsArguments& a) {
  std::optional<RectOptions> options = options_of(a.mode, a.pad);
  if (!options) {
    complain("--mode: '" + printable(a.mode) + "'; expected square, pot, free, strip:W, pages:S or mixed:S");
    return exit_not_offered;
  }
  if (a.in.empty()) throw Error::at("--in", "is missing", "a file of rectangles");
  if (a.out.empty()) throw Error::at("-o", "is missing", "a file to write");
  refuse_input(a.out);
  const std::string& rotate = a.input.empty() ? a.rotate : a.input;
  if (rotate != "0" && rotate != "1" && rotate != "true" && rotate != "false")
    throw Error::at(a.input.empty() ? "--rotate" : printable(a.input),
                    a.input.empty() ? "'" + printable(rotate) + "'" : "is not looked for with --rects",
                    a.input.empty() ? "0 or 1" : "--in FILE, and 0 or 1 behind --rotate");
  options->rotate = rotate == "1" || rotate == "true";
  options->effort = a.effort;
  options->threads = thread_count(a.threads);

  std::vector<RectSize> sizes;
  with_memory_for(
      a.in, [&] { return sizes.empty() ? "its rectangles" : std::to_string(sizes.size()) + " rectangles"; },
      [&] { place_rects(a, *options, sizes); });
  return exit_ok;
}

}  // namespace etak::cli
