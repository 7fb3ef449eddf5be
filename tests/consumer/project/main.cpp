// SPDX-License-Identifier: Apache-2.0
#include <etak/f0.h>
#include <etak/materials.h>

#include <cstdio>

int main() {
  const auto gold = etak::MaterialLibrary::builtin().find("gold");
  const auto f0 = etak::F0Solver({}).solve(gold->preferred_dataset().optics);
  std::printf("gold %.6f %.6f %.6f\n", f0.linear.r, f0.linear.g, f0.linear.b);
}
