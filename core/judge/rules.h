// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/judge/rule.h"

namespace etak {

/// Every rule, in the order of ids.
std::span<const Rule* const> rules();

/// The rule of that whole id ("ETK101") or slug ("f0-forbidden-zone"); the case of the id does not matter.
/// Null: none.
const Rule* find_rule(std::string_view id_or_slug);

/// The rule about a file that cannot be read for the reason that the message tells: ETK011 for a pointer of
/// Git LFS, else ETK001.
const Rule& rule_of_unreadable(std::string_view message);

/// Whether a rule, given by its id, is about what could not be checked (ETK001, ETK011) or about etak itself
/// (9xx).
bool is_of_the_tool(std::string_view rule);

/// The rules whose ids begin with `prefix` ("ETK1", "ETK"); a whole id or a slug gives one rule. Empty: none
/// (ETK904).
std::vector<const Rule*> rules_with_prefix(std::string_view prefix);

/// The `count` ids nearest to a mistyped one.
std::vector<std::string_view> nearest_rules(std::string_view id, std::size_t count = 3);

/// A finding of `rule` with its id, slug, severity, source and fix filled in: for the rules of the tool
/// itself (901-904) and for messages of readers.
Finding finding_of(const Rule& rule, Severity severity, std::string file = {}, std::string message = {});

}  // namespace etak
