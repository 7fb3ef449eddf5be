// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <fstream>

#include "core/study/error_time.h"
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

constexpr std::array<FamilyEntry, 10> families{{{"quadrature", quadrature_family},
                                                {"fresnel", fresnel_family},
                                                {"lobes", lobe_family},
                                                {"hemispheres", hemisphere_family},
                                                {"transfer", transfer_family},
                                                {"quantisation", quantisation_family},
                                                {"gloss-mips", gloss_mip_family},
                                                {"image", image_family},
                                                {"packer", packer_family},
                                                {"sparse-tables", sparse_table_family}}};

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
  header.repeats = options.timing.repeats;
  header.effort = options.full ? "full" : "quick";
  return header;
}

}  // namespace etak
