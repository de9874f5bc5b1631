#!/usr/bin/env python3
"""Fits the constants of src/tangential/methods/strip_calibration.hpp to exact forces and prints the table.

    fit.py LIBRARY [--start zero|fitted] [--keep N] [--power WEIGHT] FILE.csv ... [--only TERM ...]

LIBRARY is build/release/tools/libcalibration_errors.so, or libsurface_errors.so for
src/surface/rolling/surface_calibration.hpp, or libmemory_errors.so for src/tangential/methods/patch_numbers.hpp; the files are made by make_patches. From `zero` (the
default) all constants take part; with --keep the least needed ones are taken out, one after the other, until N are
left. From `fitted` only the constants that are not zero in the header take part: a change elsewhere (tables of
linear theory, normal method) wants no more than that. --only: of those, the columns with these numbers, from 0 on.

What is minimised: the mean over the patches of |e|^3 / d + ... for small e quadratic (d = 1 % of mu N), e the error
of Fx, Fy and 0.3 of that of Mz; the same for a tenth (--power) of the relative power error, fading out between 85 and 95 %
adhesion; and a weak pull of every constant towards zero. The third power looks at the 95th percentile more than at
the median. Patches given as strips (wheel on rail) count three times, as there are fewer of them.
"""
import argparse
import ctypes

import numpy as np

SCALE, MOMENT, PULL = 0.01, 0.3, 0.5e-6


class Errors:
    def __init__(self, path, files, power):
        self.library = ctypes.CDLL(path)
        self.power = power
        self.shape = self.library.calibration_quantities(), self.library.calibration_terms()
        ends = [0]
        for name in files:
            ends.append(self.library.calibration_load(name.encode()))
            if ends[-1] < 0:
                raise SystemExit(1)
        self.count = ends[-1]
        self.weight = np.ones(self.count)
        for name, first, last in zip(files, ends, ends[1:]):
            with open(name) as lines:
                next(lines)
                self.weight[first:last] = 3.0 if next(lines).rstrip("\n").split(",")[-1] else 1.0
        self.weight /= self.weight.mean()

    def fitted(self):
        constants = np.zeros(self.shape)
        self.library.calibration_fitted(constants.ctypes.data_as(ctypes.c_void_p))
        return constants

    def raw(self, constants):
        out = np.zeros((self.count, 5))
        constants = np.ascontiguousarray(constants)
        self.library.calibration_errors(constants.ctypes.data_as(ctypes.c_void_p), out.ctypes.data_as(ctypes.c_void_p))
        return out

    def __call__(self, constants):
        out = self.raw(constants)
        fade = self.power * np.clip((0.95 - out[:, 0]) / 0.1, 0.0, 1.0)
        return np.column_stack([out[:, 1], out[:, 2], MOMENT * out[:, 3], fade * out[:, 4]])


def sizes(r):
    """Of the force errors and of the power error, rounded off at SCALE, in units of it."""
    return (np.sqrt((r[:, :3] ** 2).sum(1) + SCALE**2) / SCALE, np.sqrt(r[:, 3] ** 2 + SCALE**2) / SCALE)


def loss(r, weight, power, p):
    q, q2 = sizes(r)
    return np.mean(weight * SCALE**2 * (q**power + q2**power - 2.0)) + PULL * np.sum(p**2)


def step_matrices(errors, constants, active, r, power):
    """Gauss-Newton matrix and gradient of the loss."""
    q, q2 = sizes(r)
    w = power * errors.weight[:, None] * np.stack([q ** (power - 2)] * 3 + [q2 ** (power - 2)], 1)
    jacobian = np.empty((len(active),) + r.shape)
    for k, where in enumerate(active):
        moved = constants.copy()
        moved[where] += 1e-4
        jacobian[k] = (errors(moved) - r) / 1e-4
    flat = jacobian.reshape(len(active), -1)
    weighted = flat * w.ravel()
    p = np.array([constants[where] for where in active])
    matrix = weighted @ flat.T / len(r) + 2.0 * PULL * np.eye(len(active))
    return matrix, weighted @ r.ravel() / len(r) + 2.0 * PULL * p


def fit(errors, constants, active, power, steps):
    """Levenberg-Marquardt; returns constants, loss and the matrix of the last step."""
    damping, values = 0.1, lambda c: np.array([c[where] for where in active])
    r = errors(constants)
    best = loss(r, errors.weight, power, values(constants))
    for _ in range(steps):
        matrix, gradient = step_matrices(errors, constants, active, r, power)
        before = best
        for _ in range(6):
            change = np.linalg.solve(matrix + damping * np.diag(np.diag(matrix)), -gradient)
            trial = constants.copy()
            for where, d in zip(active, change):
                trial[where] += d
            r_trial = errors(trial)
            value = loss(r_trial, errors.weight, power, values(trial))
            if value < best:
                constants, r, best, damping = trial, r_trial, value, max(damping / 4.0, 1e-6)
                break
            damping *= 6.0
        if before - best < 1e-4 * before:
            break
    return constants, best, matrix


def report(errors, constants):
    out = errors.raw(constants)
    force = 100.0 * np.hypot(out[:, 1], out[:, 2])
    power = 100.0 * np.abs(out[out[:, 0] < 0.9, 4])
    for name, e in (("force", force), ("power", power)):
        print(f"# {name}: median {np.median(e):.2f}  p95 {np.percentile(e, 95):.2f}  worst {e.max():.2f} %")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("library")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--start", choices=["zero", "fitted"], default="zero")
    parser.add_argument("--keep", type=int, default=0)
    parser.add_argument("--power", type=float, default=0.1)
    parser.add_argument("--only", type=int, nargs="+")
    arguments = parser.parse_args()
    errors = Errors(arguments.library, arguments.files, arguments.power)

    if arguments.start == "fitted":
        constants = errors.fitted()
        active = [(q, t) for q, t in zip(*np.nonzero(constants)) if not arguments.only or t in arguments.only]
    else:
        constants = np.zeros(errors.shape)
        active = [(q, t) for q in range(errors.shape[0]) for t in range(errors.shape[1])
                  if errors.library.calibration_allowed(q, t)]
        constants, _, _ = fit(errors, constants, active, 2, 25)
    constants, best, matrix = fit(errors, constants, active, 3, 40)
    while arguments.keep and len(active) > arguments.keep:
        p = np.array([constants[where] for where in active])
        price = p**2 / np.diag(np.linalg.inv(matrix))
        out = active.pop(int(np.argmin(price)))
        constants[out] = 0.0
        constants, best, matrix = fit(errors, constants, active, 3, 6)
        print(f"# {len(active)} constants, loss {1e4 * best:.3f} e-4 without {out}", flush=True)

    report(errors, constants)
    for row in constants:
        print("    {" + ", ".join(f"{value:.4g}" for value in row) + "},")


if __name__ == "__main__":
    main()
