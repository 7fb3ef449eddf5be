// SPDX-License-Identifier: Apache-2.0
#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "core/color/colorspace.h"
#include "core/color/ocio.h"
#include "core/color/srgb.h"
#include "core/spectrum/integration.h"
#include "tests/core/color/whites.h"
#include "tests/support.h"

using namespace etak;
using namespace etak::test;

namespace {

const std::string own_config = source_folder() + "/resources/ocio/config.ocio";

// $OCIO for the time of a test.
class OcioVariable {
 public:
  explicit OcioVariable(const std::string& value) {
    const char* now = std::getenv("OCIO");
    if (now != nullptr) before_ = now;
    ::setenv("OCIO", value.c_str(), 1);
  }
  ~OcioVariable() { before_ ? ::setenv("OCIO", before_->c_str(), 1) : ::unsetenv("OCIO"); }
  OcioVariable(const OcioVariable&) = delete;
  OcioVariable& operator=(const OcioVariable&) = delete;

 private:
  std::optional<std::string> before_;
};

Vec3 through(const OcioSpace& space, const Vec3& xyz, const Xyz& white) {
  return vec(space.from_xyz(to_xyz(xyz), white));
}

void near_vector(const Vec3& got, const Vec3& want, double margin) {
  for (std::size_t c = 0; c < 3; ++c) {
    INFO("channel " << c);
    CHECK(got[c] == Approx(want[c]).margin(margin));
  }
}

const std::vector<std::pair<std::string, Mat3>> linear_spaces{
    {"ACES2065-1", rgb_to_xyz({{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}}}, test::aces_white)},
    {"ACEScg", rgb_to_xyz(primaries(RgbSpace::acescg), test::aces_white)},
    {"Linear Rec.709 (sRGB)", rgb_to_xyz(primaries(RgbSpace::srgb), test::d65)},
    {"Linear Rec.2020", rgb_to_xyz(primaries(RgbSpace::rec2020), test::d65)},
    {"Linear Display P3", rgb_to_xyz(primaries(RgbSpace::display_p3), test::d65)}};

const std::vector<Vec3> colours{
    {0.5, 0.4, 0.3}, {0.2, 0.3, 0.9}, {0.95, 1, 1.08}, {0.01, 0.02, 0.03}, {0.7, 0.72, 0.3}};

// A config with the given roles and one scene space of its own.
std::string small_config(const std::string& roles) {
  return "ocio_profile_version: 2\n\nstrictparsing: true\nroles:\n" + roles +
         "\nfile_rules:\n  - !<Rule> {name: Default, colorspace: Own}\n"
         "\ndisplays:\n  Monitor:\n    - !<View> {name: Raw, colorspace: Own}\n"
         "\ncolorspaces:\n  - !<ColorSpace>\n    name: Own\n    isdata: false\n"
         "\n  - !<ColorSpace>\n    name: Half\n    isdata: false\n"
         "    from_scene_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}\n"
         "\n  - !<ColorSpace>\n    name: Mask\n    isdata: true\n";
}

}  // namespace

TEST_CASE("a flat spectrum is grey within 1e-6 in every linear RGB space of the default config") {
  for (const auto& [name, matrix] : linear_spaces) {
    const OcioSpace space = OcioConfig::open(own_config).space(name);
    for (const auto observer : {Observer::cie1931_2deg, Observer::cie1964_10deg})
      for (const auto illuminant : {Illuminant::d65, Illuminant::d50, Illuminant::a, Illuminant::e})
        for (const Method method : {Method::nm1, Method::nm20, Method::exact}) {
          INFO(name << " " << etak::name(observer) << " " << etak::name(illuminant));
          const Quadrature q = make_quadrature(method, {observer, illuminant});
          const Xyz white = to_xyz(q.white());
          for (const double r : {1.0, 0.5, 0.04}) {
            const Vec3 xyz = q.integrate(std::vector<double>(q.wavelength_nm.size(), r));
            near_vector(through(space, xyz, white), {r, r, r}, 1e-6);
          }
        }
  }
}

TEST_CASE(
    "ACEScg through OpenColorIO is etak's own ACEScg, and linear sRGB differs only by the white's last digits") {
  // etak takes sRGB's white as the discrete sum of D65, the config as x 0.3127, y 0.3290.
  const Quadrature q = make_quadrature(Method::nm1, {});
  const Xyz white = to_xyz(q.white());
  for (const auto& [space, name, margin] : {std::tuple{RgbSpace::acescg, "ACEScg", 1e-6},
                                            std::tuple{RgbSpace::srgb, "Linear Rec.709 (sRGB)", 1e-4},
                                            std::tuple{RgbSpace::rec2020, "Linear Rec.2020", 1e-4}}) {
    const OcioSpace door = OcioConfig::open(own_config).space(name);
    for (const Vec3& xyz : colours)
      near_vector(through(door, xyz, white), xyz_to_rgb(space, white, white) * xyz, margin);
  }
}

