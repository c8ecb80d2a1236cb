# SPDX-License-Identifier: Apache-2.0
"""Runs a program and measures it from outside."""
import os
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass
from pathlib import Path


class Failed(Exception):
    """A program that did not do what it was asked for, and its last words."""


@dataclass
class Finished:
    seconds: float  # from start to end
    peak_bytes: int  # of its memory, as the system counts it
    out: str  # standard output
    words: str  # standard output and error


def write_whole(path, text):
    """Beside its name first, so that a file is never half written."""
    unfinished = Path(f"{path}.{os.getpid()}")
    unfinished.write_text(text)
    unfinished.replace(path)


def last_words(text, lines=4):
    found = [line for line in text.replace("\r", "\n").split("\n") if line.strip()]
    return "\n".join(found[-lines:])


def run(command, timeout, folder=None, environment=None):
    """Fails if the program cannot start, ends with another code than 0, or takes longer than `timeout` seconds."""
    command = [str(word) for word in command]
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        start = time.monotonic()
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=err, cwd=folder,
                                       env={**os.environ, **(environment or {})})
        except OSError as error:
            raise Failed(f"{command[0]} cannot be started: {error}") from error
        late = threading.Event()
        watch = threading.Timer(timeout, lambda: (late.set(), os.kill(process.pid, 9)))
        watch.start()
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
        watch.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0), err.seek(0)
        text = out.read().decode(errors="replace")
        words = text + err.read().decode(errors="replace")
    if late.is_set():
        raise Failed(f"{command[0]} took more than {timeout:g} s")
    if process.returncode != 0:
        raise Failed(f"{' '.join(command)} ended with code {process.returncode}:\n{last_words(words)}")
    return Finished(seconds, usage.ru_maxrss * 1024, text, words)
