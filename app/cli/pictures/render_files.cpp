// SPDX-License-Identifier: Apache-2.0
// The files of etak render, and which of its options do not stand beside each other.
#include <utility>

#include "app/cli/output/replace.h"
#include "app/cli/pictures/render.h"
#include "core/base/error.h"
#include "core/base/files/output_target.h"
#include "core/base/text/text.h"
#include "core/render/view_moves.h"

namespace etak::cli {

std::vector<std::string> files_of(const RenderArguments& arguments) {
  if (arguments.turntable == 1) return {arguments.picture};
  std::vector<std::string> out;
  for (int i = 0; i < arguments.turntable; ++i)
    out.push_back(on_turntable(arguments.picture, i, arguments.turntable));
  return out;
}

void check_picture_name(const RenderArguments& arguments) {
  const std::string& path = arguments.picture;
  if (path.empty() && arguments.frames == 1)
    throw Error::at("etak render", "no picture to write", "-o FILE.png or -o FILE.exr");
  if (!path.empty() && !path.ends_with(".png") && !path.ends_with(".exr"))
    throw Error::at(printable(path, 200), "has no ending that etak writes",
                    ".png or .exr, of which other programs make what is wanted");
  if (!path.empty())
    for (const std::string& file : files_of(arguments)) {
      check_file_target(file, arguments.stats.force);
      refuse_input(file);
    }
  if (arguments.part != "all" && !arguments.sheet)
    throw Error::at("--part", "without --sheet", "--sheet, whose part it is");
  for (const auto& [option, given] :
       {std::pair("--sheet", arguments.sheet), std::pair("--sweep", !arguments.sweep.empty())})
    if (given && arguments.stats.format == "json")
      throw Error::at("--format", std::string("json with ") + option + ", which is no picture of one subject",
                      "text");
  for (const auto& [option, given] :
       {std::pair("--model", !arguments.scene.model.empty()),
        std::pair("--diffuse-model", !arguments.scene.diffuse_model.empty()),
        std::pair("--set", !arguments.scene.set.empty()), std::pair("--reference", arguments.reference),
        std::pair("--sheet", arguments.sheet)})
    if (given && !arguments.as.empty())
      throw Error::at("--as", std::string("beside ") + option + ", which chooses another model",
                      "one of them");
  if (!arguments.sweep.empty() && (arguments.sheet || arguments.frames > 1 || path.empty()))
    throw Error::at("--sweep", "is a picture of several objects",
                    "-o FILE, and neither --sheet nor --frames");
  if (arguments.reference && arguments.device == "gl")
    throw Error::at("--reference", "is not drawn with gl", "--device cpu");
  for (const auto& [option, given] :
       {std::pair("--sheet", arguments.sheet), std::pair("--sweep", !arguments.sweep.empty()),
        std::pair("--background", arguments.transparent && !arguments.scene.background.empty()),
        std::pair("--frames", arguments.frames > 1)})
    if (given && (arguments.transparent || arguments.turntable > 1))
      throw Error::at(arguments.transparent ? "--transparent" : "--turntable",
                      std::string("beside ") + option, "one of them");
  for (const auto& [option, given] :
       {std::pair("--reference", arguments.reference), std::pair("--device gl", arguments.device == "gl"),
        std::pair("--sheet", arguments.sheet), std::pair("--quad", arguments.scene.quad)})
    if (given && !arguments.mesh.empty())
      throw Error::at("--mesh", std::string("beside ") + option + ", which draws spheres and quads alone",
                      "one of them");
}

}  // namespace etak::cli
