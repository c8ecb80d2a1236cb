# SPDX-License-Identifier: Apache-2.0
"""What takes part in the benchmark: zraka, and each of its rivals in a file of its own."""
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Measured:
    """One run of one program with one scene."""
    render: float  # seconds, as the program itself says
    whole: float  # seconds of the process
    peak_bytes: int
    picture: Path
    details: dict = field(default_factory=dict)


class Rival:
    name = ""
    title = ""  # its name for people
    slow = False  # runs in fewer rounds
    program = ""  # that it needs, on the path or beside the other programs
    package = ""  # of Debian's, that brings it

    def __init__(self, programs, timeout):
        self.programs = Path(programs)
        self.timeout = timeout

    def path(self, program):
        own = self.programs / program
        return own if own.is_file() else shutil.which(program)

    def missing(self):
        """Why it cannot take part; None if it can."""
        return None if self.path(self.program) else f"{self.program} is not there (package {self.package})"

    def version(self):
        """As the package says."""
        package = self.package.split(",")[0]
        found = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True,
                               check=False).stdout if shutil.which("dpkg-query") else ""
        return f"{self.title} {found}".strip()

    def prepare(self, scene, folder):
        """Done once a scene, and not measured."""

    def run(self, scene, folder, threads):
        """Renders by the rules of `zraka render --profile spd`; gives Measured, or raises Failed."""
        raise NotImplementedError
