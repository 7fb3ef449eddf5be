#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes stacks.csv: reflectance and transmittance of layers on a base in 60 digits (mpmath), for test_stack.cpp.

The recursion here is the textbook's, by interface amplitudes, with nothing rearranged: at 80 digits nothing cancels.
"""
import random
import mpmath as mp

mp.mp.dps = 80


def root(z):
    r = mp.sqrt(z)
    return -r if mp.im(r) < 0 or (mp.im(r) == 0 and mp.re(r) < 0) else r


def shares(n0, layers, base, wavelength, cosine):
    """R_s, R_p and the unpolarised T."""
    media = [mp.mpc(n0, 0)] + [mp.mpc(n, k) for n, k, _ in layers] + [mp.mpc(*base)]
    q = mp.mpf(n0) ** 2 * (1 - mp.mpf(cosine) ** 2)
    steps = [root(m * m - q) for m in media]
    steps[0] = mp.mpf(n0) * mp.mpf(cosine)
    reflected, passed = [], []
    for polarisation in "sp":
        y = [s if polarisation == "s" else s / m ** 2 for s, m in zip(steps, media)]
        r, t = (y[-2] - y[-1]) / (y[-2] + y[-1]), 2 * y[-2] / (y[-2] + y[-1])
        for j in range(len(layers), 0, -1):
            phase = 2 * mp.pi * steps[j] * mp.mpf(layers[j - 1][2]) / mp.mpf(wavelength)
            above = (y[j - 1] - y[j]) / (y[j - 1] + y[j])
            under = 1 + above * r * mp.exp(2j * phase)
            t = 2 * y[j - 1] / (y[j - 1] + y[j]) * t * mp.exp(1j * phase) / under
            r = (above + r * mp.exp(2j * phase)) / under
        reflected.append(abs(r) ** 2)
        passed.append(mp.re(y[-1]) / mp.re(y[0]) * abs(t) ** 2)
    return reflected[0], reflected[1], (passed[0] + passed[1]) / 2


def digits(value):
    """25 digits; 0 for what a double cannot hold."""
    return "0" if value < mp.mpf("1e-300") else mp.nstr(value, 25)


rng = random.Random(38)


def clear():
    return rng.uniform(1, 3), 0.0


def metal():
    return rng.uniform(0.05, 4), rng.uniform(1, 8)


def absorbing():
    return rng.uniform(1, 3), 10 ** rng.uniform(-8, -1)


def medium():
    return rng.choice([clear, clear, metal, absorbing])()


def thin(count, media=medium, most=10000.0):
    out = []
    for _ in range(count):
        d = min(most, rng.choice([rng.uniform(0, 300), rng.uniform(0, 2000), 10 ** rng.uniform(-4, 3)]))
        most -= d
        out.append((*media(), d))
    return out


def cases():
    for count in range(1, 9):
        for _ in range(14):  # any media, any angle
            yield "any", rng.choice([1, 1.33]), thin(count), medium(), rng.choice([1, rng.uniform(0.05, 1)])
        for _ in range(6):  # nothing absorbs
            yield "clear", rng.choice([1, 1.5]), thin(count, clear), clear(), rng.choice([1, rng.uniform(0.05, 1)])
        for _ in range(5):  # all media differ by very little
            n0 = rng.choice([1, 1.33, 1.5])

            def near():
                return n0 + rng.choice([-1, 1]) * 10 ** rng.uniform(-12, -3), 0.0

            yield "matched", n0, thin(count, near), near(), rng.choice([1, rng.uniform(0.3, 1)])
        for _ in range(4):  # an opaque layer somewhere
            layers = thin(count, most=3000.0)
            at = rng.randrange(count)
            layers[at] = (*metal(), rng.uniform(2000, 6000))
            yield "opaque", 1, layers, medium(), rng.choice([1, rng.uniform(0.05, 1)])
        for _ in range(4):  # waves that tunnel: beyond the critical angle of some layer
            layers = thin(count, clear, 2000.0)
            at = rng.randrange(count)
            layers[at] = (rng.uniform(1, 1.3), 0.0, rng.uniform(10, 500))
            yield "frustrated", 1.8, layers, (rng.uniform(1.8, 2.5), 0.0), rng.uniform(0.1, 0.6)
        for _ in range(4):
            yield "grazing", rng.choice([1, 1.5]), thin(count), medium(), 10 ** rng.uniform(-8, -2)
        for _ in range(3):  # the base's critical angle, closely
            n0, n = 1.5, rng.uniform(1, 1.4)
            cosine = float(mp.sqrt(1 - (mp.mpf(n) / n0) ** 2))
            yield "critical", n0, thin(count, clear), (n, 0.0), cosine * (1 + rng.choice([-1, 1]) * 10 ** rng.uniform(-9, -4))
        for _ in range(3):  # thick, but coherent
            layers = thin(count, clear, 2000.0)
            layers[rng.randrange(count)] = (*clear(), 10 ** rng.uniform(4, 7))
            yield "thick", 1, layers, medium(), rng.choice([1, rng.uniform(0.3, 1)])


print("kind,n0,layers,n,k,wavelength,cos,reflectance_s,reflectance_p,transmittance")
for kind, n0, layers, base, cosine in cases():
    wavelength = rng.uniform(360, 830)
    s, p, t = shares(n0, layers, base, wavelength, cosine)
    text = " ".join(":".join(repr(float(v)) for v in layer) for layer in layers)
    passed = digits(t) if base[1] == 0 else ""
    print(f"{kind},{n0!r},{text},{base[0]!r},{base[1]!r},{wavelength!r},{cosine!r},{digits(s)},{digits(p)},{passed}")
