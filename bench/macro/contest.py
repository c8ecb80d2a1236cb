# SPDX-License-Identifier: Apache-2.0
"""zraka and its rivals take turns with each scene."""
import json
import math
import statistics
import sys
from dataclasses import dataclass, field

from processes import Failed, run

# Rivals whose picture differs in more than this share of the pixels did other work; they count in no mean.
AGREES = 0.05


@dataclass
class Result:
    """All runs of one contender with one scene."""
    runs: list = field(default_factory=list)
    different: float = 0.0  # share of pixels that differ from ours by more than 16/255
    failure: str = ""

    def render(self):
        return statistics.median(r.render for r in self.runs)

    def whole(self):
        return statistics.median(r.whole for r in self.runs)

    def range(self):
        return min(r.render for r in self.runs), max(r.render for r in self.runs)

    def agrees(self):
        return bool(self.runs) and self.different <= AGREES


def say(words):
    print(words, file=sys.stderr, flush=True)


def check_bits(zraka, scene, folder, threads, complaints):
    """Renders with every instruction set, one thread, and small tiles: the picture's hash has to be one. Gives it."""
    sets = zraka.instruction_sets()
    runs = {f"{name}": (threads, ("--isa", name)) for name in sets}
    runs["1 thread"] = (1, ())
    runs["tiles of 8"] = (threads, ("--tile", "8"))
    hashes = {}
    for what, (count, words) in runs.items():
        measured = zraka.run(scene, folder, count, words)
        if words[:1] == ("--isa",) and measured.details["isa"] != what:
            complaints.append(f"{scene.name}: asked for {what}, zraka took {measured.details['isa']}")
        hashes[what] = measured.details["sha256"]
    scene.learn_height(measured.picture)
    if len(set(hashes.values())) > 1:
        complaints.append(f"{scene.name}: not the same bits everywhere: "
                          + ", ".join(f"{what} {value[:12]}" for what, value in hashes.items()))
    return hashes[sets[0]]


def difference(programs, ours, theirs, timeout):
    return json.loads(run([programs / "compare_pictures", ours, theirs], timeout).out)["different"]


def contest(scene, contenders, folder, options):
    """Results by contender's name; the first contender is zraka. In each round another one begins."""
    results = {c.name: Result() for c in contenders}

    def attempt(contender, work):
        try:
            return work()
        except Failed as failed:
            results[contender.name].failure = str(failed)
            say(f"{scene.name}: {failed}")
            return None

    for contender in contenders:
        attempt(contender, lambda: contender.prepare(scene, folder))
    for number in range(options.rounds):
        for i in range(len(contenders)):
            contender = contenders[(number + i) % len(contenders)]
            result = results[contender.name]
            if result.failure or (contender.slow and number >= options.slow_rounds):
                continue
            measured = attempt(contender, lambda: contender.run(scene, folder, options.threads))
            if measured is not None:
                result.runs.append(measured)
    ours = results[contenders[0].name]
    for contender in contenders[1:]:
        result = results[contender.name]
        if result.runs and ours.runs:
            share = attempt(contender, lambda: difference(options.programs, ours.runs[-1].picture,
                                                          result.runs[-1].picture, options.timeout))
            result.different = 1.0 if share is None else share
    return results


def ratio(results, name):
    """How many times as long as ours a rival's render takes."""
    return results[name].render() / results["zraka"].render()


def geometric_mean(values):
    return math.exp(sum(math.log(v) for v in values) / len(values))
