// SPDX-License-Identifier: Apache-2.0
#include "core/base/text/ascii.h"
#include "core/exchange/surfaces/document.h"

namespace etak {
namespace {

bool ends_with(std::string_view path, std::string_view ending) {
  return path.size() > ending.size() && lower_case(path.substr(path.size() - ending.size())) == ending;
}

}  // namespace

std::vector<DocumentSurface> surfaces_of_document(std::string_view text, const std::string& file) {
  const bool usd = text.starts_with("#usda") || text.starts_with("PXR-USDC") || ends_with(file, ".usda") ||
                   ends_with(file, ".usd") || ends_with(file, ".usdc") || ends_with(file, ".usdz");
  if (usd) return surfaces_of_usda(text, file);
  return is_value_table(text) ? surfaces_of_table(text, file) : surfaces_of_material_x(text, file);
}

}  // namespace etak
