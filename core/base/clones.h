// SPDX-License-Identifier: Apache-2.0
#pragma once

// A function after ETAK_CLONES(SETS...) is compiled for each of these instruction sets and for the processor that the
// build is for; the best one is chosen when the program starts. ETAK_CLONES_O3 optimises its loops in all build types
// too. The choice needs ELF; the sanitizers are not ready yet when it is made, and clang 14 does not know the attribute.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ETAK_CLONES(...) __attribute__((target_clones("default", __VA_ARGS__)))
#define ETAK_CLONES_O3(...) __attribute__((target_clones("default", __VA_ARGS__), optimize("O3")))
#else
#define ETAK_CLONES(...)
#define ETAK_CLONES_O3(...)
#endif
