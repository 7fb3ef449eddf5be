// SPDX-License-Identifier: Apache-2.0
#include "core/study/families/families.h"

#include <fstream>

#include "core/study/study_build.h"

namespace etak {
namespace {

// The processor's name as the system gives it.
std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(':');
    if (line.starts_with("model name") && colon != line.npos && colon + 2 <= line.size())
      return line.substr(colon + 2);
  }
  return "unknown";
}

constexpr FamilyEntry families[] = {
#define ETAK_FAMILY(id, function) {id, function},
#include "core/study/families/families.inc"
#undef ETAK_FAMILY
};

}  // namespace

std::span<const FamilyEntry> all_families() {
  return families;
}

ReportHeader report_header(const ReportOptions& options) {
  ReportHeader header;
  header.version = report_build::version;
  header.commit = report_build::commit;
  header.cpu = cpu_name();
  header.compiler = report_build::compiler;
  header.flags = report_build::flags;
  header.threads = options.threads;
  header.effort = options.full ? "full" : "quick";
  return header;
}

}  // namespace etak
