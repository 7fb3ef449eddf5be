// SPDX-License-Identifier: Apache-2.0
#include "core/image/blocks/blocks.h"

#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "core/base/bytes/bytes_le.h"
#include "core/image/astc_codec.h"
#include "core/image/blocks/encode.h"
#include "core/image/files/containers.h"
#include "core/image/load.h"
#include "tests/core/image/block_files.h"
#include "tests/support.h"

namespace etak {
namespace {

using test::BlockTexture;
using test::contains;
using test::error_of;
using BlockTexel = std::array<std::uint8_t, 4>;

BlockTexels decoded(BlockCode code, std::vector<unsigned> bytes) {
  std::vector<std::uint8_t> block(bytes.begin(), bytes.end());
  return decode_block(code, block.data());
}

const BlockFormat& format_named(std::string_view name) {
  return *std::ranges::find(block_formats, name, &BlockFormat::name);
}

std::string descriptor_of(const BlockFormat& format, bool srgb) {
  const unsigned alpha = srgb ? 31 : 15;
  if (format.name == "BC1 without alpha") return test::block_descriptor(128, srgb, 8, {{0, 64, 0}});
  if (format.name == "BC1") return test::block_descriptor(128, srgb, 8, {{0, 64, 1}});
  if (format.name == "BC2") return test::block_descriptor(129, srgb, 16, {{0, 64, alpha}, {64, 64, 0}});
  if (format.name == "BC3") return test::block_descriptor(130, srgb, 16, {{0, 64, alpha}, {64, 64, 0}});
  if (format.name == "BC4") return test::block_descriptor(131, srgb, 8, {{0, 64, 0}});
  if (format.name == "BC5") return test::block_descriptor(132, srgb, 16, {{0, 64, 0}, {64, 64, 1}});
  // Floats, with the bits of 0 or -1 and 1 as range.
  if (format.name == "BC6H")
    return test::block_descriptor(133, false, 16, {{0, 128, 0x80}}, 0x0303, {0, 0x3f800000});
  if (format.name == "BC6H signed")
    return test::block_descriptor(133, false, 16, {{0, 128, 0xc0}}, 0x0303, {0xbf800000, 0x3f800000});
  if (format.name == "R8") return test::block_descriptor(1, srgb, 1, {{0, 8, 0}}, 0, {0, 255});
  return test::block_descriptor(134, srgb, 16, {{0, 128, 0}});
}

// Names of formats in DDS files of Direct3D 9.
using FourCc = std::pair<std::string_view, std::string_view>;
constexpr std::array four_ccs{FourCc{"DXT1", "BC1"}, FourCc{"DXT3", "BC2"}, FourCc{"DXT5", "BC3"},
                              FourCc{"ATI1", "BC4"}, FourCc{"BC4U", "BC4"}, FourCc{"ATI2", "BC5"},
                              FourCc{"BC5U", "BC5"}};

const std::pair<int, int> block_sizes[] = {{16, 16}, {20, 12}, {5, 3}, {1, 1}, {1, 9}, {7, 1}};

// What OpenImageIO's decoder makes of a DDS file.
template <class Value>
Pixels<Value> by_oiio(const std::string& path, OIIO::TypeDesc type) {
  const auto input = OIIO::ImageInput::open(path);
  INFO(OIIO::geterror());
  REQUIRE(input);
  const OIIO::ImageSpec& spec = input->spec();
  Pixels<Value> out(spec.width, spec.height, spec.nchannels);
  REQUIRE(input->read_image(0, 0, 0, spec.nchannels, type, out.values.data()));
  return out;
}

Image8 by_oiio(const std::string& path) {
  return by_oiio<std::uint8_t>(path, OIIO::TypeUInt8);
}

// A block of BC6H from its lowest bit on: {value, bits} each.
BlockHalves bc6h_of(const std::vector<std::pair<unsigned, unsigned>>& fields, bool with_sign) {
  std::array<std::uint8_t, 16> block{};
  std::size_t at = 0;
  for (const auto& [value, bits] : fields)
    for (unsigned i = 0; i < bits; ++i, ++at)
      block[at / 8] |= static_cast<std::uint8_t>((value >> i & 1) << at % 8);
  return decode_bc6h(block.data(), with_sign);
}

}  // namespace

TEST_CASE("a block of BC1 has four colours, or three and one without alpha, by the order of its two") {
  // 0xf800 is red and 0x001f blue; indices 0, 1, 2, 3 in the first row.
  const BlockTexels four = decoded(BlockCode::bc1, {0x00, 0xf8, 0x1f, 0x00, 0xe4, 0, 0, 0});
  CHECK(four[0] == BlockTexel{255, 0, 0, 255});
  CHECK(four[1] == BlockTexel{0, 0, 255, 255});
  CHECK(four[2] == BlockTexel{170, 0, 85, 255});
  CHECK(four[3] == BlockTexel{85, 0, 170, 255});
  CHECK(four[4] == BlockTexel{255, 0, 0, 255});
  const BlockTexels three = decoded(BlockCode::bc1, {0x1f, 0x00, 0x00, 0xf8, 0xe4, 0, 0, 0});
  CHECK(three[0] == BlockTexel{0, 0, 255, 255});
  CHECK(three[2] == BlockTexel{128, 0, 128, 255});
  CHECK(three[3] == BlockTexel{0, 0, 0, 0});
  // Equal colours: the mode of three. In BC3 the same eight bytes have four colours.
  CHECK(decoded(BlockCode::bc1, {0, 0xf8, 0, 0xf8, 0xff, 0, 0, 0})[0] == BlockTexel{0, 0, 0, 0});
  CHECK(decoded(BlockCode::bc3, {255, 0, 0, 0, 0, 0, 0, 0, 0x1f, 0, 0, 0xf8, 0xe4, 0, 0, 0})[3] ==
        BlockTexel{170, 0, 85, 255});
}

TEST_CASE("BC2 has sixteen alphas; a block of BC4 has eight values, or six with 0 and 255") {
  const BlockTexels bc2 =
      decoded(BlockCode::bc2, {0x10, 0xf2, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 0, 0, 0, 0, 0, 0});
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(bc2[i] == BlockTexel{255, 255, 255, std::array<std::uint8_t, 4>{0, 17, 34, 255}[i]});
  // Indices 0 to 7 in the first eight texels: 0xfac688 in three bytes.
  const BlockTexels eight = decoded(BlockCode::bc4, {210, 0, 0x88, 0xc6, 0xfa, 0, 0, 0});
  const BlockTexels six = decoded(BlockCode::bc4, {0, 200, 0x88, 0xc6, 0xfa, 0, 0, 0});
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(eight[i][0] == std::array{210, 0, 180, 150, 120, 90, 60, 30}[i]);
    CHECK(six[i][0] == std::array{0, 200, 40, 80, 120, 160, 0, 255}[i]);
  }
  const BlockTexels bc5 = decoded(BlockCode::bc5, {9, 9, 0, 0, 0, 0, 0, 0, 8, 7, 0, 0, 0, 0, 0, 0});
  CHECK(bc5[15] == BlockTexel{9, 8, 0, 255});
}

