// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/scene/gltf.h"
#include "tests/support.h"

/// What the tests of writing glTF share.
namespace etak::test {

inline bool has_validator() {
  static const bool has = std::system("node -e \"require('gltf-validator')\" >/dev/null 2>&1") == 0;
  if (!has) WARN("no node with gltf-validator (NODE_PATH): what is written is not validated");
  return has;
}

/// Messages of severity 0 (errors) that the Khronos validator has for a document; pictures and other files
/// are looked for in `folders`.
inline std::string validator_errors(const std::string& gltf, const std::vector<std::string>& folders) {
  const TempFolder temp;
  std::string list;
  for (const auto& folder : folders) list += "'" + folder + "',";
  spit(
      temp.file("check.js"),
      "const v=require('gltf-validator'),fs=require('fs'),path=require('path');const folders=[" + list + R"(];
v.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2])),{maxIssues:0,externalResourceFunction:uri=>new Promise((ok,no)=>{
for(const f of folders){const p=path.join(f,decodeURIComponent(uri));if(fs.existsSync(p))return ok(new Uint8Array(fs.readFileSync(p)));}
no('no file '+uri);})}).then(r=>{for(const m of r.issues.messages)if(m.severity===0)console.log(m.code+' '+m.message+' '+m.pointer);
console.log('checked');});)");
  const std::string out = temp.file("out");
  if (std::system(("node " + temp.file("check.js") + " " + gltf + " >" + out + " 2>&1").c_str()) != 0)
    return slurp(out);
  const std::string text = slurp(out);
  return text == "checked\n" ? "" : text;
}

/// Writes a scene and reads it again.
struct Written {
  TempFolder folder;
  nlohmann::json json;
  std::string buffer;
  GltfScene scene;
  Written(const GltfScene& from, const GltfOutput& output, const std::vector<std::string>& folders = {}) {
    const WrittenGltf written = write_gltf(from, output);
    const std::string& text = written.json;
    buffer = written.buffer;
    spit(folder.file("out.gltf"), text);
    if (!buffer.empty()) spit(folder.file("scene.bin"), buffer);
    // The smallest PNG there is: one grey pixel.
    const std::string png(
        "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55\0\0\0\nIDATx\x9c\x63\x60\0"
        "\0\0\2\0\1\x48\xaf\xa4\x71\0\0\0\0IEND\xae\x42\x60\x82",
        67);
    for (const auto& image : output.images) spit(folder.file(image), png);
    json = nlohmann::json::parse(text);
    scene = read_gltf(folder.file("out.gltf"), from.options);
    std::vector<std::string> all{folder.path()};
    all.insert(all.end(), folders.begin(), folders.end());
    if (has_validator()) CHECK(validator_errors(folder.file("out.gltf"), all) == "");
  }
};

}  // namespace etak::test
