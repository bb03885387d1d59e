# SPDX-License-Identifier: Apache-2.0
"""The machine, and the OpenBLAS kernels that are fastest for the peers on it."""
import os
import pathlib
import platform
import re
import subprocess
import sys

from bench.contestants import Failed


def describe():
    info = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    release = platform.freedesktop_os_release()
    compiler = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=False).stdout
    return {
        "processor": field(info, "model name"),
        "family_model": f"{field(info, 'cpu family')}/{field(info, 'model')}",
        "cores": os.cpu_count(),
        "system": release.get("PRETTY_NAME", platform.system()),
        "compiler": compiler.splitlines()[0] if compiler else "unknown",
        "load_at_start": round(os.getloadavg()[0], 2),
    }


def field(info, name):
    found = re.search(rf"^{name}\s*: (.*)$", info, re.MULTILINE)
    return found.group(1) if found else "unknown"


def flags():
    return set(field(pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), "flags").split())


def choose_blas(stable, folder):
    """Kernels that are fastest for the tuned GSL, used for all; OpenBLAS chooses by the processor's name."""
    candidates = [""]
    candidates += ["Haswell", "Zen"] if "avx2" in flags() else []
    candidates += ["SkylakeX"] if "avx512f" in flags() else []
    peer = stable.program("GSL", "gsl_tuned", variant="lm")
    if not peer.available():
        return "unknown"
    best = {}
    for _ in range(3):
        for core in candidates:
            stable.environment.pop("OPENBLAS_CORETYPE", None)
            if core:
                stable.environment["OPENBLAS_CORETYPE"] = core
            try:
                answer = stable.ask(
                    peer, "train", data=folder / "samples.csv", starts=folder / "starts.csv", epochs=20, seconds=0.1
                )
            except Failed as failure:
                print(f"   {failure}", file=sys.stderr)
                continue
            best[core] = min(best.get(core, (1e9, "")), (answer["ns"], answer["about"]["blas"]))
    core = min(best, key=lambda name: best[name][0])
    stable.environment.pop("OPENBLAS_CORETYPE", None)
    if core:
        stable.environment["OPENBLAS_CORETYPE"] = core
    return best[core][1] + ("" if core else " (its own choice)")
