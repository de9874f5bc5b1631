"""A bogie through a crossing with its check rail, in time.

    turnout.py FOLDER [--bdf]     a table, and turnout.png

The bogie is that of examples_c/vehicle: two wheelsets and a frame below a car body that runs on undisturbed. The crossing of
rails.py lies in the right rail of the main route, and in the left rail of the diverging route, a curve of 245 m. The rail
across has a check rail. Steps of 1 ms by a linearly implicit method with the library's derivatives; --bdf: by SciPy's BDF as well."""
import argparse
import pathlib
import time

import numpy as np
import wrc

import rails

RADIUS, AXLE_LOAD, BASE = 0.46, 140e3, 1.25  # m, N, half the wheelbase [m]
MASS = np.array([1500.0, 1500.0, 900.0, 900.0, 110.0] * 2 + [2600.0, 2600.0, 1500.0, 2800.0, 1800.0])  # y, z, roll, yaw, pitch of each body
START = -1.3  # of the first wheelset along the crossing [m]
WAY = 4.4  # that the bogie rolls [m]


def springs():
    """Stiffness and damping of both suspensions by y, z, roll, yaw, pitch of two wheelsets and the frame."""
    K, C = np.zeros((15, 15)), np.zeros((15, 15))
    for body, ahead in ((0, BASE), (5, -BASE)):
        for out in (1.0, -1.0):
            x, y, z = np.zeros((3, 15))
            x[[body + 3, 13]] = -out, out
            y[[body, 10, 13]] = 1.0, -1.0, -ahead
            z[[body + 1, body + 2, 11, 12, 14]] = 1.0, out, -1.0, -out, ahead
            for row, stiff, damp in ((x, 12e6, 0.0), (y, 5e6, 0.0), (z, 1.2e6, 8e3)):
                K += stiff * np.outer(row, row)
                C += damp * np.outer(row, row)
    K[range(10, 14), range(10, 14)] += (160e3, 430e3, 430e3, 250e3)
    C[range(10, 15), range(10, 15)] += (32e3, 30e3, 30e3, 30e3, 1e4)
    return K, C


def check_rail():
    """A head 41 mm from the running edge, 20 mm above the rail, whose field side guides the flange's back."""
    y, z = rails.head(-70e-3, 0.0, 0.0, corner=5e-3, depth=60e-3)
    return {"y": -76e-3, "z": -20e-3, "profile": {"kind": "POINTS", "y": y, "z": z}}


