// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace etak::test {

/// The errors and warnings that the Khronos validator has for glTF files that need no other files, one a
/// line; none where there is no node with gltf-validator (NODE_PATH).
///   folder   for the files of this function
inline std::optional<std::string> gltf_messages(const std::string& folder,
                                                const std::vector<std::string>& files) {
  static const bool has = std::system("node -e \"require('gltf-validator')\" >/dev/null 2>&1") == 0;
  if (!has) return std::nullopt;
  const std::string script = folder + "/check.js", out = folder + "/checked.txt";
  std::ofstream(script) << R"(const v=require('gltf-validator'),fs=require('fs');(async()=>{
for(const f of process.argv.slice(2)){const r=await v.validateBytes(new Uint8Array(fs.readFileSync(f)),{maxIssues:0});
for(const m of r.issues.messages)if(m.severity<2)console.log(f+' '+m.code+' '+m.message+' '+m.pointer);}
console.log('checked '+(process.argv.length-2));})())";
  std::string command = "node '" + script + "'";
  for (const std::string& file : files) command += " '" + file + "'";
  const int status = std::system((command + " >'" + out + "' 2>&1").c_str());
  std::ostringstream text;
  text << std::ifstream(out).rdbuf();
  return status == 0 && text.str() == "checked " + std::to_string(files.size()) + "\n" ? "" : text.str();
}

}  // namespace etak::test
