# SPDX-License-Identifier: Apache-2.0
"""Several threads at once: the same answers as one after the other, and the lock of the interpreter is released."""
import os
import signal
import tempfile
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import etak
from support import work_folder

NM = np.arange(360.0, 831.0)


def everything(name):
    of = etak.read(name)
    n = of.n(NM, extrapolate=True)
    out = [etak.f0(name).rgb, etak.f0(n=np.tile(n, (50, 1)), wavelength=NM, threads=2),
           etak.fresnel(name, [1, 0.5, 0], form="f82"), n]
    out.append(np.array([etak.f0(name).spread.count, len(etak.library), len(etak.validate("textures", threads=2))]))
    return out


class Threads(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        work_folder(folder.name)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def test_eight_threads_give_what_one_gives(self):
        names = ["gold", "silver", "copper", "silicon", "water", "glass_bk7", "diamond", "chromium"] * 4
        one = [everything(name) for name in names[:8]]
        with ThreadPoolExecutor(8) as pool:
            many = list(pool.map(everything, names))
        for i, each in enumerate(many):
            for mine, expected in zip(each, one[i % 8]):
                np.testing.assert_array_equal(mine, expected)

    def test_errors_in_threads_are_those_of_their_own_call(self):
        def fails(i):
            try:
                etak.f0(n=[[1.5, 1.5]] * i + [[-1, 1.5]], wavelength=[380, 780])
            except etak.Error as error:
                return str(error)

        with ThreadPoolExecutor(8) as pool:
            for i, text in enumerate(pool.map(fails, range(200))):
                self.assertEqual(text, f"n[{i}]: n = -1 at 380 nm; expected 0 <= n <= 10000")

    def test_packs_into_folders_of_their_own(self):
        with ThreadPoolExecutor(4) as pool:
            packed = list(pool.map(lambda i: etak.pack("materials.json", f"atlas{i}", threads=2), range(8)))
        self.assertEqual([p.materials for p in packed], [2] * 8)
        self.assertTrue(all(p.layout == packed[0].layout for p in packed))

    def test_other_threads_of_python_run_while_etak_computes(self):
        n = np.full((20000, 471), 1.5)
        ticks, done = [], threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.001)

        ticker = threading.Thread(target=tick)
        ticker.start()
        begin = time.perf_counter()
        etak.f0(n=n, wavelength=NM, threads=1)
        end = time.perf_counter()
        done.set()
        ticker.join()
        self.assertGreater(sum(begin < t < end for t in ticks), 5, f"in {end - begin:.3f} s")

    def test_an_interrupt_stops_a_batch(self):
        n = np.broadcast_to(np.full(471, 1.5), (20000, 471)).copy()
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                for _ in range(1000):
                    etak.f0(n=n, wavelength=NM)
        finally:
            timer.cancel()

    def test_an_array_that_another_thread_changes_does_no_harm(self):
        n = np.full((2000, 471), 1.5)
        done = threading.Event()

        def change():
            while not done.is_set():
                n[::7, ::3] = np.nan
                n[::7, ::3] = 2.0

        changer = threading.Thread(target=change)
        changer.start()
        try:
            for _ in range(20):
                try:
                    out = etak.f0(n=n, wavelength=NM)
                    self.assertEqual(out.shape, (2000, 3))
                except etak.Error as error:
                    self.assertIn("nan", str(error))
        finally:
            done.set()
            changer.join()


if __name__ == "__main__":
    unittest.main()
