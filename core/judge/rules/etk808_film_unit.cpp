// SPDX-License-Identifier: Apache-2.0
#include "core/base/number.h"
#include "core/judge/rules/surface_check.h"

namespace etak {

constinit const Rule etk808_film_unit{
    .id = "ETK808",
    .slug = "film-unit",
    .title = "A film's thickness in another unit",
    .severity = Severity::error,
    .needs = {Need::material},
    .source = "OpenPBR 1.1 (micrometres); Standard Surface, glTF and MaterialX's bsdfs (nanometres)",
    .what =
        "A film of a material document that is thinner than 1 nm or thicker than 20 um, by the unit of its input: micrometres in open_pbr_surface, nanometres elsewhere. 0 is no film.",
    .why =
        "Films show colours between some 30 nm and a few micrometres. Outside of that a value of the other unit is meant.",
    .example = "thin_film_thickness 400 in an open_pbr_surface, whose unit is the micrometre.",
    .fix = "Divide or multiply by 1000.",
    .check = [](RuleCheck& check) {
      constexpr double least_nm = 0.99, most_nm = 20000;
      for_each_surface(check, [&](const DocumentSurface& surface, const DocumentValues& values) {
        if (!values.film_nm || *values.film_nm <= 0) return;
        if (*values.film_nm >= least_nm && *values.film_nm <= most_nm) return;
        const bool thin = *values.film_nm < least_nm;
        Finding& finding = report_surface(check, surface, values, values.film_from,
                                          "a film of " + number(*values.film_nm, 3) + " nm; possibly " +
                                              (thin ? "micrometres" : "nanometres") + " are meant");
        finding.limit = "1 nm to 20 um";
      });
    }};

}  // namespace etak
