# SPDX-License-Identifier: Apache-2.0
"""python3 -m zraka is the program zraka, with its arguments."""

import os
import shutil
import sys


def program():
    """The program that was built with this package, else the one on PATH, else None."""
    built = os.path.join(os.path.dirname(__file__), "..", "..", "zraka")
    if os.path.isfile(built) and os.access(built, os.X_OK):
        return built
    return shutil.which("zraka")


def main():
    path = program()
    if path is None:
        sys.exit("zraka: the program is not installed: install the package zraka, or put it on PATH")
    os.execv(path, ["zraka", *sys.argv[1:]])


if __name__ == "__main__":
    main()
