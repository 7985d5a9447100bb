#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cycle of a valve with different time steps: error of what a user reads off against seconds.

Errors are differences from the run with the shortest steps, from opening to closing: root mean square
and largest, relative to the largest value of the quantity.
"""
import sys
from math import sqrt

from study import Program, parse_arguments, table

CURVES = ("orifice_area", "tip_radius", "max_mipe", "strain_energy", "coaptation_area")
TIMES = ("opening_begins", "fully_open", "closing_begins", "closed", "coaptation_complete")
ELEMENTS = "12"
END = "0.36"  # after closing; what follows is at rest
FIXED = ("1e-4", "2e-4", "5e-4", "1e-3")
TOLERANCES = ("3e-4", "1e-3", "3e-3")


def run(program, **entries):
    return program.run("../../valve/structural-cycle", Valve__Elements_along=ELEMENTS,
                       Valve__Elements_across=ELEMENTS, Checkpoints__Wall_interval="0", Time__End_time=END, **entries)


def errors(curve, result, reference):
    """Root mean square and largest difference of a curve, relative to its largest value."""
    pairs = [(row[curve], other[curve]) for row, other in zip(result.rows, reference.rows)]
    scale = max(abs(b) for _, b in pairs)
    differences = [abs(a - b) / scale for a, b in pairs]
    return sqrt(sum(d * d for d in differences) / len(differences)), max(differences)


def main():
    program = Program(parse_arguments(__doc__).program)
    runs = []
    for step in FIXED:
        runs.append((f"fixed {step}", run(program, Time__Step=step)))
        print(runs[-1][0], runs[-1][1].cpu, file=sys.stderr, flush=True)
    for tolerance in TOLERANCES:
        runs.append((f"adaptive {tolerance}",
                     run(program, Time__Step="1e-4", Time__Largest_step="2e-2",
                         Time__Adaptive="true", Time__Error_tolerance=tolerance)))
        print(runs[-1][0], runs[-1][1].cpu, file=sys.stderr, flush=True)
    reference = runs[0][1]
    print(f"{ELEMENTS} x {ELEMENTS} elements a leaflet\n")
    header = ["step [s] or tolerance [cm]", "steps", "iterations", "rejected", "CPU [s]"]
    rows = []
    for name, result in runs:
        quantities = result.quantities
        row = [name, f"{quantities['steps']:.0f}", f"{result.iterations}",
               f"{quantities['rejected_steps']:.0f}", f"{result.cpu:.1f}"]
        for curve in CURVES:
            mean, largest = errors(curve, result, reference)
            row.append(f"{100 * mean:.2f} / {100 * largest:.1f}")
        rows.append(row)
    table(header + [f"{curve} [%]" for curve in CURVES], rows)
    table(["step or tolerance", *(f"{time} [ms]" for time in TIMES), "largest MIPE",
           "numerically lost / work in"],
          [[name, *(f"{1e3 * result.quantities.get(time, float('nan')):.2f}" for time in TIMES),
            f"{result.quantities['max_mipe_over_time']:.4f}",
            f"{result.quantities['numerically_lost'] / result.quantities['work_in']:.4f}"]
           for name, result in runs])


if __name__ == "__main__":
    main()