TEST_CASE("BC7: mode 6 by hand, and the reserved mode is 0 in all channels") {
  // Mode 6: bit 6 is set; each channel has two ends of 7 bits; both last bits are 1: all ends are 255.
  std::vector<unsigned> white(16, 0);
  for (std::size_t bit = 6; bit < 65; ++bit) white[bit / 8] |= 1u << bit % 8;
  CHECK(decoded(BlockCode::bc7, white)[7] == BlockTexel{255, 255, 255, 255});
  // Only the second end of alpha (bits 56 to 62) and its last bit (64) are not 0: texel 1 has index 8, 34 / 64 of it.
  // The other channels have that last bit alone: 1.
  std::vector<unsigned> ramp(16, 0);
  ramp[0] = 0x40;
  ramp[7] = 0x7f;
  ramp[8] = 1 | 8 << 4;
  CHECK(decoded(BlockCode::bc7, ramp)[0] == BlockTexel{0, 0, 0, 0});
  CHECK(decoded(BlockCode::bc7, ramp)[1] == BlockTexel{1, 1, 1, (255 * 34 + 32) / 64});
  CHECK(decoded(BlockCode::bc7, std::vector<unsigned>(16, 0))[3] == BlockTexel{0, 0, 0, 0});
  std::vector<unsigned> reserved(16, 0xff);
  reserved[0] = 0;
  for (const BlockTexel& texel : decoded(BlockCode::bc7, reserved)) CHECK(texel == BlockTexel{0, 0, 0, 0});
}

