# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C is heard in time by every function that may take long, and what arrays of the caller throw passes through."""
import json
import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy as np

import etak
from support import PROGRAM

NM = np.arange(360.0, 831.0)


class Interrupts(unittest.TestCase):
    def late(self, call, after=0.15):
        """The seconds from Ctrl-C to KeyboardInterrupt, of a call that would take far longer."""
        sent = []

        def send():
            sent.append(time.perf_counter())
            os.kill(os.getpid(), signal.SIGINT)

        timer = threading.Timer(after, send)
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                call()
                timer.join()
                time.sleep(1)
            return time.perf_counter() - sent[0]
        finally:
            timer.cancel()

    def assert_heard(self, call, within=0.2):
        # The best of up to three: other work on the machine makes them later.
        took = [self.late(call)]
        while min(took) >= within and len(took) < 3:
            took.append(self.late(call))
        self.assertLess(min(took), within)

    def test_functions_of_arrays_hear_it_within_a_fifth_of_a_second(self):
        cosines = np.linspace(0, 1, 10**7)
        for form in ("exact", "f82"):
            with self.subTest(form):
                self.assert_heard(lambda: [etak.fresnel("gold", cosines, form=form) for _ in range(50)])
        n = np.broadcast_to(np.full(471, 1.5), (20000, 471)).copy()
        for method in ("1nm", "exact"):
            with self.subTest(method):
                self.assert_heard(lambda: [etak.f0(n=n, wavelength=NM, method=method) for _ in range(1000)])
        of, at = etak.read("glass_bk7"), np.linspace(400, 700, 10**7)
        self.assert_heard(lambda: [of.n(at) for _ in range(1000)])
        colors = np.full((10**6, 3), 0.5)
        self.assert_heard(lambda: [etak.delta_e(colors, colors / 2) for _ in range(1000)])
        self.assert_heard(lambda: etak.eval("schlick", f0=0.04, cos=cosines))

    def test_lists_of_names_hear_it_within_a_fifth_of_a_second(self):
        mine = [etak.dataset(NM, n=np.full(471, 1.5)) for _ in range(20000)]
        self.assert_heard(lambda: [etak.f0(mine) for _ in range(10)])
        self.assert_heard(lambda: [etak.f0(["gold", "silver"] * 10000) for _ in range(100)])
        self.assert_heard(lambda: [etak.f0(["gold"] * 10**6) for _ in range(10)])
        self.assert_heard(lambda: etak.export(["gold"] * 100000, "mtlx"))
        self.assert_heard(lambda: etak.choose(["gold", "silver", "iron"] * 50, roughness=0.3), 0.5)
        self.assert_heard(lambda: etak.choose(["gold"] * 10**6, roughness=0.3))
        self.assert_heard(lambda: [etak.validate(["nowhere.png"] * 10**6) for _ in range(10)])
        self.assert_heard(lambda: etak.validate([f"no_{i}.png" for i in range(10**5)], only=["ETK101"] * 10**6))

    def test_opening_a_library_hears_it_between_two_files(self):
        shown = subprocess.run([PROGRAM, "show", "gold", "--format", "json"], capture_output=True, text=True, check=True)
        material = json.loads(shown.stdout)["material"]
        material["aliases"] = []
        material.pop("alias_notes", None)
        with tempfile.TemporaryDirectory() as folder:
            for i in range(3000):
                material["id"], material["name"] = f"m{i}", f"M {i}"
                Path(folder, f"m{i}.json").write_text(json.dumps(material))
            for use in (len, lambda l: l["m5"], lambda l: etak.f0("m5", library=l),
                        lambda l: etak.nearest("#ffe49c", library=l), lambda l: etak.validate("nowhere", library=l)):
                self.assert_heard(lambda: use(etak.Library(folder)), 0.5)
            whole = etak.Library(folder)  # one whose opening was interrupted can be opened again
            self.late(lambda: len(whole))
            self.assertEqual(len(whole), len(etak.library) + 3000)

    def test_what_arrays_throw_passes_through(self):
        class Bad:
            def __init__(self, error):
                self.error = error

            def __array__(self, *_, **__):
                raise self.error

        for error in (KeyboardInterrupt, MemoryError, ZeroDivisionError, ValueError("mine")):
            for call in (lambda bad: etak.f0(n=bad, wavelength=[380, 780]),
                         lambda bad: etak.f0(n=[1, 1], wavelength=bad),
                         lambda bad: etak.fresnel("gold", bad), lambda bad: etak.read("gold").n(bad),
                         lambda bad: etak.dataset(bad, n=[1, 1]), lambda bad: etak.delta_e(bad, [1, 1, 1])):
                with self.subTest(error), self.assertRaises(type(error) if isinstance(error, ValueError) else error):
                    call(Bad(error))

    def test_arrays_beyond_memory_are_a_memory_error(self):
        big = np.broadcast_to(np.full(5, 1.5), (10**12, 5))
        at = np.broadcast_to(0.5, (10**14,))
        for call in (lambda: etak.f0(n=big, wavelength=[380, 480, 580, 680, 780]), lambda: etak.fresnel("gold", at),
                     lambda: etak.read("gold").n(at), lambda: etak.delta_e(np.broadcast_to(at[:, None], (10**14, 3)), [1, 1, 1])):
            with self.assertRaises(MemoryError):
                call()

    def test_an_array_that_another_thread_changes_is_checked_as_it_is_read(self):
        cosines = np.full(200000, 0.5)
        at = np.full(200000, 500.0)
        done = threading.Event()

        def change():
            while not done.is_set():
                cosines[::7], at[::7] = np.nan, np.nan
                cosines[::7], at[::7] = 0.6, 600.0

        changer = threading.Thread(target=change)
        changer.start()
        try:
            for call in (lambda: etak.fresnel("gold", cosines, form="f82"), lambda: etak.read("gold").n(at)):
                for _ in range(40):
                    try:
                        self.assertTrue(np.isfinite(call()).all())
                    except etak.Error as error:
                        self.assertIn("nan", str(error))
        finally:
            done.set()
            changer.join()


class Names(unittest.TestCase):
    def test_names_that_are_no_utf8_go_in_and_out(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.fsencode(folder) + b"/t\xe4ble.csv"
            Path(os.fsdecode(name)).write_text("wavelength (nm),n,k\n380,1.5,0\n780,1.5,0\n")
            text = os.fsdecode(name)
            for asked in (text, Path(text)):
                answer = etak.f0(asked)
                self.assertEqual((answer.name, answer.hex), (text, "#383838"))
                repr(answer).encode(), str(answer).encode(), answer._repr_html_().encode()
                self.assertEqual(etak.f0([asked])[0].name, text)
                self.assertEqual(etak.read(asked).n(500), 1.5)
            picture = os.fsdecode(os.fsencode(folder) + b"/\xff_specular.png")
            Path(picture).write_bytes(b"no picture")
            report = etak.validate(picture)
            self.assertEqual(report[0].path, picture)
            self.assertEqual(report.files[0].path, picture)
            for each in (repr(report), repr(report[0]), repr(report.files[0]), str(report), report.form("json")):
                each.encode()
            with self.assertRaisesRegex(etak.Error, r"\\xff"):
                etak.f0(text.replace("\udce4", "\udcff"))
            with self.assertRaises(UnicodeEncodeError):
                etak.f0("\ud800")


if __name__ == "__main__":
    unittest.main()
