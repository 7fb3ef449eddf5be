// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <set>
#include <string>
#include <tuple>

#include "core/base/files/output.h"
#include "core/findings/output/formats.h"
#include "core/pack/pack.h"
#include "core/validate/check_pack.h"
#include "core/validate/validate.h"
#include "tests/core/atlas/scene_support.h"

// What is said of a scene: of its files, and while it is packed.
namespace etak::test {

/// Rule, severity and material of everything that was said.
using Told = std::set<std::tuple<std::string, Severity, std::string>>;

inline Told told(const ValidationReport& report) {
  Told out;
  for (const CheckedFile& file : report.files)
    for (const Finding& f : file.findings) out.emplace(f.rule, f.severity, f.material);
  return out;
}

inline std::string text_of(const Told& all) {
  std::string out;
  for (const auto& [rule, severity, material] : all)
    out += rule + ' ' + std::string(name(severity)) + ' ' + material + '\n';
  return out;
}

inline ValidationReport said_of(const std::string& path) {
  ValidationRequest request;
  request.inputs.paths = {path};
  request.run.door = picture_door();
  request.run.threads = 2;
  return validate(request);
}

/// What is said of a scene while it is packed.
///   before   sees each page before the check does
///   result   what packing returned; null: not wanted
inline ValidationReport said_while_packing(const std::string& scene, const std::string& out,
                                           PackOptions options, const PageCheck& before = {},
                                           PackResult* result = nullptr) {
  options.input.pictures.door = picture_door();
  PackCheckOptions asked;
  asked.threads = 2;
  PackCheck check(out, asked);
  check.attach(options);
  if (before)
    options.check.page = [&, after = options.check.page](const AtlasLayout& layout, int page,
                                                         const PagePixels& pixels) {
      return before(layout, page, pixels) && after(layout, page, pixels);
    };
  options.check.beside = [&](PackResult& packed, OutputFolder*) -> std::unique_ptr<Output> {
    check.finish(packed);
    return nullptr;
  };
  options.run.threads = 2;
  PackResult packed = pack(scene, out, options, test::library());
  REQUIRE(check.report() != nullptr);
  if (result != nullptr) *result = std::move(packed);
  return *check.report();
}

}  // namespace etak::test
