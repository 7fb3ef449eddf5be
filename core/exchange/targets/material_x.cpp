// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/targets/material_x.h"

#include <algorithm>

#include "core/base/text/text.h"
#include "core/exchange/material_x.h"
#include "core/exchange/targets/target.h"

namespace etak {

std::string material_x_body(const ExportSurface& s, const EngineValues& values) {
  std::string category(values.target);
  std::ranges::replace(category, '-', '_');
  const std::string name = identifier(s.node_name());
  std::string out = material_x_comment(s.title());
  for (const Change& change : values.changes) out += material_x_comment(one_line(change));
  append(out, "  <", category, " name=\"", name, "_surface\" type=\"surfaceshader\" nodedef=\"ND_", category,
         "_surfaceshader\">\n");
  for (const EngineField& field : values.fields) {
    const bool color = field.values.size() == 3;
    append(out, "    <input name=\"", field.name, "\" type=\"", color ? "color3" : "float", "\" value=\"",
           field.text, color ? "\" colorspace=\"lin_rec709\" />\n" : "\" />\n");
  }
  append(out, "  </", category, ">\n  <surfacematerial name=\"", name,
         "\" type=\"material\">\n    <input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"", name,
         "_surface\" />\n  </surfacematerial>\n");
  return out;
}

}  // namespace etak
