// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/pack/pack.h"

namespace etak::cli {

/// One atlas, with its report. Returns the exit status: 1 for findings that fail the run.
int pack_once(PackArguments& arguments);

/// Every job of --batch (parse_pack_jobs) in the file's order, in this process; a job that fails is told and
/// stops no other. Returns the exit status: the worst of all.
int pack_batch(PackArguments& arguments);

/// Packs, and again whenever an input changes, until the process is interrupted.
int pack_watch(PackArguments& arguments);

}  // namespace etak::cli
