// SPDX-License-Identifier: Apache-2.0
#include "core/atlas/variant.h"

#include <algorithm>

namespace etak {
namespace {

// In the order of a model's name.
constexpr std::array<std::string_view, 3> term_prefixes{"ETAK_LOBE_", "ETAK_FRESNEL_", "ETAK_MASKING_"};

std::string define_of(std::string_view prefix, std::string_view id) {
  std::string out(prefix);
  for (const char c : id) out += c == '-' ? '_' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return out;
}

}  // namespace

const MaterialVariant* ShadingVariants::find(std::string_view material) const {
  const auto found = std::ranges::lower_bound(materials, material, {}, &MaterialVariant::material);
  return found == materials.end() || found->material != material ? nullptr : &*found;
}

std::vector<std::string> shading_defines(std::string_view model, std::string_view filter) {
  std::vector<std::string> out;
  if (model.find(':') == std::string_view::npos)
    return {define_of("ETAK_MODEL_", model), define_of("ETAK_FILTER_", filter)};
  std::string_view rest = model.substr(model.find(':') + 1);
  for (const std::string_view prefix : term_prefixes) {
    const std::size_t comma = rest.find(',');
    out.push_back(define_of(prefix, rest.substr(0, comma)));
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
  }
  out.push_back(define_of("ETAK_FILTER_", filter));
  return out;
}

}  // namespace etak
