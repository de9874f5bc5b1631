"""A wheelset on an irregular track with scipy's implicit integrators, which take the analytic Jacobian of the contact.

    wheelset_scipy.py [--method Radau|BDF] [--seconds 2] [--rms 0.0015] [--differences] [--check] [--rows FILE.csv]

--differences leaves the Jacobian to scipy, for comparison; --check compares it with central differences along the way."""
import argparse
import pathlib
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from wheelset import MASS, Wheelset, report

arguments = argparse.ArgumentParser()
arguments.add_argument("--method", default="Radau", choices=("Radau", "BDF"))
arguments.add_argument("--seconds", type=float, default=2.0)
arguments.add_argument("--speed", type=float, default=40.0)
arguments.add_argument("--rms", type=float, default=1.5e-3)
arguments.add_argument("--tolerance", type=float, default=1e-6)
arguments.add_argument("--every", type=float, default=1e-3, help="seconds between rows")
arguments.add_argument("--differences", action="store_true")
arguments.add_argument("--check", action="store_true")
arguments.add_argument("--rows")
options = arguments.parse_args()
wheelset = Wheelset(options.speed, options.rms)


def slopes(t, x):
    return np.concatenate([x[6:], wheelset.forces(t, x[:6], x[6:]) / MASS])


def jacobian(t, x):
    upper = np.hstack([np.zeros((6, 6)), np.eye(6)])
    return np.vstack([upper, wheelset.jacobian(t, x[:6], x[6:]) / MASS[:, None]])


# what counts as small: 1e-3 of a micrometre and microradian, 1 um/s
absolute = np.concatenate([np.full(6, 1e-9), np.full(6, 1e-6)])
start = time.perf_counter()
found = solve_ivp(slopes, (0.0, options.seconds), np.zeros(12), options.method, rtol=options.tolerance, atol=absolute,
                  jac=None if options.differences else jacobian, dense_output=True)
took = time.perf_counter() - start
print(f"{options.method}, Jacobian {'by differences' if options.differences else 'analytic'}: "
      f"{'reached the end' if found.success else 'FAILED: ' + found.message} at {found.t[-1]:.3f} of {options.seconds:g} s, "
      f"{len(found.t) - 1} steps, {found.nfev} right-hand sides, {found.njev} Jacobians, {wheelset.calls} wheel calls, {took:.1f} s")
if options.check:
    worst = 0.0
    step = np.concatenate([np.full(6, 1e-9), np.full(6, 1e-6)])
    for t in np.linspace(0.1, 1.0, 5) * options.seconds:
        x = found.sol(t)
        exact = jacobian(t, x)
        differences = np.array([(slopes(t, x + h) - slopes(t, x - h)) / (2 * np.max(h)) for h in np.diag(step)]).T
        worst = max(worst, np.max(np.abs(exact - differences) / np.max(np.abs(exact), axis=1, keepdims=True)))
    print(f"Jacobian against central differences: at most {worst:.1e} of the largest entry of its row")
report([wheelset.row(t, found.sol(t)[:6], found.sol(t)[6:]) for t in np.arange(0.0, found.t[-1] + 0.5 * options.every, options.every)],
       options.rows)
sys.exit(0 if found.success else 1)
