// SPDX-License-Identifier: Apache-2.0
#include "tests/core/validate/repaired.h"

#include <filesystem>

#include "core/image/files/png.h"
#include "core/image/image_io.h"
#include "core/image/load.h"
#include "tests/core/validate/checked.h"
#include "tests/support.h"

namespace etak::test {

namespace fs = std::filesystem;

Image8 noisy_diffuse(Random& random) {
  Image8 out(set_edge, set_edge, 4, 255);
  for (int y = 0; y < set_edge; ++y)
    for (int x = 0; x < set_edge; ++x) {
      const int value = 90 + random.below(60);
      set_rgb(out.at(x, y), {value, value - 20, value - 40});
    }
  return out;
}

Planted doubled_patch(Random& random) {
  auto b = varied_f0<std::uint8_t>(random, 0.045, 0.004);
  Planted out;
  out.rule = "ETK101";
  out.repaired = "crate_spec.png";
  out.right = out.wrong = {{"crate_diff.png", noisy_diffuse(random)}, {"crate_spec.png", b}};
  const Patch square{10 + random.below(60), 10 + random.below(60), 24 + random.below(20)};
  each_texel(b, [&](auto texel, int x, int y) {
    for (std::size_t c = 0; c < 3 && square.holds(x, y); ++c) texel[c] = srgb_u8(texel[c] / 255.0);
  });
  out.wrong["crate_spec.png"] = b;
  return out;
}

RepairedFolder repair_folder(const std::string& from, const std::string& to, const std::string& material) {
  ValidationRequest request;
  request.inputs.paths = {from};
  request.inputs.manifest.material = material;
  request.config.root = from;
  request.run.door = picture_door();
  RepairedFolder out;
  ValidationRequest again = request;
  out.before = validate(std::move(request));
  OutputTree copies(to, true);
  RepairRequest how;
  how.door = picture_door();
  how.folder = to;
  out.report = repair_files(out.before, how, copies);
  copies.commit();
  again.inputs.paths = {to};
  again.config.root = to;
  out.after = validate(std::move(again));
  return out;
}

std::string file_of_codes(const PictureCodes& codes) {
  return std::visit([](const auto& image) { return png_bytes(PngRows(image), {}); }, codes);
}

void put_pictures(const std::string& folder, const NamedPictures& pictures) {
  fs::create_directories(folder);
  for (const auto& [file, codes] : pictures) spit(folder + "/" + file, file_of_codes(codes));
}

PictureCodes loaded_codes(const std::string& path) {
  Picture picture = load_picture(path, picture_door());
  if (auto* wide = std::get_if<Image16>(&picture.pixels)) return std::move(*wide);
  return std::get<Image8>(picture.pixels);
}

bool has_rule(const ValidationReport& report, const std::string& rule) {
  return std::ranges::any_of(report.files,
                             [&](const CheckedFile& file) { return find(file, rule) != nullptr; });
}

}  // namespace etak::test
