# SPDX-License-Identifier: Apache-2.0
"""POV-Ray 3.7, as Debian has it: five levels, no threshold that ends rays early, no antialiasing (write_povray.cpp)."""
import re

from processes import Failed, last_words, run
from rivals.rival import Measured, Rival


class PovRay(Rival):
    name = "povray"
    title = "POV-Ray"
    slow = True
    program = "povray"
    package = "povray"

    def prepare(self, scene, folder):
        run([self.path("write_povray"), scene.file, self.translated(scene, folder), scene.width], self.timeout)

    def translated(self, scene, folder):
        return folder / f"{scene.file.stem}-{scene.width}.pov"

    def run(self, scene, folder, threads):
        picture = folder / f"{scene.file.stem}-{scene.width}-povray.png"
        # Rays go through the corners of pixels, as ours do. It may read and write in its folder and home only.
        done = run([self.path("povray"), f"+I{self.translated(scene, folder).name}", f"+O{picture.name}",
                    f"+W{scene.width + 1}", f"+H{scene.height + 1}", "-D", "-V", "-A", f"+WT{threads}", "+FN8",
                    "File_Gamma=1.0"], self.timeout, folder, {"HOME": str(folder)})
        found = re.search(r"Trace Time:.*\(([\d.]+) seconds\)", done.words)
        if not found:
            raise Failed(f"povray told no time for {scene.name}:\n{last_words(done.words)}")
        return Measured(float(found[1]), done.seconds, done.peak_bytes, picture)