TEST_CASE("BC6H: modes of one line by hand, and the reserved modes are 0") {
  using Halves = std::array<std::uint16_t, 3>;
  // Mode 11, number 3: two ends of 10 bits a channel, then indices of 4 bits, the first of 3. All bits of an end are
  // the largest half float that is finite; texel 1 has index 15, texel 2 index 8: 34 / 64.
  const std::vector<std::pair<unsigned, unsigned>> ramp{{3, 5},     {0, 10}, {1023, 10}, {1, 10}, {1023, 10},
                                                        {1023, 10}, {0, 10}, {0, 3},     {15, 4}, {8, 4}};
  // 1 of 10 bits is (0x10000 + 0x8000) / 1024 = 96, and 96 * 31 / 64 = 46.
  CHECK(bc6h_of(ramp, false)[0] == Halves{0, 0x7bff, 46});
  CHECK(bc6h_of(ramp, false)[1] == Halves{0x7bff, 0x7bff, 0});
  CHECK(bc6h_of(ramp, false)[2] ==
        Halves{(0xffff * 34 + 32) / 64 * 31 / 64, 0x7bff, (96 * 30 + 32) / 64 * 31 / 64});
  // With a sign 1023 is -1: -(0x8000 + 0x4000) / 512 = -96, and 96 * 31 / 32 = 93.
  CHECK(bc6h_of(ramp, true)[0] == Halves{0, 0x8000 | 93, 93});
  // Mode 14, number 15: a difference of 4 bits, then bits 15 to 10 of the end, the highest first; 0x8000 is -0x8000.
  const std::vector<std::pair<unsigned, unsigned>> far{{15, 5}, {0, 10}, {0x3ff, 10}, {5, 10}, {0, 4},
                                                       {1, 6},  {15, 4}, {0x3f, 6},   {8, 4}};
  CHECK(bc6h_of(far, false)[0] == Halves{0x8000 * 31 / 64, 0x7bff, 5 * 31 / 64});
  CHECK(bc6h_of(far, true)[0] == Halves{0xfc00, 0x8000, 5 * 31 / 32});
  for (unsigned reserved = 19; reserved < 32; reserved += 4)
    for (const bool with_sign : {false, true})
      CHECK(bc6h_of({{reserved, 5}, {~0u, 32}, {~0u, 32}, {~0u, 32}, {~0u, 27}}, with_sign) == BlockHalves{});
}

TEST_CASE("OpenImageIO decodes 100,000 random blocks of BC6H to the same floats") {
  const test::TempFolder folder;
  for (const std::string_view name : {"BC6H", "BC6H signed"}) {
    CAPTURE(name);
    const BlockFormat& format = format_named(name);
    BlockTexture texture = test::random_blocks(format, 1268, 1264, 9);
    texture.levels.resize(1);
    test::spit(folder.file("a.dds"), test::dds_of(texture, "", format.dxgi));
    const Image theirs = by_oiio<float>(folder.file("a.dds"), OIIO::TypeFloat);
    const TextureFile ours = read_dds(test::slurp(folder.file("a.dds")), "a.dds");
    REQUIRE((ours.levels.empty() && ours.floats.size() == 1));
    CHECK(ours.floats[0] == theirs);
  }
}

TEST_CASE("OpenImageIO decodes 100,000 random blocks of each format alike") {
  const test::TempFolder folder;
  for (const BlockFormat& format : block_formats) {
    const auto* old = std::ranges::find(four_ccs, format.name, &FourCc::second);
    if (old == four_ccs.end() && format.name != "BC7") continue;
    CAPTURE(format.name);
    BlockTexture texture = test::random_blocks(format, 1268, 1264, 5);
    texture.levels.resize(1);
    test::spit(folder.file("a.dds"), old == four_ccs.end() ? test::dds_of(texture, "", format.dxgi)
                                                           : test::dds_of(texture, old->first, 0));
    const Image8 theirs = by_oiio(folder.file("a.dds"));
    const Image8 ours = read_dds(test::slurp(folder.file("a.dds")), "a.dds").levels[0];
    const auto compared = static_cast<std::size_t>(std::min(ours.channels, theirs.channels));
    CHECK(compared >= std::min(2u, static_cast<unsigned>(ours.channels)));
    int most = 0;
    for (std::size_t i = 0; i < ours.pixel_count(); ++i)
      for (std::size_t c = 0; c < compared; ++c)
        most = std::max(most, std::abs(ours.values[i * static_cast<std::size_t>(ours.channels) + c] -
                                       theirs.values[i * static_cast<std::size_t>(theirs.channels) + c]));
    CHECK(most <= (format.name == "BC7" ? 0 : 1));
  }
}

