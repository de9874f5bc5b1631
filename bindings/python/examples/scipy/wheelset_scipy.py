"""A wheelset on an irregular track with scipy's implicit integrators, which take the analytic Jacobian of the contact.

    wheelset_scipy.py [--method Radau|BDF] [--seconds 2] [--differences] [--rows FILE.csv]   --differences: scipy's Jacobian"""
import argparse
import sys

import numpy as np
from scipy.integrate import solve_ivp

sys.path.append(sys.path[0] + "/..")
from wheelset import MASS, TOLD, Wheelset

arguments = argparse.ArgumentParser()
arguments.add_argument("--method", default="Radau")
arguments.add_argument("--seconds", type=float, default=2.0)
arguments.add_argument("--differences", action="store_true")
arguments.add_argument("--rows", default="wheelset_scipy.csv", help="time, coordinates, their rates, every ms")
options = arguments.parse_args()
wheelset = Wheelset()


def rates(t, x):
    return np.concatenate([x[6:], wheelset.forces(t, x[:6], x[6:]) / MASS])


def jacobian(t, x):
    """Derivatives of rates(): of the wrench the library's, of what it is told and of the balance by complex steps."""
    rates(t, x)  # leaves its input and both wrenches there
    wrench = np.concatenate([wheelset.out["force"].sum(axis=0), wheelset.out["moment"].sum(axis=0)])
    slopes = sum(contact.wrench_derivatives(wheelset.input)[1].wrench for contact in wheelset.wheels.contacts)
    columns = []
    for moved in x + 1e-30j * np.eye(12):
        told, own = wheelset.seen(t, moved[:6], moved[6:])
        rails = wrench + 1j * slopes[:, TOLD] @ told.imag
        forces = wheelset.balance(moved[:6], moved[6:], own, rails[:3], rails[3:])
        columns.append(np.concatenate([moved[6:], forces / MASS]).imag / 1e-30)
    return np.transpose(columns)


times = np.linspace(0.0, options.seconds, round(1000 * options.seconds) + 1)
found = solve_ivp(rates, (0.0, options.seconds), np.zeros(12), options.method, times, rtol=1e-6,
                  atol=np.repeat([1e-9, 1e-6], 6), jac=None if options.differences else jacobian)
print(f"{options.method}: {found.message} {found.nfev} right-hand sides, {found.njev} Jacobians")
np.savetxt(options.rows, np.column_stack([found.t, found.y.T]), "%.10g", ",")
assert found.success
