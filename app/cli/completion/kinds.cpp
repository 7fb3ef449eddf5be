// SPDX-License-Identifier: Apache-2.0
#include "app/cli/completion/kinds.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/base/text/text.h"
#include "core/brdf/models.h"
#include "core/color/colorspace.h"
#include "core/exchange/engine_values.h"
#include "core/judge/rules.h"
#include "core/light/functions.h"

namespace etak::cli {
namespace {

// What stands for a value in the help, without "...".
constexpr std::array<std::pair<std::string_view, std::string_view>, 22> value_names{{
    {"FILE", "files"},
    {"LIST", "files"},
    {"CONFIG", "files"},
    {"PATH", "files"},
    {"N|FILE", "files"},
    {"FILE|NAME", "files"},
    {"DIR", "folders"},
    {"INPUT", "materials"},
    {"NAME", "materials"},
    {"MATERIAL", "materials"},
    {"NUMBER|MATERIAL", "materials"},
    {"SCENE|MATERIAL", "materials"},
    {"SUBJECT", "materials"},
    {"CLASS", "classes"},
    {"RULE", "rules"},
    {"RULE,", "rules"},
    {"MODEL", "models"},
    {"DIFFUSE_MODEL", "diffuse-models"},
    {"FUNCTION", "functions"},
    {"TARGET,", "targets"},
    {"SPACE", "spaces"},
    {"VERB", "verbs"},
}};

std::vector<std::string> model_names(ModelKind without) {
  std::vector<std::string> out;
  for (const Model& each : models())
    if (each.kind != without) out.emplace_back(each.id);
  out.emplace_back("none");
  return out;
}

template <class Row>
std::vector<std::string> ids_of(std::span<const Row> rows) {
  std::vector<std::string> out;
  for (const Row& each : rows) out.emplace_back(each.id);
  return out;
}

}  // namespace

std::vector<std::string> named_kinds() {
  return {"materials", "classes", "rules",  "models", "diffuse-models",
          "functions", "targets", "spaces", "verbs"};
}

std::string_view completes(const OptionRow& option) {
  if (!option.words.empty()) return {};
  std::string_view value = option.value;
  if (value.ends_with("...")) value.remove_suffix(3);
  const auto found =
      std::ranges::find(value_names, value, &std::pair<std::string_view, std::string_view>::first);
  return found == value_names.end() ? std::string_view() : found->second;
}

bool is_list(const OptionRow& option) {
  return option.value.ends_with(",...");
}

std::vector<std::string> names_of(std::string_view kind, const std::vector<VerbRow>& table,
                                  Library& library) {
  std::vector<std::string> out;
  if (kind == "materials") return library.get().ids();
  if (kind == "classes") return {material_classes.begin(), material_classes.end()};
  if (kind == "models") return model_names(ModelKind::diffuse);
  if (kind == "diffuse-models") return model_names(ModelKind::specular);
  if (kind == "functions") return ids_of(functions());
  if (kind == "targets") return ids_of(engine_targets());
  if (kind == "rules")
    for (const Rule* each : rules()) out.emplace_back(each->id);
  else if (kind == "spaces")
    for (const RgbSpace each : all_rgb_spaces) out.emplace_back(name(each));
  else if (kind == "verbs")
    return verb_names(table);
  else
    throw Error::at("--words", printable(kind), joined(named_kinds()));
  return out;
}

std::vector<std::string> verb_names(const std::vector<VerbRow>& table) {
  std::vector<std::string> out;
  for (const VerbRow& each : table)
    if (!each.name.empty()) out.push_back(each.name);
  return out;
}

}  // namespace etak::cli
