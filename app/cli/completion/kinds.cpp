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

constexpr std::array<std::pair<Completes, std::string_view>, 12> kind_names{{
    {Completes::nothing, "nothing"},
    {Completes::files, "files"},
    {Completes::folders, "folders"},
    {Completes::materials, "materials"},
    {Completes::classes, "classes"},
    {Completes::rules, "rules"},
    {Completes::models, "models"},
    {Completes::diffuse_models, "diffuse-models"},
    {Completes::functions, "functions"},
    {Completes::targets, "targets"},
    {Completes::spaces, "spaces"},
    {Completes::verbs, "verbs"},
}};

// What stands for a value in the help, without "...".
constexpr std::array<std::pair<std::string_view, Completes>, 22> value_names{{
    {"FILE", Completes::files},
    {"LIST", Completes::files},
    {"CONFIG", Completes::files},
    {"PATH", Completes::files},
    {"N|FILE", Completes::files},
    {"FILE|NAME", Completes::files},
    {"DIR", Completes::folders},
    {"INPUT", Completes::materials},
    {"NAME", Completes::materials},
    {"MATERIAL", Completes::materials},
    {"NUMBER|MATERIAL", Completes::materials},
    {"SCENE|MATERIAL", Completes::materials},
    {"SUBJECT", Completes::materials},
    {"CLASS", Completes::classes},
    {"RULE", Completes::rules},
    {"RULE,", Completes::rules},
    {"MODEL", Completes::models},
    {"DIFFUSE_MODEL", Completes::diffuse_models},
    {"FUNCTION", Completes::functions},
    {"TARGET,", Completes::targets},
    {"SPACE", Completes::spaces},
    {"VERB", Completes::verbs},
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

std::string_view name(Completes kind) {
  return std::ranges::find(kind_names, kind, &std::pair<Completes, std::string_view>::first)->second;
}

std::vector<std::string> named_kinds() {
  std::vector<std::string> out;
  for (const auto& [kind, text] : kind_names)
    if (kind != Completes::nothing && kind != Completes::files && kind != Completes::folders)
      out.emplace_back(text);
  return out;
}

Completes completes(const OptionRow& option) {
  if (!option.words.empty()) return Completes::nothing;
  std::string_view value = option.value;
  if (value.ends_with("...")) value.remove_suffix(3);
  const auto found = std::ranges::find(value_names, value, &std::pair<std::string_view, Completes>::first);
  return found == value_names.end() ? Completes::nothing : found->second;
}

bool is_list(const OptionRow& option) {
  return option.value.ends_with(",...");
}

std::vector<std::string> names_of(std::string_view kind, const std::vector<VerbRow>& table,
                                  Library& library) {
  std::vector<std::string> out;
  if (kind == name(Completes::materials)) return library.get().ids();
  if (kind == name(Completes::classes)) return {material_classes.begin(), material_classes.end()};
  if (kind == name(Completes::models)) return model_names(ModelKind::diffuse);
  if (kind == name(Completes::diffuse_models)) return model_names(ModelKind::specular);
  if (kind == name(Completes::functions)) return ids_of(functions());
  if (kind == name(Completes::targets)) return ids_of(engine_targets());
  if (kind == name(Completes::rules))
    for (const Rule* each : rules()) out.emplace_back(each->id);
  else if (kind == name(Completes::spaces))
    for (const RgbSpace each : all_rgb_spaces) out.emplace_back(name(each));
  else if (kind == name(Completes::verbs))
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
