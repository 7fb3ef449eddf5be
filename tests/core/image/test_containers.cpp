// SPDX-License-Identifier: Apache-2.0
#include "core/image/files/containers.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "core/base/bytes/bytes_le.h"
#include "core/image/image_io.h"
#include "core/image/mips.h"
#include "tests/core/image/container_bytes.h"
#include "tests/core/image/mip_reference.h"
#include "tests/support.h"

namespace etak {
namespace {

using test::contains;
using test::dds_bytes;
using test::error_of;
using test::ktx2_bytes;

std::vector<Image8> chain(int width, int height) {
  const Image8 picture = test::noise_picture(width, height, 11);
  return mip_pair(picture, picture, {}).diffuse_alpha;
}

// The bytes with a 32-bit number written at `at`.
std::string with(std::string bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (8 * i) & 0xff);
  return bytes;
}

std::string output_of(const std::string& command) {
  std::string out;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) out.append(buffer, n);
  pclose(pipe);
  return out;
}

const std::pair<int, int> sizes[] = {{1, 1}, {16, 16}, {20, 12}, {3, 5}, {1, 9}, {64, 1}};

}  // namespace

TEST_CASE("KTX2 files come back as they were, with and without Zstandard") {
  for (const auto& [width, height] : sizes)
    for (const bool srgb : {true, false})
      for (const int zstd : {0, 1, 9}) {
        CAPTURE(width, height, srgb, zstd);
        const auto levels = chain(width, height);
        const std::string bytes = ktx2_bytes({levels, srgb}, zstd);
        const TextureFile back = read_ktx2(bytes, "x.ktx2");
        CHECK(back.levels == levels);
        CHECK(back.srgb == srgb);
        const std::vector<Image8> first(levels.begin(), levels.begin() + 1);
        CHECK(read_ktx2(ktx2_bytes({first, srgb}, zstd), "x.ktx2").levels == first);
      }
}

TEST_CASE("KTX2: the smallest level comes first in the file, each on a multiple of 4 bytes") {
  const auto levels = chain(20, 12);
  const std::string bytes = ktx2_bytes({levels, true}, 0);
  std::uint64_t end = bytes.size();
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const std::uint64_t offset = bytes_le::number64(bytes, 80 + 24 * l);
    CHECK(offset % 4 == 0);
    CHECK(offset + bytes_le::number64(bytes, 88 + 24 * l) == end);
    end = offset;
  }
}

TEST_CASE("ktx-parse reads the same from our KTX2 files") {
  if (std::getenv("NODE_PATH") == nullptr ||
      std::system("node -e \"require.resolve('ktx-parse')\" >/dev/null 2>&1") != 0) {
    WARN("node with ktx-parse (NODE_PATH) not found: not compared");
    return;
  }
  const test::TempFolder folder;
  const auto levels = chain(20, 12);
  for (const bool srgb : {true, false})
    for (const int zstd : {0, 3}) {
      CAPTURE(srgb, zstd);
      test::spit(folder.file("a.ktx2"), ktx2_bytes({levels, srgb}, zstd));
      const std::string found =
          output_of("node '" + test::source_folder() + "/tests/core/image/ktx2_by_ktx_parse.cjs' '" +
                    folder.file("a.ktx2") + "'");
      std::string expected = std::string("format ") + (srgb ? "43" : "37") +
                             "\ntypeSize 1\nsize 20 12 0\nlayers faces 0 1\nscheme " +
                             (zstd > 0 ? "2" : "0") + "\nblocks 1\nmodel primaries transfer flags 1 1 " +
                             (srgb ? "2" : "1") +
                             " 0\nversion vendor type 2 0 0\ntexel block 0 0 0 0\nplanes 4 0 0 0 0 0 0 0\n"
                             "sample 0 7 0 0 0 0 0 0 255\nsample 8 7 1 0 0 0 0 0 255\n"
                             "sample 16 7 2 0 0 0 0 0 255\nsample 24 7 " +
                             (srgb ? "31" : "15") + " 0 0 0 0 0 255\nKTXorientation rd\nKTXwriter etak\n";
      if (zstd == 0)
        for (const Image8& level : levels)
          expected += "level " + std::to_string(level.values.size()) + ' ' +
                      std::to_string(level.values.size()) + ' ' +
                      std::to_string(std::accumulate(level.values.begin(), level.values.end(), 0)) + '\n';
      CHECK(found.substr(0, expected.size()) == expected);
      if (zstd > 0) CHECK(contains(found, " 960 "));
    }
}

