// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/f0/run.h"
#include "core/exchange/f0_worker.h"

namespace etak::cli {

/// The rows or the strip of --sweep for the one stack that is named. Returns the exit status; throws Error.
int answer_film_sweep(F0Arguments& arguments, const F0Job& job);

}  // namespace etak::cli
