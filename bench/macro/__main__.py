# SPDX-License-Identifier: Apache-2.0
"""The macro benchmark: zraka beside its rivals, interleaved, on the same scenes. bench/run starts it."""
import argparse
import json
import os
import platform
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import pins  # noqa: E402
import scenes  # noqa: E402
import sections  # noqa: E402
from contest import check_bits, contest, say  # noqa: E402
from processes import Failed, write_whole  # noqa: E402
from rivals.embree import Embree, EmbreePoints, EmbreeSingle  # noqa: E402
from rivals.povray import PovRay  # noqa: E402
from rivals.tachyon import Tachyon  # noqa: E402
from rivals.zraka import Zraka  # noqa: E402
from tables import contest_tables  # noqa: E402

RIVALS = {rival.name: rival for rival in (Embree, EmbreeSingle, EmbreePoints, Tachyon, PovRay)}
USUAL_RIVALS = "embree,tachyon,povray"

EXAMPLES = """examples:
  bench/run                                            generated scenes, all rivals
  bench/run balls.nff gears.nff --rounds 9             the Standard Procedural Databases' own output, brought by you
  bench/run --scenes sphereflake:6 --rivals embree
  bench/run --growth --scaling --large                 instead of the contest
  bench/run --markdown --json times.json >table.md
  bench/run --micro --benchmark_filter=Sphere          the micro-benchmarks, with Google Benchmark's options
"""


