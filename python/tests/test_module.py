# SPDX-License-Identifier: Apache-2.0
"""What the module does with good arguments and with bad ones."""

import os
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

try:
    import numpy as np
except ImportError:
    print("there is no NumPy", file=sys.stderr)
    sys.exit(1)

import zraka

def small_scene(width=60, height=40):
    scene = zraka.Scene(width, height)
    scene.camera((1, 1, 5))
    scene.light((2, 4, 3))
    scene.material(color=(0.8, 0.3, 0.1), reflection=0.3)
    scene.spheres([[0, 0, 0], [1, 0.5, 0], [-1, 0.25, 0.5]], [0.5, 0.4, 0.3])
    return scene


class Pictures(unittest.TestCase):
    def test_shapes_and_types(self):
        scene = small_scene()
        image = scene.render()
        self.assertEqual((image.shape, image.dtype), ((40, 60, 3), np.float32))
        self.assertGreater(image.max(), 0)
        self.assertEqual(scene.render(dtype=np.uint8).dtype, np.uint8)
        clear = scene.render(transparent=True)
        self.assertEqual(clear.shape, (40, 60, 4))
        self.assertEqual((clear[0, 0, 3], clear[20, 30, 3]), (0, 1))
        self.assertTrue(scene._repr_png_().startswith(b"\x89PNG"))
        self.assertEqual(len(scene), 3)

    def test_arrays_of_all_layouts_make_one_picture(self):
        centers = np.random.default_rng(1).uniform(-1, 1, (50, 3)).astype(np.float32)
        hashes = set()
        padded = np.zeros((100, 7))
        padded[::2, 1:7:2] = centers
        for points in (
            centers,
            centers.astype(float),
            np.asfortranarray(centers),
            padded[::2, 1:7:2],
            centers[::-1][::-1],
            centers.tolist(),
            centers.astype(">f4"),
        ):
            scene = zraka.Scene(40, 40)
            scene.light((2, 4, 3))
            scene.spheres(points, 0.1)
            hashes.add(zraka.sha256(scene.render()))
        self.assertEqual(len(hashes), 1)

    def test_one_hash_by_python_toml_and_the_program(self):
        scene = small_scene()
        expected = zraka.sha256(scene.render())
        text = scene.to_toml()
        self.assertEqual(zraka.sha256(zraka.loads(text).render()), expected)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.toml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            self.assertEqual(zraka.sha256(zraka.load(path).render()), expected)
            if not os.path.exists(os.path.join(os.environ["ZRAKA_BUILD"], "zraka")):
                self.skipTest("the program is not built")
            picture = os.path.join(folder, "picture.png")
            said = subprocess.run(
                [sys.executable, "-m", "zraka", "render", path, "-o", picture, "--stats"],
                capture_output=True, text=True, check=True,
            )
            self.assertIn(expected, said.stdout)

    def test_nff_has_the_hash_of_the_program(self):
        path = os.path.join(os.environ["ZRAKA_SOURCE"], "scenes", "nff", "benzene.nff")
        scene = zraka.load(path)
        scene.resolution = (32, 32)
        again = zraka.loads(scene.to_toml())
        self.assertEqual(zraka.sha256(scene.render()), zraka.sha256(again.render()))

    def test_a_renderer_gives_what_the_scene_does(self):
        scene = small_scene()
        renderer = zraka.Renderer(scene)
        self.assertTrue(np.array_equal(renderer.render(), scene.render()))
        scene.camera((4, 1, 2), (0, 0, 0))
        self.assertTrue(np.array_equal(renderer.render((4, 1, 2)), scene.render()))

    def test_outlines(self):
        scene = small_scene()
        plain, drawn = scene.render(), scene.render(outlines=1)
        changed = np.any(plain != drawn, axis=2)
        self.assertTrue(0.01 < changed.mean() < 0.3)
        self.assertTrue(np.all(drawn[changed] == 0))
        self.assertTrue(np.array_equal(zraka.Renderer(scene).render(outlines=1), drawn))
        with self.assertRaisesRegex(ValueError, "outlines: "):
            scene.render(outlines=-1)

    def test_layers(self):
        layers = small_scene().layers(["depth", "object-id"])
        ids = layers["objectId.X"]
        self.assertEqual((ids.shape, ids.dtype), ((40, 60), np.uint32))
        self.assertEqual(set(np.unique(ids)), {0, 1, 2, 3})
        self.assertIn("Z", layers)

    def test_explains(self):
        explained = small_scene().explain(30, 20)
        self.assertIn("sphere", str(explained))
        self.assertIsInstance(explained.data, dict)

    def test_progress_and_interrupts(self):
        scene = small_scene(300, 300)
        told = []
        scene.render(samples=64, progress=lambda done, of: told.append((done, of)))
        self.assertEqual(told[-1], (90000, 90000))
        self.assertEqual(told, sorted(told))

        def fail(done, of):
            raise KeyError("from the callback")

        with self.assertRaises(KeyError):
            scene.render(samples=64, progress=fail)

        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            scene.render(samples=60000)
        # 0.2 s is what a free machine needs; tests run side by side.
        self.assertLess(time.monotonic() - start, 3)

    def test_other_threads_run_meanwhile(self):
        scene, counted = small_scene(200, 200), [0]
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        scene.render(samples=64)
        stop.set()
        thread.join()
        self.assertGreater(counted[0], 1)

    def test_large_arrays_are_kept_and_make_the_picture_that_copies_make(self):
        n = 120_000
        rng = np.random.default_rng(2)
        points = rng.uniform(-1, 1, (n, 3)).astype(np.float32)
        colors = rng.integers(0, 3, (n, 3)) / 2

        def with_spheres(add):
            scene = zraka.Scene(50, 50)
            scene.light((2, 4, 3))
            scene.sphere((0.5, 0.5, 0.5), 0.3)
            add(scene)
            scene.sphere((-0.5, 0.5, 0.5), 0.3, material=0)
            return scene

        def in_parts(scene):
            for i in range(0, n, 40_000):
                scene.spheres(points[i : i + 40_000], 0.01, colors=colors[i : i + 40_000])

        kept = with_spheres(lambda scene: scene.spheres(points, 0.01, colors=colors))
        copied = with_spheres(in_parts)
        self.assertEqual(len(kept), n + 2)
        for _ in range(2):
            self.assertEqual(zraka.sha256(kept.render()), zraka.sha256(copied.render()))
        self.assertTrue(np.array_equal(zraka.Renderer(kept).render(), copied.render()))
        ids = [scene.layers(["object-id"])["objectId.X"] for scene in (kept, copied)]
        self.assertTrue(np.array_equal(*ids))
        self.assertEqual(kept.explain(25, 25).data["pixel"], copied.explain(25, 25).data["pixel"])

        points[7, 1] += 1
        with self.assertRaises(ValueError) as caught:
            kept.render()
        self.assertEqual(
            str(caught.exception),
            "centers, radii or colors of 120000 spheres were changed after they had been added to the scene, "
            "which keeps large arrays as they are (add a copy: scene.spheres(centers.copy(), …))",
        )
        points[7, 1] -= 1
        self.assertEqual(zraka.sha256(kept.render()), zraka.sha256(copied.render()))

    def test_large_scenes_take_64_bytes_a_sphere(self):
        code = """
import numpy as np, zraka
n = 1_000_000
points = np.random.default_rng(0).random((n, 3), dtype=np.float32)
def field(name):
    return next(int(line.split()[1]) for line in open("/proc/self/status") if line.startswith(name)) * 1024
try:
    open("/proc/self/clear_refs", "w").write("5")
except OSError:
    print("no")
    raise SystemExit
before = field("VmRSS")
scene = zraka.Scene(512, 512)
scene.light((5, 10, 7))
scene.spheres(points, 0.003)
scene.render()
print((field("VmHWM") - before) / n)
"""
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        if said.stdout.strip() == "no":
            self.skipTest("the peak of memory cannot be set back here")
        self.assertLess(float(said.stdout), 66)  # 62 to 63, and what the allocator has not given back

    def test_importing_needs_no_numpy(self):
        said = subprocess.run(
            [sys.executable, "-c", "import zraka, sys; print('numpy' in sys.modules)"],
            capture_output=True, text=True, check=True,
        )
        self.assertEqual(said.stdout.strip(), "False")


