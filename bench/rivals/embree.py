# SPDX-License-Identifier: Apache-2.0
"""Our own renderer on Embree (rivals/embree/), by the same rules and with the same reader."""
import json

from processes import run
from rivals.rival import Measured, Rival


class Embree(Rival):
    name = "embree"
    title = "Embree"
    program = "embree_rival"
    package = "libembree-dev, then build again"
    options = ()

    def run(self, scene, folder, threads):
        picture = folder / f"{scene.file.stem}-{scene.width}-{self.name}.png"
        done = run([self.path(self.program), scene.file, "-o", picture, "--width", scene.width, "--threads", threads,
                    *self.options], self.timeout)
        details = json.loads(done.out)
        return Measured(details["seconds"]["render"], done.seconds, done.peak_bytes, picture, details)


class EmbreeSingle(Embree):
    """Ray by ray instead of sixteen at a time."""
    name = "embree-single"
    title = "Embree, ray by ray"
    options = ("--mode", "single")


class EmbreePoints(Embree):
    """Spheres as Embree's own points: built faster and smaller than callbacks, slower to trace."""
    name = "embree-points"
    title = "Embree, points"
    options = ("--spheres", "points")
