# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the studies share: run a scene, read its results, print tables."""
import argparse
import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SCENES = ROOT / "prm" / "benchmarks" / "shell"
HARD = ROOT / "prm" / "hard" / "shell"
RESULTS = ROOT / "doc" / "results"


class Run:
    """Results of a finished run."""

    def __init__(self, summary, rows, deviations):
        self.quantities = {name: q["value"] for name, q in summary["quantities"].items()}
        self.phases = summary["phases"]
        self.iterations = summary["cost"]["newton_iterations"]
        self.unknowns = summary["cost"]["unknowns"]
        self.cpu = summary["cost"].get("cpu_s", math.nan)
        self.version = summary["version"]
        self.rows = rows  # of timeseries.csv, by the names of the columns without units
        self.deviations = deviations  # of deviation.csv, the quantity among them
        self.references = {name: q["reference"] for name, q in summary["quantities"].items()
                           if q.get("reference") is not None}


class Program:
    """The semilunar program."""

    def __init__(self, path):
        self.path = path

    def run(self, scene, may_give_up=False, scenes=SCENES, **entries):
        """Run a scene of the folder. Entries: Section__Entry_name="value", a space for each underscore."""
        with tempfile.TemporaryDirectory() as folder:
            command = [self.path, str(scenes / f"{scene}.prm"), "--output", folder, "--quiet"]
            for name, value in entries.items():
                command += ["--set", f"{name.replace('__', '/').replace('_', ' ')}={value}"]
            finished = subprocess.run(command, stderr=subprocess.PIPE, text=True)
            gave_up = may_give_up and finished.returncode == 2
            if finished.returncode != 0 and not gave_up:
                sys.exit(f"{' '.join(command)}\n{finished.stderr}")
            summary = Path(folder) / "summary.json"
            empty = {"quantities": {}, "phases": {}, "version": "",
                     "cost": {"newton_iterations": math.nan, "unknowns": 0}}
            return Run(json.loads(summary.read_text()) if summary.exists() else empty,
                       read_rows(Path(folder) / "timeseries.csv"),
                       read_deviations(Path(folder) / "deviation.csv"))


def read_rows(path):
    with open(path) as file:
        reader = csv.reader(file)
        names = [name.split(" [")[0] for name in next(reader)]
        return [dict(zip(names, map(float, row))) for row in reader]


def read_deviations(path):
    if not path.exists():
        return []
    with open(path) as file:
        return [{name: text if name == "quantity" else float(text) for name, text in row.items()}
                for row in csv.DictReader(file)]


def table(header, rows):
    """Print a table in markdown."""
    print("| " + " | ".join(header) + " |")
    print("|" + "---|" * len(header))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def limit(coarse, middle, fine):
    """Richardson's limit of three values on meshes refined by the same factor."""
    first, second = middle - coarse, fine - middle
    if first == second:
        return fine
    return fine - second * second / (second - first)


def order(coarse_error, fine_error):
    """Observed order for a refinement by two; a dash where the errors are no longer regular."""
    if coarse_error * fine_error <= 0.0:
        return "-"
    return f"{math.log2(coarse_error / fine_error):.1f}"


def parse_arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("program", help="path of the semilunar program")
    parser.add_argument("--iga", type=Path, help="folder of .iga files to compare with")
    parser.add_argument("--quick", action="store_true", help="leave out what takes minutes")
    return parser.parse_args()
