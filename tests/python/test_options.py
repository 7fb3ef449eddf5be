# SPDX-License-Identifier: Apache-2.0
"""Every option of the command line that changes an answer is a keyword of the same name."""
import inspect
import re
import subprocess
import unittest

import etak
from support import PROGRAM

# What is about files of output, messages and lists of inputs has no counterpart: a program has values for them.
ABOUT_THE_PROGRAM = set("""help help_all files_from format output out quiet verbose stats color progress jobs input_timeout
    follow_links list_files list_rules report page_report page_link batch watch
    shard batch_report cache_stats cache_report sort""".split())
VERBS = {"plot": "curve"}  # where a function has not the name of its verb
NOT_IN_PYTHON = {
    "curve": {"force", "integration", "class", "scale", "straight", "dark"},  # these of the file are of plot()
    "plot": {"integration", "class"},
    # `bands` are columns of a file; F0.band is always there.
    "f0": {"stdin_format", "allow_empty", "all", "all_datasets", "force", "integration", "class", "sweep", "bands"},
    "validate": {"changed_since", "min_severity", "mask", "fix", "cache_key", "max_warnings", "exit_zero",
                 "write_baseline", "force"},
    "pack": {"no_validate", "cache", "cache_key", "cache_size"},  # validate=False
    "choose": {"all", "measure", "write_costs", "force", "dataset", "unit", "columns", "duplicates", "class", "origin"},
}
ONLY_IN_PYTHON = {
    "curve": {"materials", "material_class"},
    "plot": {"materials", "file", "material_class"},
    "f0": {"material", "material_class", "n", "k", "wavelength", "reflectance", "threads"},
    "validate": {"paths", "threads", "progress"},
    "pack": {"input", "output", "validate", "threads", "progress"},
    "choose": {"materials", "threads", "progress"},
}


def options(verb):
    text = subprocess.run([PROGRAM, verb, "--help-all"], capture_output=True, text=True, check=True).stdout
    text = re.sub(r"^Bare rectangles:\n(?:  .*\n)*", "", text, flags=re.MULTILINE)  # another task: sizes, no materials
    names = re.findall(r"^  ((?:-\w,)?--[a-z0-9,-]+)", text, re.MULTILINE)
    return {word.replace("-", "_") for each in names for word in re.findall(r"--([a-z0-9-]+)", each)}


def keywords(verb):
    names = {p.name for p in inspect.signature(getattr(etak, verb)).parameters.values() if p.kind != p.VAR_KEYWORD}
    return names | (set(etak.pack_settings()) if verb == "pack" else set())


class Options(unittest.TestCase):
    def test_options_are_keywords(self):
        for verb, without in NOT_IN_PYTHON.items():
            with self.subTest(verb):
                theirs = options(VERBS.get(verb, verb))
                self.assertEqual(without - theirs, set(), "these are no options")
                expected = theirs - without - ABOUT_THE_PROGRAM
                self.assertEqual(keywords(verb) - ONLY_IN_PYTHON[verb], expected)


if __name__ == "__main__":
    unittest.main()
