// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/exchange/engine_values.h"

namespace etak {

struct JsonMember;

/// The targets with these ids, all where there are none. Throws Error (naming the setting "target").
std::vector<const EngineTarget*> engine_targets_named(const std::vector<std::string>& ids);

/// Throws Error (naming the setting "space") where a form of export does not hold colours of that space.
///   to   "mtlx", "gltf", "glb" or "values"
void require_export_space(std::string_view to, const F0Options& options);

/// How the source of a surface goes on before the medium that F0 is against, where that is not vacuum.
inline constexpr std::string_view source_outside = "; F0 against ";

/// A surface with its values in every target asked for.
struct ExportedValues {
  ExportSurface surface;
  std::string dataset;
  std::vector<EngineValues> targets;
};

/// The values of `surfaces` in `targets`, computed on `threads` threads.
///   datasets   id of the dataset of each surface
std::vector<ExportedValues> exported_values(std::vector<ExportSurface> surfaces,
                                            const std::vector<std::string>& datasets,
                                            const std::vector<const EngineTarget*>& targets, Fit fit,
                                            unsigned threads);

/// A clear body as JSON on one line; "null" for none.
///   color   how the document writes its colours
std::string json_clear(const std::optional<ClearBody>& body, std::string (*color)(const LinearRgb&));
/// Of a coat: its n, F0 and F82 under it and of the whole, as members of JSON.
std::vector<JsonMember> coat_members(const CoatedF0& coat, std::string (*color)(const LinearRgb&));

/// The error of values in a sentence, or why there is none; empty for colours and constants, of which nobody asks it.
std::string error_line(const EngineValues& values);

// The forms of `etak export --to values`.
std::string export_table(const std::vector<ExportedValues>& all);
std::string export_text(const std::vector<ExportedValues>& all);  // what an editor copies
std::string export_csv(const std::vector<ExportedValues>& all);
std::string export_json(const std::vector<ExportedValues>& all, Fit fit, const std::string& policy);

}  // namespace etak
