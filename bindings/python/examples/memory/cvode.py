"""The wheelset beside in SUNDIALS' CVODE (scikit-sundae, PyPI), which picks steps and order by itself: cvode.py [--seconds 8] [--rows FILE.csv]

It rolls up a slope of 20 per mille, is braked to a stop, and rests. The brake is Dahl's friction: a spring that yields at its torque. CVODE asks
for rates at trial states of steps that it may reject. The contact is told the displacement since the committed step: as velocities, the
mean of that displacement over the time since. After every step that CVODE has accepted, its end is solved once more and committed. Forces
are smooth within a step. A contact is a spring with little damping, on which BDF is stable to order 2 only. Steps that CVODE takes back are
counted, and their forces are scanned for jumps."""
import argparse

import numpy as np
from braked import DAMPING, GRAVITY, INERTIA, LOAD, MASS, RADIUS, SLOPE, STIFFNESS, TORQUE, Braked
from sksundae.cvode import CVODE

ATOL = np.array([1e-8, 2e-8, 1e-6, 2e-6, 1e-8])


class Host:
    """State: x [m], angle of the axle [rad], v [m/s], w [rad/s], twist of the brake's spring [rad]."""

    def __init__(self, memory):
        self.wheelset, self.committed, self.trial = Braked(memory), None, None
        self.taken_back = []  # share of the step that CVODE then tried, largest jump of the force in it [N]

    def forces(self, t, y):
        begin, place = self.committed
        step = t - begin
        moved = (y[:2] - place) / step if self.wheelset.memory and step > 0.0 else y[2:4]
        return self.wheelset.forces(moved[0], moved[1], max(step, 0.0))

    def look_back(self, t):
        """A trial earlier than the one before, since the same commit: CVODE has taken that step back. Along it the largest second difference
        of the force is looked for, in parts that become shorter around it: only a jump stays."""
        (begin, place), (tried, y) = self.committed, self.trial
        if not begin < t < tried:
            return
        calls, shares = self.wheelset.calls, np.linspace(0.0, 1.0, 65)[1:]
        for _ in range(4 if self.wheelset.memory else 0):
            forces = [self.forces(begin + share * (tried - begin), np.append(place + share * (y[:2] - place), y[2:]))[0] for share in shares]
            bends = np.abs(np.diff(forces, 2))
            around = bends.argmax()
            shares = np.linspace(shares[around], shares[around + 2], 65)
        self.taken_back.append(((t - begin) / (tried - begin), bends.max() if self.wheelset.memory else np.nan))
        self.wheelset.calls = calls

    def rates(self, t, y, yp):
        self.look_back(t)
        self.trial = (t, y.copy())
        force, moment = self.forces(t, y)
        yields = y[3] - abs(y[3]) * STIFFNESS / TORQUE * y[4]
        brake = -STIFFNESS * y[4] - DAMPING * yields
        yp[:] = y[2], y[3], force / MASS - GRAVITY * SLOPE, (moment + brake) / INERTIA, yields

    def run(self, seconds, tolerance):
        y = np.array([0.0, 0.0, 2.0, -2.0 / RADIUS, 0.0])
        self.committed = self.trial = (0.0, y[:2].copy())
        solver = CVODE(self.rates, method="BDF", max_order=2, rtol=tolerance, atol=ATOL, max_num_steps=200000)
        solver.init_step(0.0, y)
        rows, found = [[0.0, *y]], None
        while rows[-1][0] < seconds:
            found = solver.step(seconds, method="onestep", tstop=seconds)
            t, y = float(np.atleast_1d(found.t)[-1]), np.atleast_2d(found.y)[-1].copy()
            self.forces(t, y)
            self.wheelset.commit()
            self.committed = (t, y[:2].copy())
            rows.append([t, *y])
        return np.array(rows), found


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--seconds", type=float, default=8.0)
    arguments.add_argument("--tolerance", type=float, default=1e-4, help="relative")
    arguments.add_argument("--rows", help="time and state after the steps with memory")
    options = arguments.parse_args()
    for memory in (True, False):
        host = Host(memory)
        rows, found = host.run(options.seconds, options.tolerance)
        print(f"{'memory' if memory else 'without'}: {len(rows) - 1} steps, {host.wheelset.calls} calls; stops after {rows[:, 1].max():.4f} m; "
              f"in the last second it moves {1e6 * (rows[-1, 1] - np.interp(options.seconds - 1.0, *rows[:, :2].T)):+.3g} um; {found.message}")
        share, jump = np.array(host.taken_back).reshape(-1, 2).T
        newton = np.count_nonzero(np.abs(share - 0.25) < 1e-9)  # where Newton's iteration fails CVODE tries a quarter of the step
        print(f"  {len(share)} steps taken back, {newton} by Newton's iteration"
              + (f"; largest jump of the force in them {jump.max(initial=0.0) / (0.6 * LOAD):.1e} of friction x load" if memory else ""))
        if memory and options.rows:
            np.savetxt(options.rows, rows, delimiter=",")


if __name__ == "__main__":
    main()
