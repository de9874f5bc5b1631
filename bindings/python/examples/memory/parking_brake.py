"""A wheel that its parking brake holds, on a frame that swings: Mindlin's loop. parking_brake.py [--swings 2] [--picture mindlin.png]

The locked wheel is carried along the rail by the frame, back and forth, with three amplitudes. Force over displacement is drawn beside the
closed form (Cattaneo 1938, Mindlin 1949; branches by Masing's rule) and beside exact contact of the same ellipse, cell by cell
(wrc.exact.Transient). Profiles are a wheel of constant radius on a rail of the same radius across, so that the contact is Hertz's circle."""
import argparse

import numpy as np
import wrc

RADIUS, LOAD, FRICTION, STEP = 0.46, 80e3, 0.3, 1e-3  # m, N, -, s
LIMIT = FRICTION * LOAD


def ball_on_plane():
    """A cylinder that rolls on a rail with an arc across: equal curvatures along and across."""
    y = np.linspace(-0.035, 0.035, 281)
    rail = wrc.Profile(y=y, z=RADIUS - np.sqrt(RADIUS ** 2 - y ** 2))
    wheel = wrc.Profile(y=np.linspace(-0.06, 0.06, 121), z=np.zeros(121))
    return wrc.Model(wheel=wheel, rail=rail, track={"placement": "ORIGIN", "rail_origin": 0.75}, surface={"memory": 1})


class Hertz:
    """The circle of the pair, and shifts of it by the closed form."""

    def __init__(self, material=wrc.Material()):
        shear, poisson = material.shear_modulus, material.poisson
        self.a = (1.5 * LOAD * RADIUS * (1 - poisson) / (2 * shear)) ** (1 / 3)
        self.compliance = (2 - poisson) / (4 * shear * self.a)  # m/N, of small shifts

    def slip_all(self):
        return 1.5 * LIMIT * self.compliance

    def force(self, shift):
        """First loading."""
        return np.sign(shift) * LIMIT * (1 - (1 - np.minimum(np.abs(shift) / self.slip_all(), 1)) ** 1.5)

    def loop(self, amplitude, count=100):
        back = np.linspace(amplitude, -amplitude, count)
        down = self.force(amplitude) - 2 * self.force((amplitude - back) / 2)
        return np.concatenate([back, -back]), np.concatenate([down, -down])

    def loss(self, amplitude):
        """Work of a whole loop [J]: 8 Int F dx - 4 F x of first loading."""
        part, force = min(amplitude / self.slip_all(), 1.0), self.force(amplitude)
        under = LIMIT * self.slip_all() * (part - 0.4 * (1 - (1 - part) ** 2.5)) + LIMIT * max(amplitude - self.slip_all(), 0.0)
        return 8 * under - 4 * force * amplitude


def work(shift, force):
    """Of the frame on the wheel, round a closed loop [J]: trapezoids."""
    return float(np.sum(np.diff(shift) * -0.5 * (force[1:] + force[:-1])))


def swing(amplitude, swings, steps=80):
    """Shifts and forces of the locked wheel, from rest."""
    wheel = ball_on_plane().contact()
    data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=LOAD, friction={"coefficient": FRICTION})
    data.wheel.z = wheel.wrench(data).z
    data.prescribed, data.vertical_load, data.time_step = "HEIGHT", 0.0, STEP
    wheel.wrench(data)
    wheel.commit()
    shift = amplitude * np.sin(2 * np.pi * np.arange(steps * swings + 1) / steps)
    force = [0.0]
    for move in np.diff(shift):
        data.wheel.velocity[0] = move / STEP  # the brake holds: pitch_rate stays 0
        force.append(wheel.wrench(data).force[0])
        wheel.commit()
    return shift, np.array(force), wheel


def exact(hertz, amplitude, steps=40, cells=30):
    """The same by exact contact of cells: one whole loop after the first loading."""
    size = 2.1 * hertz.a / cells
    grid = wrc.exact.grid(cells, cells, size)
    middle = (np.arange(cells) - (cells - 1) / 2) * size
    inside = np.clip(1 - (middle[None, :] ** 2 + middle[:, None] ** 2) / hertz.a ** 2, 0, None)
    pressure = np.sqrt(inside)
    pressure *= LOAD / (pressure.sum() * size ** 2)
    bodies = wrc.exact.Transient(grid)
    shift = amplitude * np.sin(2 * np.pi * np.arange(steps // 4 * 5 + 1) / steps)
    force = [0.0]
    for move in np.diff(shift):
        found, _ = bodies.step(pressure, friction=FRICTION, creepage={"longitudinal": move / size, "speed": 0.0})
        force.append(found.fx)
    return shift, np.array(force)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--swings", type=int, default=2)
    arguments.add_argument("--cells", type=int, default=30, help="of the exact contact, each way")
    arguments.add_argument("--picture")
    options = arguments.parse_args()
    hertz, rows = Hertz(), []
    print(f"Hertz's circle: radius {1e3 * hertz.a:.3f} mm, all slips at {1e6 * hertz.slip_all():.2f} um")
    for part in (0.3, 0.6, 0.9):
        amplitude = part * hertz.slip_all()
        shift, force, wheel = swing(amplitude, options.swings)
        last = slice(-81, None)
        slow, cells = exact(hertz, amplitude, cells=options.cells)
        closed, lost, by_cells = hertz.loss(amplitude), work(shift[last], force[last]), work(slow[-41:], cells[-41:])
        off = np.max(np.abs(-force[:21] - hertz.force(shift[:21]))) / LIMIT
        rows.append((amplitude, shift, -force, slow, -cells))
        print(f"amplitude {1e6 * amplitude:6.2f} um: loss of a loop {1e3 * lost:8.3f} mJ, closed form {1e3 * closed:8.3f} "
              f"({100 * (lost / closed - 1):+.1f} %), exact cells {1e3 * by_cells:8.3f} ({100 * (by_cells / closed - 1):+.1f} %); "
              f"first loading within {100 * off:.2f} % of the friction limit")
    if options.picture:
        draw(hertz, rows, options.picture)


def draw(hertz, rows, path):
    figure = wrc.plot.figure(figsize=(8.5, 6))
    axes = figure.subplots()
    for k, (amplitude, shift, force, slow, cells) in enumerate(rows):
        x, f = hertz.loop(amplitude)
        axes.plot(1e6 * x, f / LIMIT, color="0.55", lw=3, label="closed form" if k == 0 else None)
        axes.plot(1e6 * shift, force / LIMIT, color="#0072B2", lw=1.1, label="wheel that remembers" if k == 0 else None)
        axes.plot(1e6 * slow, cells / LIMIT, ".", color="#D55E00", ms=4, label="exact, cell by cell" if k == 0 else None)
    axes.set(xlabel="displacement of the frame [um]", ylabel="force on the rail / (friction x load)", ylim=(-1.05, 1.05))
    axes.legend()
    figure.savefig(path)


if __name__ == "__main__":
    main()
