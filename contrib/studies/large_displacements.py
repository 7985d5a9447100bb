#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large displacements of St. Venant-Kirchhoff shells: the cantilever under end shear against the
elastica, the hinged roof (snap-through and snap-back) against a published path."""
from math import cos, hypot, sin

from study import Program, parse_arguments, table

# Load over 3000 and deflection of the centre of the hinged roof, h = 6.35: Sze, Liu and Lo, Finite
# Elem. Anal. Des. 40 (2004) 1551-1569 (Abaqus S4R), to about one percent.
ROOF_PATH = [
    (0.0517, 1.846), (0.1182, 5.271), (0.1583, 8.257), (0.1837, 10.799), (0.1914, 11.904),
    (0.1953, 12.892), (0.1950, 13.752), (0.1901, 14.472), (0.1806, 15.050), (0.1671, 15.501),
    (0.1323, 16.145), (0.0923, 16.602), (0.0504, 16.915), (0.0083, 17.008), (-0.0312, 16.697),
    (-0.0622, 15.780), (-0.0739, 15.206), (-0.0861, 14.767), (-0.1001, 14.520), (-0.1142, 14.451),
    (-0.1247, 14.862), (-0.1288, 15.778), (-0.1271, 16.961), (-0.1196, 18.320), (-0.1055, 19.817),
    (-0.0825, 21.420), (-0.0484, 23.100), (-0.0006, 24.824), (0.0626, 26.565), (0.1427, 28.302),
    (0.2403, 30.023), (0.3559, 31.720), (0.4898, 33.388), (0.6417, 35.024), (0.8114, 36.626)]


def shoot(force, curvature, n=2000):
    """Integrate the elastica theta'' = -force cos theta from a clamped end; end slope and place."""
    h = 1.0 / n
    theta, rate, x, z = 0.0, curvature, 0.0, 0.0
    for _ in range(n):  # classical Runge-Kutta method of fourth order
        def slope(t, r):
            return r, -force * cos(t), cos(t), sin(t)
        k1 = slope(theta, rate)
        k2 = slope(theta + h / 2 * k1[0], rate + h / 2 * k1[1])
        k3 = slope(theta + h / 2 * k2[0], rate + h / 2 * k2[1])
        k4 = slope(theta + h * k3[0], rate + h * k3[1])
        theta, rate, x, z = (a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in
                             zip((theta, rate, x, z), k1, k2, k3, k4))
    return rate, x, z


def elastica(force):
    """Shortening and rise of the end over the length; force = P L^2 / (E I)."""
    low, high = 0.0, force
    for _ in range(50):
        middle = (low + high) / 2
        if shoot(force, middle, 200)[0] > 0:
            high = middle
        else:
            low = middle
    _, x, z = shoot(force, (low + high) / 2)
    return 1 - x, z


def cantilever(program):
    print("### Cantilever under end shear, 16 x 2 elements\n")
    rows, totals = [], []
    for degree in (2, 3):
        for steps in (20, 10):
            run = program.run("cantilever", Surface__Degree=degree, Solver__Load_steps=steps)
            totals.append([str(degree), str(steps), str(len(run.rows)), f"{run.iterations}",
                           f"{run.phases['solve'] - run.phases['output']:.2f}"])
        for row in run.rows:
            shortening, rise = elastica(4 * row["load_factor"])
            rows.append([str(degree), f"{row['load_factor']:.4g}", f"{row['iterations']:.0f}",
                         f"{-row['end_ux']:.6f}", f"{-row['end_ux'] / 10 / shortening - 1:.1e}",
                         f"{row['end_uz']:.6f}", f"{row['end_uz'] / 10 / rise - 1:.1e}"])
    table(["degree", "load factor", "iterations", "shortening", "error", "rise", "error"], rows)
    table(["degree", "load steps asked", "taken", "iterations", "solve [s]"], totals)


def distance(point, path, scales):
    """Of a point from a polyline, both coordinates divided by their scales."""
    px, py = (p / s for p, s in zip(point, scales))
    best = float("inf")
    for (ax, ay), (bx, by) in zip(path, path[1:]):
        ax, bx, ay, by = ax / scales[0], bx / scales[0], ay / scales[1], by / scales[1]
        squared = (bx - ax) ** 2 + (by - ay) ** 2
        t = max(0.0, min(1.0, ((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / squared))
        best = min(best, hypot(px - ax - t * (bx - ax), py - ay - t * (by - ay)))
    return best


def hinged_roof(program):
    print("### Hinged roof, h = 6.35\n")
    rows = []
    for n in (4, 8, 16):
        # at most two corrections a step: short steps, between which a straight line is good enough
        run = program.run("hinged-roof", Surface__Elements=f"{n},{n}", Solver__Iterations=3)
        path = [(0.0, 0.0)] + [(row["load_factor"], -row["centre_uy"]) for row in run.rows]
        peak = next(path[k] for k in range(1, len(path)) if path[k + 1][0] < path[k][0])
        lowest = min(path)
        # in units of the path's largest values
        worst = max(distance(point, path, (1.0, ROOF_PATH[-1][1])) for point in ROOF_PATH)
        rows.append([f"{n} x {n}", f"{run.unknowns}", str(len(run.rows)),
                     f"{run.iterations}", f"{peak[0]:.4f} at {peak[1]:.2f}",
                     f"{lowest[0]:.4f} at {lowest[1]:.2f}", f"{path[-1][1]:.3f}",
                     f"{100 * worst:.2f} %",
                     f"{run.phases['solve'] - run.phases['output']:.1f}"])
    table(["elements", "equations", "steps", "corrections", "first peak", "lowest load",
           "deflection at load 1", "farthest published point", "solve [s]"], rows)


def main():
    program = Program(parse_arguments(__doc__.splitlines()[0]).program)
    cantilever(program)
    hinged_roof(program)


if __name__ == "__main__":
    main()
