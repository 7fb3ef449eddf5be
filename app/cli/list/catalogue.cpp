// SPDX-License-Identifier: Apache-2.0
#include "app/cli/list/catalogue.h"

#include <algorithm>

#include "app/cli/output/output.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/material/quality.h"

namespace etak::cli {

std::vector<CatalogueEntry> catalogue(const MaterialLibrary& library, const F0Solver& solver,
                                      unsigned threads) {
  std::vector<CatalogueEntry> out(library.ids().size());
  parallel_chunks(out.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      out[i].material = library.at(i);
      const Dataset& dataset = out[i].material.preferred_dataset();
      out[i].result = solve(solver, out[i].material, dataset);
    }
  });
  return out;
}

std::string quality_text(const CatalogueEntry& entry) {
  return etak::quality_text(entry.material.preferred_dataset().origin, entry.result.flags);
}

std::string flag_names(const CatalogueEntry& entry) {
  std::string out;
  entry.result.flags.for_each([&](Flag flag) { out.append(out.empty() ? "" : ";").append(name(flag)); });
  return out;
}

std::string json_flags(const CatalogueEntry& entry) {
  std::string out = "[";
  entry.result.flags.for_each([&](Flag flag) { out += (out.size() > 1 ? ", " : "") + json(name(flag)); });
  return out + "]";
}

void add_class_option(Command verb, std::vector<std::string>& classes, const std::string& help) {
  verb.option("--class", classes, help).value_name("CLASS").one_at_a_time();
}

void check_classes(const std::vector<std::string>& classes) {
  for (const std::string& each : classes) {
    if (std::find(material_classes.begin(), material_classes.end(), each) != material_classes.end()) continue;
    throw Error::at("--class", printable(each), joined(material_classes));
  }
}

}  // namespace etak::cli
