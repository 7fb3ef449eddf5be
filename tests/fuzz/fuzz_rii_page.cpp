// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: the page reader answers with an Error or with a page that keeps its promises,
// and what is imported from it can be written as a material and read again.
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "core/base/error.h"
#include "core/exchange/rii/rii_page.h"
#include "core/material/dispersion.h"
#include "core/material/json.h"

using namespace etak;

namespace {

void check(const RiiPage& page) {
  if (page.constants().k) {
    validate(*page.constants().k, "k");
    for (const double k : page.constants().k->value) assert(k >= 0);
  }
  if (const auto* formula = std::get_if<DispersionFormula>(&page.constants().n)) {
    validate(*formula, "formula");
    const std::array<double, 3> at{360, 555, 830};
    std::array<double, 3> n{};
    evaluate(*formula, at, n);
  } else if (page.refusal.empty()) {
    validate(std::get<Spectrum>(page.constants().n), "n");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // A copy of just this size: the address sanitizer then sees every read beyond the end.
  const std::vector<char> bytes(data, data + size);
  const std::string_view text(bytes.data(), bytes.size());
  static RiiPage page;  // reused, as callers do
  bool is_page = false;
  try {
    parse_rii_page(text, "page", page);
    is_page = page.kind == PageKind::constants;
  } catch (const Error&) {
  }
  if (is_page) check(page);
  try {
    const Material material = material_from_rii_page(text, "main/X - x/nk/Author-o.yml", "");
    assert(is_page && parse_material(format_material(material), "written") == material);
  } catch (const Error&) {
  }
  return 0;
}
