// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/output/output.h"
#include "app/cli/program.h"
#include "core/base/files/input.h"
#include "core/base/files/links.h"
#include "core/base/system.h"
#include "core/base/system/memory_tree.h"
#include "core/base/text/text.h"

// The door to the program `etak` for JavaScript (etak.mjs): a run is a row of calls.
//   etak_begin()       forgets the run before
//   etak_file(), etak_input(), etak_words()   where the host writes a file, standard input, and the words of the line
//   etak_run()         runs the program; returns its exit status
//   etak_part()        what came of it: standard output, standard error, and for each file written its path and bytes
// All texts are UTF-8.

namespace {

std::string words;
std::vector<std::string_view> parts;
std::vector<etak::sys::WrittenFile> written;

}  // namespace

extern "C" {

[[clang::export_name("etak_begin")]] void etak_begin() {
  etak::sys::empty_tree();
  parts.clear();
  written.clear();
}

[[clang::export_name("etak_words")]] char* etak_words(std::size_t size) {
  words.resize(size);
  return words.data();
}

/// The path of the file is what etak_words() holds. Null where another file is in its way.
[[clang::export_name("etak_file")]] char* etak_file(std::size_t size) {
  return etak::sys::put_file(words, size);
}

[[clang::export_name("etak_input")]] char* etak_input(std::size_t size) {
  return etak::sys::put_standard_input(size);
}

/// The words of the line are what etak_words() holds, each with a zero behind it.
[[clang::export_name("etak_run")]] int etak_run() {
  using namespace etak;
  std::vector<std::string> line_words{"etak"};
  for (std::size_t at = 0, end = 0; (end = words.find('\0', at)) != words.npos; at = end + 1)
    line_words.push_back(words.substr(at, end - at));
  int status = 0;
  {
    cli::CommandLine line = cli::empty_line();
    status = cli::run_line(line_words, line);
  }
  forget_inputs();
  set_follow_links(false);
  written = sys::written_files();
  parts = {sys::written_to(sys::standard_output), sys::written_to(sys::standard_error)};
  for (const sys::WrittenFile& file : written) {
    parts.emplace_back(file.path);
    parts.emplace_back(*file.bytes);
  }
  return status;
}

[[clang::export_name("etak_parts")]] std::size_t etak_parts() {
  return parts.size();
}

[[clang::export_name("etak_part")]] const char* etak_part(std::size_t index) {
  return parts[index].data();
}

[[clang::export_name("etak_part_size")]] std::size_t etak_part_size(std::size_t index) {
  return parts[index].size();
}

}  // extern "C"
