// SPDX-License-Identifier: Apache-2.0
// The vectorised loops, compiled for any processor of the target architecture.
#define ETAK_MANY many_generic
#include "core/brdf/evaluate/evaluate_many.inc"
