# SPDX-License-Identifier: Apache-2.0
"""Starts a contestant: a process of its own that answers with one line of JSON."""
import dataclasses
import json
import os
import pathlib
import shutil
import subprocess
import sys

TIMEOUT = 900  # seconds; none comes near
PEERS = pathlib.Path(__file__).resolve().parent.parent / "peers"


@dataclasses.dataclass
class Contestant:
    name: str
    command: list  # program and what selects its algorithm; the task's flags follow
    settings: dict = dataclasses.field(default_factory=dict)  # flags that are its own
    rounds: int = 1000  # at most: slow peers sit some rounds out

    def available(self):
        return shutil.which(self.command[0]) is not None


class Failed(Exception):
    pass


class Stable:
    """All contestants, and the settings that their processes share."""

    def __init__(self, build, target, instructions):
        self.instructions = instructions  # sets of them that the processor has
        self.bin = pathlib.Path(build) / "bin"
        self.target = target
        self.environment = quiet_environment()
        self.failures = []  # names of contestants that gave no answer

    def ours(self, name, **settings):
        if self.target:
            settings["target"] = self.target
        return Contestant(name, [str(self.bin / "bench_ours")], settings)

    def ours_by_avx2(self, name, **settings):
        """The same with AVX2 forced, as on the many processors without AVX-512; none when it is forced already."""
        if self.target or "avx512f" not in self.instructions:
            return []
        return [self.ours(name + ", AVX2 forced", target="avx2", **settings)]

    def program(self, name, program, rounds=1000, **settings):
        return Contestant(name, [str(self.bin / "peers" / program)], settings, rounds)

    def python(self, name, script, rounds=1000, **settings):
        return Contestant(name, [sys.executable, str(PEERS / script)], settings, rounds)

    def octave(self, name, rounds=1000, **settings):
        command = ["octave-cli", "--norc", "--no-history", str(PEERS / "octave_peer.m")]
        return Contestant(name, command, settings, rounds)

    def ask(self, contestant, task, **flags):
        words = [*contestant.command, task]
        for flag, value in {**flags, **contestant.settings}.items():
            words += ["--" + flag, str(value)]
        done = subprocess.run(
            words, env=self.environment, capture_output=True, text=True, check=False, timeout=TIMEOUT
        )
        if done.returncode != 0:
            raise Failed(f"{contestant.name}: {done.stderr.strip()[-500:]}")
        return json.loads(done.stdout.splitlines()[-1])


def quiet_environment():
    """One thread each, and no setting that makes OpenBLAS use slower kernels than the processor's best."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("OPENBLAS_", "OMP_", "GOTO_"))}
    environment.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", LC_ALL="C.UTF-8")
    environment["PYTHONPATH"] = ""
    return environment
