// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/bytes/bytes_le.h"
#include "core/base/files/cache_folder.h"
#include "core/base/hash/sha256.h"
#include "tests/core/base/cache_support.h"
#include "tests/support.h"

namespace etak {
namespace {

using test::cache_at;
using test::slurp;
using test::spit;
using test::TempFolder;
namespace fs = std::filesystem;

constexpr int many = 1200;  // enough for a bundle
constexpr std::size_t row_size = 80, trailer_size = 28;

std::string bundled_digest(int number) {
  return sha256("bundled " + std::to_string(number));
}

std::string text_for(int number) {
  return "result " + std::to_string(number) + std::string(static_cast<std::size_t>(number % 97), '.');
}

std::vector<std::string> bundles_of(const std::string& cache) {
  std::vector<std::string> out;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(cache + "/bundles", none))
    out.push_back(entry.path().string());
  return out;
}

void remove_single_files(const std::string& cache) {
  for (const auto& folder : fs::directory_iterator(cache))
    if (folder.is_directory() && folder.path().filename().string().size() == 2) fs::remove_all(folder.path());
}

void fill(const std::string& path, int from = 0, int to = many) {
  CacheFolder cache(cache_at(path));
  for (int i = from; i < to; ++i) cache.keep(bundled_digest(i), text_for(i));
}

// A run that looks all of them up.
CacheUse looked_up(CacheOptions options, int from = 0, int to = many) {
  CacheFolder cache(std::move(options));
  cache.expect(static_cast<std::size_t>(to - from));
  int wrong = 0;
  for (int i = from; i < to; ++i) {
    const auto entry = cache.find(bundled_digest(i));
    wrong += entry && entry->text != text_for(i);
  }
  CHECK(wrong == 0);
  return cache.use();
}

// Makes a cache with one bundle.
void fill_and_bundle(const std::string& path) {
  fill(path);
  looked_up(cache_at(path));
  REQUIRE(bundles_of(path).size() == 1);
}

}  // namespace

TEST_CASE("a thousand entries that were found are copied to a bundle, which holds what their files hold") {
  const TempFolder folder;
  fill(folder.path());
  CHECK(bundles_of(folder.path()).empty());
  const CacheUse first = looked_up(cache_at(folder.path()));
  CHECK(first.counts == CacheCounts{many, 0, 0, 0, 0, 0, 0});
  REQUIRE(bundles_of(folder.path()).size() == 1);
  CHECK(first.size->entries == many);
  CHECK(first.size->bytes ==
        many * 4096u + (fs::file_size(bundles_of(folder.path())[0]) + 4095) / 4096 * 4096);
  // The next run reads the bundle and makes no other one.
  CHECK(looked_up(cache_at(folder.path())).counts == CacheCounts{many, 0, 0, 0, 0, 0, 0});
  CHECK(bundles_of(folder.path()).size() == 1);
  remove_single_files(folder.path());
  CHECK(looked_up(cache_at(folder.path())).counts == CacheCounts{many, 0, 0, 0, 0, 0, 0});
  CHECK(bundles_of(folder.path()).size() == 1);
  CHECK(fs::is_empty(folder.file("new")));
}

TEST_CASE("few look-ups, and entries of another kind or key, take nothing from a bundle") {
  const TempFolder folder;
  fill_and_bundle(folder.path());
  remove_single_files(folder.path());
  CHECK(looked_up(cache_at(folder.path()), 0, 10).counts == CacheCounts{0, 10, 0, 0, 0, 0, 0});
  CacheOptions other = cache_at(folder.path());
  other.kind = "other";
  CHECK(looked_up(other).counts == CacheCounts{0, many, many, 0, 0, 0, 0});
  CacheOptions keyed = cache_at(folder.path());
  keyed.key = "a key of some bytes";
  CHECK(looked_up(keyed).counts == CacheCounts{0, many, many, 0, 0, 0, 0});
}

TEST_CASE("entries with a key are bundled as they are, and count with that key alone") {
  const TempFolder folder;
  CacheOptions keyed = cache_at(folder.path());
  keyed.key = "a key of some bytes";
  {
    CacheFolder cache(keyed);
    for (int i = 0; i < many; ++i) cache.keep(bundled_digest(i), text_for(i));
  }
  looked_up(keyed);
  remove_single_files(folder.path());
  CHECK(looked_up(keyed).counts.hits == many);
  CHECK(looked_up(cache_at(folder.path())).counts.hits == 0);
}

