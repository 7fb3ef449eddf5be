// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/certainty/bands.h"
#include "core/material/appearance.h"
#include "core/material/f0.h"
#include "core/material/f0_coat.h"

namespace etak {

/// A layer of a stack, or its base, which has no thickness.
struct F0Layer {
  std::string id, dataset;
  std::optional<double> thickness_nm;
  bool coherent = true;
};

/// One line of an F0 report: the material or file that was asked for, the source of its data, and the result.
struct F0Row {
  // Id of the material ("gold", "gold/johnson-1972"), or the path of the file, relative to the folder given.
  std::string path;
  std::string name;            // "Gold"; empty for bare files
  std::string material_class;  // empty for bare files
  std::string dataset;         // id of the dataset; empty for bare files
  std::string source;          // citation in one line; empty when unknown
  F0Result result;
  std::string alias_note = {};  // note of the library on the alias that was asked for; may be empty
  std::string kind = {};        // of the dataset: "measured", "fit", "computed"; empty when unknown
  std::string doubt = {};       // why the dataset is doubtful; empty: it is not, or nothing is known of it
  std::optional<ClearBody> clear = {};  // of a material whose body is clear, its colour in the space of F0
  std::optional<CoatedF0> coat = {};    // where the job has a coat
  std::vector<F0Layer> layers = {};     // of a stack, the outermost first, the base last
  std::optional<Band> band = {};        // where new publications would lie; where the job asks for it
  std::string band_reason = "one set of data, of no material";  // why there is none
};

}  // namespace etak
