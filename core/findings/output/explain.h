// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/judge/rule.h"

namespace etak {

/// The rule for people: what, why, an example, the fix, its parameters and sources.
///   columns   width of the lines in characters, at most 100; 0: 100
std::string explanation(const Rule& rule, std::size_t columns = 0);

/// The explanation in Markdown, under a heading.
std::string explanation_markdown(const Rule& rule);

/// A table of all rules, a line for each: id, slug, severity in the default and strict profile, title.
std::string rules_table();

/// {"schema": "etak-rules/1", "rules": [...]} for editors and documentation.
std::string rules_json(std::span<const Rule* const> rules);

}  // namespace etak
