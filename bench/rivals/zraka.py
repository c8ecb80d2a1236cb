# SPDX-License-Identifier: Apache-2.0
"""zraka itself."""
import json
import re

from processes import run
from rivals.rival import Measured, Rival


class Zraka(Rival):
    name = "zraka"
    title = "zraka"
    program = "zraka"

    def __init__(self, program, timeout):
        super().__init__(program.parent, timeout)

    def words(self):
        return run([self.path("zraka"), "--version"], self.timeout).out

    def version(self):
        return self.words().split("\n")[0]

    def instruction_sets(self):
        return re.search(r"this machine has: (.*)", self.words())[1].split()

    def generate(self, name, size, file):
        run([self.path("zraka"), "generate", name, "--size", size, "-o", file], self.timeout)

    def run(self, scene, folder, threads, more=()):
        picture = folder / f"{scene.file.stem}-{scene.width}-zraka.png"
        done = run([self.path("zraka"), "render", scene.file, "-o", picture, "--profile", "spd", "--width", scene.width,
                    "--threads", threads, "--stats=json", "--quiet", *more], self.timeout)
        details = json.loads(done.out)
        return Measured(details["seconds"]["render"], done.seconds, done.peak_bytes, picture, details)
