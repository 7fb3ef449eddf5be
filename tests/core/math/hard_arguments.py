#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes hard_arguments.inc: arguments of core/math/functions.h with results of 1,500 bits, by mpmath.

    python3 hard_arguments.py > hard_arguments.inc

A row has the function, its arguments, the double nearest to the result, and what that lacks in units of its last place."""
import random

import mpmath
from mpmath import mpf

mpmath.mp.prec = 1500
random.seed(44)
FUNCTIONS = {"pow": mpmath.power, "atan2": mpmath.atan2, "hypot": mpmath.hypot, "exp2": lambda x: mpf(2) ** x,
             "log2": lambda x: mpmath.log(x) / mpmath.log(2), "log10": lambda x: mpmath.log(x) / mpmath.log(10),
             "cbrt": lambda x: mpmath.sign(x) * mpmath.root(abs(x), 3), "log1p": lambda x: mpmath.log(1 + x),
             "expm1": lambda x: mpmath.exp(x) - 1}
COUNT = 10

# Near whole multiples of pi / 2 (the first is the nearest of all doubles), and the largest.
TURNS = [float.fromhex("0x1.6ac5b262ca1ffp+849"), 1e22, 2.0 ** 1023, float.fromhex("0x1.fffffffffffffp+1023"), 355.0, 22.0, 1e5, 6e5, 1e9,
         float.fromhex("0x1.921fb54442d18p+0"), float.fromhex("0x1.921fb54442d18p+1"), float.fromhex("0x1.921fb54442d18p-1"),
         float.fromhex("0x1.2d97c7f3321d2p+2"), 0.24999999, 0.25000001, 1e-300, 1e-5]


def between(low, high):
    return [random.uniform(low, high) for _ in range(COUNT)]


def of_size(low, high):
    return [2.0 ** random.uniform(low, high) for _ in range(COUNT)]


ARGUMENTS = {
    "exp": between(-700, 700) + between(-1, 1) + [709.782712893384, -708.3, -745.1, 1e-10],
    "exp2": between(-1000, 1000) + between(-1, 1) + [1023.9999999999999, -1022.0000001, 1e-10],
    "expm1": between(-1, 1) + between(-0.1, 0.1) + [1e-300, -1e-10, 0.0625, -0.0625, 30, 700, -40],
    "log": of_size(-1070, 1020) + between(0.9, 1.1) + [1 + 2.0 ** -52, 1 - 2.0 ** -53, 0.69999, 1.39, 5e-324],
    "log2": of_size(-1070, 1020) + between(0.9, 1.1) + [1 + 2.0 ** -52, 1 - 2.0 ** -53, 3e-310],
    "log10": of_size(-1070, 1020) + between(0.9, 1.1) + [1 + 2.0 ** -52, 1 - 2.0 ** -53, 3e-310],
    "log1p": between(-0.01, 0.01) + between(-1, 3) + [1e-300, -1e-17, 2.0 ** -9, 1e20, -1 + 2.0 ** -53],
    "cbrt": of_size(-1070, 1020) + between(-1, 8) + [5e-324, 1e-310],
    "erf": between(-1, 1) + between(0, 6) + [0.5, 0.49999999, 1e-300, 5.9],
    "sin": between(-4, 4) + TURNS, "cos": between(-4, 4) + TURNS, "tan": between(-4, 4) + TURNS,
    "asin": between(-1, 1) + [1e-300, 0.9999999999999999, -0.125, 1],
    "acos": between(-1, 1) + [1e-300, 0.9999999999999999, -0.9999999999999999, 0.99999],
    "atan": between(-2, 2) + of_size(-30, 80) + [1e-300, 0.1171875, 0.11718749],
    "pow": list(zip(between(0, 2), between(-50, 50))) + list(zip(between(0.999, 1.001), between(-5e5, 5e5))) +
           list(zip(of_size(-1000, 1000), between(-1, 1))) + [(0.5, 1073.5), (1 + 2.0 ** -52, 2.0 ** 61), (5e-324, 0.3), (-1.5, 7.0), (-2.5, -3.0)],
    "atan2": list(zip(between(-1, 1), between(-1, 1))) + list(zip(of_size(-1000, 1000), of_size(-1000, 1000))) +
             [(1e-310, 3e-310), (1e308, -1.7e308), (1e-300, -1e300), (-1.0, -1e-300)],
    "hypot": list(zip(between(-1, 1), between(-1, 1))) + [(1e308, 1.2e308), (3e-310, 4e-309), (1e-200, 1e-201), (1.0, 1e-9), (1e300, 1e-300)],
}


def unit_of(value):
    """The unit of the last place of the double nearest to the value."""
    return mpf(2) ** max(mpmath.frexp(value)[1] - 53, -1074)


print("// SPDX-License-Identifier: Apache-2.0\n// Made by hard_arguments.py.")
for name, arguments in ARGUMENTS.items():
    for each in arguments:
        pair = each if isinstance(each, tuple) else (each,)
        result = FUNCTIONS.get(name, getattr(mpmath, name, None))(*map(mpf, pair))
        unit = unit_of(result)
        nearest = mpmath.nint(result / unit) * unit  # mpmath rounds subnormal numbers twice
        second = float(pair[1]).hex() if len(pair) == 2 else "0"
        print(f"{{Function::{name}_of, {float(pair[0]).hex()}, {second}, {float(nearest).hex()}, {float((result - nearest) / unit):.4f}}},")
