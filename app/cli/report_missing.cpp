// SPDX-License-Identifier: Apache-2.0
#include "app/cli/choose.h"
#include "app/cli/report.h"
#include "core/base/error.h"

namespace etak::cli {

int measure(ReportArguments&) {
  throw Error::at("etak report", "this etak was built without Google Benchmark", "one built with it");
}

int choose_materials(ChooseArguments&) {
  throw Error::at("etak choose", "this etak was built without Google Benchmark", "one built with it");
}

int show_stability(StabilityArguments& arguments) {
  throw Error::at("etak stability --device " + arguments.device, "this etak was built without OpenGL",
                  "--device cpu");
}

}  // namespace etak::cli
