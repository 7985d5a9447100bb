#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Homogeneous states of all isotropic materials against their closed forms.

Sheets in uniaxial, planar and equibiaxial tension; the inflated tube and balloon both against the
membrane's pressure and against that of a shell whose metric is linear through the thickness.
"""
from math import exp

from study import Program, parse_arguments, table

MU = 4.225e5
C10, C01 = 7 / 16 * MU, MU / 16  # Mooney-Rivlin
C0, C1, C2 = 1e6, 2e5, 100.0  # Fung
E, NU = 1.1e7, 0.495  # Saint Venant-Kirchhoff
RADIUS, THICKNESS = 10.0, 0.1  # tube and balloon
SHEET = 0.0386  # thickness

# Gauss points and weights on [-1, 1]
GAUSS = [(-0.8611363115940526, 0.3478548451374538), (-0.3399810435848563, 0.6521451548625461),
         (0.3399810435848563, 0.6521451548625461), (0.8611363115940526, 0.3478548451374538)]


def psi_1(material, first_invariant):
    """d psi / d I1."""
    if material == "neo-Hookean":
        return MU / 2
    if material == "Mooney-Rivlin":
        return C10
    return C0 / 2 + C1 * C2 * (first_invariant - 3) * exp(C2 * (first_invariant - 3) ** 2)


def principal_stress(material, a, b):
    """Second Piola-Kirchhoff stress along the first axis for squared stretches a and b."""
    if material == "Saint Venant-Kirchhoff":
        return E / (1 - NU ** 2) * ((a - 1) / 2 + NU * (b - 1) / 2)
    c = 1 / (a * b)
    psi_2 = C01 if material == "Mooney-Rivlin" else 0.0
    return 2 * psi_1(material, a + b + c) * (1 - c / a) + 2 * psi_2 * b * (1 - c / a)


def energy_rate(material, stretch, sphere):
    """dW/dlambda of tube or balloon per undeformed area, integrated through the thickness."""
    total = 0.0
    for point, weight in GAUSS:
        xi = THICKNESS / 2 * point
        metric, undeformed = stretch ** 2 + 2 * xi * stretch / RADIUS, 1 + 2 * xi / RADIUS
        rate = (2 * stretch + 2 * xi / RADIUS) / undeformed
        squared = metric / undeformed
        stress = principal_stress(material, squared, squared if sphere else 1.0)
        total += THICKNESS / 2 * weight * stress / 2 * rate * (2 if sphere else 1)
    return total


def pressures(material, stretch, sphere):
    """Pressure of the membrane and of the shell."""
    membrane = THICKNESS / RADIUS * principal_stress(
        material, stretch ** 2, stretch ** 2 if sphere else 1.0)
    if sphere:
        return 2 * membrane / stretch, energy_rate(material, stretch, True) / RADIUS / stretch ** 2
    return membrane, energy_rate(material, stretch, False) / RADIUS / stretch


MATERIALS = ("neo-Hookean", "Mooney-Rivlin", "Fung", "Saint Venant-Kirchhoff")
FORCE = {"neo-Hookean": 15000, "Mooney-Rivlin": 15000, "Fung": 60000,
         "Saint Venant-Kirchhoff": 60000}  # per length
PULLS = {
    "uniaxial": ("symmetry x=0; symmetry y=0; fix z=0 z", "x=2: ({0}, 0, 0)"),
    "planar": ("symmetry x=0; symmetry y=0; symmetry y=1; fix z=0 z", "x=2: ({0}, 0, 0)"),
    "equibiaxial": ("symmetry x=0; symmetry y=0; fix z=0 z",
                    "x=2: ({0}, 0, 0); y=1: (0, {0}, 0)"),
}


def sheets(program):
    print("### Sheets\n")
    rows = []
    for material in MATERIALS:
        for name, (supports, loads) in PULLS.items():
            run = program.run("biaxial-strip", Shell__Material=material,
                              Supports__Supports=supports,
                              Loads__Edge_loads=loads.format(FORCE[material]),
                              Solver__Tolerance="1e-11")
            first = 1 + run.quantities["corner_ux"] / 2
            second = 1 + run.quantities["corner_uy"]
            stress = principal_stress(material, first ** 2, second ** 2)
            across = principal_stress(material, second ** 2, first ** 2)
            wanted = 0.0 if name == "uniaxial" else across if name == "planar" else stress
            rows.append([material, name, f"{first:.6f}", f"{second:.6f}",
                         f"{SHEET * first * stress / FORCE[material] - 1:.1e}",
                         f"{(across - wanted) / stress:.1e}"])
    table(["material", "tension", "lambda 1", "lambda 2", "error of stress 1",
           "error of stress 2 / stress 1"], rows)


def inflate(program, scene, probe, sphere, loads, **entries):
    rows = []
    for material, pressure in loads.items():
        run = program.run(scene, may_give_up=True, Shell__Material=material,
                          Loads__Pressure=-pressure, Solver__Tolerance="1e-10",
                          Output__Reference_curve="", **entries)
        for row in run.rows:
            stretch = 1 + row[probe] / RADIUS
            given = pressure * row["load_factor"]
            membrane, shell = pressures(material, stretch, sphere)
            rows.append([material, f"{stretch:.6f}", f"{given:.6g}", f"{given / membrane - 1:.1e}",
                         f"{given / shell - 1:.1e}"])
    table(["material", "lambda", "pressure", "to membrane", "to shell"], rows)


def main():
    program = Program(parse_arguments(__doc__.splitlines()[0]).program)
    sheets(program)
    print("### Tube of fixed length\n")
    inflate(program, "cylinder-inflation", "wall_ux", False,
            {"neo-Hookean": 3800, "Mooney-Rivlin": 3800, "Fung": 12000,
             "Saint Venant-Kirchhoff": 20000})
    print("### Balloon\n")
    inflate(program, "balloon", "equator_ux", True,
            {"neo-Hookean": 6000, "Mooney-Rivlin": 6000, "Fung": 20000},
            # the neo-Hookean balloon has no state at its full load: the path ends on the way
            Solver__Stop_after_steps=14, Solver__Largest_arc=1000)


if __name__ == "__main__":
    main()
