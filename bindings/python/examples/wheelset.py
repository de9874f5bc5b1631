"""The wheelset of docs/hosts.md on its irregular track, for any host. Coordinates: x (against a frame that moves at constant
speed), y, z, roll, turning about the axle against free rolling, yaw about the rolled axis; complex ones give derivatives.
What the library is told: y, z, roll, yaw, velocity, rates of roll, pitch and yaw, the rails' y and slope: TOLD of wrc.WrenchInput."""
import numpy as np
import wrc

SPEED, RADIUS, LOAD = 40.0, 0.46, 160e3  # m/s, m, N on the rails
ACROSS, ABOUT, SPRINGS = 800.0, 100.0, np.array([4e6, 2e6, 1e6])  # kg m2, N/m at (0, +-1 m, 0)
MASS = np.array([1500.0, 1500.0, 1500.0, ACROSS, ABOUT, ACROSS])
TOLD = [*range(wrc.WrenchInput.RAIL_Y + 1), wrc.WrenchInput.RAIL_Y_SLOPE]
WAVES, PHASES = 3.0 * 20.0 ** (np.arange(40) / 39.0), 0.618034 * np.arange(1, 41)  # m, turns


class Wheelset:
    def __init__(self, rms=1.5e-3):
        model = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK")
        self.wheels = wrc.Batch([model.contact("RIGHT"), model.contact("LEFT")])
        self.scale = rms / np.sqrt(0.5 * np.sum(WAVES ** 2))
        at_rest = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=LOAD / 2, friction={"coefficient": 0.0})
        self.height = self.wheels.wrench(at_rest)["z"][0]
        self.input, self.out = wrc.WheelInput(friction={"coefficient": 0.3}), wrc.Wrench.array(2)

    def track(self, x):
        """Lateral displacement of both rails: 40 cosines of 3 to 60 m, faded in over the first 10 m."""
        t = x / 10.0 if 0.0 < x.real < 10.0 else float(x.real > 0.0)
        return t * t * (3.0 - 2.0 * t) * self.scale * np.sum(WAVES * np.cos(2 * np.pi * (x / WAVES + PHASES)))

    def seen(self, t, q, v):
        """What the library is told; the wheelset's own axes, which do not turn about the axle."""
        cr, sr, cy, sy = np.cos(q[3]), np.sin(q[3]), np.cos(q[5]), np.sin(q[5])
        own = np.array([[cy, -sy, 0], [cr * sy, cr * cy, -sr], [sr * sy, sr * cy, cr]])
        x = SPEED * t + q[0]
        slope = (self.track(x + 1e-4) - self.track(x - 1e-4)) / 2e-4
        pitch_rate = v[4] - SPEED / RADIUS + v[3] * sy  # v[4]: the whole turning's part along the axle
        told = [q[1], self.height + q[2], q[3], q[5], SPEED + v[0], v[1], v[2], v[3], pitch_rate, v[5], self.track(x), slope]
        return np.array(told), own

    def balance(self, q, v, own, force, moment):
        """MASS * acceleration under the rails' force and moment; of roll and yaw by Euler's equations."""
        for side in (1, -1):
            spring = -SPRINGS * (q[:3] + side * (own[:, 1] - [0, 1, 0]))
            force, moment = force + spring + [0, 0, LOAD / 2], moment + np.cross(side * own[:, 1], spring)
        forward, axle, third = own.T @ moment
        spin, cy, sy = ABOUT * (v[4] - SPEED / RADIUS), np.cos(q[5]), np.sin(q[5])
        return np.array([*force, (forward + v[5] * spin + 2 * ACROSS * v[3] * v[5] * sy) / cy, axle,
                         third - v[3] * cy * spin - ACROSS * v[3] ** 2 * sy * cy])

    def forces(self, t, q, v):
        told, own = self.seen(t, q, v)
        wheel, rail = self.input.wheel, self.input.rail
        wheel.y, wheel.z, wheel.roll, wheel.yaw = told[:4]
        wheel.velocity, wheel.roll_rate, wheel.pitch_rate, wheel.yaw_rate = told[4:7], *told[7:10]
        rail.y, rail.y_slope = told[10:]
        rails = self.wheels.wrench(self.input, out=self.out)
        return self.balance(q, v, own, rails["force"].sum(axis=0), rails["moment"].sum(axis=0))
