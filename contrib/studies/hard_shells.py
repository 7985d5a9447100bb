#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Static shells that are hard to solve: what they promise and what comes out."""
from study import HARD, Program, parse_arguments, table

CASES = ["very-thin-shell", "fung-25-percent", "snap-through", "distorted-mesh", "refined-mesh",
         "near-degenerate-element", "buckling-leaflet"]
# entries that make a case harder still
HARDER = [
    ("very-thin-shell", "R/h = 20,000", {"Shell__Thickness": "0.0005",
                                         "Loads__Edge_loads": "x=0: (0, -0.0003125, 0)"}),
    ("very-thin-shell", "R/h = 20,000, tolerance 1e-5",
     {"Shell__Thickness": "0.0005", "Loads__Edge_loads": "x=0: (0, -0.0003125, 0)",
      "Solver__Tolerance": "1e-5"}),
    ("very-thin-shell", "one load step", {"Solver__Load_steps": "1"}),
    ("fung-25-percent", "one load step", {"Solver__Load_steps": "1"}),
    ("near-degenerate-element", "hole of 1e-10", {"Surface__Annulus__Radii": "1e-10, 1"}),
    ("snap-through", "one load step", {"Solver__Load_steps": "1"}),
]


def row(name, note, run):
    if not run.quantities:
        return [name, note, "gave up", "", "", str(len(run.rows)), "", ""]
    known = {q: (run.quantities[q], r) for q, r in run.references.items()}
    if not known:
        known = {"orifice_area": (run.quantities["orifice_area"], None)}
    value = "; ".join(f"{q} = {v:.6g}" for q, (v, _) in known.items())
    error = "; ".join("-" if r is None else f"{abs(v / r - 1):.1e}" for v, r in known.values())
    return [name, note, value, "; ".join("-" if r is None else f"{r:g}" for _, r in known.values()),
            error, str(len(run.rows)), str(run.iterations), f"{run.cpu:.2g}"]


def main():
    program = Program(parse_arguments(__doc__).program)
    rows = [row(case, "as in the scene", program.run(case, scenes=HARD, may_give_up=True))
            for case in CASES]
    rows += [row(case, note, program.run(case, scenes=HARD, may_give_up=True, **entries))
             for case, note, entries in HARDER]
    table(["scene", "change", "value", "reference", "relative error", "steps", "iterations",
           "CPU [s]"], rows)


if __name__ == "__main__":
    main()
