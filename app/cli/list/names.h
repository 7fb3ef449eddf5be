// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/material/f0.h"
#include "core/material/library.h"

namespace etak::cli {

/// What a name would be answered with.
struct NameAnswer {
  std::string asked;
  std::optional<Material> material;  // none: the name is not answered
  NameKind by = NameKind::id;        // of the material's names
  std::string note;                  // what must be said of the name; of one not answered: why
  std::string near;         // names that come near, or what is measured and near; of one not answered
  bool unmeasured = false;  // known as a thing without a measurement
  std::string refusal;      // why the material has no F0; empty: it has
};

NameAnswer answer_name(const MaterialLibrary& library, const F0Solver& solver, const std::string& name);

/// Forms of `etak list NAME...`; `format` is table, csv, json, jsonl or markdown.
std::string names_text(std::span<const NameAnswer> answers, const std::string& format);

}  // namespace etak::cli
