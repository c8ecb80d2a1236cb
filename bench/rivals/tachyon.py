# SPDX-License-Identifier: Apache-2.0
"""Tachyon, as Debian has it. It bends no rays, and draws cones as cylinders of their mean radius (write_tachyon.cpp):
of the Standard Procedural Databases it draws balls, lattice, rings, teapot and tetra in full, and tree nearly so."""
import re

from processes import Failed, last_words, run
from rivals.rival import Measured, Rival


class Tachyon(Rival):
    name = "tachyon"
    title = "Tachyon"
    slow = True
    program = "tachyon"
    package = "tachyon-bin-nox"

    def prepare(self, scene, folder):
        run([self.path("write_tachyon"), scene.file, self.translated(scene, folder), scene.width], self.timeout)

    def translated(self, scene, folder):
        return folder / f"{scene.file.stem}-{scene.width}.dat"

    def run(self, scene, folder, threads):
        picture = folder / f"{scene.file.stem}-{scene.width}-tachyon.png"
        picture.unlink(missing_ok=True)
        done = run([self.path("tachyon"), self.translated(scene, folder), "-o", picture, "-format", "PNG",
                    "-shade_phong", "-numthreads", threads], self.timeout)
        # It ends with 0 whatever went wrong.
        found = re.search(r"Ray Tracing Time:\s*([\d.]+) seconds", done.words)
        if not found or not picture.is_file():
            raise Failed(f"tachyon drew no picture of {scene.name}:\n{last_words(done.words)}")
        return Measured(float(found[1]), done.seconds, done.peak_bytes, picture)