TEST_CASE("a KTX2 file that is not as it should be is refused by what is wrong") {
  const auto levels = chain(20, 12);
  const std::string good = ktx2_bytes({levels, true}, 0);
  const auto refused = [&](const std::string& bytes, std::string_view why) {
    const std::string error = error_of([&] { read_ktx2(bytes, "x.ktx2"); });
    CAPTURE(error, why);
    CHECK(contains(error, "x.ktx2"));
    CHECK(contains(error, why));
  };
  refused("", "identifier");
  refused("\x89PNG\r\n", "identifier");
  refused(with(good, 12, 44), "Vulkan format 44");
  refused(with(good, 12, 37), "descriptor");
  refused(with(good, 16, 4), "typeSize 4");
  refused(with(good, 20, 0), "side 0");
  refused(with(good, 24, 16385), "side 16385");
  refused(with(good, 20, 24), "uncompressed bytes");
  refused(with(good, 28, 1), "depth 1");
  refused(with(good, 32, 2), "layers 2");
  refused(with(good, 36, 6), "faces 6");
  refused(with(good, 40, 6), "levels 6");
  refused(with(good, 44, 1), "scheme 1");
  refused(with(good, 48, 0xffffffff), "descriptor");
  refused(with(good, 60, 0xffffff), "key/value");
  refused(with(good, 72, 8), "global data");
  refused(with(good, 80, 0), "level 0 at 0");
  refused(with(good, 84, 0xffffffff), "level 0 at");
  refused(with(good, 88, 959), "level 0");
  const std::size_t descriptor = bytes_le::number32(good, 48), pairs = bytes_le::number32(good, 56);
  std::string premultiplied = good;
  premultiplied[descriptor + 15] = 1;
  refused(premultiplied, "premultiplied");
  refused(with(good, pairs, 0xfffffff0), "break off");
  std::string upside_down = good;
  upside_down[good.find("rd", pairs) + 1] = 'u';
  refused(upside_down, "KTXorientation \"ru\"");
  for (std::size_t size = 0; size < good.size(); size += 7)
    CHECK(error_of([&] { read_ktx2(good.substr(0, size), "x.ktx2"); }) != "");
  const std::string packed = ktx2_bytes({levels, true}, 3);
  refused(with(packed, 96, 961), "uncompressed bytes 961");
  std::string damaged = packed;
  damaged[bytes_le::number64(packed, 80) + 1] ^= 0x55;
  refused(damaged, "Zstandard");
  // A few bytes cannot ask for a gigabyte.
  const std::vector<Image8> small{Image8(4, 4, 4)};
  std::string greedy = with(with(ktx2_bytes({small, true}, 3), 20, 16384), 24, 16384);
  refused(with(greedy, 96, 1u << 30), "compressed bytes");
}

TEST_CASE("KTX2 files of older writers are read: no key/values, bytesPlane 0 under Zstandard, levels 0") {
  const auto levels = chain(8, 8);
  const std::string plain = ktx2_bytes({levels, false}, 0);
  CHECK(read_ktx2(with(with(plain, 56, 0), 60, 0), "x").levels == levels);
  const std::vector<Image8> one{levels[0]};
  CHECK(read_ktx2(with(ktx2_bytes({one, false}, 0), 40, 0), "x").levels == one);
  const std::size_t descriptor = bytes_le::number32(plain, 48);
  CHECK(error_of([&] { read_ktx2(with(plain, descriptor + 20, 0), "x"); }) != "");
  CHECK(read_ktx2(with(ktx2_bytes({levels, false}, 1), descriptor + 20, 0), "x").levels == levels);
}