TEST_CASE("a bundle that is cut, changed or made by an enemy gives misses, and never a wrong result") {
  const TempFolder folder;
  fill_and_bundle(folder.path());
  const std::string path = bundles_of(folder.path())[0], whole = slurp(path);
  const std::size_t rows_at = whole.size() - trailer_size - many * row_size;
  remove_single_files(folder.path());
  const auto hits_of = [&](const std::string& bytes) {
    spit(path, bytes);
    const CacheCounts counts = looked_up(cache_at(folder.path())).counts;
    CHECK(counts.hits + counts.misses == many);
    return counts.hits;
  };
  const auto changed = [&](const std::function<void(std::string&)>& change) {
    std::string bytes = whole;
    change(bytes);
    return hits_of(bytes);
  };
  const auto put = [](std::string& bytes, std::size_t at, std::uint64_t value) {
    std::string number;
    bytes_le::append64(number, value);
    bytes.replace(at, number.size(), number);
  };
  CHECK(hits_of(whole) == many);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, trailer_size, rows_at / 2, rows_at,
                                 rows_at + 40, whole.size() - trailer_size, whole.size() - 1})
    CHECK(hits_of(whole.substr(0, size)) == 0);
  CHECK(hits_of(whole + '\n') == 0);
  CHECK(hits_of(std::string(100000, '\xff')) == 0);
  // Another form, and numbers of rows that the file does not have.
  CHECK(changed([&](std::string& b) { b[whole.size() - trailer_size + 18] = '2'; }) == 0);
  for (const std::uint64_t rows :
       {std::uint64_t{many} + 1000000, ~std::uint64_t{0}, ~std::uint64_t{0} / row_size})
    CHECK(changed([&](std::string& b) { put(b, b.size() - 8, rows); }) == 0);
  // An entry that leads beyond the end, into the index, to another entry, or to nothing.
  const auto of_row = [&](std::size_t row, std::size_t member) {
    return rows_at + row * row_size + 64 + 8 * member;
  };
  for (const std::uint64_t at : {std::uint64_t{rows_at}, std::uint64_t{whole.size()}, ~std::uint64_t{0},
                                 ~std::uint64_t{0} - 100, std::uint64_t{1}})
    CHECK(changed([&](std::string& b) { put(b, of_row(7, 0), at); }) == many - 1);
  for (const std::uint64_t size :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{16384}, std::uint64_t{16385}, ~std::uint64_t{0}})
    CHECK(changed([&](std::string& b) { put(b, of_row(7, 1), size); }) == many - 1);
  // All rows lead to the entry of the first: it is theirs by no seal.
  CHECK(changed([&](std::string& b) {
          for (std::size_t row = 1; row < many; ++row) b.replace(of_row(row, 0), 16, whole, of_row(0, 0), 16);
        }) == 1);
  // A byte of each entry is another one.
  CHECK(changed([&](std::string& b) {
          for (std::size_t at = 0; at < rows_at; at += 50) b[at] = static_cast<char>(b[at] ^ 4);
        }) == 0);
  // Rows out of order are not found, or found.
  CHECK(changed([&](std::string& b) {
          std::vector<std::string> rows;
          for (std::size_t row = 0; row < many; ++row)
            rows.push_back(whole.substr(rows_at + row * row_size, row_size));
          std::ranges::reverse(rows);
          std::string index;
          for (const std::string& row : rows) index += row;
          b.replace(rows_at, index.size(), index);
        }) < many);
}

