#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Profiles of a leaflet in its plane of symmetry at some times of a run, as SVG.

usage: leaflet_profiles.py RUN TIMES_MS OUT.svg, as in
       leaflet_profiles.py results/fsi-rigid 0,15,20,25,60,240 opening.svg
"""
import csv
import pathlib
import sys
from math import atan2, cos, sin

from plot import write_svg


def read_profiles(path):
    """{time in s: [(distance from the axis, height)] in cm}, negative across the axis."""
    profiles = {}
    with open(path, newline="") as file:
        rows = csv.reader(file)
        next(rows)
        for time, x, y, z, _ in (map(float, row) for row in rows):
            profiles.setdefault(time, []).append((x, y, z))
    x, y, _ = profiles[min(profiles)][0]  # the attached edge
    angle = atan2(y, x)
    return {time: [(x * cos(angle) + y * sin(angle), z) for x, y, z in points]
            for time, points in profiles.items()}


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    run, times, out = sys.argv[1:]
    profiles = read_profiles(pathlib.Path(run) / "profile.csv")
    curves = []
    for milliseconds in times.split(","):
        time = min(profiles, key=lambda t: abs(t - 1e-3 * float(milliseconds)))
        curves.append((f"{1e3 * time:.0f} ms", profiles[time], False))
    write_svg(pathlib.Path(out), "Leaflet in its plane of symmetry", "distance from the axis [cm]",
              "height [cm]", curves)


if __name__ == "__main__":
    main()
