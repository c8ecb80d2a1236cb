# SPDX-License-Identifier: Apache-2.0
"""A Whitted ray tracer: exact to the bit, and able to say why each pixel has its colour.

    import zraka

    scene = zraka.Scene(400, 300)
    scene.camera((3, 2, 4))
    scene.light((2, 4, 3))
    scene.spheres([[0, 0, 0], [1, 0, 0]], 0.5, colors=[[1, 0.2, 0.1], [0.1, 0.4, 1]])
    image = scene.render()  # a NumPy array, (300, 400, 3), linear light
    print(scene.explain(200, 150))
"""

from ._zraka import (
    Explanation,
    Renderer,
    Scene,
    __version__,
    load,
    loads,
    sha256,
    write_image,
)

__all__ = [
    "Explanation",
    "Renderer",
    "Scene",
    "__version__",
    "load",
    "loads",
    "sha256",
    "write_image",
]
