// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/validate/repairs/repair.h"

namespace etak {

/// The rows of the table of repairs, one per file of this folder.
#define ETAK_REPAIR(name) extern const Repair name;
#include "core/validate/repairs/repairs.inc"
#undef ETAK_REPAIR

}  // namespace etak