class Errors(unittest.TestCase):
    def refuse(self, text, call):
        with self.assertRaises(ValueError) as caught:
            call()
        self.assertEqual(str(caught.exception), text)

    def test_name_the_argument_what_was_expected_and_what_came(self):
        scene = zraka.Scene(20, 20)
        spheres = scene.spheres
        self.refuse(
            "centers: expected numbers of shape (n, 3), got shape (5, 2) of float64",
            lambda: spheres(np.zeros((5, 2))),
        )
        self.refuse(
            "centers: expected numbers of shape (n, 3), got shape (5, 3) of complex128",
            lambda: spheres(np.zeros((5, 3), complex)),
        )
        self.refuse(
            "radii: expected numbers of shape (5,), got shape (4,) of float64",
            lambda: spheres(np.zeros((5, 3)), np.ones(4)),
        )
        self.refuse(
            "radii[1] is -1: expected a finite number greater than 0",
            lambda: spheres(np.zeros((2, 3)), [1, -1]),
        )
        self.refuse(
            "radii: expected a number greater than 0, or one for each shape, got -2",
            lambda: spheres(np.zeros((2, 3)), -2),
        )
        self.refuse(
            "centers[0, 2] is nan: expected a finite number",
            lambda: spheres([[0, 0, float("nan")]]),
        )
        self.refuse(
            "colors: expected numbers of shape (1, 3), got shape (2, 3) of float64",
            lambda: spheres([[0, 0, 0]], colors=np.ones((2, 3))),
        )
        self.refuse(
            "corners[0, 1, 2] is inf: expected a finite number",
            lambda: scene.triangles([[[0, 0, 0], [0, 0, float("inf")], [1, 0, 0]]]),
        )
        self.refuse(
            "material: expected a whole number from 0 to 0, got 1",
            lambda: spheres([[0, 0, 0]], material=1),
        )
        self.refuse(
            "eye: expected numbers of shape (3,), got 'left'", lambda: scene.camera("left")
        )
        self.refuse(
            "x: expected a whole number from 0 to 19, got 20", lambda: scene.explain(20, 0)
        )
        self.refuse("width: expected a whole number from 1 to 1048576, got 0", lambda: zraka.Scene(0))
        self.refuse(
            'dtype: expected "float32" or "uint8"', lambda: scene.render(dtype="float64")
        )
        self.assertEqual(len(scene), 0)
        with self.assertRaisesRegex(ValueError, "scene:1:"):
            zraka.loads("[camra]")
        with self.assertRaisesRegex(ValueError, "no-such.toml"):
            zraka.load("no-such.toml")

    def test_random_wrong_calls_raise_and_nothing_more(self):
        scene = zraka.Scene(8, 8)
        scene.light((1, 2, 3))
        scene.material()
        rng = random.Random(24)
        nan, inf = float("nan"), float("inf")
        good = [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]
        odd = [
            None, "word", b"bytes", 3, -1, 2.5, nan, -inf, 10**400, object(), {}, [], [[]], [1], [1, 2],
            [[1, 2, 3], [4, 5]], [[nan, 0, 0], [0, 0, 0]], [[1e308, inf, 0], [0, 0, 0]],
            np.zeros((0, 3)), np.zeros((2, 3), complex), np.zeros((2, 3), bool), np.zeros((2, 3), "U1"),
            np.zeros((2, 3, 3, 1)), np.full((2, 3), nan, np.float32), np.zeros((2, 4)), np.float16(1),
            np.zeros((2, 3), object), np.array(1.0), np.zeros((2, 3), np.longdouble), scene, lambda: 0,
        ]
        calls = [
            (scene.spheres, ["centers", "radii", "colors", "material"]),
            (scene.cylinders, ["starts", "ends", "radii", "colors", "material"]),
            (scene.triangles, ["corners", "colors", "material"]),
            (scene.sphere, ["center", "radius", "material"]),
            (scene.camera, ["eye", "target", "fov", "up"]),
            (scene.light, ["position", "color"]),
            (scene.material, ["color", "ambient", "specular", "shininess", "reflection", "ior"]),
            (scene.render, ["samples", "depth", "threads", "transparent", "outlines", "progress", "dtype"]),
            (scene.explain, ["x", "y"]),
            (zraka.Scene, ["width", "height", "background", "ambient_light"]),
            (zraka.sha256, ["image"]),
        ]
        refused = 0
        for _ in range(500):
            call, names = rng.choice(calls)
            arguments = {
                name: good if rng.random() < 0.3 else rng.choice(odd)
                for name in names
                if rng.random() < 0.8
            }
            try:
                call(**arguments)
            except (ValueError, TypeError) as error:
                refused += 1
                self.assertTrue(str(error))
        self.assertGreater(refused, 250)
        # What was right, if anything, can still be drawn.
        scene.camera((0, 0, 9))
        scene.render()


if __name__ == "__main__":
    unittest.main()