TEST_CASE("DDS files come back as they were, under both headers") {
  for (const auto& [width, height] : sizes) {
    const auto levels = chain(width, height);
    for (const bool srgb : {true, false})
      for (const bool custom : {true, false}) {
        const TextureFile back = read_dds(dds_bytes({levels, srgb}, custom), "x.dds");
        CHECK(back.levels == levels);
        CHECK(back.srgb == srgb);
        CHECK(back.custom_alpha == custom);
      }
    const TextureFile back = read_dds(dds_bytes({levels, false}, true, DdsHeader::legacy), "x.dds");
    CHECK(back.levels == levels);
    CHECK(!back.srgb);
    CHECK(contains(error_of([&] { dds_bytes({levels, true}, false, DdsHeader::legacy); }), "sRGB"));
  }
}

TEST_CASE("a DDS header holds what the guide names at the places it names") {
  const auto levels = chain(20, 12);
  const std::string bytes = dds_bytes({levels, true}, true);
  const auto u32 = [&](std::size_t at) { return bytes_le::number32(bytes, at); };
  CHECK(bytes.substr(0, 4) == "DDS ");
  CHECK(u32(4) == 124);
  CHECK(u32(8) == 0x2100f);
  CHECK(u32(12) == 12);
  CHECK(u32(16) == 20);
  CHECK(u32(20) == 80);
  CHECK(u32(28) == 5);
  CHECK(bytes.substr(84, 4) == "DX10");
  CHECK(u32(108) == 0x401008);
  CHECK(u32(128) == 29);
  CHECK(u32(132) == 3);
  CHECK(u32(140) == 1);
  CHECK(u32(144) == 4);
  CHECK(bytes.size() == 148 + 4 * (240 + 60 + 15 + 2 + 1));
}

TEST_CASE("a DDS file that is not as it should be is refused by what is wrong") {
  const auto levels = chain(20, 12);
  const std::string good = dds_bytes({levels, true}, false);
  const auto refused = [&](const std::string& bytes, std::string_view why) {
    const std::string error = error_of([&] { read_dds(bytes, "x.dds"); });
    CAPTURE(error, why);
    CHECK(contains(error, "x.dds"));
    CHECK(contains(error, why));
  };
  refused("", "signature");
  refused("DDS ", "header");
  refused(good.substr(0, 140), "DX10 header");
  refused(with(good, 4, 123), "header size 123");
  refused(with(good, 12, 0), "side 0");
  refused(with(good, 16, 65536), "side 65536");
  refused(with(good, 28, 6), "levels 6");
  refused(with(good, 28, 4), "texels");
  refused(with(good, 84, 0x32545844), "DXT2");
  refused(with(good, 112, 0x200), "caps2");
  refused(with(good, 128, 98), "texels");
  refused(with(good, 128, 97), "DXGI format 97");
  refused(with(good, 132, 4), "dimension 4");
  refused(with(good, 140, 2), "layers 2");
  refused(with(good, 144, 2), "alpha mode 2");
  refused(good + '\0', "texels");
  const std::string legacy = dds_bytes({levels, false}, false, DdsHeader::legacy);
  refused(with(legacy, 92, 0xff0000), "bit mask");
  refused(with(legacy, 88, 24), "pixel format");
  for (std::size_t size = 0; size < good.size(); size += 7)
    CHECK(error_of([&] { read_dds(good.substr(0, size), "x.dds"); }) != "");
}

TEST_CASE("OpenImageIO reads our DDS files with a legacy header") {
  const test::TempFolder folder;
  const auto levels = chain(20, 12);
  test::spit(folder.file("a.dds"), dds_bytes({levels, false}, true, DdsHeader::legacy));
  CHECK(std::get<Image8>(read_picture(folder.file("a.dds")).pixels) == levels[0]);
}

}  // namespace etak
