// SPDX-License-Identifier: Apache-2.0
#include "core/study/families/families.h"

#include "core/base/files/descriptor.h"
#include "core/base/text/text.h"
#include "core/study/study_build.h"

namespace etak {
namespace {

// The processor's name as the system gives it.
std::string cpu_name() {
  const Descriptor file(sys::open_file("/proc/cpuinfo", sys::Open::read));
  std::string text(std::size_t{1} << 16, '\0');
  text.resize(file ? read_all_at(file.get(), text, 0) : 0);
  for (const std::string& line : parts_of(text, '\n')) {
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
