// SPDX-License-Identifier: Apache-2.0
#include "app/cli/catalogue.h"

#include "core/base/parallel.h"

namespace etak::cli {

std::vector<CatalogueEntry> catalogue(const MaterialLibrary& library, const F0Solver& solver,
                                      unsigned threads) {
  std::vector<CatalogueEntry> out(library.ids().size());
  parallel_chunks(out.size(), threads, 8, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      out[i].material = library.at(i);
      const Dataset& dataset = out[i].material.preferred_dataset();
      out[i].result = solver.solve(dataset.optics, dataset.flags);
    }
  });
  return out;
}

}  // namespace etak::cli