def words_of(arguments):
    parser = argparse.ArgumentParser(prog="bench/run", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description="Times zraka beside Embree, Tachyon and POV-Ray: render seconds as each\n"
                                     "program tells them, in turns, by the rules of --profile spd.", epilog=EXAMPLES)
    parser.add_argument("files", nargs="*", metavar="SCENE.nff", help="scene files; without any, generated scenes")
    parser.add_argument("--scenes", help="generated scenes as NAME:SIZE@WIDTH, with commas between "
                        f"(default {scenes.USUAL} where no files are given)")
    parser.add_argument("--rivals", default=USUAL_RIVALS,
                        help=f"of {', '.join(RIVALS)} (default {USUAL_RIVALS}); '' for none")
    parser.add_argument("--rounds", type=int, default=5, help="how often each program runs (default 5)")
    parser.add_argument("--slow-rounds", type=int, default=2, help="the same for Tachyon and POV-Ray (default 2)")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)), help="default: all there are")
    parser.add_argument("--width", type=int, default=scenes.WIDTH, help="of the files' pictures (default 512)")
    parser.add_argument("--timeout", type=float, default=600, help="seconds that a program may take (default 600)")
    parser.add_argument("--growth", action="store_true", help="time per ray from 10³ to 10⁶ spheres")
    parser.add_argument("--scaling", action="store_true", help="one thread to all of them")
    parser.add_argument("--large", action="store_true", help="time and memory of a sphereflake of 5.4 million spheres")
    parser.add_argument("--quick", action="store_true", help="everything once and tiny, as a test")
    parser.add_argument("--markdown", action="store_true", help="tables for docs/performance.md")
    parser.add_argument("--json", metavar="FILE", help="write every run into a file")
    parser.add_argument("--folder", help="keep scenes and pictures there instead of throwing them away")
    parser.add_argument("--pin", action="store_true", help="from now on these pictures are right (bench/pins.json)")
    parser.add_argument("--zraka", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--programs", type=Path, required=True, help=argparse.SUPPRESS)
    words = parser.parse_args(arguments)
    for name in ("rounds", "slow_rounds", "threads", "width"):
        if getattr(words, name) < 1:
            parser.error(f"--{name.replace('_', '-')} is less than 1")
    words.rivals = [name for name in words.rivals.split(",") if name]
    for name in words.rivals:
        if name not in RIVALS:
            parser.error(f"'{name}' is no rival: there are {', '.join(RIVALS)}")
    if words.quick:
        words.rounds = words.slow_rounds = 1
    words.zraka, words.programs = words.zraka.resolve(), words.programs.resolve()
    return words


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.split(":")[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def warn_if_busy(words):
    busy = os.getloadavg()[0]
    if busy > 0.3 * words.threads and not words.quick:
        say(f"warning: this machine is busy (load {busy:.1f}): times will be too long, ratios less sure")
    return busy


def chosen_scenes(words, zraka, folder):
    found = [scenes.from_file(path, words.width) for path in words.files]
    listed = words.scenes if words.scenes is not None else scenes.QUICK if words.quick else scenes.USUAL
    if words.scenes is not None or not words.files:
        found += [scenes.from_word(word, zraka, folder) for word in listed.split(",") if word]
    names = [scene.name for scene in found]
    for name in names:
        if names.count(name) > 1:
            raise scenes.Unknown(f"{name} is asked for twice")
    return found


def taking_part(words, names):
    """Those of the rivals that are installed; says which are not."""
    rivals = []
    for name in names:
        rival = RIVALS[name](words.programs, words.timeout)
        reason = rival.missing()
        if reason is None:
            rivals.append(rival)
        else:
            say(f"without {rival.title}: {reason}")
    return rivals


def run_contest(words, zraka, folder, record):
    """Complaints about bits, pictures and failures."""
    complaints, outcome, pictures, known = [], {}, [], pins.read()
    contenders = [zraka, *taking_part(words, words.rivals)]
    found = chosen_scenes(words, zraka, folder)
    for scene in found:
        say(f"{scene.name} …")
        digest = check_bits(zraka, scene, folder, words.threads, complaints)
        pictures.append((scene, digest))
        if not words.pin:
            complaint = pins.complaint(scene, digest, known)
            complaints += [complaint] if complaint else []
        results = outcome[scene.name] = contest(scene, contenders, folder, words)
        complaints += [f"{scene.name}: {c.title} failed" for c in contenders if results[c.name].failure]
        if any(run.details["sha256"] != digest for run in results["zraka"].runs):
            complaints.append(f"{scene.name}: zraka's picture is not the same every time")
        if words.quick and "embree" in results and results["embree"].different > 0.01:
            complaints.append(f"{scene.name}: Embree's picture is another")
    record["means"] = contest_tables(found, outcome, contenders, words.markdown)
    record["contest"] = [
        {"scene": scene.name, "program": name, "different": result.different, "failure": result.failure,
         "runs": [{"render": r.render, "whole": r.whole, "peak_bytes": r.peak_bytes, **r.details} for r in result.runs]}
        for scene in found for name, result in outcome[scene.name].items()]
    if words.pin:
        pins.write(pictures)
    return complaints


def measure(words, zraka, folder):
    record = {"processor": processor(), "load": warn_if_busy(words), "threads": words.threads, "zraka": zraka.version(),
              "instruction_set": zraka.instruction_sets()[0],
              "rivals": [RIVALS[name](words.programs, words.timeout).version() for name in words.rivals]}
    print(f"{record['processor']}, {record['threads']} threads, {record['instruction_set']}; {record['zraka']}"
          + "".join(f"; {rival}" for rival in record["rivals"]) + "\n")
    complaints = []
    embree = [name for name in words.rivals if name == "embree"]
    if words.quick or not (words.growth or words.scaling or words.large):
        complaints += run_contest(words, zraka, folder, record)
    if words.growth or words.quick:
        steps = range(1, 3) if words.quick else range(3, 7)
        record["growth"] = sections.growth([f"spheres:{n}" + ("@64" if words.quick else "") for n in steps],
                                           [zraka, *taking_part(words, embree)], zraka, folder, words)
    if words.scaling or words.quick:
        record["scaling"] = sections.scaling(chosen_scenes(words, zraka, folder), zraka, folder, words)
    if words.large or words.quick:
        rivals = taking_part(words, ["embree-points"] if embree else [])
        record["large"] = sections.large("sphereflake:2@64" if words.quick else "sphereflake:7", [zraka, *rivals],
                                         zraka, folder, words)
    if words.json:
        write_whole(words.json, json.dumps(record, indent=2) + "\n")
    return complaints


def main():
    words = words_of(sys.argv[1:])
    zraka = Zraka(words.zraka, words.timeout)
    try:
        with tempfile.TemporaryDirectory(prefix="zraka-bench-") as temporary:
            folder = Path(words.folder or temporary).resolve()
            folder.mkdir(parents=True, exist_ok=True)
            complaints = measure(words, zraka, folder)
    except (Failed, scenes.Unknown, OSError) as problem:
        complaints = [str(problem)]
    except KeyboardInterrupt:
        return 130
    for complaint in complaints:
        say(f"error: {complaint}")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
