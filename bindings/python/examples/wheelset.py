"""The wheelset of docs/hosts.md on its irregular track, as equations of motion for any host: forces and their Jacobian.

Coordinates: x (against a frame that moves at constant speed), y, z, roll, turning about the axle against free rolling, yaw
about the rolled axis. Everything here but the library's wrench also takes complex numbers: the Jacobian of the kinematics
is their complex step, exact to rounding, that of the wrench is what wrench_sensitivities() gives."""
import numpy as np

import wrc

MASS = np.array([1500.0, 1500.0, 1500.0, 800.0, 100.0, 800.0])  # kg; kg m2 across, about the axle, across
ACROSS, ABOUT = 800.0, 100.0
CARRIED, ARM, BOX = 160e3, 1.0, np.array([4e6, 2e6, 1e6])  # N, m, N/m
RADIUS, FRICTION = 0.46, 0.3
INPUTS = [wrc.WrenchInput[name] for name in ("Y", "Z", "ROLL", "YAW", "VELOCITY_X", "VELOCITY_Y", "VELOCITY_Z", "ANGULAR_VELOCITY_X",
                                             "ANGULAR_VELOCITY_Y", "ANGULAR_VELOCITY_Z", "RAIL_Y")]
STEP = 1e-30


class Wheelset:
    def __init__(self, speed=40.0, rms=1.5e-3):
        self.speed = speed
        self.waves = 3.0 * 20.0 ** (np.arange(40) / 39.0)
        self.amplitudes = self.waves * rms / np.sqrt(0.5 * np.sum(self.waves ** 2))
        self.phases = 2 * np.pi * np.mod(0.618034 * np.arange(1, 41), 1.0)
        model = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK", material={"shear_modulus": 82e9, "poisson": 0.28})
        self.contacts = [model.contact(side) for side in ("RIGHT", "LEFT")]
        # anew: a host's Jacobian by differences must not see what was solved before
        self.data, self.out, self.slopes = wrc.WheelInput(start="ANEW", friction={"coefficient": FRICTION}), wrc.Wrench(), wrc.WrenchSensitivities()
        at_rest = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=CARRIED / 2, friction={"coefficient": 0.0})
        self.height = self.contacts[0].wrench(at_rest).z
        self.calls = 0

    def irregularity(self, x):
        """Lateral displacement of both rails and its slope; faded in over the first 10 m."""
        angle = 2 * np.pi * x / self.waves + self.phases
        y, slope = np.sum(self.amplitudes * np.cos(angle)), -np.sum(self.amplitudes * 2 * np.pi / self.waves * np.sin(angle))
        t = x / 10.0 if 0.0 < x.real < 10.0 else np.clip(x.real / 10.0, 0.0, 1.0)
        fade, rate = t * t * (3 - 2 * t), 6 * t * (1 - t) / 10.0
        return fade * y, fade * slope + rate * y

    def seen(self, t, q, v):
        """What the library is told: y, z, roll, yaw, velocity, angular velocity, the rails' y, all seen in axes along the
        rails' slope; those axes, and the wheelset's own without its turning about the axle."""
        cr, sr, cy, sy = np.cos(q[3]), np.sin(q[3]), np.cos(q[5]), np.sin(q[5])
        body = np.array([[cy, -sy, 0], [cr * sy, cr * cy, -sr], [sr * sy, sr * cy, cr]])
        rail, slope = self.irregularity(self.speed * t + q[0])
        c = 1 / np.sqrt(1 + slope * slope)
        along = np.array([[c, -slope * c, 0], [slope * c, c, 0], [0, 0, 1]])
        axle = along.T @ body[:, 1]
        angular = along.T @ body @ np.array([v[3] * cy, -self.speed / RADIUS + v[4], v[5]])
        velocity = along.T @ np.array([self.speed + v[0], v[1], v[2]])
        numbers = np.array([q[1], self.height + q[2], np.arctan(axle[2] / axle[1]), -np.arcsin(axle[0]), *velocity, *angular, rail])
        return numbers, along, body

    def tell(self, numbers):
        wheel = self.data.wheel
        wheel.y, wheel.z, wheel.roll, wheel.yaw = numbers[0:4]
        wheel.velocity, wheel.angular_velocity, self.data.rail.y = numbers[4:7], numbers[7:10], numbers[10]
        self.calls += 2

    def wrench(self, numbers):
        """Force and moment of both rails, and each side's force."""
        self.tell(numbers)
        sides = []
        for contact in self.contacts:
            contact.wrench(self.data, out=self.out)
            sides.append(np.concatenate([self.out.force, self.out.moment]))
        return sides[0] + sides[1], sides

    def balance(self, q, v, wrench, along, body):
        """Right-hand side of MASS * acceleration; of roll and yaw Euler's equations of a body of revolution."""
        force, moment = along @ wrench[:3], along @ wrench[3:]
        force = force + [0, 0, CARRIED]
        for side in (1, -1):
            box = side * ARM * body[:, 1]
            spring = -BOX * (q[0:3] + box - np.array([0, side * ARM, 0]))
            force, moment = force + spring, moment + np.cross(box, spring)
        forward, axle, third = body.T @ moment
        spin = ABOUT * (-self.speed / RADIUS + v[4])
        cy, sy = np.cos(q[5]), np.sin(q[5])
        return np.array([*force, (forward + v[5] * spin + 2 * ACROSS * v[3] * v[5] * sy) / cy, axle,
                         third - v[3] * cy * spin - ACROSS * v[3] ** 2 * sy * cy])

    def forces(self, t, q, v):
        q, v = np.asarray(q, float), np.asarray(v, float)
        numbers, along, body = self.seen(t, q, v)
        return self.balance(q, v, self.wrench(numbers)[0], along, body)

    def jacobian(self, t, q, v):
        """Derivatives of forces() by q and v, shape (6, 12)."""
        x = np.concatenate([q, v])
        numbers, _, _ = self.seen(t, x[:6], x[6:])
        self.tell(numbers)
        wrench, slopes = np.zeros(6), np.zeros((6, len(INPUTS)))
        for contact in self.contacts:
            contact.wrench_sensitivities(self.data, wrench=self.out, sensitivities=self.slopes)
            wrench += np.concatenate([self.out.force, self.out.moment])
            slopes += self.slopes.wrench[:, INPUTS]
        columns = []
        for k in range(12):
            moved = x + 1j * STEP * (np.arange(12) == k)
            there, along, body = self.seen(t, moved[:6], moved[6:])
            change = slopes @ there.imag
            columns.append(self.balance(moved[:6], moved[6:], wrench + 1j * change, along, body).imag / STEP)
        return np.array(columns).T

    def row(self, t, q, v):
        """What docs/hosts.md draws and compares."""
        numbers, _, _ = self.seen(t, np.asarray(q, float), np.asarray(v, float))
        _, (right, left) = self.wrench(numbers)
        regions = [contact.regions() for contact in self.contacts]
        steepest = max((abs(each.angle) for side in regions for each in side), default=0.0)
        return [t, *q[0:4], q[5], v[4], numbers[10], *right[1:3], *left[1:3], len(regions[0]), len(regions[1]), np.degrees(steepest)]


def report(rows, file=None):
    """What a run came to; the rows as a file."""
    data = np.array(rows)
    y = data[:, 2] - data[:, 7]
    print(f"lateral against the rails: rms {1e3 * np.std(y):.2f} mm, largest {1e3 * np.max(np.abs(y)):.2f} mm; "
          f"largest lateral force of a wheel {1e-3 * np.max(np.abs(data[:, [8, 10]])):.0f} kN")
    print(f"rows with contact on a flange's root {np.sum(data[:, 14] > 12)}, on a flange {np.sum(data[:, 14] > 40)}, "
          f"with two regions on a wheel {np.sum(np.max(data[:, 12:14], axis=1) > 1)} of {len(data)}")
    if file:
        np.savetxt(file, data, "%.9g", ",", comments="",
                   header="t,x,y,z,roll,yaw,spin,rail_y,y_right,z_right,y_left,z_left,regions_right,regions_left,steepest")