TEST_CASE("where the copy in a bundle is damaged, the entry's own file is read") {
  const TempFolder folder;
  fill_and_bundle(folder.path());
  const std::string path = bundles_of(folder.path())[0];
  std::string bytes = slurp(path);
  std::fill_n(bytes.begin(), bytes.size() / 2, 'x');
  spit(path, bytes);
  CHECK(looked_up(cache_at(folder.path())).counts == CacheCounts{many, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("links, folders and pipes in the place of bundles are not followed") {
  const TempFolder folder, elsewhere;
  fill_and_bundle(elsewhere.path());
  const std::string bundle = bundles_of(elsewhere.path())[0], name = fs::path(bundle).filename().string();
  fs::create_directory(folder.file("bundles"));
  fs::create_symlink(bundle, folder.file("bundles/" + name));
  fs::create_directory(folder.file("bundles/0123456789abcdef.bundle"));
  CHECK(looked_up(cache_at(folder.path())).counts.hits == 0);
  fs::remove_all(folder.file("bundles"));
  fs::create_directory_symlink(elsewhere.file("bundles"), folder.file("bundles"));
  CHECK(looked_up(cache_at(folder.path())).counts.hits == 0);
}

TEST_CASE("two runs that make bundles at once lose nothing") {
  const TempFolder folder;
  fill(folder.path());
  std::vector<std::thread> runs;
  std::vector<CacheUse> uses(2);
  for (std::size_t i = 0; i < uses.size(); ++i)
    runs.emplace_back([&, i] {
      CacheFolder cache(cache_at(folder.path()));
      cache.expect(many);
      for (int n = 0; n < many; ++n) (void)cache.find(bundled_digest(n));
      for (int n = 0; n < 50; ++n) cache.keep(bundled_digest(many + n), text_for(many + n));
      uses[i] = cache.use();
    });
  for (std::thread& run : runs) run.join();
  for (const CacheUse& use : uses) CHECK(use.counts.hits == many);
  CHECK(!bundles_of(folder.path()).empty());
  CHECK(bundles_of(folder.path()).size() <= 2);
  CHECK(looked_up(cache_at(folder.path()), 0, many + 50).counts.hits == many + 50);
  remove_single_files(folder.path());
  CHECK(looked_up(cache_at(folder.path())).counts.hits == many);
}

TEST_CASE("what a run that was killed has left of a bundle is no bundle, and goes when it is old") {
  const TempFolder folder;
  fill_and_bundle(folder.path());
  const std::string whole = slurp(bundles_of(folder.path())[0]);
  fs::remove_all(folder.file("bundles"));
  const std::string left = folder.file("new/0123456789abcdef");
  spit(left, whole.substr(0, whole.size() / 2));
  fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(2));
  const CacheUse use = looked_up(cache_at(folder.path()));
  CHECK(use.counts.hits == many);
  CHECK(bundles_of(folder.path()).size() == 1);
  // Entries are counted anew where there is no account, and DIR/new is cleaned then.
  fs::remove(folder.file("account"));
  fill(folder.path(), many, many + 1);
  CHECK(!fs::exists(left));
}

TEST_CASE("a bundle counts in the size of a cache, goes by its use, and takes a quarter at most") {
  const TempFolder folder;
  fill_and_bundle(folder.path());
  const std::string bundle = bundles_of(folder.path())[0];
  const std::uint64_t bundle_bytes = (fs::file_size(bundle) + 4095) / 4096 * 4096;
  // Used longest ago, it is the first to go, and the entries stay.
  fs::last_write_time(bundle, fs::file_time_type::clock::now() - std::chrono::hours(50));
  const std::uint64_t all = many * 4096u + bundle_bytes;
  {
    CacheFolder cache(cache_at(folder.path(), all));
    cache.keep(bundled_digest(many), text_for(many));
  }
  CHECK(!fs::exists(bundle));
  const CacheUse after = looked_up(cache_at(folder.path()), 0, 10);
  CHECK(after.size->bytes <= all);
  CHECK(after.size->entries >= many * 8 / 10);
  // A cache that four bundles would fill has none.
  const TempFolder small;
  fill(small.path());
  looked_up(cache_at(small.path(), 3 * bundle_bytes));
  CHECK(bundles_of(small.path()).empty());
  CHECK(fs::is_empty(small.file("new")));
}

TEST_CASE("a bundle that is used stays, and the entries that only it is asked for go before it") {
  const TempFolder folder;
  fill_and_bundle(folder.path());
  const std::string bundle = bundles_of(folder.path())[0];
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    if (entry.is_regular_file())
      fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - std::chrono::hours(50));
  looked_up(cache_at(folder.path()));
  CHECK(fs::last_write_time(bundle) > fs::file_time_type::clock::now() - std::chrono::hours(1));
  {
    CacheFolder cache(cache_at(folder.path(), many * 4096u));
    cache.keep(bundled_digest(many), text_for(many));
  }
  CHECK(fs::exists(bundle));
  CHECK(looked_up(cache_at(folder.path())).counts.hits == many);
}

TEST_CASE("there are at most 32 bundles: the one used longest ago makes room") {
  const TempFolder folder;
  fill_and_bundle(folder.path());
  const std::string bundle = bundles_of(folder.path())[0];
  for (int i = 10; i < 42; ++i) {
    const std::string other = folder.file("bundles/00000000000000" + std::to_string(i) + ".bundle");
    spit(other, "not one");
    fs::last_write_time(other, fs::file_time_type::clock::now() - std::chrono::hours(i));
  }
  fs::remove(bundle);
  looked_up(cache_at(folder.path()));
  CHECK(bundles_of(folder.path()).size() == 32);
  CHECK(!fs::exists(folder.file("bundles/0000000000000041.bundle")));
  CHECK(fs::exists(folder.file("bundles/0000000000000040.bundle")));
}

TEST_CASE("a cache that cannot be written gives what it has, with a bundle and without one") {
  const TempFolder folder;
  fill(folder.path());
  // Nothing can be made in the place of DIR/new while a file is there.
  fs::remove_all(folder.file("new"));
  spit(folder.file("new"), "");
  const CacheUse use = looked_up(cache_at(folder.path()));
  CHECK(use.counts == CacheCounts{many, 0, 0, 0, 0, 0, 0});
  CHECK(use.fault.empty());
  CHECK(bundles_of(folder.path()).empty());
}

}  // namespace etak