TEST_CASE("what the encoders make is written as KTX2 and DDS, and OpenImageIO decodes it alike") {
  constexpr int side = 128;
  std::vector<BlockSource> blocks(side * side / 16);
  unsigned state = 1;
  for (BlockSource& block : blocks)
    for (auto& texel : block.texels)
      for (std::size_t c = 0; c < 4; ++c) {
        state = state * 1664525u + 1013904223u;
        texel[c] = static_cast<std::uint8_t>(100 + 20 * c + (state >> 26));
      }
  const test::TempFolder folder;
  for (const std::string_view name : {"BC4", "BC5", "BC7"}) {
    CAPTURE(name);
    const BlockFormat& format = format_named(name);
    std::string bytes(texture_level_bytes(&format, side, side), '\0');
    encode_blocks(blocks, {format.code, {1, 1, 1, 1}, 3}, reinterpret_cast<std::uint8_t*>(bytes.data()));
    const std::vector<TextureLevel> levels{{side, side, bytes}};
    const bool srgb = format.vk_srgb != 0;
    std::string dds, ktx2;
    const auto into = [](std::string& to) {
      return FileSink{[&to](std::string_view more) { to += more; },
                      [&to](std::size_t at, std::string_view with) { to.replace(at, with.size(), with); }};
    };
    write_dds(levels, &format, false, false, into(dds));  // it reads no BC7 that is marked as sRGB
    for (const int zstd : {0, has_zstd() ? 5 : 0}) {
      ktx2.clear();
      write_ktx2(levels, &format, srgb, zstd, into(ktx2));
      CHECK(contains(ktx2, descriptor_of(format, srgb)));
      CHECK(read_ktx2(ktx2, "a.ktx2").levels[0] == level_of(bytes, &format, side, side));
    }
    test::spit(folder.file("a.dds"), dds);
    const Image8 theirs = by_oiio(folder.file("a.dds")), ours = read_dds(dds, "a.dds").levels[0];
    int most = 0;
    for (std::size_t i = 0; i < ours.pixel_count(); ++i)
      for (std::size_t c = 0; c < static_cast<std::size_t>(std::min(ours.channels, theirs.channels)); ++c)
        most = std::max(most, std::abs(ours.values[i * static_cast<std::size_t>(ours.channels) + c] -
                                       theirs.values[i * static_cast<std::size_t>(theirs.channels) + c]));
    CHECK(most <= (name == "BC7" ? 0 : 1));
  }
}

TEST_CASE("KTX2 and DDS files of every format in blocks are read with all levels, whatever their size") {
  for (const BlockFormat& format : block_formats)
    for (const auto& [width, height] : block_sizes) {
      if (format.code == BlockCode::astc) continue;  // it has no decoder of etak's own
      for (const bool srgb : {false, true}) {
        if (srgb && format.vk_srgb == 0) continue;
        CAPTURE(format.name, width, height, srgb);
        const BlockTexture texture = test::random_blocks(format, width, height, 7);
        const auto check = [&](const TextureFile& file) {
          CHECK(file.blocks->code == format.code);
          CHECK(file.srgb == srgb);
          for (std::size_t l = 0; l < file.floats.size(); ++l)
            CHECK(file.floats[l] == float_level_of(texture.levels[l], *file.blocks,
                                                   std::max(1, texture.width >> l),
                                                   std::max(1, texture.height >> l)));
          CHECK((holds_floats(file.blocks) ? file.levels.size() : file.floats.size()) == 0);
          REQUIRE(file.levels.size() + file.floats.size() == texture.levels.size());
          for (std::size_t l = 0; l < file.levels.size(); ++l) {
            const Image8& level = file.levels[l];
            CHECK(level.width == std::max(1, texture.width >> l));
            CHECK(level == level_of(texture.levels[l], file.blocks, level.width, level.height));
          }
        };
        const unsigned vk = srgb ? format.vk_srgb : format.vk;
        for (const bool zstd : {false, has_zstd()})
          check(read_ktx2(test::ktx2_of(texture, vk, descriptor_of(format, srgb), zstd), "x.ktx2"));
        if (format.dxgi == 0) continue;
        check(read_dds(test::dds_of(texture, "", srgb ? format.dxgi_srgb : format.dxgi), "x.dds"));
      }
    }
  for (const auto& [four_cc, name] : four_ccs) {
    CAPTURE(four_cc);
    const BlockTexture texture = test::random_blocks(format_named(name), 20, 12, 3);
    const TextureFile file = read_dds(test::dds_of(texture, four_cc, 0), "x.dds");
    CHECK(file.blocks == &format_named(name));
    CHECK(file.levels[0] == level_of(texture.levels[0], file.blocks, 20, 12));
    CHECK(!file.srgb);
  }
}

