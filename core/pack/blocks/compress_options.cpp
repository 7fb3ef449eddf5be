// SPDX-License-Identifier: Apache-2.0
#include "core/pack/blocks/compress_options.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/setting.h"
#include "core/base/text/text.h"

namespace etak {

BlockBudget parse_block_budget(const std::string& text) {
  const auto fail = [&](std::string_view part) {
    throw Error::at(
        setting("block-error"), in_quotes(part),
        "a number above 0, or some of diffuse, f0, gloss and alpha, each once, as diffuse=1,gloss=10");
  };
  BlockBudget out;
  double factor = 1;
  if (parse_number(text, factor)) {
    if (factor <= 0) fail(text);
    return {factor * out.diffuse, factor * out.f0, factor * out.gloss, factor * out.alpha};
  }
  const std::pair<std::string_view, double*> parts[]{
      {"diffuse", &out.diffuse}, {"f0", &out.f0}, {"gloss", &out.gloss}, {"alpha", &out.alpha}};
  std::vector<std::string> seen;
  if (text.empty() || text.back() == ',') fail(text);
  for (const std::string& each : parts_of(text, ',')) {
    const std::size_t at = each.find('=');
    const std::string name = each.substr(0, at);
    const auto* const part = std::ranges::find(parts, name, &std::pair<std::string_view, double*>::first);
    if (at == each.npos || part == std::end(parts) || std::ranges::find(seen, name) != seen.end()) fail(each);
    if (!parse_number(std::string_view(each).substr(at + 1), *part->second) || *part->second <= 0) fail(each);
    seen.push_back(name);
  }
  return out;
}

CompressOptions compress_word(std::string_view word) {
  CompressOptions out;
  if (word == "none") return out;
  out.falls_back = word == "auto" || word == "astc";
  out.fits = word == "auto";
  std::string name = "BC7";
  if (word == "astc") name = "ASTC 4x4";
  if (word.starts_with("astc:")) name = "ASTC " + std::string(word.substr(5));
  out.format = block_format_named(name);
  return out;
}

}  // namespace etak
