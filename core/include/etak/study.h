// SPDX-License-Identifier: Apache-2.0
#pragma once

// The cheapest way to draw a material within a budget of error, error against run time of ways to compute the
// same thing, and stiff cases. Link etak::core; what takes times (time_cases(), all_families(),
// measure_costs()) is in etak::study_run, scene_subjects() in etak::choose_scene.
//
// ```cpp
// #include <cstdio>
// #include <etak/materials.h>
// #include <etak/study.h>
//
// int main() {
//   const etak::MaterialLibrary library = etak::MaterialLibrary::builtin();
//   const etak::FoundDataset silver = etak::find_dataset(library, "silver", "", {});
//   const etak::ChooseSubject subject = etak::library_subject(silver.material, silver.chosen(), 0.75);
//   etak::ChooseOptions options;
//   options.budget = 1;                         // CIEDE2000, of every pixel and of F at any angle
//   const etak::Choice choice = etak::choose(subject, options, etak::shipped_costs());
//   std::printf("%s: %s, worst pixel %.2f\n", choice.material.c_str(), choice.model.c_str(),
//               choice.picture_error);
//   if (!choice.met) std::puts(etak::unmet_remark(choice).c_str());
//
//   std::size_t passed = 0;
//   for (const etak::StabilityCase& each : etak::stability_cases()) passed += each.passed;
//   std::printf("%zu stiff cases passed\n", passed);
// }
// ```
//
// Units and ranges
//   budget       at least 0, in ChooseOptions::unit: CIEDE2000 (D65) or 8-bit sRGB codes of the worst channel
//   costs        nanoseconds per evaluation. The shipped table makes a choice the same on every machine;
//                measure_costs() times this one
//   RunTime      nanoseconds: median and quartiles over rounds of interleaved repeats on one thread
//   errors       stand beside every time, in the units of ErrorMetric
//
// Errors
//   etak::Error    data without a colour or without n and k, a scene that cannot be read
//   Choice::met    false where no form stays within the budget: the closest one was taken

#include "core/base/error.h"
#include "core/pages/choose_report.h"
#include "core/pages/error_time_report.h"
#include "core/pages/stability_report.h"
#include "core/study/choose/choose.h"
#include "core/study/choose/choose_scene.h"
#include "core/study/error_time.h"
#include "core/study/stability/stability.h"
