// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/material/f0.h"
#include "core/material/library.h"

namespace etak {

// From text to a material, one of its datasets, or a medium. Everything that takes such text asks here: the
// command line, projects, manifests. What takes files too (core/exchange/material_file.h) asks here first.

/// How the message speaks of a name that no material has.
///   place      where the name was asked for, such as "m.json#/materials/0/specular"; empty: the name itself
///              stands in front of the message
///   found      what is then said of the name
///   instead    what else may stand there, such as "a number": said beside the nearest names
struct NameWords {
  std::string_view place;
  std::string_view found = "is no material of the library";
  std::string_view instead;
};

/// Throws the Error of a text whose part before the first '/' is no name of a material of the library: with
/// the nearest names, or why nothing of that name is measured.
[[noreturn]] void fail_unknown_name(const MaterialLibrary& library, std::string_view text,
                                    const NameWords& words);

/// A material by the text that asks for it.
///   name      the text without the dataset: an id, name, alias or formula, maybe with qualifiers
///   dataset   what stands behind a '/', as dataset_named() takes it; empty: the preferred one
///   answer    what the library says to the name
struct NamedMaterial {
  LibraryAnswer answer;
  std::string name, dataset;
};

/// "gold", "Au" or "gold/johnson": the whole text is looked up first, then what stands before its first '/'.
/// A text of layers ("water:2mm/copper") is a material of its own. Nothing where the library has no answer to the name.
std::optional<NamedMaterial> find_material(const MaterialLibrary& library, std::string_view text);

/// One dataset and the material that it belongs to.
///   dataset   index in material.datasets
struct FoundDataset {
  Material material;
  std::size_t dataset = 0;

  const Dataset& chosen() const { return material.datasets[dataset]; }
};

/// The dataset of the material called `name`; the preferred one where `dataset` is empty. Throws Error where
/// there is none.
FoundDataset find_dataset(const MaterialLibrary& library, std::string_view name, std::string_view dataset,
                          const NameWords& words);

/// The medium in front of a surface: an index of refraction above 0, or a material ("water", "water/hale")
/// that n is known of, without qualifiers; vacuum for an empty text. Throws Error for a text that is none of
/// these.
///   place   of the text, such as setting("outside")
///   words   of names that no material has
OutsideMedium outside_medium(const MaterialLibrary& library, std::string_view text, const std::string& place,
                             const NameWords& words);

}  // namespace etak
