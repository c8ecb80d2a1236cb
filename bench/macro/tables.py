# SPDX-License-Identifier: Apache-2.0
"""Tables, for terminals and for Markdown."""
from contest import geometric_mean, ratio


def show(title, header, rows, markdown):
    """The first column is words, the others are numbers."""
    cells = [header, *rows]
    if markdown:
        lines = ["| " + " | ".join(row) + " |" for row in cells]
        lines.insert(1, "|---" + "|--:" * (len(header) - 1) + "|")
        print(f"{title}\n\n" + "\n".join(lines) + "\n")
        return
    widths = [max(len(row[i]) for row in cells) for i in range(len(header))]
    print(title)
    for row in cells:
        print("  " + "  ".join(cell.ljust(w) if i == 0 else cell.rjust(w)
                               for i, (cell, w) in enumerate(zip(row, widths))).rstrip())
    print()


def ms(seconds):
    return f"{seconds * 1000:.1f}"


def factor(value):
    return f"{value:.2f}" if value < 10 else f"{value:.0f}"


def spread(result):
    """Median and, if there are more runs than one, lowest and highest."""
    low, high = result.range()
    return ms(result.render()) + (f" ({ms(low)}–{ms(high)})" if len(result.runs) > 1 else "")


def contest_tables(scenes, outcome, contenders, markdown):
    """`outcome` holds the results of each scene, by its name."""
    rivals = contenders[1:]
    header = ["scene", "M rays", "zraka, ms"]
    for rival in rivals:
        header += [f"{rival.title}, ms", "×"]
    rows, wholes, pictures = [], [], []
    ratios = {rival.name: [] for rival in rivals}
    for scene in scenes:
        results = outcome[scene.name]
        ours = results["zraka"]
        if not ours.runs:
            rows.append([scene.name, "", "failed"] + [""] * (2 * len(rivals)))
            continue
        row = [scene.name, f"{sum(ours.runs[-1].details['rays'].values()) / 1e6:.2f}", spread(ours)]
        whole, picture = [scene.name, ms(ours.whole())], [scene.name]
        for rival in rivals:
            result = results[rival.name]
            if not result.runs:
                row += ["failed", ""]
                whole.append("failed")
                picture.append("none")
                continue
            times = ratio(results, rival.name)
            row += [spread(result), factor(times) if result.agrees() else f"({factor(times)})"]
            whole.append(ms(result.whole()))
            picture.append(f"{100 * result.different:.2f} %")
            if result.agrees():
                ratios[rival.name].append(times)
        rows.append(row)
        wholes.append(whole)
        pictures.append(picture)
    mean, least = ["geometric mean", "", ""], ["least", "", ""]
    for rival in rivals:
        counted = ratios[rival.name]
        mean += ["", factor(geometric_mean(counted)) if counted else ""]
        least += ["", factor(min(counted)) if counted else ""]
    show("Render alone, medians (lowest–highest); × is the rival's time over zraka's, in brackets where the picture "
         "is another and the ratio counts in no mean:", header, rows + ([mean, least] if rivals else []), markdown)
    show("Whole process, ms, medians:", ["scene", *(c.title for c in contenders)], wholes, markdown)
    if rivals:
        show("Pixels that differ from ours by more than 16/255:", ["scene", *(r.title for r in rivals)], pictures,
             markdown)
    return {name: geometric_mean(counted) if counted else None for name, counted in ratios.items()}
