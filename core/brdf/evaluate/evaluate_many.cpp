// SPDX-License-Identifier: Apache-2.0
#include "core/brdf/evaluate/evaluators.h"

namespace etak::evaluators {
namespace {

int level() {
#ifdef ETAK_X86_64_LEVELS
  // Features are asked for one by one, because GCC 12 takes no names of levels here; only those that the
  // loops can use are needed.
  __builtin_cpu_init();
  const bool v3 =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  return v4 ? 4 : v3 ? 3 : 0;
#else
  return 0;
#endif
}

}  // namespace

ManyTable many() {
#ifdef ETAK_X86_64_LEVELS
  static const int best = level();
  if (best == 4) return many_v4();
  if (best == 3) return many_v3();
#endif
  return many_generic();
}

const char* instruction_set() {
  const int best = level();
  return best == 4 ? "x86-64-v4" : best == 3 ? "x86-64-v3" : "generic";
}

}  // namespace etak::evaluators