TEST_CASE("KTX2 files of ASTC are read with all levels by the door of the program, and refused without it") {
  const AstcDoor door = astc_door();
  for (const BlockFormat& format : block_formats) {
    if (format.code != BlockCode::astc) continue;
    for (const auto& [width, height] : block_sizes)
      for (const bool srgb : {false, true}) {
        CAPTURE(format.name, width, height, srgb);
        const BlockTexture texture = test::random_blocks(format, width, height, 7);
        const auto sides = static_cast<unsigned>((format.block_height - 1) << 8 | (format.block_width - 1));
        const std::string bytes =
            test::ktx2_of(texture, srgb ? format.vk_srgb : format.vk,
                          test::block_descriptor(162, srgb, 16, {{0, 128, 0}}, sides), false);
        const TextureFile file = read_ktx2(bytes, "x.ktx2", door);
        CHECK((file.blocks == &format && file.srgb == srgb));
        REQUIRE(file.levels.size() == texture.levels.size());
        for (std::size_t l = 0; l < file.levels.size(); ++l)
          CHECK(file.levels[l] == door.decode(texture.levels[l], {&format, srgb}, file.levels[l].width,
                                              file.levels[l].height, "x"));
        CHECK(contains(error_of([&] { (void)read_ktx2(bytes, "x.ktx2"); }), "x.ktx2: is in ASTC"));
      }
  }
}

TEST_CASE("ASTC: a block of one colour by its bits, and blocks depend on themselves alone") {
  // A void extent: bits 0 to 8 are 0x1fc, bits 10 and 11 are set, no extent is given, and four colours of 16 bits.
  std::string constant("\xfc\xfd\xff\xff\xff\xff\xff\xff", 8);
  for (const unsigned value : {0x8000u, 0x1234u, 0xffffu, 0x4000u}) bytes_le::append(constant, value, 2);
  const AstcDoor door = astc_door();
  const BlockFormat& format = format_named("ASTC 6x6");
  const Image8 flat = door.decode(constant, {&format, true}, 6, 6, "x");
  for (int i = 0; i < 36; ++i) {
    const auto texel = flat.at(i % 6, i / 6);
    CHECK(std::vector<int>(texel.begin(), texel.end()) == std::vector<int>{0x80, 0x12, 0xff, 0x40});
  }
  std::vector<AnyBlock> blocks(40);
  unsigned state = 1;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (auto& texel : blocks[b].texels)
      for (std::size_t c = 0; c < 4; ++c) {
        state = state * 1664525u + 1013904223u;
        texel[c] = static_cast<std::uint8_t>(90 + 30 * c + (state >> 27));
      }
    blocks[b].weights[3] = b % 3 == 0 ? 16.0f : 1.0f;
  }
  std::vector<std::uint8_t> together(16 * blocks.size()), alone(together.size());
  door.encode(blocks, {&format, true, 1}, together.data());
  for (std::size_t b = 0; b < blocks.size(); ++b)
    door.encode(std::span(blocks).subspan(b, 1), {&format, true, 1}, &alone[16 * b]);
  CHECK(together == alone);
}

TEST_CASE("a texel of a level stands where its block stands, and blocks at the edge are cut") {
  // Every block of BC4 has one value: its number.
  std::string blocks;
  for (int i = 0; i < 6; ++i) blocks += std::string(2, static_cast<char>(i + 1)) + std::string(6, '\0');
  const Image8 level = level_of(blocks, &format_named("BC4"), 9, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 9; ++x) CHECK(level.at(x, y)[0] == 3 * (y / 4) + x / 4 + 1);
}