TEST_CASE("the default config's matrices are the ones that follow from primaries and whites") {
  for (const auto& [name, matrix] : linear_spaces) {
    INFO(name);
    const OcioSpace space = OcioConfig::open(own_config).space(name);
    const bool aces = name.starts_with("ACES");
    const Mat3 want = inverse(matrix) * (aces ? bradford(test::d65, test::aces_white) : identity3);
    for (const Vec3& xyz : colours) near_vector(through(space, xyz, test::d65), want * xyz, 1e-6);
  }
  for (const auto* name : {"CIE XYZ D65", "CIE XYZ D65 - Display"})
    for (const Vec3& xyz : colours)
      near_vector(through(OcioConfig::open(own_config).space(name), xyz, test::d65), xyz, 1e-6);
}

TEST_CASE("encoded spaces and displays of the default config carry their curves") {
  const Mat3 srgb = inverse(rgb_to_xyz(primaries(RgbSpace::srgb), test::d65));
  const Mat3 p3 = inverse(rgb_to_xyz(primaries(RgbSpace::display_p3), test::d65));
  const Vec3 xyz{0.4, 0.42, 0.3};
  const auto encoded = [](Vec3 v) {
    for (double& x : v) x = srgb_encode(x);
    return v;
  };
  // OpenColorIO derives the toe from gamma and offset; it ends 2e-5 away from the standard's rounded
  // constants.
  near_vector(through(OcioConfig::open(own_config).space("sRGB - Texture"), xyz, test::d65),
              encoded(srgb * xyz), 2e-5);
  near_vector(through(OcioConfig::open(own_config).space("sRGB - Display"), xyz, test::d65),
              encoded(srgb * xyz), 2e-5);
  near_vector(through(OcioConfig::open(own_config).space("Display P3 - Display"), xyz, test::d65),
              encoded(p3 * xyz), 2e-5);
  Vec3 power = srgb * xyz;
  for (double& x : power) x = std::pow(x, 1 / 2.4);
  near_vector(through(OcioConfig::open(own_config).space("Rec.1886 Rec.709 - Display"), xyz, test::d65),
              power, 2e-6);
}

TEST_CASE("colours outside the gamut pass unclipped through linear spaces") {
  const Mat3 srgb = rgb_to_xyz(primaries(RgbSpace::srgb), test::d65);
  const Vec3 gold{1.022, 0.782, -0.344};
  near_vector(through(OcioConfig::open(own_config).space("lin_srgb"), srgb * gold, test::d65), gold, 2e-6);
}

TEST_CASE("spaces are found by name, alias and role") {
  CHECK(OcioConfig::open(own_config).space("ACEScg").name() == "ACEScg");
  CHECK(OcioConfig::open(own_config).space("lin_rec2020").name() == "Linear Rec.2020");
  CHECK(OcioConfig::open(own_config).space("scene_linear").name() == "Linear Rec.709 (sRGB)");
  CHECK(OcioConfig::open(own_config).name() == own_config);
}

TEST_CASE("no config named and no $OCIO gives the built-in config, which is the one in resources") {
  const OcioVariable unset("");
  CHECK(OcioConfig::open("").name() == builtin_ocio_config);
  CHECK(OcioConfig::open("").space("ACEScg").name() == OcioConfig::open(own_config).space("ACEScg").name());
}

TEST_CASE("$OCIO names the config, and an argument wins over it") {
  const TempFolder folder;
  spit(folder.file("small.ocio"), small_config("  aces_interchange: Own\n"));
  const OcioVariable set(folder.file("small.ocio"));
  CHECK(OcioConfig::open("").name() == folder.file("small.ocio"));
  CHECK(OcioConfig::open(own_config).name() == own_config);
}

TEST_CASE(
    "scene spaces are entered through ACES, display spaces through XYZ, so that no view transform lies between") {
  CHECK(OcioConfig::open(own_config).space("ACEScg").role() == "aces_interchange");
  CHECK(OcioConfig::open(own_config).space("sRGB - Texture").role() == "aces_interchange");
  CHECK(OcioConfig::open(own_config).space("sRGB - Display").role() == "cie_xyz_d65_interchange");
}

TEST_CASE("either interchange role is a way in") {
  const TempFolder folder;
  spit(folder.file("aces.ocio"), small_config("  aces_interchange: Own\n"));
  const OcioSpace aces = OcioConfig::open(folder.file("aces.ocio")).space("Half");
  CHECK(aces.role() == "aces_interchange");
  near_vector(through(aces, vec(test::d65), test::d65), {0.5, 0.5, 0.5}, 1e-6);
  spit(folder.file("cie.ocio"), small_config("  cie_xyz_d65_interchange: Own\n"));
  const OcioSpace cie = OcioConfig::open(folder.file("cie.ocio")).space("Half");
  CHECK(cie.role() == "cie_xyz_d65_interchange");
  near_vector(through(cie, vec(test::d65), test::d65), {0.5 * test::d65.x, 0.5, 0.5 * test::d65.z}, 1e-6);
  near_vector(through(cie, {1, 1, 1}, {1, 1, 1}), {0.5 * test::d65.x, 0.5, 0.5 * test::d65.z}, 1e-6);
}

