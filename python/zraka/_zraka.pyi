# SPDX-License-Identifier: Apache-2.0
from typing import Any, Callable, Literal, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

_Color = float | ArrayLike
_Progress = Callable[[int, int], object]

class Scene:
    resolution: tuple[int, int]
    def __init__(
        self, width: int = 400, height: int = 400, *, background: _Color = 0, ambient_light: _Color = 0.2
    ) -> None: ...
    def camera(
        self, eye: ArrayLike, target: ArrayLike = (0, 0, 0), *, fov: float = 40, up: ArrayLike = (0, 1, 0)
    ) -> None: ...
    def light(self, position: ArrayLike, color: _Color = 1) -> None: ...
    def material(
        self,
        *,
        color: _Color = 0.7,
        ambient: _Color | None = None,
        specular: _Color = 0,
        shininess: float = 10,
        reflection: _Color = 0,
        refraction: _Color = 0,
        ior: float = 1,
    ) -> int: ...
    def sphere(self, center: ArrayLike, radius: float = 1, *, material: int = 0) -> None: ...
    def spheres(
        self, centers: ArrayLike, radii: ArrayLike = 1, *, colors: ArrayLike | None = None, material: int = 0
    ) -> None: ...
    def cylinders(
        self,
        starts: ArrayLike,
        ends: ArrayLike,
        radii: ArrayLike = 1,
        *,
        colors: ArrayLike | None = None,
        material: int = 0,
    ) -> None: ...
    def triangles(self, corners: ArrayLike, *, colors: ArrayLike | None = None, material: int = 0) -> None: ...
    def render(
        self,
        *,
        samples: int | None = None,
        depth: int | None = None,
        threads: int | None = None,
        transparent: bool = False,
        outlines: int = 0,
        progress: _Progress | None = None,
        dtype: Literal["float32", "uint8"] | type = "float32",
    ) -> NDArray[Any]: ...
    def layers(self, names: Sequence[str]) -> dict[str, NDArray[Any]]: ...
    def explain(self, x: int, y: int) -> Explanation: ...
    def to_toml(self) -> str: ...
    def _repr_png_(self) -> bytes: ...
    def __len__(self) -> int: ...

class Renderer:
    def __init__(self, scene: Scene) -> None: ...
    def render(
        self,
        eye: ArrayLike | None = None,
        target: ArrayLike = (0, 0, 0),
        *,
        fov: float = 40,
        up: ArrayLike = (0, 1, 0),
        samples: int | None = None,
        depth: int | None = None,
        threads: int | None = None,
        transparent: bool = False,
        outlines: int = 0,
        progress: _Progress | None = None,
        dtype: Literal["float32", "uint8"] | type = "float32",
    ) -> NDArray[Any]: ...

class Explanation:
    @property
    def data(self) -> dict[str, Any]: ...

def load(path: str) -> Scene: ...
def loads(text: str) -> Scene: ...
def sha256(image: NDArray[np.float32]) -> str: ...
def write_image(image: ArrayLike, path: str) -> None: ...
