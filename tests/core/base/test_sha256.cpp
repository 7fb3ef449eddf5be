// SPDX-License-Identifier: Apache-2.0
#include "core/base/hash/sha256.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/base/hash/sha256_blocks.h"
#include "tests/support.h"

using namespace etak;

TEST_CASE("SHA-256 gives the digests that FIPS 180-4's examples print") {
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("SHA-256 is the same however the bytes are cut into pieces") {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(i * 37 + i / 11);
  const std::string whole = sha256(bytes);
  for (std::size_t piece = 1; piece < 200; ++piece) {
    Sha256 hash;
    for (std::size_t at = 0; at < bytes.size(); at += piece)
      hash.add(std::string_view(bytes).substr(at, piece));
    REQUIRE(hash.finish() == whole);
  }
}

TEST_CASE("the processor's instructions for SHA-256 give what the plain loop gives") {
  if (!has_sha256_x86()) {
    WARN("this processor has no SHA instructions");
    return;
  }
  std::vector<std::uint8_t> bytes(64 * 9);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i + i / 3);
  for (std::size_t blocks = 0; blocks <= 9; ++blocks) {
    std::array<std::uint32_t, 8> plain{1, 2, 3, 4, 0x80000005, 6, 0xfffffff7, 8}, fast = plain;
    sha256_blocks_plain(plain, bytes.data(), blocks);
    sha256_blocks_x86(fast, bytes.data(), blocks);
    CHECK(fast == plain);
  }
}

TEST_CASE(
    "SHA-256 of a file is that of its bytes, of whatever size it is, and empty where it cannot be read") {
  const test::TempFolder folder;
  const std::string path = folder.file("a");
  // About the sizes of a block and of what is read at once.
  for (const std::size_t size : {0u, 1u, 64u, 4096u, 262143u, 262144u, 262145u, 700000u}) {
    std::string bytes(size, 'x');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 31 + size);
    test::spit(path, bytes);
    for (const SeenAsFile seen : {SeenAsFile::no, SeenAsFile::yes}) {
      sys::FileInfo info;
      CHECK(sha256_of_file(path, info, seen) == sha256(bytes));
      CHECK(info.size == size);
    }
    CHECK(sha256_of_file(path) == sha256(bytes));
  }
  CHECK(sha256_of_file(folder.file("absent")).empty());
}

TEST_CASE("HMAC-SHA-256 gives the digests that RFC 4231 prints") {
  CHECK(hmac_sha256(std::string(20, '\x0b'), "Hi There") ==
        "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
  CHECK(hmac_sha256("Jefe", "what do ya want for nothing?") ==
        "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
  CHECK(hmac_sha256(std::string(20, '\xaa'), std::string(50, '\xdd')) ==
        "773ea91e36800e46854db8ebd09181a72959098b3ef8c122d9635514ced565fe");
  std::string counted;
  for (char c = 1; c <= 25; ++c) counted += c;
  CHECK(hmac_sha256(counted, std::string(50, '\xcd')) ==
        "82558a389a443c0ea4cc819899f2083a85f0faa3e578f8077a2e3ff46729665b");
  // Keys longer than a block are hashed first.
  CHECK(hmac_sha256(std::string(131, '\xaa'), "Test Using Larger Than Block-Size Key - Hash Key First") ==
        "60e431591ee0b67f0d8a26aacbf5b77f8e0bc6213728c5140546040f0ee37f54");
  CHECK(
      hmac_sha256(
          std::string(131, '\xaa'),
          "This is a test using a larger than block-size key and a larger than block-size data. The key needs to be hashed before being used by the HMAC algorithm.") ==
      "9b09ffa71b942fcb27635fbcd5b0e944bfdc63644f0713938a7f51535c3a35e2");
}

TEST_CASE("digests are equal only when every digit is") {
  CHECK(same_digest("", ""));
  CHECK(same_digest("0123", "0123"));
  CHECK_FALSE(same_digest("0123", "0124"));
  CHECK_FALSE(same_digest("1123", "0123"));
  CHECK_FALSE(same_digest("0123", "01234"));
}
