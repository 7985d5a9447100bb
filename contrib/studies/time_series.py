#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Columns of the time series of runs against time, as SVG.

usage: time_series.py OUT.svg TITLE RUN:COLUMN[:LABEL] ..., as in
       time_series.py flow.svg "Flow out" results/fsi:flow_rate_outlet:elastic results/fsi-rigid:flow_rate_outlet:rigid
"""
import csv
import pathlib
import sys

from plot import write_svg


def read_column(run, name):
    """Points (time, value) of a column, its name and its unit."""
    with open(pathlib.Path(run) / "timeseries.csv", newline="") as file:
        titles, *rows = csv.reader(file)
    names = [title.split(" ")[0] for title in titles]
    if name not in names:
        sys.exit(f"{run} has no column '{name}', but {', '.join(names)}")
    column = names.index(name)
    return [(float(row[0]), float(row[column])) for row in rows], titles[column]


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    out, title, *wanted = sys.argv[1:]
    curves, units = [], set()
    for text in wanted:
        run, name, *label = text.split(":")
        points, heading = read_column(run, name)
        curves.append((label[0] if label else heading, points, False))
        units.add(heading.partition(" ")[2])
    write_svg(pathlib.Path(out), title, "time [s]", " ".join(sorted(units)), curves,
              labels_right=True)


if __name__ == "__main__":
    main()