TEST_CASE("textures in blocks that are cut, hostile or of another form are refused by what is wrong") {
  const BlockFormat& bc7 = format_named("BC7");
  const BlockTexture texture = test::random_blocks(bc7, 20, 12, 1);
  const std::string ktx2 = test::ktx2_of(texture, 146, descriptor_of(bc7, true), false),
                    dds = test::dds_of(texture, "", 99);
  const auto without_door = [](std::string_view bytes, std::string_view path) {
    return read_ktx2(bytes, path);
  };
  const auto refused = [](auto read, const std::string& bytes, std::string_view why) {
    const std::string error = error_of([&] { read(bytes, "x"); });
    CAPTURE(error, why);
    CHECK(contains(error, why));
    CHECK(error.find('\n') == error.npos);
  };
  const auto with = [](std::string bytes, std::size_t at, std::uint64_t value) {
    std::string word;
    bytes_le::append32(word, value);
    return bytes.replace(at, 4, word);
  };
  for (std::size_t size = 0; size < ktx2.size(); size += 5)
    refused(without_door, ktx2.substr(0, size), "x: ");
  for (std::size_t size = 0; size < dds.size(); size += 5) refused(read_dds, dds.substr(0, size), "x: ");
  refused(without_door, with(ktx2, 12, 142), "Vulkan format 142");  // BC5 with signs
  refused(without_door, with(ktx2, 12, 143), "BC6H's");             // under the descriptor of BC7
  refused(without_door, with(ktx2, 12, 145), "descriptor");  // linear by its format, sRGB by its descriptor
  refused(without_door, with(ktx2, 12, 138), "descriptor");  // BC3
  refused(without_door, with(ktx2, 20, 24), "uncompressed bytes");
  refused(without_door, with(ktx2, 20, 0xffffffff), "side");
  refused(without_door, with(ktx2, 80, bytes_le::number32(ktx2, 80) - 8), "multiple of 16");
  refused(read_dds, with(dds, 128, 84), "DXGI format 84");
  refused(read_dds, with(dds, 144, 2), "alpha mode 2");
  refused(read_dds, with(dds, 16, 24), "texels of bytes");
  refused(read_dds, with(dds, 28, 6), "levels 6");
  refused(read_dds, dds + '\0', "texels of bytes");
  const BlockTexture bc2 = test::random_blocks(format_named("BC2"), 8, 8, 1);
  refused(read_dds, test::dds_of(bc2, "DXT2", 0), "DXT2");  // premultiplied
  refused(read_dds, test::dds_of(bc2, "BC5S", 0), "BC5S");
}

TEST_CASE("a picture in blocks is opened as any other, tells its transfer and that it is lossy") {
  const BlockFormat& bc7 = format_named("BC7");
  const BlockTexture texture = test::random_blocks(bc7, 20, 12, 1);
  const Image8 wanted = level_of(texture.levels[0], &bc7, 20, 12);
  const test::TempFolder folder;
  test::spit(folder.file("a.ktx2"), test::ktx2_of(texture, 146, descriptor_of(bc7, true), false));
  test::spit(folder.file("a.dds"), test::dds_of(texture, "", 98));
  for (const bool ktx2 : {true, false}) {
    const Picture picture = load_picture(folder.file(ktx2 ? "a.ktx2" : "a.dds"), PictureDoor{});
    CHECK(std::get<Image8>(picture.pixels) == wanted);
    CHECK(picture.header.colour_space == (ktx2 ? "srgb" : ""));
    CHECK(picture.header.lossy);
  }
}

TEST_CASE("a picture in BC6H is opened as one of half floats in linear light") {
  const BlockFormat& bc6h = format_named("BC6H signed");
  const BlockTexture texture = test::random_blocks(bc6h, 20, 12, 1);
  const Image wanted = float_level_of(texture.levels[0], bc6h, 20, 12);
  const std::string ktx2 = test::ktx2_of(texture, 144, descriptor_of(bc6h, false), has_zstd());
  const std::string dds = test::dds_of(texture, "", 96);
  for (const std::string& bytes : {ktx2, dds}) {
    const Picture picture = load_picture(bytes, "x", PictureDoor{});
    CHECK(std::get<Image>(picture.pixels) == wanted);
    const PictureHeader& header = picture.header;
    CHECK((header.floating && header.lossy && header.bits == 16 && header.channels == 3));
    CHECK((header.blocks == "BC6H signed" && header.bits_per_texel == 8 && header.colour_space.empty()));
    for (std::size_t size = 4; size < bytes.size(); size += 7) {
      const std::string error =
          error_of([&] { (void)load_picture(std::string_view(bytes).substr(0, size), "x", PictureDoor{}); });
      CHECK((error.starts_with("x: ") && !contains(error, "\n")));
    }
  }
}

}  // namespace etak
