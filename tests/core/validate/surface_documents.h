// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/validate/find/kind.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

namespace etak::test {

inline const std::string open_pbr_model = "open_pbr_surface";

/// A MaterialX document of one surface.
///   inputs   "name=type:value" each
inline std::string material_x_of(const std::string& model, const std::vector<std::string>& inputs,
                                 const std::string& name = "thing", const std::string& space = "lin_rec709") {
  std::string out = "<?xml version=\"1.0\"?>\n<materialx version=\"1.39\" colorspace=\"" + space +
                    "\">\n  <" + model + " name=\"s\" type=\"surfaceshader\">\n";
  for (const std::string& each : inputs) {
    const std::size_t equals = each.find('='), colon = each.find(':', equals);
    out += "    <input name=\"" + each.substr(0, equals) + "\" type=\"" +
           each.substr(equals + 1, colon - equals - 1) + "\" value=\"" + each.substr(colon + 1) + "\" />\n";
  }
  return out + "  </" + model + ">\n  <surfacematerial name=\"" + name +
         "\" type=\"material\">\n    <input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"s\" />\n" +
         "  </surfacematerial>\n</materialx>\n";
}

/// A USD layer with one preview surface.
///   inputs   lines such as "float inputs:metallic = 1"
inline std::string usda_of(const std::vector<std::string>& inputs, const std::string& name = "thing") {
  std::string out = "#usda 1.0\n( upAxis = \"Y\" )\ndef Material \"" + name +
                    "\"\n{\n    token outputs:surface.connect = </" + name +
                    "/s.outputs:surface>\n    def Shader \"s\"\n    {\n"
                    "        uniform token info:id = \"UsdPreviewSurface\"\n";
  for (const std::string& each : inputs) out += "        " + each + '\n';
  return out + "        token outputs:surface\n    }\n}\n";
}

/// A glTF document of materials alone.
inline std::string gltf_of(const std::string& material) {
  return R"({"asset": {"version": "2.0"}, "materials": [{"name": "thing", )" + material + "}]}";
}

/// A table of exported values.
///   rows   "target,field,text,value1,value2,value3" each
inline std::string value_table_of(const std::vector<std::string>& rows, const std::string& name = "thing") {
  std::string out = "id,dataset,target,field,text,value1,value2,value3,changed_from,action,amount\n";
  for (const std::string& each : rows) out += name + ",own," + each + ",,,\n";
  return out;
}

/// What validate() finds in a document.
///   file   the name, whose ending tells the form
inline CheckedFile checked_document(const std::string& file, const std::string& text) {
  const TempFolder folder;
  spit(folder.file(file), text);
  const auto role = role_of_file(folder.file(file));
  CheckTarget target;
  target.label = file;
  if (role) target.files = {{*role, folder.file(file), file, false}};
  return checked(target);
}

/// A MaterialX document around some nodes.
inline std::string in_material_x(const std::string& inside) {
  return "<materialx version=\"1.39\">\n" + inside + "\n</materialx>\n";
}

/// Rules and messages of all findings, a line for each.
inline std::string remarks_on(const CheckedFile& file) {
  std::string out;
  for (const Finding& each : file.findings) out += each.rule + ": " + each.message + "\n";
  return out;
}

}  // namespace etak::test
