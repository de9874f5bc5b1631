"""A four-axle vehicle on a slope brakes to a stop, rests, starts uphill, stops, rolls back, stops: vehicle.py [--short] [--picture vehicle.png]

A body on two bogies on four wheelsets, along the track: springs between them, brakes that hang on springs, loads of the axles from the pitch
of body and bogies (quasi-static). The wheels run centred; lateral motion and yaw are left out. Implicit Euler steps of 10 ms, Newton's method
with differences of trials; each accepted step is committed. The same vehicle without memory runs beside."""
import argparse

import numpy as np
import wrc
from braked import DAMPING, GRAVITY, INERTIA, RADIUS, SLOPE, STIFFNESS, Braked

STEP, AXLES = 10e-3, 4  # s, -
MASS = np.array([32e3, 2.6e3, 2.6e3, 1.4e3, 1.4e3, 1.4e3, 1.4e3])  # body, bogies, wheelsets [kg]
SPRING = np.array([5e6] * 2 + [24e6] * 4)  # bogies to body, wheelsets to bogies [N/m]
DAMPER = np.array([5e5] * 2 + [1e5] * 4)  # N s/m
LINKS = np.array([[-1, 1, 0, 0, 0, 0, 0], [-1, 0, 1, 0, 0, 0, 0], [0, -1, 0, 1, 0, 0, 0], [0, -1, 0, 0, 1, 0, 0],
                  [0, 0, -1, 0, 0, 1, 0], [0, 0, -1, 0, 0, 0, 1]], float)  # ends that a spring joins
BRAKE, MOTOR, RAMP = 6e3, 3.4e3, 0.5  # N m an axle, s until a torque is there
BODY_HEIGHT, PIVOT_HEIGHT, BOGIE_HEIGHT, PIVOTS, BASE = 1.8, 0.7, 0.6, 17.0, 2.5  # m; between pivots, between axles of a bogie
STATIC = GRAVITY * (MASS[0] / 4 + MASS[1] / 2 + MASS[3])  # N an axle
JOURNEY = (("brakes, rests", 23.0, 1, 0.0), ("starts uphill", 6.0, 0, 1.0), ("brakes, rests", 13.0, 1, 0.0), ("rolls back", 5.0, 0, -0.3),
           ("brakes, rests", 12.0, 1, 0.0))  # seconds, braked or not, part of the motor's torque


class Axle(Braked):
    """The wheelset beside, under a load that changes."""

    def __init__(self, memory):
        super().__init__(memory)
        self.input.prescribed = "VERTICAL_LOAD"

    def under(self, load, v, w):
        """Force [N] and moment [N m] of both wheels, for a load of the axle [N]."""
        self.input.vertical_load = load / 2
        return self.forces(v, w, STEP)

    def derivatives(self, at, load, v, w):
        """By load, v and w: differences of trials."""
        steps = np.diag([1.0, 1e-8, 1e-8 / RADIUS])
        return np.column_stack([(self.under(load + dq, v + dv, w + dw) - at) / (dq + dv + dw) for dq, dv, dw in steps])


