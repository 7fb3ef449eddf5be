// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

namespace {

void etk607(RuleCheck& check) {
  const auto& material = check.evidence.material;
  if (!material) return;
  for (const SpectralRows& rows : material->datasets) {
    if (!material->is_material_file) break;
    std::string missing;
    const auto miss = [&](bool absent, const char* what) {
      if (absent) missing += std::string(missing.empty() ? "" : ", ") + what;
    };
    miss(rows.doi.empty() && rows.url.empty() && rows.via.empty(), "DOI or URL");
    miss(rows.licence.empty(), "licence");
    const bool serious = !missing.empty();
    miss(rows.sample.empty(), "description of the sample");
    if (missing.empty()) continue;
    Finding& finding = check.report();
    if (!serious) finding.severity = check.at_most(Severity::warning);
    finding.pointer = rows.pointer;
    finding.value = missing;
    finding.message = "dataset \"" + rows.id + "\" has no " + missing;
  }
}

}  // namespace

constinit const Rule etk607_reference_missing{
    "ETK607",
    "reference-missing",
    "No source is given",
    Severity::error,
    Severity::error,
    {Need::material},
    {},
    "Practice of refractiveindex.info and physicallybased.info",
    "A dataset of a material file that names neither DOI nor URL nor the collection and page "
    "it came through, or no licence (error), or does not describe the sample (warning: many "
    "published tables do not say).",
    "A number that nobody can look up cannot be trusted, nor passed on.",
    "A material typed in from a slide.",
    "Add doi, url or via, licence and sample.",
    &etk607};

}  // namespace etak
