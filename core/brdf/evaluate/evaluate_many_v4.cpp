// SPDX-License-Identifier: Apache-2.0
// The vectorised loops, compiled for x86-64-v4; CMakeLists.txt sets the flags.
#define ETAK_MANY many_v4
#include "core/brdf/evaluate/evaluate_many.inc"
