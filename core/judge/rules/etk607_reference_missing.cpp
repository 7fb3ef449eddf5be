// SPDX-License-Identifier: Apache-2.0
#include "core/judge/rules/rows.h"

namespace etak {

constinit const Rule etk607_reference_missing{
    .id = "ETK607",
    .slug = "reference-missing",
    .title = "No source is given",
    .severity = Severity::error,
    .needs = {Need::material},
    .source = "Practice of refractiveindex.info and physicallybased.info",
    .what =
        "A dataset of a material file that names neither DOI nor URL nor the collection and page it came through, or no licence (error), or does not describe the sample (warning: many published tables do not say).",
    .why = "A number that nobody can look up cannot be trusted, nor passed on.",
    .example = "A material typed in from a slide.",
    .fix = "Add doi, url or via, licence and sample.",
    .check = [](RuleCheck& check) {
      for (const SpectralRows& rows : check.datasets()) {
        if (!check.evidence.material->is_material_file) break;
        std::string missing;
        const auto miss = [&](bool absent, const char* what) {
          if (absent) missing += std::string(missing.empty() ? "" : ", ") + what;
        };
        miss(rows.doi.empty() && rows.url.empty() && rows.via.empty(), "DOI or URL");
        miss(rows.licence.empty(), "licence");
        const bool serious = !missing.empty();
        miss(rows.sample.empty(), "description of the sample");
        if (missing.empty()) continue;
        Finding& finding = check.report(rows);
        if (!serious) finding.severity = check.at_most(Severity::warning);
        finding.value = missing;
        finding.message = "dataset \"" + rows.id + "\" has no " + missing;
      }
    }};

}  // namespace etak
