#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large displacements of St. Venant-Kirchhoff and inflated shells: load paths against the reference
curves that come with the scenes, on several meshes, with plots."""
from plot import write_svg
from study import RESULTS, SCENES, Program, order, parse_arguments, table

# name, scene, what the curve is, meshes (degree and elements), published or exact
CASES = [
    ("Cantilever, end shear", "cantilever", "exact (elastica)",
     ((3, "8,2"), (3, "16,2"), (3, "32,2"))),
    ("Cantilever, end moment", "cantilever-moment", "exact",
     ((3, "12,2"), (3, "24,2"), (3, "48,2"))),
    ("Slit annular plate", "slit-annulus", "published", ((5, "2,16"), (5, "4,24"), (5, "4,32"))),
    ("Hemisphere, hole of 18 degrees", "pinched-hemisphere-large", "published",
     ((3, "16,16"), (3, "32,32"), (4, "24,24"))),
    ("Pinched semi-cylinder", "pinched-semicylinder", "published", ((3, "16,16"), (3, "24,24"),
                                                                    (3, "32,32"))),
    ("Hinged roof, h = 6.35", "hinged-roof", "published", ((3, "4,4"), (3, "8,8"), (3, "16,16"))),
    ("Balloon, Mooney-Rivlin", "balloon", "exact membrane", ((3, "4,4"), (3, "8,8"))),
    ("Tube, Fung", "cylinder-inflation", "exact membrane", ((3, "4,1"), (3, "8,2"))),
    ("Circular membrane, Fung", "circular-membrane", "exact membrane",
     ((3, "8,4"), (3, "16,4"), (3, "32,4"))),
]
SLOW = [("Pinched cylinder, diaphragms", "pinched-cylinder-large", "published", ((3, "32,32"),))]
VARIANTS = [
    ("Balloon, neo-Hookean", "balloon", "balloon-neo-hookean",
     {"Shell__Material": "neo-Hookean", "Solver__Stop_at": "equator_ux: 30"}),
    ("Balloon, Fung", "balloon", "balloon-fung",
     {"Shell__Material": "Fung", "Loads__Pressure": "-102209.346", "Solver__Method": "Newton"}),
    ("Tube, neo-Hookean", "cylinder-inflation", "cylinder-inflation-neo-hookean",
     {"Shell__Material": "neo-Hookean", "Loads__Pressure": "-3960.9375"}),
    ("Circular membrane, St. Venant-Kirchhoff", "circular-membrane", "circular-membrane-svk",
     {"Shell__Material": "Saint Venant-Kirchhoff"}),
    ("Cantilever, end shear, published (S4R)", "cantilever", "cantilever-sze", {}),
]


def percent(value, digits=".2g"):
    return f"{100 * value:{digits}} %"


def row(name, mesh, run):
    q = run.quantities
    return [name, mesh, str(run.unknowns), str(len(run.rows)), str(run.iterations),
            f"{q['points_compared']:.0f}", percent(q["largest_deviation"]),
            percent(q["mean_deviation"]), percent(q["points_within_1_percent"], ".0f"),
            f"{run.cpu:.2g}"]


HEADER = ["problem", "mesh", "equations", "steps", "iterations", "points", "largest deviation",
          "mean", "points within 1 %", "CPU [s]"]


def column(name):
    return name.lstrip("-"), -1.0 if name.startswith("-") else 1.0


def draw(name, scene, run):
    """The path as a line and the reference points as marks."""
    series = []
    for quantity in dict.fromkeys(d["quantity"] for d in run.deviations):
        probe, sign = column(quantity)
        path = [(0.0, 0.0)] + [(sign * r[probe], r["load_factor"]) for r in run.rows]
        points = [(d["reference"], d["load_factor"]) for d in run.deviations
                  if d["quantity"] == quantity]
        series += [(quantity, path, False), ("reference", points, True)]
    write_svg(RESULTS / f"{scene}.svg", name, "displacement", "load factor", series)


def compare(program, cases):
    rows, finest = [], []
    for name, scene, kind, meshes in cases:
        for degree, elements in meshes:
            run = program.run(scene, Surface__Degree=degree, Surface__Elements=elements)
            rows.append(row(f"{name} ({kind})", f"degree {degree}, {elements.replace(',', ' x ')}",
                            run))
        draw(name, scene, run)
        finest.append((name, run))
    table(HEADER, rows)
    return finest


def points(finest):
    """Every point of the published problems, on the finest mesh."""
    for name, run in finest:
        print(f"#### {name}\n")
        quantities = list(dict.fromkeys(d["quantity"] for d in run.deviations))
        rows, loads = {}, []
        for d in run.deviations:
            key = d["load_factor"]
            if key not in loads:
                loads.append(key)
            rows.setdefault(key, {})[d["quantity"]] = d
        table(["load factor"] + [text for q in quantities for text in (q, "reference", "deviation")],
              [[f"{key:g}"] + [text for q in quantities for d in [rows[key][q]] for text in
                               (f"{d['value']:.4f}", f"{d['reference']:g}",
                                f"{100 * d['deviation']:.2f} %")] for key in loads])


def orders(program):
    """Self-convergence of smooth problems: theory says 2 (p - 1) for displacements."""
    rows = []
    for scene, quantity, meshes in (("cantilever", "end_uz", ("8,2", "16,2", "32,2", "64,2")),
                                    ("pinched-hemisphere-large", "inward_uy",
                                     ("8,8", "16,16", "32,32"))):
        for degree in (2, 3, 4):
            values = [program.run(scene, Surface__Degree=degree, Surface__Elements=mesh,
                                  Solver__Load_steps=2,
                                  Output__Reference_curve="").quantities[quantity]
                      for mesh in meshes]
            changes = [b - a for a, b in zip(values, values[1:])]
            rows.append([scene, str(degree)] + [f"{v:.6f}" for v in values] +
                        [""] * (4 - len(values)) +
                        [", ".join(order(a, b) for a, b in zip(changes, changes[1:]))])
    table(["scene", "degree", "values, elements doubled each time", "", "", "",
           "order of the differences"], rows)


def main():
    arguments = parse_arguments(__doc__)
    program = Program(arguments.program)
    print("### Load paths against reference curves\n")
    finest = compare(program, CASES + ([] if arguments.quick else SLOW))
    rows = []
    for name, scene, reference, entries in VARIANTS:
        run = program.run(scene, Output__Reference_curve=SCENES / "reference" / f"{reference}.csv",
                          **entries)
        rows.append(row(name, "as in the scene", run))
    table(HEADER, rows)
    print("### Orders\n")
    orders(program)
    print("### Points\n")
    points([(name, run) for name, run in finest if name not in ("Balloon, Mooney-Rivlin",)])


if __name__ == "__main__":
    main()
