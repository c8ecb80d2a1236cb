# SPDX-License-Identifier: Apache-2.0
"""Growth with the number of shapes, scaling over threads, and a scene too large for caches."""
import statistics

import scenes
from contest import Result, contest
from tables import factor, ms, show


def thousands(number):
    return f"{number:,}".replace(",", " ")


def rays_of(run):
    return sum(run.details["rays"].values())


def shapes_of(scene):
    """Counted in the file, where each shape of the generators begins a line."""
    with open(scene.file, "rb") as file:
        return sum(line[:2] in (b"s ", b"c ", b"p ") for line in file)


def growth(words, contenders, zraka, folder, options):
    """Time per ray as the spheres grow tenfold; the spheres fill the same share of the same cube."""
    rows, record, before = [], [], {}
    for word in words:
        scene = scenes.from_word(word, zraka, folder)
        results = contest(scene, contenders, folder, options)
        row = [scene.name, thousands(shapes_of(scene))]
        for contender in contenders:
            result = results[contender.name]
            if not result.runs:
                row += ["failed", "", ""]
                continue
            build = statistics.median(r.details["seconds"]["build"] for r in result.runs)
            per_ray = result.render() / rays_of(result.runs[-1])
            last = before.get(contender.name)
            before[contender.name] = per_ray
            row += [ms(build), f"{per_ray * 1e9:.1f}", factor(per_ray / last) if last else ""]
            record.append({"scene": scene.name, "program": contender.name, "build": build, "seconds_per_ray": per_ray})
        rows.append(row)
    header = ["scene", "shapes"]
    for contender in contenders:
        header += [f"{contender.title}: build, ms", "ns a ray", "growth"]
    show("Growth: time per ray, and how many times that of the row above:", header, rows, options.markdown)
    return record


def scaling(chosen, zraka, folder, options):
    """Speed-up over one thread."""
    counts, rows, record = [1], [], []
    while counts[-1] * 2 < options.threads:
        counts.append(counts[-1] * 2)
    if options.threads > 1:
        counts.append(options.threads)
    for scene in chosen:
        results = {count: Result() for count in counts}
        for _ in range(options.rounds):
            for count in counts:
                results[count].runs.append(zraka.run(scene, folder, count))
        alone = results[1].render()
        rows.append([scene.name] + [f"{ms(r.render())} ({factor(alone / r.render())}×)" for r in results.values()])
        record += [{"scene": scene.name, "threads": count, "render": r.render()} for count, r in results.items()]
    show("Scaling: render in ms, and the speed-up over one thread:",
         ["scene"] + [f"{count} thread{'s' if count > 1 else ''}" for count in counts], rows, options.markdown)
    return record


def large(word, contenders, zraka, folder, options):
    """Load, build and render of one large scene, and the most memory that the process took."""
    scene = scenes.from_word(word, zraka, folder)
    shapes = shapes_of(scene)
    results = contest(scene, contenders, folder, options)
    rows, record = [], []
    for contender in contenders:
        result = results[contender.name]
        if not result.runs:
            rows.append([contender.title, "failed"] + [""] * 6)
            continue

        def median(value):
            return statistics.median(value(r) for r in result.runs)
        steps = [median(lambda r, s=step: r.details["seconds"][s]) for step in ("load", "build", "render")]
        peak = median(lambda r: r.peak_bytes)
        kept = sum(result.runs[-1].details["bytes"].values())
        rows.append([contender.title, *(f"{s:.2f}" for s in steps), f"{sum(steps):.2f}", f"{peak / 1e6:.0f}",
                     f"{peak / shapes:.0f}", f"{kept / shapes:.0f}"])
        record.append({"program": contender.name, "shapes": shapes, "load": steps[0], "build": steps[1],
                       "render": steps[2], "peak_bytes": peak, "scene_bytes": kept})
    show(f"{scene.name}, {thousands(shapes)} shapes, seconds (Embree reads with zraka's reader):",
         ["program", "load", "build", "render", "all", "peak, MB", "bytes a shape", "of them scene and hierarchy"],
         rows, options.markdown)
    return record