class Vehicle:
    """Unknown are the speeds at the end of a step: seven along the track [m/s], four of the axles [rad/s]."""

    def __init__(self, memory, speed):
        self.axles = [Axle(memory) for _ in range(AXLES)]
        self.u = np.array([speed] * 7 + [-speed / RADIUS] * AXLES)
        self.x, self.stretch, self.twist = np.zeros(7), np.zeros(6), np.zeros(AXLES)
        self.inverse = None  # of the residual's slopes
        self.inertia = np.concatenate([MASS, [INERTIA] * AXLES])
        self.scale = np.array([1.0] * 7 + [RADIUS] * AXLES)
        self.loads_by_springs, self.loads_by_brakes = self.load_transfer()

    @staticmethod
    def load_transfer():
        """Change of the axles' loads by forces of springs and torques of brakes: body and bogies do not pitch up faster."""
        springs, brakes = np.zeros((AXLES, 6)), np.zeros((AXLES, AXLES))
        for axle in range(AXLES):
            bogie, fore = axle // 2, 1 if axle % 2 == 0 else -1
            springs[axle, :2] = (-1 if bogie == 0 else 1) * (BODY_HEIGHT - PIVOT_HEIGHT) / PIVOTS / 2
            springs[axle, bogie] += fore * (BOGIE_HEIGHT - PIVOT_HEIGHT) / BASE
            for each in (2 * bogie, 2 * bogie + 1):
                springs[axle, 2 + each] = -fore * (BOGIE_HEIGHT - RADIUS) / BASE
                brakes[axle, each] = fore / BASE
        return springs, brakes

    def brakes(self, w, limit):
        """Torques on the axles [N m], twists of their springs [rad], and the torques' slopes: a spring that yields at the limit."""
        twist = self.twist + STEP * w
        most = (limit + DAMPING / STEP * self.twist) / (STIFFNESS + DAMPING / STEP)
        least = (-limit + DAMPING / STEP * self.twist) / (STIFFNESS + DAMPING / STEP)
        slope = np.where((twist > least) & (twist < most), -STIFFNESS * STEP - DAMPING, 0.0)
        twist = np.clip(twist, least, most)
        return -STIFFNESS * twist - DAMPING * (twist - self.twist) / STEP, twist, slope

    def residual(self, u, limit, motor):
        """Speeds that are left over, and all that was found with them."""
        v, w = u[:7], u[7:]
        rate = LINKS @ v
        springs = SPRING * (self.stretch + STEP * rate) + DAMPER * rate  # on the body or bogie above, forwards
        torque, twist, slope = self.brakes(w, limit)
        # a motor's torque is carried by the bogie, as that of a brake
        load = STATIC + self.loads_by_springs @ springs + self.loads_by_brakes @ (torque + motor)
        wheels = np.array([axle.under(*each) for axle, *each in zip(self.axles, load, v[3:], w)])
        force = -LINKS.T @ springs - MASS * GRAVITY * SLOPE
        force[3:] += wheels[:, 0]
        left = u - self.u - STEP * np.concatenate([force, wheels[:, 1] + torque + motor]) / self.inertia
        return left, (wheels, load, springs, torque, twist, slope)

    def slopes(self, u, found):
        """Of the residual by the speeds."""
        wheels, load, _, _, _, slope = found
        stiff = (SPRING * STEP + DAMPER)[:, None] * LINKS
        by = np.zeros((11, 11))
        by[:7, :7] = -LINKS.T @ stiff
        by[7:, 7:] = np.diag(slope)
        load_by = np.hstack([self.loads_by_springs @ stiff, self.loads_by_brakes * slope])
        for k, axle in enumerate(self.axles):
            by_load, by_v, by_w = axle.derivatives(wheels[k], load[k], u[3 + k], u[7 + k]).T
            rows = [3 + k, 7 + k]
            by[rows] += np.outer(by_load, load_by[k])
            by[rows, 3 + k] += by_v
            by[rows, 7 + k] += by_w
        return np.eye(11) - STEP * by / self.inertia[:, None]

    def step(self, limit, motor, tolerance=1e-10):
        """One step, committed: what it found, Newton's iterations, whether they converged, and its energies."""
        u, count = self.u.copy(), 0
        left, found = self.residual(u, limit, motor)
        before = np.linalg.norm(self.scale * left)
        while before > tolerance and count < 60:
            count += 1
            fresh = self.inverse is None
            if fresh:
                self.inverse = np.linalg.inv(self.slopes(u, found))
            change = -self.inverse @ left
            for part in 0.5 ** np.arange(8.0) if fresh else (1.0,):  # half as far where it is no better
                trial = self.residual(u + part * change, limit, motor)
                after = np.linalg.norm(self.scale * trial[0])
                if after < before:
                    break
            if after > 0.2 * before:  # else slopes are kept, over steps too
                self.inverse = None
            if fresh or after < before:
                u, (left, found), before = u + part * change, trial, after
        for axle, load, v, w in zip(self.axles, found[1], u[3:7], u[7:]):
            axle.under(load, v, w)  # the last trial is the one to commit
            axle.commit()
        energy = self.energies(u, found, motor)
        self.u, self.twist = u, found[4]
        self.x, self.stretch = self.x + STEP * u[:7], self.stretch + STEP * LINKS @ u[:7]
        return found, count, before <= tolerance, energy

    def energies(self, u, found, motor):
        """Of the step [J]: change of kinetic energy; work of contact, gravity, springs with dampers, brakes, motors; what Euler's
        rule loses; friction's heat by the contacts' power."""
        wheels, _, springs, torque, _, _ = found
        return np.array([0.5 * self.inertia @ (u ** 2 - self.u ** 2), STEP * (wheels[:, 0] @ u[3:7] + wheels[:, 1] @ u[7:]),
                         -STEP * GRAVITY * SLOPE * MASS @ u[:7], -STEP * springs @ (LINKS @ u[:7]), STEP * torque @ u[7:],
                         STEP * motor * u[7:].sum(), -0.5 * self.inertia @ (u - self.u) ** 2,
                         2 * STEP * sum(axle.wrench.power for axle in self.axles)])