TEST_CASE("errors of a config name it, the space and what is missing") {
  const TempFolder folder;
  const auto opening = [&](const std::string& config, const std::string& space) {
    const std::string message = error_of([&] { OcioConfig::open(config).space(space); });
    CHECK(!contains(message, "\n"));
    return message;
  };
  SECTION("no interchange role") {
    spit(folder.file("a.ocio"), small_config("  scene_linear: Own\n"));
    const auto message = opening(folder.file("a.ocio"), "Half");
    CHECK(contains(message, folder.file("a.ocio")));
    CHECK(contains(message, "aces_interchange"));
    CHECK(contains(message, "cie_xyz_d65_interchange"));
  }
  SECTION("no such space: the nearest are named") {
    const auto message = opening(own_config, "lin_rec2002");
    CHECK(contains(message, own_config));
    CHECK(contains(message, "lin_rec2002"));
    CHECK(contains(message, "Linear Rec.2020"));
    CHECK(!opening(own_config, "").empty());
  }
  SECTION("a space that holds data") {
    CHECK(contains(opening(own_config, "Raw"), "data"));
  }
  SECTION("no such file, a folder, no config") {
    CHECK(contains(opening(folder.file("absent.ocio"), "ACEScg"), folder.file("absent.ocio")));
    CHECK(contains(opening(folder.path(), "ACEScg"), folder.path()));
    spit(folder.file("noise.ocio"),
         "\x7f"
         "ELF, no config: [");
    CHECK(contains(opening(folder.file("noise.ocio"), "ACEScg"), folder.file("noise.ocio")));
    spit(folder.file("empty.ocio"), "");
    CHECK(contains(opening(folder.file("empty.ocio"), "ACEScg"), folder.file("empty.ocio")));
  }
  SECTION("a table that is missing") {
    spit(folder.file("lut.ocio"), small_config("  aces_interchange: Own\n") +
                                      "\n  - !<ColorSpace>\n    name: Lut\n    isdata: false\n"
                                      "    from_scene_reference: !<FileTransform> {src: absent.spi1d}\n");
    const auto message = opening(folder.file("lut.ocio"), "Lut");
    CHECK(contains(message, folder.file("lut.ocio")));
    CHECK(contains(message, "Lut"));
  }
}

TEST_CASE("values of a space become the linear sRGB that OpenColorIO itself makes of them") {
  const auto config = OCIO_NAMESPACE::Config::CreateFromFile(own_config.c_str());
  for (const char* name : {"ACEScg", "ACES2065-1", "Linear Rec.2020", "Linear Display P3", "sRGB - Texture",
                           "Linear Rec.709 (sRGB)", "CIE XYZ D65"}) {
    INFO(name);
    const OcioSource source = OcioConfig::open(own_config).source(name);
    const auto theirs = config->getProcessor(name, "Linear Rec.709 (sRGB)")
                            ->getOptimizedCPUProcessor(OCIO_NAMESPACE::OPTIMIZATION_LOSSLESS);
    std::vector<float> many;
    for (const Vec3& each : colours)
      for (const double v : each) many.push_back(static_cast<float>(v));
    std::vector<float> expected = many;
    source.to_linear_srgb(many.data(), colours.size());
    for (std::size_t i = 0; i < colours.size(); ++i) theirs->applyRGB(expected.data() + 3 * i);
    for (std::size_t i = 0; i < many.size(); ++i)
      CHECK(double{many[i]} == Approx(double{expected[i]}).margin(1e-5));
  }
}

TEST_CASE("a display's values become the linear sRGB that it shows") {
  for (int code = 0; code < 256; ++code) {
    const auto v = static_cast<float>(code / 255.0);
    for (const char* name : {"sRGB - Texture", "sRGB - Display"}) {
      float rgb[3] = {v, 0.25f, 1};
      OcioConfig::open(own_config).source(name).to_linear_srgb(rgb, 1);
      CHECK(double{rgb[0]} == Approx(srgb_decode(double{v})).margin(2e-5));
      CHECK(srgb_u8(std::clamp(double{rgb[0]}, 0.0, 1.0)) == code);
      CHECK(double{rgb[2]} == Approx(1).margin(2e-5));
    }
  }
  CHECK(contains(error_of([] { OcioConfig::open(own_config).source("ACEScgg"); }), "\"ACEScg\""));
  CHECK(contains(error_of([] { OcioConfig::open(own_config).source("Raw"); }), "data"));
}
