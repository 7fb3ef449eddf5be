// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "core/base/files/file.h"
#include "core/base/files/links.h"
#include "core/base/text/ascii.h"
#include "core/exchange/surfaces/document.h"

namespace etak {
std::vector<DocumentSurface> surfaces_of_document(const std::string& path, const std::string& label,
                                                  std::vector<std::string>* read) {
  const std::string text = read_file(path, most_document_bytes);
  const std::filesystem::path place(path);
  if (text.starts_with("#usda") || text.starts_with("PXR-USDC") ||
      lower_case(place.extension().string()).starts_with(".usd"))
    return surfaces_of_usda(text, label);
  if (is_value_table(text)) return surfaces_of_table(text, label);
  return surfaces_of_material_x(text, label, [&](const std::string& name) {
    const std::string file = path_beside(place.parent_path().string(), name);
    if (read != nullptr) read->push_back(file);
    return read_file(file, most_document_bytes);
  });
}

}  // namespace etak
