// SPDX-License-Identifier: Apache-2.0
#include "core/runs/cache_folder.h"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "core/base/error.h"
#include "core/base/hash/sha256.h"
#include "tests/core/runs/cache_support.h"
#include "tests/support.h"

namespace etak {
namespace {

using test::cache_at;
using test::TempFolder;
namespace fs = std::filesystem;

std::string digest_of(int number) {
  return sha256("entry " + std::to_string(number));
}

std::string path_of(const std::string& folder, const std::string& digest) {
  return folder + '/' + digest.substr(0, 2) + '/' + digest.substr(2) + ".entry";
}

std::string text_of(CacheFolder& cache, const std::string& digest) {
  const auto entry = cache.find(digest);
  return entry ? entry->text : "none";
}

constexpr const char* tag =
    "Signature: 8a477f597d28d172789f06886806bc55\n"
    "# etak-cache\n";

std::string fault_of(const std::string& folder) {
  return test::error_of([&] { CacheFolder cache(cache_at(folder)); });
}

// Bytes that this program has read from files so far; none where the system does not count them.
std::optional<std::uint64_t> bytes_read() {
  std::ifstream counts("/proc/self/io");
  counts.ignore(std::numeric_limits<std::streamsize>::max(), ' ');
  std::uint64_t out = 0;
  return counts >> out ? std::optional(out) : std::nullopt;
}

void set_age(const std::string& path, std::chrono::hours age) {
  fs::last_write_time(path, fs::file_time_type::clock::now() - age);
}

}  // namespace

TEST_CASE("an entry of a cache comes back, also in another run, and not under another kind or key") {
  const TempFolder folder;
  const std::string digest = digest_of(1);
  {
    CacheFolder cache(cache_at(folder.path()));
    CHECK(text_of(cache, digest) == "none");
    cache.keep(digest, "what was found");
    CHECK(text_of(cache, digest) == "what was found");
    CHECK(cache.use().counts == CacheCounts{1, 1, 0, 1, 0, 0, 0});
  }
  CacheFolder again(cache_at(folder.path()));
  CHECK(text_of(again, digest) == "what was found");
  CHECK(again.use().size->entries == 1);
  CHECK(again.use().size->bytes == 4096);
  CacheOptions other = cache_at(folder.path());
  other.kind = "other";
  CacheFolder of_other_kind(other);
  CHECK(text_of(of_other_kind, digest) == "none");
  CHECK(of_other_kind.use().counts.refused == 1);
  other = cache_at(folder.path());
  other.key = "sixteen bytes ok";
  CacheFolder with_key(other);
  CHECK(text_of(with_key, digest) == "none");
  with_key.keep(digest, "sealed");
  CHECK(text_of(with_key, digest) == "sealed");
  CHECK(text_of(again, digest) == "none");
}

TEST_CASE("an entry of a cache that is cut, changed or longer anywhere is refused") {
  const TempFolder folder;
  const std::string digest = digest_of(2), path = path_of(folder.path(), digest);
  CacheFolder cache(cache_at(folder.path()));
  cache.keep(digest, "twelve bytes");
  const std::string good = test::slurp(path);
  for (std::size_t i = 0; i < good.size(); ++i) {
    test::spit(path, good.substr(0, i));
    CHECK(text_of(cache, digest) == "none");
    std::string changed = good;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    test::spit(path, changed);
    CHECK(text_of(cache, digest) == "none");
  }
  test::spit(path, good + 'x');
  CHECK(text_of(cache, digest) == "none");
  test::spit(path, "etak-cache/1 test 0 999999999999999999 0\n");
  CHECK(text_of(cache, digest) == "none");
  const CacheCounts counts = cache.use().counts;
  CHECK(counts.refused == counts.misses);
  test::spit(path, good);
  CHECK(text_of(cache, digest) == "twelve bytes");
}

TEST_CASE("an entry of a cache with a rest is kept where all of it came") {
  const TempFolder folder;
  CacheFolder cache(cache_at(folder.path()));
  {
    auto whole = cache.begin(digest_of(3), "head", 6);
    REQUIRE(whole);
    whole->add("abc");
    whole->add("def");
    whole->keep();
    auto part = cache.begin(digest_of(4), "head", 6);
    REQUIRE(part);
    part->add("abc");
    part->keep();
    auto given_up = cache.begin(digest_of(5), "head", 6);
    REQUIRE(given_up);
    given_up->add("abcdef");
  }
  const auto entry = cache.find(digest_of(3));
  REQUIRE(entry);
  CHECK(entry->text == "head");
  std::string rest(static_cast<std::size_t>(entry->rest_size), '\0');
  CHECK(sys::read_at(entry->file.get(), rest.data(), rest.size(), entry->rest_at) == 6);
  CHECK(rest == "abcdef");
  CHECK(!cache.find(digest_of(4)));
  CHECK(!cache.find(digest_of(5)));
  CHECK(fs::is_empty(folder.file("new")));
}

TEST_CASE("a cache stays within its size, and what was used longest ago goes first") {
  const TempFolder folder;
  constexpr std::uint64_t most = 40 * 4096;
  {
    CacheFolder cache(cache_at(folder.path(), most));
    for (int i = 0; i < 30; ++i) cache.keep(digest_of(i), "small");
    CHECK(cache.use().counts.evicted == 0);
  }
  for (int i = 0; i < 30; ++i) set_age(path_of(folder.path(), digest_of(i)), std::chrono::hours(100 - i));
  CacheFolder cache(cache_at(folder.path(), most));
  CHECK(text_of(cache, digest_of(0)) == "small");  // used: it is the youngest of the old ones now
  for (int i = 30; i < 45; ++i) cache.keep(digest_of(i), "small");
  const CacheUse use = cache.use();
  CHECK(use.size->bytes <= most);
  CHECK(use.size->entries + use.counts.evicted == 45);
  CHECK(use.size->entries >= 30);
  CHECK(text_of(cache, digest_of(0)) == "small");
  CHECK(text_of(cache, digest_of(1)) == "none");
  CHECK(text_of(cache, digest_of(2)) == "none");
  for (int i = 30; i < 45; ++i) CHECK(text_of(cache, digest_of(i)) == "small");
}

TEST_CASE("an entry that would take more than a quarter of a cache is not kept, and told") {
  const TempFolder folder;
  CacheFolder cache(cache_at(folder.path(), 16 * 4096));
  cache.keep(digest_of(1), std::string(5 * 4096, 'x'));
  CHECK(!cache.begin(digest_of(2), "text", 4 * 4096));
  cache.keep(digest_of(3), std::string(3 * 4096, 'x'));
  CHECK(cache.use().counts.too_large == 2);
  CHECK(cache.use().counts.written == 1);
}

TEST_CASE("wrong clocks neither empty a cache nor keep an entry in it for ever") {
  const TempFolder folder;
  constexpr std::uint64_t most = 40 * 4096;
  {
    CacheFolder cache(cache_at(folder.path(), most));
    for (int i = 0; i < 38; ++i) cache.keep(digest_of(i), "small");
  }
  const int years = 24 * 365;
  for (int i = 0; i < 38; ++i)
    set_age(path_of(folder.path(), digest_of(i)), std::chrono::hours(i % 2 == 0 ? -70 * years : 50 * years));
  const auto in_future = [&] {
    int out = 0;
    for (int i = 0; i < 38; ++i) {
      std::error_code gone;
      const auto time = fs::last_write_time(path_of(folder.path(), digest_of(i)), gone);
      out += !gone && time > fs::file_time_type::clock::now() + std::chrono::hours(2);
    }
    return out;
  };
  CHECK(in_future() == 19);
  CacheFolder cache(cache_at(folder.path(), most));
  for (int i = 38; i < 42; ++i) cache.keep(digest_of(i), "small");
  const CacheUse use = cache.use();
  CHECK(use.size->entries >= 30);
  CHECK(use.size->bytes <= most);
  // From now on they age as others do.
  CHECK(in_future() == 0);
  // The old ones went first.
  for (int i = 0; i < 38; i += 2) CHECK(text_of(cache, digest_of(i)) == "small");
  CHECK(text_of(cache, digest_of(41)) == "small");
}

TEST_CASE(
    "what a killed run has left in a cache goes when it is old, and nothing that is no entry ever does") {
  const TempFolder folder;
  constexpr std::uint64_t most = 8 * 4096;
  { CacheFolder(cache_at(folder.path(), most)).keep(digest_of(1), "small"); }
  const std::string old = folder.file("new/00000000000000aa"), young = folder.file("new/00000000000000bb");
  test::spit(old, "half");
  test::spit(young, "half");
  set_age(old, std::chrono::hours(2));
  const std::vector<std::string> others{"new/mine.psd", "new/00000000000000aab", "new/00000000000000AA",
                                        "new/00000000000000a"};
  for (const std::string& name : others) {
    test::spit(folder.file(name), "somebody's");
    set_age(folder.file(name), std::chrono::hours(2));
  }
  test::spit(folder.file("notes.txt"), "somebody's");
  test::spit(fs::path(path_of(folder.path(), digest_of(1))).parent_path().string() + "/notes.txt", "too");
  // Without an account all entries are counted.
  fs::remove(folder.file("account"));
  CacheFolder cache(cache_at(folder.path(), most));
  for (int i = 2; i < 20; ++i) cache.keep(digest_of(i), "small");
  CHECK(cache.use().size->bytes <= most);
  CHECK(!fs::exists(old));
  CHECK(fs::exists(young));
  for (const std::string& name : others) CHECK(test::slurp(folder.file(name)) == "somebody's");
  CHECK(test::slurp(folder.file("notes.txt")) == "somebody's");
  CHECK(fs::exists(fs::path(path_of(folder.path(), digest_of(1))).parent_path() / "notes.txt"));
}

TEST_CASE("an account of a cache that says anything does no harm") {
  for (const char* said : {"", "no account", "etak-cache/1 0 0\n", "etak-cache/1 999999999999999999 1\n",
                           "etak-cache/1 -5 1\n", "etak-cache/1 99999999999999999999999999 1\n"}) {
    const TempFolder folder;
    CacheFolder cache(cache_at(folder.path()));
    test::spit(folder.file("account"), said);
    for (int i = 0; i < 10; ++i) cache.keep(digest_of(i), "small");
    CHECK(cache.use().size->entries == 10);
    CHECK(cache.use().counts.evicted == 0);
  }
}

TEST_CASE("an account of a cache is replaced where a cache has written it, and left as it is otherwise") {
  const auto account_after = [](const std::string& said) {
    const TempFolder folder;
    CacheFolder cache(cache_at(folder.path()));
    test::spit(folder.file("account"), said);
    cache.keep(digest_of(1), "small");
    CHECK(cache.use().size->entries == 1);
    return test::slurp(folder.file("account"));
  };
  CHECK(account_after("etak-cache/1 8192 3\n") == "etak-cache/1 12288 4\n");
  CHECK(account_after("etak-cache/7 many\n") == "etak-cache/1 4096 1\n");
  // What a power cut leaves of one.
  CHECK(account_after("") == "etak-cache/1 4096 1\n");
  CHECK(account_after(std::string(21, '\0')) == "etak-cache/1 4096 1\n");
  for (const std::string& foreign :
       {std::string("mine\n"), std::string("etak-cach"), std::string(5000, 'x'), std::string(1, '\n')})
    CHECK(account_after(foreign) == foreign);
}

TEST_CASE("a folder is a cache's where it is new, empty or marked; any other one is refused as it is") {
  const TempFolder folder;
  { CacheFolder cache(cache_at(folder.file("made"))); }
  CHECK(test::slurp(folder.file("made/CACHEDIR.TAG")).starts_with(tag));
  fs::create_directory(folder.file("empty"));
  CHECK(fault_of(folder.file("empty")).empty());
  CHECK(test::slurp(folder.file("empty/CACHEDIR.TAG")).starts_with(tag));
  // Beside the tag anything may lie.
  test::spit(folder.file("made/notes.txt"), "kept");
  CHECK(fault_of(folder.file("made")).empty());

  const std::string entry = "ab/" + std::string(62, '0') + ".entry";
  const std::vector<std::string> names{
      "mine.txt", "new/mine.psd", "account",    "CACHEDIR.TAG", "new/0123456789abcdeg",
      "ab/mine",  entry + "x",    "AB" + entry, "cd/" + entry,  "secret"};
  for (const std::string& name : names) {
    INFO(name);
    const TempFolder foreign;
    fs::create_directories(fs::path(foreign.file(name)).parent_path());
    test::spit(foreign.file(name), "mine");
    set_age(foreign.file(name), std::chrono::hours(2));
    CHECK(test::contains(fault_of(foreign.path()), "is no cache of etak: it holds \""));
    CHECK(test::slurp(foreign.file(name)) == "mine");
    CHECK(std::distance(fs::directory_iterator(foreign.path()), {}) == 1);
  }
  // The tag of another program's cache does not make the folder etak's.
  const TempFolder other;
  test::spit(other.file("CACHEDIR.TAG"),
             "Signature: 8a477f597d28d172789f06886806bc55\n# of another program\n");
  CHECK(test::contains(fault_of(other.path()), "holds \"CACHEDIR.TAG\""));
}

TEST_CASE("a cache from before there was a tag is marked and goes on, and its entries go when it is full") {
  const TempFolder folder;
  constexpr std::uint64_t most = 20 * 4096;
  {
    CacheFolder cache(cache_at(folder.path(), most));
    for (int i = 0; i < 15; ++i) cache.keep(digest_of(i), "small");
  }
  for (const char* later : {"CACHEDIR.TAG", "account"}) fs::remove(folder.file(later));
  test::spit(folder.file("new/0123456789abcdef"), "half");
  const std::string older = folder.file(digest_of(1).substr(0, 2) + '/' + std::string(62, 'a') + ".json");
  test::spit(older, "of an early version");
  set_age(older, std::chrono::hours(3));
  CacheFolder cache(cache_at(folder.path(), most));
  CHECK(test::slurp(folder.file("CACHEDIR.TAG")).starts_with(tag));
  CHECK(text_of(cache, digest_of(7)) == "small");
  CHECK(cache.use().size->bytes == 16 * 4096);
  for (int i = 15; i < 20; ++i) cache.keep(digest_of(i), "small");
  CHECK(cache.use().size->bytes <= most);
  CHECK(!fs::exists(older));
}

TEST_CASE("the secret of a cache is drawn once, tells files apart, and is made again where it was lost") {
  const TempFolder folder;
  const std::string path = folder.file("secret"), a = folder.file("a"), b = folder.file("b");
  const TempFolder other;
  { const CacheFolder cache(cache_at(folder.path())), another(cache_at(other.path())); }
  const std::string drawn = test::slurp(path);
  CHECK(drawn.size() == 256);
  CHECK(drawn != test::slurp(other.file("secret")));
  test::spit(a, "one");
  test::spit(b, "two");
  const auto hash = [](const std::string& at, const std::string& file, const std::string& key = "") {
    CacheOptions options = cache_at(at);
    options.key = key;
    sys::FileInfo info;
    return CacheFolder(options).hash_of(file, info);
  };
  CHECK(hash(folder.path(), a) == hash(folder.path(), a));
  CHECK(hash(folder.path(), a) != hash(folder.path(), b));
  CHECK(hash(folder.path(), a) != hash(other.path(), a));
  CHECK(hash(folder.path(), a).size() == 32);
  CHECK(hash(folder.path(), a, "sixteen bytes or more") == sha256("one"));
  CHECK(test::slurp(path) == drawn);
  sys::FileInfo info;
  std::string promised;
  (void)CacheFolder(cache_at(folder.path())).hash_of(a, info, SeenAsFile::no, &promised);
  CHECK(promised == sha256("one"));
  // What a power cut leaves is replaced; a file of somebody else stays, and the keys are SHA-256 then.
  for (const std::string& lost : {std::string(), std::string(256, '\0')}) {
    test::spit(path, lost);
    CHECK(hash(folder.path(), a).size() == 32);
    CHECK(test::slurp(path) != drawn);
  }
  test::spit(path, "mine");
  CHECK(hash(folder.path(), a) == sha256("one"));
  CHECK(test::slurp(path) == "mine");
}

TEST_CASE("many programs that begin with a new cache at once all mark it and lose nothing") {
  const TempFolder folder;
  std::atomic<int> wrong{0};
  std::vector<std::thread> programs;
  for (int p = 0; p < 8; ++p)
    programs.emplace_back([&, p] {
      for (int i = 0; i < 20; ++i) {
        const std::string path = folder.file("cache" + std::to_string(i)), digest = digest_of(p);
        try {
          CacheFolder cache(cache_at(path));
          cache.keep(digest, "small");
          if (text_of(cache, digest) != "small") ++wrong;
        } catch (const Error&) {
          ++wrong;
        }
      }
    });
  for (std::thread& program : programs) program.join();
  CHECK(wrong == 0);
  for (int i = 0; i < 20; ++i) {
    CacheFolder cache(cache_at(folder.file("cache" + std::to_string(i))));
    CHECK(cache.use().size->entries == 8);
  }
}

TEST_CASE("an entry of a cache that tells a size which none has is refused without being read") {
  const TempFolder folder;
  const std::string digest = digest_of(1), path = path_of(folder.path(), digest);
  CacheFolder cache(cache_at(folder.path()));
  cache.keep(digest, "small");
  constexpr std::uint64_t zeros = std::uint64_t{256} << 20;
  const std::string head = "etak-cache/1 test " + std::string(64, '0') + ' ' + std::to_string(zeros) + " 0\n";
  for (const std::string& begin : {head, std::string("\0", 1)}) {
    test::spit(path, begin);
    fs::resize_file(path, begin.size() + zeros);
    const auto before = bytes_read();
    CHECK(text_of(cache, digest) == "none");
    if (const auto after = bytes_read()) CHECK(*after - *before < 100000);
  }
  CHECK(cache.use().counts.refused == 2);
}

TEST_CASE("links in a cache are not followed") {
  const TempFolder folder, elsewhere;
  const std::string digest = digest_of(1), path = path_of(folder.path(), digest);
  { CacheFolder(cache_at(folder.path())).keep(digest, "small"); }
  fs::rename(path, elsewhere.file("entry"));
  fs::create_symlink(elsewhere.file("entry"), path);
  fs::remove_all(folder.file("new"));
  fs::create_directory_symlink(elsewhere.path(), folder.file("new"));
  CacheFolder cache(cache_at(folder.path()));
  CHECK(text_of(cache, digest) == "none");
  cache.keep(digest_of(2), "small");
  CHECK(text_of(cache, digest_of(2)) == "none");
  CHECK(cache.use().counts.not_written == 1);
  CHECK(std::distance(fs::directory_iterator(elsewhere.path()), {}) == 1);
}

TEST_CASE("a cache whose path is a file is an error, and threads share one") {
  const TempFolder folder;
  test::spit(folder.file("file"), "no folder");
  CHECK(test::contains(test::error_of([&] { CacheFolder cache(cache_at(folder.file("file"))); }),
                       "is no folder"));
  // The bound makes every thread evict while the others read and write.
  CacheFolder cache(cache_at(folder.file("cache"), 30 * 4096));
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 200; ++i) {
        const int number = (i * 7 + t * 13) % 60;
        const auto entry = cache.find(digest_of(number));
        if (entry && entry->text != "text " + std::to_string(number)) ++wrong;
        if (!entry) cache.keep(digest_of(number), "text " + std::to_string(number));
      }
    });
  for (std::thread& thread : threads) thread.join();
  const CacheUse use = cache.use();
  CHECK(wrong == 0);
  CHECK(use.counts.hits + use.counts.misses == 800);
  CHECK(use.counts.refused == 0);
  CHECK(use.counts.not_written == 0);
  CHECK(use.size->bytes <= 30 * 4096);
  CHECK(use.fault.empty());
  CHECK(fs::is_empty(folder.file("cache/new")));
}

}  // namespace etak