class Record:
    """Of a journey, step by step."""

    def __init__(self, memory, speed, journey):
        vehicle, rows, adhesion, self.parts, self.energy, self.failures = Vehicle(memory, speed), [], [], [], np.zeros(8), 0
        brake = motor = 0.0
        for name, seconds, braked, driven in journey:
            begin = len(rows)
            for k in range(round(seconds / STEP)):
                brake = np.clip(BRAKE * braked, brake - BRAKE * STEP / RAMP, brake + BRAKE * STEP / RAMP)
                motor = np.clip(-MOTOR * driven, motor - MOTOR * STEP / RAMP, motor + MOTOR * STEP / RAMP)
                found, count, converged, energy = vehicle.step(brake, motor)
                self.energy, self.failures = self.energy + energy, self.failures + (not converged)
                rows.append([(len(rows) + 1) * STEP, vehicle.x[0], vehicle.u[0], count])
                adhesion.append(np.concatenate([found[0][:, 0] / found[1], found[1]]))
            self.parts.append((name, begin, len(rows)))
        self.t, self.x, self.v, self.count = np.array(rows).T
        self.adhesion, self.load = np.split(np.array(adhesion), 2, axis=1)
        self.calls = sum(axle.calls for axle in vehicle.axles)

    def stops(self):
        """Rows of each stop (the first turn of the speed under a brake), and the end of the rest after it."""
        for name, begin, end in self.parts:
            if name.startswith("brakes"):
                turned = np.flatnonzero(self.v[begin:end] * np.sign(self.v[begin]) <= 0.0)
                yield (begin + turned[0] if len(turned) else end - 1), end

    def tell(self, name, settled):
        for number, (stop, end) in enumerate(self.stops(), 1):
            v, still = self.v[stop:end], stop + round(settled / STEP)
            turns = np.sum((v[1:] * v[:-1] < 0.0) & (np.abs(np.diff(v)) > 1e-6))
            change = np.diff(self.adhesion[stop:end], axis=0)  # chatter: forces that swing from step to step
            chatter = np.sum((change[2:] * change[1:-1] < 0.0) & (change[1:-1] * change[:-2] < 0.0) & (np.abs(change[1:-1]) > 1e-4))
            print(f"{name}: stop {number} at {self.x[stop]:.3f} m; swings {turns} times on its springs, {chatter} chatters; "
                  f"at rest, from {settled:g} s on for {STEP * (end - still):.1f} s, it drifts {1e6 * (self.x[end - 1] - self.x[still]):+.3g} um")
        kinetic, *work, heat = self.energy
        print(f"{name}: {len(self.t)} steps, {self.failures} failed; Newton iterations {self.count.mean():.2f} per step, most {self.count.max():.0f}; "
              f"{self.calls} calls; loads of axles {self.load.min() / 1e3:.1f} to {self.load.max() / 1e3:.1f} kN, "
              f"adhesion up to {np.abs(self.adhesion).max():.3f}")
        print(f"{name}: kinetic energy {kinetic / 1e3:+.3f} kJ; work of contact {work[0] / 1e3:+.5g} (heat {heat / 1e3:.5g}), "
              f"gravity {work[1] / 1e3:+.3f}, springs {work[2] / 1e3:+.3f}, "
              f"brakes {work[3] / 1e3:+.3f}, motors {work[4] / 1e3:+.3f}, Euler's rule {work[5] / 1e3:+.3f}; left over {sum(work) - kinetic:.2g} J")


def draw(with_memory, without, settled, path):
    figure = wrc.plot.figure(figsize=(11, 8))
    panels = figure.subplots(2, 2)
    t = with_memory.t
    panels[0, 0].plot(t, with_memory.v, color="#0072B2", lw=1.2)
    panels[0, 0].set(ylabel="speed of the body [m/s]")
    for k, colour in enumerate(("#0072B2", "#56B4E9", "#D55E00", "#E69F00")):
        panels[0, 1].plot(t, with_memory.adhesion[:, k], color=colour, lw=0.9, label=f"axle {k + 1}")
        panels[1, 0].plot(t, with_memory.load[:, k] / 1e3, color=colour, lw=0.9, label=f"axle {k + 1}")
    panels[0, 1].set(ylabel="adhesion: force along the track / load")
    panels[1, 0].set(ylabel="load of the axle [kN]")
    for axes in panels.flat[:3]:
        axes.set(xlabel="time [s]")
        axes.margins(x=0.01)
        for _, _, end in with_memory.parts[:-1]:
            axes.axvline(t[end - 1], color="0.8", lw=0.8)
    panels[0, 1].legend(fontsize=8, ncols=2)
    panels[0, 0].set_title("on 20 per mille: brakes, starts, brakes, rolls back, brakes", fontsize=10)
    for run, colour, name in ((with_memory, "#0072B2", "memory"), (without, "#D55E00", "without: a damper")):
        for number, ((stop, end), style) in enumerate(zip(run.stops(), ("-", "--", ":")), 1):
            still = np.arange(stop + round(settled / STEP), end)
            panels[1, 1].plot(STEP * (still - stop), 1e6 * (run.x[still] - run.x[still[0]]), style, color=colour, lw=1.3, label=f"{name}, stop {number}")
    panels[1, 1].set(xlabel="time since the stop [s]", ylabel="place [um]")
    panels[1, 1].set_title(f"at rest: the place from {settled:g} s on", fontsize=10)
    panels[1, 1].legend(fontsize=8)
    figure.savefig(path)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--short", action="store_true", help="one stop, from walking pace")
    arguments.add_argument("--picture")
    options = arguments.parse_args()
    speed, journey, settled = (0.05, (("brakes, rests", 2.2, 1, 0.0),), 1.7) if options.short else (15 / 3.6, JOURNEY, 5.0)
    runs = [Record(memory, speed, journey) for memory in (True, False)]
    for run, name in zip(runs, ("memory", "without")):
        run.tell(name, settled)
    if options.picture:
        draw(*runs, settled, options.picture)


if __name__ == "__main__":
    main()
