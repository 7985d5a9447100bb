#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linear shell obstacle course: error against equations and seconds, for degrees and meshes."""
from plot import write_svg
from study import RESULTS, Program, limit, order, parse_arguments, table

# name, scene, quantity, reference; where the references come from is said in the scene files
CASES = [
    ("Scordelis-Lo roof", "scordelis-lo", "edge_uy", -0.3006),
    ("Pinched cylinder with diaphragms", "pinched-cylinder", "load_uy", -1.8248e-5),
    ("Pinched hemisphere, hole of 18 degrees", "pinched-hemisphere", "inward_uy", -0.0935),
    ("Pinched hemisphere, closed", "pinched-hemisphere-closed", "inward_uy", -0.0924),
    ("Square plate, simply supported", "plate-simply-supported", "centre_uz", 0.004062352661),
    ("Square plate, clamped", "plate-clamped", "centre_uz", 0.001265319088),
    ("Circular plate, clamped", "plate-circular", "centre_uz", 0.015625),
]
MESHES = (4, 8, 16, 32)
DEGREES = (2, 3, 4)

# name, scene for files, quantity, files, scene for patches, the same quantity there
IMPORTED = [
    ("Scordelis-Lo roof", "scordelis-lo-imported", "edge_uz",
     ("geoQuarterRoofR2", "geoQuarterRoofR4"), "scordelis-lo", "edge_uy"),
    ("Pinched cylinder with diaphragms", "pinched-cylinder-imported", "load_uz",
     ("geoOctantCylinderR2", "geoOctantCylinderR3"), "pinched-cylinder", "load_uy"),
    ("Pinched hemisphere, hole of 18 degrees", "pinched-hemisphere", "inward_uy",
     ("geoHemisphereR1", "geoHemisphereR3", "geoHemisphereR4"), "pinched-hemisphere", "inward_uy"),
    ("Tube under line load (not linear)", "cylinder-line-load-imported", "middle_uz",
     ("geoCylinderLineLoad",), "cylinder-line-load", "middle_uy"),
]
FINE = {"Surface__Elements": "32,32", "Surface__Degree": 4}


def seconds(run):
    return [f"{run.phases[name]:.3f}" for name in ("set-up", "assembly", "linear solver")]


def draw(name, scene, quantity, runs, end):
    """Errors against equations and against seconds of assembly and solution."""
    for what, label, cost in (
            ("equations", "equations", lambda run: run.unknowns),
            ("seconds", "seconds of assembly and linear solver",
             lambda run: run.phases["assembly"] + run.phases["linear solver"])):
        series = []
        for degree, of_degree in runs.items():
            points = [(cost(run), abs(run.quantities[quantity] / end - 1)) for run in of_degree]
            series.append((f"degree {degree}", [p for p in points if p[1] > 1e-9], False))
        write_svg(RESULTS / f"{scene}-{what}.svg", name, label, "relative error", series, True)


def converge(program, name, scene, quantity, reference):
    print(f"### {name}: `{quantity}`, reference {reference:g}\n")
    runs = {degree: [program.run(scene, Surface__Degree=degree, Surface__Elements=f"{n},{n}")
                     for n in MESHES] for degree in DEGREES}
    finest = [run.quantities[quantity] for run in runs[DEGREES[-1]][-3:]]
    end = limit(*finest)
    print(f"Limit of degree {DEGREES[-1]}: {end:.7g}\n")
    draw(name, scene, quantity, runs, end)
    rows = []
    for degree in DEGREES:
        errors = [run.quantities[quantity] - end for run in runs[degree]]
        for k, (n, run) in enumerate(zip(MESHES, runs[degree])):
            value = run.quantities[quantity]
            rows.append([str(degree), f"{n} x {n}", f"{run.unknowns}",
                         f"{value:.6g}", f"{100 * (value / reference - 1):+.3f} %",
                         f"{100 * errors[k] / end:+.5f} %",
                         "-" if k == 0 else order(errors[k - 1], errors[k]), *seconds(run)])
    table(["degree", "elements", "equations", "value", "to reference", "to limit", "order",
           "set-up [s]", "assembly [s]", "linear solver [s]"], rows)


def compare_files(program, folder):
    rows = []
    for name, scene, quantity, files, patch_scene, patch_quantity in IMPORTED:
        fine = program.run(patch_scene, **FINE).quantities[patch_quantity]
        for file in files:
            run = program.run(scene, Surface__Source="iga",
                              Surface__File=folder / f"{file}.iga")
            value = run.quantities[quantity]
            rows.append([name, file, f"{run.unknowns}", f"{value:.6g}",
                         f"{fine:.6g}", f"{100 * (value / fine - 1):+.3f} %"])
    table(["problem", "file", "equations", "value", "patch, degree 4, 32 x 32", "difference"], rows)


def main():
    arguments = parse_arguments(__doc__)
    program = Program(arguments.program)
    for case in CASES:
        converge(program, *case)
    if arguments.iga:
        print("### Surfaces from files\n")
        compare_files(program, arguments.iga)


if __name__ == "__main__":
    main()
