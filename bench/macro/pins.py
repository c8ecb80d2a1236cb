# SPDX-License-Identifier: Apache-2.0
"""Pictures' hashes that are known: a speed that changes pixels is no speed."""
import json
from pathlib import Path

from processes import write_whole

FILE = Path(__file__).resolve().parent.parent / "pins.json"


def read():
    return json.loads(FILE.read_text()) if FILE.exists() else {}


def complaint(scene, picture, pins):
    """What is wrong with a picture's hash; None if nothing is, or nothing is known."""
    known = pins.get(scene.name)
    if not scene.pinned or known is None or known["picture"] == picture:
        return None
    if known["scene"] != scene.digest():
        return None  # another scene has another picture: a generator or a C library has changed
    return (f"{scene.name}: the picture has changed, its hash is {picture[:16]}… and not {known['picture'][:16]}…; "
            "if that is meant, run again with --pin")


def write(pictures):
    """Adds or replaces the hashes of these scenes: pairs of scene and picture's hash."""
    pins = read()
    for scene, picture in pictures:
        if scene.pinned:
            pins[scene.name] = {"scene": scene.digest(), "picture": picture}
    write_whole(FILE, json.dumps(dict(sorted(pins.items())), indent=2) + "\n")