class Bogie:
    """The equations of motion on a route at a speed [m/s]."""

    ROWS = [1, 2, 3, 5, 4]  # Fy, Fz, Mx, Mz, My of y, z, roll, yaw, pitch
    PLACES, RATES = [0, 1, 2, 3], [5, 6, 7, 9, 8]  # columns of the derivatives

    def __init__(self, faces, route, speed):
        self.speed, self.curvature = speed, 1.0 / 245.0 if route == "diverging" else 0.0
        crossing_side = "RIGHT" if route == "main" else "LEFT"
        crossing = rails.model_of(faces)
        plain = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}, check_rail=check_rail())
        self.contacts = [(side, (crossing if side == crossing_side else plain).contact(side), side == crossing_side)
                         for _ in range(2) for side in ("RIGHT", "LEFT")]
        self.K, self.C = springs()
        self.load = np.zeros(15)
        self.load[[1, 6]] = AXLE_LOAD
        self.data, self.wrench = wrc.WheelInput(damping=0.05), wrc.Wrench._new()
        self.forces, self.failures, self.flagged = np.zeros((4, 3)), 0, 0
        # each wheel stands where its rail has it under the load; the wheelset's height is their mean
        heights = []
        for wheelset in range(2):
            z = []
            for _, contact, crosses in self.contacts[2 * wheelset:2 * wheelset + 2]:
                stand = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=AXLE_LOAD / 2)
                if crosses:
                    stand.distance = self.distance(0.0, wheelset)
                z.append(contact.wrench(stand).z)
            heights.append((z[0] + z[1]) / 2)
        self.standing = np.zeros(30)
        self.standing[[1, 6]] = heights
        self.standing[11] = sum(heights) / 2
        self.load += self.K @ self.standing[:15]  # springs are at rest there

    def distance(self, t, wheelset):
        return START + self.speed * t - 2.0 * BASE * wheelset

    def motion(self, t, state, slopes=False):
        """Rates of the state, and if wanted their derivatives by it and by time: the rail below changes."""
        q, v = state[:15], state[15:]
        aside = q.copy()  # in a curve the frame sees wheelsets turned and aside
        aside[[3, 8]] += BASE * self.curvature * np.array([1.0, -1.0])
        aside[[0, 5]] += 0.5 * BASE ** 2 * self.curvature
        force = self.load - self.K @ aside - self.C @ v
        by, by_time = np.zeros((15, 30)), np.zeros(15)
        for k, (_, contact, crosses) in enumerate(self.contacts):
            body = 5 * (k // 2)
            wheel = self.data.wheel
            wheel.y, wheel.z, wheel.roll, wheel.yaw = q[body:body + 4]
            wheel.velocity = (self.speed, v[body], v[body + 1])
            wheel.roll_rate, wheel.yaw_rate = v[body + 2], v[body + 3] + self.speed * self.curvature
            wheel.pitch_rate = -self.speed / RADIUS + v[body + 4]
            self.data.distance = self.distance(t, k // 2) if crosses else 0.0
            if slopes:
                wrench, found = contact.wrench_derivatives(self.data)
                by[body:body + 5, body:body + 4] += found.wrench[np.ix_(self.ROWS, self.PLACES)]
                by_time[body:body + 5] += self.speed * crosses * found.wrench[self.ROWS, 17]
                by[body:body + 5, 15 + body:20 + body] += found.wrench[np.ix_(self.ROWS, self.RATES)]
            else:
                wrench = contact.wrench(self.data)
            self.flagged += wrench.flags != 0 and wrc.Flags.NO_CONTACT not in wrench.flags  # a lifted wheel is no fault
            self.forces[k] = wrench.force
            force[body:body + 5] += np.r_[wrench.force, wrench.moment][self.ROWS]
        rate = np.r_[v, force / MASS]
        if not slopes:
            return rate
        by[:, :15] -= self.K
        by[:, 15:] -= self.C
        return rate, np.vstack([np.hstack([np.zeros((15, 15)), np.eye(15)]), by / MASS[:, None]]), np.r_[np.zeros(15), by_time / MASS]


def stepped(bogie, step=1e-3):
    """Two stages of Rosenbrock's kind, second order, damping what is fast (ROS2, 1 + 1 / sqrt 2)."""
    gamma = 1.0 - 1.0 / np.sqrt(2.0)
    state, told = bogie.standing.copy(), []
    for k in range(int(WAY / bogie.speed / step)):
        try:
            first_rate, jacobian, by_time = bogie.motion(k * step, state, slopes=True)
            told.append((k * step, state.copy(), bogie.forces.copy()))
            solve = np.linalg.inv(np.eye(30) - gamma * step * jacobian)
            first = solve @ (first_rate + gamma * step * by_time)
            second = solve @ (bogie.motion((k + 1) * step, state + step * first) - 2.0 * first - gamma * step * by_time)
            state = state + step * (1.5 * first + 0.5 * second)
        except wrc.Error as why:
            bogie.failures += 1
            print(f"    step {k} at {bogie.distance(k * step, 0):.3f} m: {why}")
            break
    return told


def by_bdf(bogie):
    from scipy.integrate import solve_ivp

    found = solve_ivp(bogie.motion, (0.0, WAY / bogie.speed), bogie.standing, method="BDF", rtol=1e-5, atol=np.r_[np.full(15, 1e-8), np.full(15, 1e-6)],
                      jac=lambda t, state: bogie.motion(t, state, slopes=True)[1], max_step=1e-3)
    told = []
    for t, state in zip(found.t, found.y.T):
        bogie.motion(t, state)
        told.append((t, state.copy(), bogie.forces.copy()))
    return told


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("folder", type=pathlib.Path)
    asked.add_argument("--bdf", action="store_true")
    told = asked.parse_args()
    faces = wrc.rail_faces(rails.crossing(way=True))
    made = wrc.plot.figure(figsize=(13, 9))
    panels = made.subplots(3, 2, sharex=True)
    runs = [("main", speed) for speed in (40, 80, 120)] + [("diverging", speed) for speed in (40, 60)]
    for k, (route, speed) in enumerate(runs):
        for name, integrate in [("1 ms", stepped)] + ([("BDF", by_bdf)] if told.bdf else []):
            bogie = Bogie(faces, route, speed / 3.6)
            began = time.process_time()
            found = integrate(bogie)
            took = time.process_time() - began
            place = np.array([bogie.distance(t, 0) for t, _, _ in found])
            vertical = -1e-3 * np.array([force[:, 2] for _, _, force in found])
            lateral = 1e-3 * np.array([force[:, 1] for _, _, force in found])
            crossing, check = (0, 1) if route == "main" else (1, 0)
            last = place[-1]
            print(f"{route:9} {speed:4} km/h {name:4}: to {last:.3f} m of {START + WAY:.3f}, {bogie.failures} failed, {bogie.flagged} flagged calls; wheel on the "
                  f"crossing {vertical[:, crossing].min():.1f} .. {vertical[:, crossing].max():.1f} kN, lateral {np.abs(lateral[:, crossing]).max():.1f} kN, "
                  f"opposite lateral {np.abs(lateral[:, check]).max():.1f} kN; {took / found[-1][0]:.1f} times real time", flush=True)
            column = 0 if route == "main" else 1
            style = dict(color=wrc.plot.COLOURS[k], label=f"{speed} km/h {name}", linewidth=1, linestyle="-" if name == "1 ms" else ":")
            panels[0, column].plot(place, vertical[:, crossing], **style)
            panels[1, column].plot(place, lateral[:, check], **style)
            panels[2, column].plot(place, 1e3 * np.array([state[1] for _, state, _ in found]), **style)
    for column, route in enumerate(("main route", "diverging route, radius 245 m")):
        panels[0, column].set(title=route, ylabel="wheel on the crossing, upwards [kN]")
        panels[1, column].set(ylabel="wheel at the check rail, to the right [kN]")
        panels[2, column].set(ylabel="first wheelset down [mm]", xlabel="first wheelset along the crossing [m]")
        panels[2, column].invert_yaxis()
    for panel in panels.flat:
        panel.grid(alpha=0.3)
    panels[0, 0].legend(fontsize=8)
    panels[0, 1].legend(fontsize=8)
    made.savefig(told.folder / "turnout.png", dpi=90)


if __name__ == "__main__":
    main()
