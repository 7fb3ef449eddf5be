// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "tests/support.h"

using namespace etak::test;
namespace fs = std::filesystem;

namespace {

struct SourceFile {
  std::string path;    // relative to the root: "core/color/srgb.cpp"
  std::string folder;  // "color"
  std::vector<std::string> lines;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<SourceFile> files_below(const std::string& root) {
  std::vector<SourceFile> files;
  for (const auto& entry : fs::recursive_directory_iterator(source_folder() + "/" + root)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp" && extension != ".inc" && extension != ".glsl") continue;
    const std::string path = fs::relative(entry.path(), source_folder()).generic_string();
    const auto slash = path.find('/', root.size() + 1);
    files.push_back({path,
                     slash == std::string::npos ? "" : path.substr(root.size() + 1, slash - root.size() - 1),
                     lines_of(slurp(entry.path().string()))});
  }
  REQUIRE(!files.empty());
  return files;
}

// What stands between `open` and `close` in the line, when it begins with `open` (after blanks); else "".
std::string between(std::string_view line, std::string_view open, char close) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (!line.starts_with(open)) return "";
  line.remove_prefix(open.size());
  return std::string(line.substr(0, line.find(close)));
}

// The folders of core in the order of use, from the add_subdirectory lines of core/CMakeLists.txt.
std::vector<std::string> folder_order() {
  std::vector<std::string> order;
  for (const auto& line : lines_of(slurp(source_folder() + "/core/CMakeLists.txt"))) {
    const std::string folder = between(line, "add_subdirectory(", ')');
    if (!folder.empty()) order.push_back(folder);
  }
  return order;
}

std::string included(std::string_view line) {
  const std::string own = between(line, "#include \"", '"');
  return own.empty() ? between(line, "#include <", '>') : own;
}

// A line without its comment, taken apart.
struct LineParts {
  std::string code;                // without the texts in quotes
  std::vector<std::string> texts;  // in quotes
};
LineParts parts_of(const std::string& line) {
  LineParts parts;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!quoted && line.compare(i, 2, "//") == 0) break;
    if (!quoted && line.compare(i, 3, "'\"'") == 0) {
      i += 2;
    } else if (quoted && line[i] == '\\') {
      parts.texts.back() += line.substr(i++, 2);
    } else if (line[i] == '"') {
      quoted = !quoted;
      if (quoted) parts.texts.emplace_back();
    } else if (quoted) {
      parts.texts.back() += line[i];
    } else {
      parts.code += line[i];
    }
  }
  return parts;
}

