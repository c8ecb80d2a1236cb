# SPDX-License-Identifier: Apache-2.0
"""Runs each example of docs/python.md by itself."""

import contextlib
import io
import os
import re
import sys
import tempfile
import unittest

try:
    import numpy  # noqa: F401
except ImportError:
    print("there is no NumPy", file=sys.stderr)
    sys.exit(1)


class Examples(unittest.TestCase):
    def test_all_run(self):
        path = os.path.join(os.environ["ZRAKA_SOURCE"], "docs", "python.md")
        with open(path, encoding="utf-8") as file:
            blocks = re.findall(r"^```python\n(.*?)^```$", file.read(), re.M | re.S)
        self.assertEqual(len(blocks), 10)
        before = os.getcwd()
        for number, block in enumerate(blocks, 1):
            with self.subTest(number=number), tempfile.TemporaryDirectory() as folder:
                os.chdir(folder)
                try:
                    with contextlib.redirect_stdout(io.StringIO()):
                        exec(compile(block, f"example {number}", "exec"), {"__name__": "example"})
                finally:
                    os.chdir(before)


if __name__ == "__main__":
    unittest.main()
