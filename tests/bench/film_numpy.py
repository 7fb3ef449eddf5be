# SPDX-License-Identifier: Apache-2.0
"""Films a second by numpy, for bench_film: characteristic matrices (Born and Wolf, Principles of Optics, section 1.6) of
arrays over wavelengths and a batch of films, the method that colour-science 0.4.7 documents for its multilayer_tmm.
Where colour-science itself is installed, its own function is measured too.

    film_numpy.py SECONDS < spectra     rows of nm, n of the film, n and k of the base; prints a line for each program
"""
import sys
import time

import numpy as np

rows = np.loadtxt(sys.stdin)
nm, film, base = rows[:, 0], rows[:, 1].astype(complex), rows[:, 2] + 1j * rows[:, 3]


def reflectance(thickness_nm):
    """R at normal incidence of films of these thicknesses, shape (films, wavelengths)."""
    turn = 2 * np.pi * film / nm * thickness_nm[:, None]
    down, up = np.cos(turn), -1j * np.sin(turn)
    electric = down + up / film * base
    magnetic = up * film + down * base
    r = (electric - magnetic) / (electric + magnetic)
    return r.real**2 + r.imag**2


def speed(work, batch):
    """Films a second."""
    done, begin = 0, time.perf_counter()
    while time.perf_counter() - begin < float(sys.argv[1]):
        work(np.arange(done, done + batch) % 400.0)
        done += batch
    return done / (time.perf_counter() - begin)


for d in (0.0, 100.0, 300.0):  # against the recursion from the base outwards
    way = np.exp(4j * np.pi * film * d / nm)
    above, below = (1 - film) / (1 + film), (film - base) / (film + base)
    assert np.allclose(reflectance(np.array([d]))[0], abs((above + below * way) / (1 + above * below * way)) ** 2)
batch, best = max(((b, speed(reflectance, b)) for b in (1, 8, 64)), key=lambda each: each[1])
print(f"numpy {np.__version__}, one thread, {batch} films at a time: {best:.0f} films/s")
try:
    from colour import __version__
    from colour.phenomena import multilayer_tmm
except ImportError:
    print("colour-science is not installed (it is no package of Debian 12)")
else:
    n = np.stack([np.ones_like(film), film, base])
    each = speed(lambda ds: [multilayer_tmm(n, [d], nm) for d in ds], 8)
    print(f"colour-science {__version__}, one film at a time: {each:.0f} films/s")