// "--name" at the beginning of a word, which is no part of a whole command such as "etak list --all".
bool names_option(const std::string& text) {
  for (std::size_t at = text.find("--"); at != text.npos; at = text.find("--", at + 2)) {
    const bool begins_word = at == 0 || text[at - 1] == ' ' || text[at - 1] == '[';
    const bool has_name = at + 2 < text.size() && std::islower(static_cast<unsigned char>(text[at + 2])) != 0;
    const std::string before = text.substr(0, at);
    if (begins_word && has_name && !contains(before, "etak ") && !contains(before, "maketx ")) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("no include of core runs back in the order of its folders") {
  const auto order = folder_order();
  REQUIRE(order.size() >= 8);
  const auto rank = [&](const std::string& folder) {
    return std::find(order.begin(), order.end(), folder) - order.begin();
  };
  for (const auto& file : files_below("core")) {
    INFO(file.path);
    REQUIRE(rank(file.folder) < static_cast<std::ptrdiff_t>(order.size()));
    for (const auto& line : file.lines) {
      const std::string target = included(line);
      if (target.empty()) continue;
      INFO(line);
      CHECK(!target.starts_with("app/"));
      CHECK(!target.starts_with("tests/"));
      if (!target.starts_with("core/")) continue;
      const std::string folder = target.substr(5, target.find('/', 5) - 5);
      CHECK(rank(folder) <= rank(file.folder));
    }
  }
}

TEST_CASE("no public header of core names a third party") {
  const std::vector<std::string> third_parties{
      "nlohmann", "OpenColorIO", "OCIO_NAMESPACE", "OCIO::", "OpenImageIO", "OIIO",    "YAML::",
      "yaml-cpp", "Catch",       "<catch2",        "<Q",     "QObject",     "QString", "QWidget"};
  for (const auto& file : files_below("core")) {
    // What the JSON readers share is a header of their own affair, and no other header includes it.
    if (!file.path.ends_with(".h") || file.path.ends_with("_json.h")) continue;
    for (const auto& line : file.lines) {
      INFO(file.path << ": " << line);
      CHECK(!included(line).ends_with("_json.h"));
    }
    for (const auto& line : file.lines)
      for (const auto& name : third_parties) {
        if (!contains(parts_of(line).code, name) && !included(line).starts_with(name)) continue;
        INFO(file.path << ": " << line);
        CHECK(name.empty());
      }
  }
}

TEST_CASE("each third party stands behind its own door") {
  for (const auto& file : files_below("core"))
    for (const auto& line : file.lines) {
      const std::string target = included(line);
      INFO(file.path << ": " << line);
      if (target.starts_with("nlohmann/")) CHECK(contains(fs::path(file.path).filename().string(), "json"));
      if (target.starts_with("OpenColorIO/")) CHECK(file.path.starts_with("core/color/ocio"));
      if (target.starts_with("OpenImageIO/")) CHECK(file.path == "core/image/image_io.cpp");
    }
}

TEST_CASE("what differs between systems stands in the sources of core/base/system alone") {
  const std::vector<std::string> headers{"sys/",      "linux/",     "mach",     "arpa/",      "netinet/",
                                         "unistd.h",  "fcntl.h",    "dirent.h", "dlfcn.h",    "poll.h",
                                         "pthread.h", "signal.h",   "malloc.h", "termios.h",  "io.h",
                                         "windows.h", "winternl.h", "bcrypt.h", "shellapi.h", "spawn.h"};
  std::size_t seen = 0;
  for (const std::string root : {"core", "app/cli"})
    for (const auto& file : files_below(root)) {
      // The OpenGL of pictures is not built for other systems than Linux.
      if (file.path == "core/glsl/gl_context.cpp") continue;
      const bool is_door = file.path.starts_with("core/base/system/");
      for (const auto& line : file.lines) {
        const std::string target = between(line, "#include <", '>');
        const bool of_system = std::any_of(headers.begin(), headers.end(), [&](const std::string& header) {
          return target.starts_with(header);
        });
        if (is_door) seen += of_system ? 1 : 0;
        INFO(file.path << ": " << line);
        CHECK((is_door || !of_system));
        if (!is_door) CHECK_FALSE(contains(parts_of(line).code, "syscall("));
      }
    }
  CHECK(seen > 10);
}

TEST_CASE("elementary functions are those of core/math, whose digits no C library changes") {
  const std::vector<std::string> names{"pow",   "exp",    "exp2",   "expm1", "log",  "log2",  "log10",
                                       "log1p", "sin",    "cos",    "tan",   "asin", "acos",  "atan",
                                       "atan2", "sinh",   "cosh",   "tanh",  "cbrt", "hypot", "erf",
                                       "erfc",  "tgamma", "lgamma", "polar", "arg",  "proj"};
  std::size_t ours = 0;
  for (const auto& file : files_below("core")) {
    if (file.folder == "math") continue;
    for (const auto& line : file.lines) {
      const std::string code = parts_of(line).code;
      INFO(file.path << ": " << line);
      for (std::size_t at = code.find("std::"); at != code.npos; at = code.find("std::", at + 1)) {
        const std::size_t from = at + 5,
                          end = code.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789", from);
        CHECK(std::find(names.begin(), names.end(), code.substr(from, end - from)) == names.end());
      }
      ours += contains(code, "math::") ? 1 : 0;
    }
  }
  CHECK(ours > 200);
}

TEST_CASE(
    "files and folders are asked about by core/base/system alone: of std::filesystem others use paths") {
  // A system without files has std::filesystem::path, and neither operations nor streams of files.
  const auto follows = [](std::string_view code, std::string_view name) {
    const bool longer =
        code.size() > name.size() &&
        (std::isalnum(static_cast<unsigned char>(code[name.size()])) != 0 || code[name.size()] == '_');
    return code.starts_with(name) && !longer;
  };
  std::size_t paths = 0;
  for (const std::string root : {"core", "app/cli"})
    for (const auto& file : files_below(root)) {
      // The second is a program of the build.
      if (file.path.starts_with("core/base/system/") || file.path == "core/material/embedded/embed_main.cpp")
        continue;
      for (const auto& line : file.lines) {
        const std::string code = parts_of(line).code;
        INFO(file.path << ": " << line);
        CHECK(between(line, "#include <", '>') != "fstream");
        if (contains(code, "= std::filesystem;")) CHECK(contains(code, "namespace fs = "));
        for (const std::string name : {"filesystem::", "fs::"})
          for (std::size_t at = code.find(name); at != code.npos; at = code.find(name, at + 1)) {
            const std::string_view used = std::string_view(code).substr(at + name.size());
            CHECK((follows(used, "path") || follows(used, "filesystem_error")));
            ++paths;
          }
      }
    }
  CHECK(paths > 100);
}

TEST_CASE("no message of core names an option of a command line: setting() names what would help") {
  const std::vector<std::string> others{
      "core/findings/",                       // options of the run that a report tells of
      "core/judge/rules/",                    // what rules tell people to do
      "core/validate/",                       // its settings are those of etak.toml and of the command line
      "core/pages/atlas_page.cpp",            // a command for the reader to copy
      "core/pages/choose_text.cpp",           // the same
      "core/project/command_line.cpp",        // the same
      "core/study/choose/choose_values.cpp",  // the same
      "core/study/timing.cpp"};               // arguments of the benchmark library
  for (const auto& file : files_below("core")) {
    const auto is_other = [&](const std::string& begin) { return file.path.starts_with(begin); };
    if (std::any_of(others.begin(), others.end(), is_other)) continue;
    for (const auto& line : file.lines)
      for (const auto& text : parts_of(line).texts) {
        INFO(file.path << ": " << line);
        CHECK_FALSE(names_option(text));
      }
  }
}

TEST_CASE(
    "what stands in a thread has no destructor, which GCC for Windows calls after the memory is freed") {
  std::size_t seen = 0;
  for (const auto* root : {"core", "app"})
    for (const auto& file : files_below(root))
      for (std::size_t i = 0; i < file.lines.size(); ++i) {
        if (!contains(parts_of(file.lines[i]).code, "thread_local ")) continue;
        ++seen;
        INFO(file.path << ": " << file.lines[i] << "; core/base/spares.h is for what has a destructor");
        REQUIRE(i + 1 < file.lines.size());
        CHECK(contains(file.lines[i + 1], "static_assert(std::is_trivially_destructible_v<decltype("));
      }
  CHECK(seen > 0);
}

TEST_CASE("every source file opens with its licence line") {
  for (const auto* root : {"core", "app", "tests"})
    for (const auto& file : files_below(root)) {
      INFO(file.path);
      REQUIRE(!file.lines.empty());
      CHECK(file.lines[0] == "// SPDX-License-Identifier: Apache-2.0");
    }
}
