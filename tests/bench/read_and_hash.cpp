// SPDX-License-Identifier: Apache-2.0
// read_and_hash FOLDER [THREADS]: lists the folder, reads every file below it and makes its SHA-256, and nothing else: what
// a warm cache can not do without. Prints the seconds of listing and of reading, and the number of files. cache_warm.sh
// compares etak with it.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/hash/sha256.h"
#include "core/base/parallel.h"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "read_and_hash FOLDER [THREADS]\n");
    return 2;
  }
  const auto threads = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 2);
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
  };
  const auto start = Clock::now();
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[1]))
    if (entry.is_regular_file()) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  const double listed = seconds(start);
  std::vector<std::string> hashes(files.size());
  etak::parallel_chunks(files.size(), threads, 16, [&](std::size_t begin, std::size_t end, unsigned) {
    std::array<char, 65536> bytes;
    for (std::size_t i = begin; i < end; ++i) {
      const int file = ::open(files[i].c_str(), O_RDONLY | O_CLOEXEC);
      etak::Sha256 hash;
      for (ssize_t count = 0; file >= 0 && (count = ::read(file, bytes.data(), bytes.size())) > 0;)
        hash.add({bytes.data(), static_cast<std::size_t>(count)});
      if (file >= 0) ::close(file);
      hashes[i] = hash.finish();
    }
  });
  std::printf("list %.3f read and hash %.3f all %.3f s, %zu files\n", listed, seconds(start) - listed,
              seconds(start), files.size());
  return 0;
}
