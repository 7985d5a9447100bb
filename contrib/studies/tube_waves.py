#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Axisymmetric waves in a thick elastic tube that is filled with a viscous liquid: speeds by (M1) of
doc/theory/wall.md for some wave lengths, and (M2), their limit for long waves without viscosity.
Frequencies are complex for real wave numbers, as those of standing waves that decay. Needs mpmath."""
import argparse

import mpmath as mp

ENTRIES = {"inner": 0.5, "outer": 0.6, "modulus": 3e6, "poisson": 0.3, "wall_density": 1.2, "density": 1.0,
           "viscosity": 0.003}


class Tube:
    def __init__(self, **entries):
        self.__dict__.update((name, mp.mpf(value)) for name, value in entries.items())
        self.shear = self.modulus / (2 * (1 + self.poisson))
        self.lame = self.modulus * self.poisson / ((1 + self.poisson) * (1 - 2 * self.poisson))

    def liquid(self, k, w):
        """Velocity and traction (radial, axial) inside, of a potential and of a rotational flow."""
        a, i, eta = self.inner, mp.mpc(0, 1), self.viscosity
        kappa = mp.sqrt(k * k - i * w * self.density / eta)
        I0, I1 = mp.besseli(0, k * a), mp.besseli(1, k * a)
        ratio = mp.besseli(0, kappa * a) / mp.besseli(1, kappa * a)
        yield [k * I1, i * k * I0,
               -i * w * self.density * I0 + 2 * eta * k * k * (I0 - I1 / (k * a)), 2j * eta * k * k * I1]
        yield [-i * k, kappa * ratio,
               -2j * eta * k * kappa * (ratio - 1 / (kappa * a)), eta * (k * k + kappa * kappa)]

    def wall(self, k, w, r):
        """Displacement and traction (radial, axial) at r, of the four potentials."""
        i, G = mp.mpc(0, 1), self.shear
        p = mp.sqrt(k * k - w * w * self.wall_density / (self.lame + 2 * G))
        q = mp.sqrt(k * k - w * w * self.wall_density / G)
        compression = -self.lame * w * w * self.wall_density / (self.lame + 2 * G)
        for f, df in ((mp.besseli(0, p * r), mp.besseli(1, p * r)),
                      (mp.besselk(0, p * r), -mp.besselk(1, p * r))):
            slope = p * df
            yield [slope, i * k * f, compression * f + 2 * G * (p * p * f - slope / r), 2j * G * k * slope]
        x = q * r
        for f, df in ((mp.besseli(1, x), mp.besseli(0, x) - mp.besseli(1, x) / x),
                      (mp.besselk(1, x), -mp.besselk(0, x) - mp.besselk(1, x) / x)):
            yield [-i * k * f, q * df + f / r, -2j * G * k * q * df, G * (k * k + q * q) * f]

    def determinant(self, k, w):
        """Of the conditions: velocities and tractions agree inside, there are none of these outside."""
        columns = [[-1j * w * u, -1j * w * v, s / self.modulus, t / self.modulus,
                    S / self.modulus, T / self.modulus]
                   for (u, v, s, t), (_, _, S, T) in zip(self.wall(k, w, self.inner),
                                                         self.wall(k, w, self.outer))]
        columns += [[-u, -v, -s / self.modulus, -t / self.modulus, 0, 0]
                    for u, v, s, t in self.liquid(k, w)]
        return mp.det(mp.matrix(columns))

    def complex_speed(self, length, guess):
        k = 2 * mp.pi / length
        start = k * guess
        w = mp.findroot(lambda w: self.determinant(k, w), (start, 0.99 * start, (0.995 - 0.003j) * start),
                        solver="muller", tol=1e-30, verify=False)
        return w / k

    def long_waves(self):
        """(M2), and the same without the wall's inertia along the axis."""
        a2, b2 = self.inner ** 2, self.outer ** 2
        lame = (a2 + b2) / (b2 - a2) + self.poisson
        speed = without = mp.sqrt(self.modulus / (2 * self.density * lame))
        for _ in range(50):
            inertia = self.wall_density * speed ** 2
            more = 2 * self.poisson ** 2 * a2 / (b2 - a2) * inertia / (self.modulus - inertia)
            speed = mp.sqrt(self.modulus / (2 * self.density * (lame + more)))
        return speed, without


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, value in ENTRIES.items():
        parser.add_argument(f"--{name}", type=float, default=value, help=f"[CGS], {value}")
    parser.add_argument("--lengths", type=float, nargs="+", default=[20, 10, 5, 4],
                        help="of waves [cm], the longest first")
    arguments = vars(parser.parse_args())
    lengths = arguments.pop("lengths")
    mp.mp.dps = 30
    tube = Tube(**arguments)
    speed, without = tube.long_waves()
    print(f"long waves: {mp.nstr(speed, 7)} cm/s (M2); Moens-Korteweg, thick wall: {mp.nstr(without, 7)}")
    guess = speed * (1 - 0.01j)
    print("length [cm], speed [cm/s], frequency [1/s], loss of amplitude in a period")
    for length in lengths:
        guess = tube.complex_speed(length, guess)
        loss = 1 - mp.exp(2 * mp.pi * guess.imag / guess.real)
        print(", ".join([f"{length:g}"] + [mp.nstr(x, 10) for x in (guess.real, guess.real / length)]
                        + [mp.nstr(loss, 3)]))


if __name__ == "__main__":
    main()
