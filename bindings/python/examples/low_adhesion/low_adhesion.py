"""Wheels that change the rail: each axle finds the films as those before it left them.

    python low_adhesion.py stop [--speed 20] [--cars 2]     cars stop on wet leaves with slide protection, without and with sand
    python low_adhesion.py traction                         a locomotive of four axles looks for the slip with most adhesion
    python low_adhesion.py start                            a freight locomotive of six axles starts 1100 t on damp oxide, without and with sand
    python low_adhesion.py curve                            creep curve on a roller rig, slip up and down twice
    python low_adhesion.py lubricator                       grease at a gauge corner, which wheels carry along the rail and onto its tread

--picture FILE draws it. Steps are 1 ms. Left and right are alike: one wheel of each axle is computed, on one rail. Brakes, sanders and
controls are simple stand-ins. examples_c/low_adhesion.c has the first four in C.
"""
import argparse

import numpy as np

import wrc

STEP, RADIUS, GRAVITY = 1e-3, 0.46, 9.81  # s, m, m/s^2
SANDER = 0.3  # before its axle [m]


class Axle:
    """One wheel of it: contact, tread, passage of a step, speed of the tread [m/s], share of the full torque 0..1, force forwards [N]
    and frictional energy [J]."""

    def __init__(self, model, behind, speed):
        self.contact, self.behind, self.turning = model.contact(), behind, speed
        self.tread = wrc.Band(24, 2 * np.pi * RADIUS / 24, closed=True)
        self.passage = wrc.SurfacePassage()
        self.torque = self.force = self.energy = 0.0


class Train:
    """Axles on a rail, S1002 on 60E1.

    behind: of each axle, the front of the train [m]; axle_load [kg]; mass: of all [kg]; inertia: of an axle [kg m^2]
    full: torque of an axle's motors, < 0 of its brakes [N m]
    rail: where its bins begin and end, and their length [m]. At a crawl a wheel that spins cleans the length of its contact: 5 mm
    """

    def __init__(self, behind, axle_load, speed, mass=np.inf, inertia=np.inf, full=0.0, rail=(-110.0, 1500.0, 0.1)):
        model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}, preset="real time")
        self.axles = [Axle(model, each, speed) for each in behind]
        self.load, self.speed, self.mass, self.inertia, self.full = 0.5 * axle_load * GRAVITY, speed, mass, inertia, full
        first, last, length = rail
        self.rail = wrc.Band(int(np.ceil((last - first) / length)), length, first=first)
        self.laws, self.dry = wrc.surface_laws("low adhesion"), wrc.Friction(coefficient=0.4)
        self.place, self.time, self.lines = 0.0, 0.0, []
        data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=self.load)
        self.data = wrc.WheelInput(start="WARM", wheel={"z": self.axles[0].contact.wrench(data).z})

    def lay(self, quantity, amount):
        """A substance along the whole rail [kg/m^2]."""
        band = self.rail.struct
        self.rail.add(quantity, amount, band.first, band.first + band.count * band.length)

    def strew(self, axle, rate):
        """Sand before a wheel, over the way of a step [kg/s]."""
        at, way = self.place - axle.behind + SANDER, self.speed * STEP
        self.rail.add("SAND", rate * STEP / (self.rail.struct.width * way), at, at + way)

    def slip(self, axle):
        return axle.turning / self.speed - 1.0

    def wrench(self, axle, turning):
        """Force forwards [N], moment about the axle [N m] and frictional power [W] of a wheel that turns so fast [m/s]."""
        self.data.wheel.velocity = (self.speed, 0.0, 0.0)
        self.data.wheel.pitch_rate = -turning / RADIUS
        wrench = axle.contact.wrench(self.data)
        return wrench.force[0], wrench.moment[1], wrench.power

    def step_axle(self, axle):
        """Friction of the films, wrench, rotation, passage. Slides are soft; where the wheel rolls a difference gives the slope."""
        at, passage = self.place - axle.behind, axle.passage
        passage.rail_from, passage.rail_to = at, at + self.speed * STEP
        passage.wheel_from, passage.wheel_to = passage.wheel_to, passage.wheel_to + axle.turning * STEP
        wrc.surface_friction(self.rail, axle.tread, self.laws, passage, self.dry, out=self.data.friction)
        force, moment, power = self.wrench(axle, axle.turning)
        by_force = by_moment = 0.0
        if abs(axle.turning - self.speed) < 0.03 * self.speed:
            little = 1e-4 * self.speed
            more, turned, _ = self.wrench(axle, axle.turning + little)
            by_force, by_moment = (more - force) / little, max(0.0, (turned - moment) / little)
        slowing = 2.0 * moment - self.full * axle.torque
        change = -STEP * RADIUS * slowing / (self.inertia + STEP * RADIUS * 2.0 * by_moment)
        if self.full < 0.0:
            change = max(change, -axle.turning)  # a brake does not turn it back
        passage.energy = power * STEP
        wrc.surface_pass(self.rail, axle.tread, self.laws, passage)
        axle.tread.rest(self.laws, STEP)
        axle.turning, axle.force, axle.energy = axle.turning + change, force + by_force * change, axle.energy + passage.energy

    def step(self, resistance=0.0):
        """All axles in the order in which they pass, then the speed by their forces and a resistance [N]."""
        for axle in self.axles:
            self.step_axle(axle)
        self.place += self.speed * STEP
        self.speed += STEP * (2.0 * sum(axle.force for axle in self.axles) - resistance) / self.mass
        self.time += STEP
        if self.time % 1.0 < STEP:
            self.rail.rest(self.laws, 1.0)
        self.note()

    def note(self):
        self.lines.append([self.time, self.speed, *(self.slip(axle) for axle in self.axles), *(axle.force / self.load for axle in self.axles)])

    def table(self):
        """Of each step: time [s], speed [m/s]; slips and adhesions, a column for each axle."""
        lines, count = np.array(self.lines), len(self.axles)
        return lines[:, 0], lines[:, 1], lines[:, 2:2 + count], lines[:, 2 + count:]

    def mean_adhesions(self):
        """Of each axle, over the way."""
        _, speed, _, adhesions = self.table()
        return np.average(np.abs(adhesions), axis=0, weights=speed)


def stop(kmh=20.0, sand=False, cars=2):
    """Slide protection lets the brake go above 15 % slip, holds it between, builds it up below 5 %. A sander stands before axle 3."""
    behind = [26.4 * car + place for car in range(cars) for place in (0.0, 2.5, 19.0, 21.5)]
    demand = 1.0  # of braking [m/s^2]
    train = Train(behind, 11.5e3, kmh / 3.6, mass=len(behind) * 11.5e3, inertia=110.0, full=-11.5e3 * demand * RADIUS)
    train.lay("FILM", 0.009)
    train.lay("WATER", 0.020)
    sander, since = train.axles[2], 0.0  # it slid [s]
    while train.speed > 0.5:
        for axle in train.axles:
            slide = -train.slip(axle)
            axle.torque = min(1.0, max(0.0, axle.torque + STEP * (-4.0 if slide > 0.15 else 1.0 if slide < 0.05 else 0.0)))
        since = 0.0 if train.slip(sander) < -0.05 else since + STEP
        if sand and since < 2.0 and train.speed > 3.0:
            train.strew(sander, 2.0 / 60.0)
        train.step()
    return train


def traction(seconds=60):
    """Motors turn all axles to a wished slip, which climbs to where they pull most. Wishes, and pulls [N], second by second."""
    train = Train([0.0, 2.6, 9.9, 12.5], 21e3, 8.0, inertia=250.0, full=0.4 * 21e3 * GRAVITY * RADIUS)  # the train holds its speed
    train.dry = wrc.Friction(coefficient=0.4, speed_law="EXPONENTIAL", fall_rate=0.2)  # Polach, wet: more slip cleans more, and slides faster
    train.lay("FILM", 0.006)
    train.lay("WATER", 0.020)
    wish, change, wishes, pulls = 0.04, 0.01, [], [0.0]
    for _ in range(seconds):
        pull = 0.0
        for _ in range(1000):
            for axle in train.axles:
                axle.torque = min(1.0, max(0.0, 0.3 + 20.0 * (wish - train.slip(axle))))
                pull += 2e-3 * axle.force
            train.step()
        change = -change if pull < pulls[-1] else change
        wishes.append(wish)
        pulls.append(pull)
        wish = min(0.5, max(0.005, wish + change))
    return train, wishes, pulls[1:]


def start(sand=False, seconds=30.0):
    """Creep control: a tread that runs 0.3 m/s too fast loses torque. Sanders stand before axles 1 and 4. The slope is 10 per mille."""
    train = Train([0.0, 2.0, 4.0, 12.0, 14.0, 16.0], 22e3, 0.1, mass=6 * 22e3 + 1100e3, inertia=300.0, full=0.33 * 22e3 * GRAVITY * RADIUS,
                  rail=(-20.0, 120.0, 0.005))
    train.lay("OXIDE", 0.006)
    train.lay("WATER", 0.006)
    for _ in range(round(seconds / STEP)):
        for axle in train.axles:
            creep = axle.turning - train.speed
            axle.torque = min(1.0, max(0.0, axle.torque + STEP * (-4.0 if creep > 0.3 else 0.5 if creep < 0.15 else 0.0)))
        if sand:
            for axle in train.axles[::3]:
                train.strew(axle, 0.4 / 60.0)
        train.step(0.010 * train.mass * GRAVITY if train.time > 3.0 else 0.0)
        if train.time <= 3.0:
            train.speed = 0.1  # the train hangs on its brakes until the locomotive pulls
        if train.speed <= 0.02:
            break
    return train


def curve():
    """A driven wheel on a driven roller, whose band is closed and sprayed with water: slip up to 10 % and down in 8 s, twice."""
    rig = Train([0.0], 11.5e3, 10.0)
    rig.rail = wrc.Band(30, 0.1, closed=True)
    rig.lay("FILM", 0.009)
    rig.lay("WATER", 0.020)
    wheel, = rig.axles
    for step in range(16000):
        wheel.turning = rig.speed * (1.0 - 0.1 * (1.0 - abs(step * STEP % 8.0 / 4.0 - 1.0)))
        if step % 100 == 0:
            rig.lay("WATER", 2e-3)
        rig.step_axle(wheel)
        rig.place, rig.time = rig.place + rig.speed * STEP, rig.time + STEP
        rig.note()
    return rig


def lubricator(axles=32, grease=0.05):
    """A lubricator greases the gauge corner of the outer rail of a curve over 3 m, before every eighth axle. The axles' flanges touch the
    rail there. Further on the axles move away from it by up to 8 mm and back. Bands have rows across. Gives the rail, the places along
    it [m], and there each axle's displacement [m] and frictional power of its outer wheel [W]."""
    model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}, preset="real time")
    contact, speed, way, laws = model.contact(), 20.0, 0.1, wrc.surface_laws("low adhesion")
    laws.lubricant.carry = 1.0  # a grease that wheels pick up well
    rail = wrc.Band(40, 1.0, width=6e-3, rows=10, row_first=-37e-3)
    data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=60e3, wheel={"velocity": (speed, 0.0, 0.0), "pitch_rate": -speed / RADIUS * 0.997})
    dry, passage = wrc.Friction(coefficient=0.4), wrc.SurfacePassage()
    places = np.arange(1.0, 39.0, way)
    shifts, powers = np.zeros((2, axles, len(places)))
    for axle in range(axles):
        if axle % 8 == 0:
            rail.row(0).add("LUBRICANT", grease, 4.0, 7.0)  # y from -37 to -31 mm
        tread = wrc.Band(24, 2 * np.pi * RADIUS / 24, width=6e-3, closed=True, rows=10, row_first=-43e-3)
        for k, at in enumerate(places):
            shifts[axle, k] = data.wheel.y = 6.8e-3 - (1.0 + axle % 8) * 0.5e-3 * (1.0 - np.cos(2 * np.pi * max(0.0, at - 7.0) / 16.0))
            passage.rail_from = passage.wheel_from = at
            passage.rail_to = passage.wheel_to = at + way
            wrc.surface_friction(rail, tread, laws, passage, dry, out=data.friction)
            powers[axle, k] = contact.wrench(data).power
            passage.energy = powers[axle, k] * way / speed
            wrc.surface_pass(rail, tread, laws, passage, contact)
    return rail, places, shifts, powers


def at_half(rig):
    """Adhesion at half of the largest slip, on each branch of the curve."""
    return -rig.table()[3][2000::4000, 0]


def draw_runs(runs):
    """Speed over time, and adhesion of each axle, of runs of stop() or start() by their names."""
    figure = wrc.plot.figure(figsize=(9, 4))
    left, right = figure.subplots(1, 2)
    for label, train in runs.items():
        time, speed, _, _ = train.table()
        left.plot(time, 3.6 * speed, label=f"{label}: {train.place:.0f} m")
        right.plot(np.arange(len(train.axles)) + 1, train.mean_adhesions(), "o-", label=label)
    left.set(xlabel="time [s]", ylabel="speed [km/h]")
    right.set(xlabel="axle", ylabel="adhesion, mean over the way [-]", ylim=(0, None))
    left.legend()
    return figure


def draw_traction(train):
    figure = wrc.plot.figure(figsize=(9, 4))
    left, right = figure.subplots(1, 2)
    time, _, slips, adhesions = train.table()
    left.plot(time, 100 * slips[:, 0], label="slip of axle 1 [%]")
    left.plot(time, 100 * adhesions.mean(axis=1), label="mean adhesion [% of the load]")
    for axle in range(len(train.axles)):
        right.plot(100 * slips[1000::100, axle], adhesions[1000::100, axle], ".", ms=2, label=f"axle {axle + 1}")
    left.set(xlabel="time [s]")
    right.set(xlabel="slip [%]", ylabel="adhesion [-]", xlim=(0, None), ylim=(0, None))
    left.legend()
    right.legend(markerscale=5)
    return figure


def draw_curve(rig):
    figure = wrc.plot.figure(figsize=(6, 4))
    axes = figure.subplots()
    _, _, slips, adhesions = rig.table()
    for label, slip, adhesion in zip(("up", "down", "up again", "down again"), np.split(slips, 4), np.split(adhesions, 4)):
        axes.plot(-100 * slip, -adhesion, label=label)
    axes.set(xlabel="slip [%]", ylabel="adhesion [-]", xlim=(0, None), ylim=(0, None))
    axes.legend()
    return figure


def draw_lubricator(run):
    rail, places, shifts, powers = run
    band = rail.struct
    figure = wrc.plot.figure(figsize=(10, 4))
    left, right = figure.subplots(1, 2)
    edges = 1e3 * (band.row_first + band.width * np.arange(band.rows + 1))
    grams = 1e3 * rail.values("LUBRICANT")
    shown = left.pcolormesh(np.arange(band.count + 1), edges, np.maximum(grams, 1e-4), norm="log", cmap="viridis")
    figure.colorbar(shown, ax=left, label="lubricant [g/m2]")
    left.set(xlabel="distance [m]; lubricator from 4 to 7 m", ylabel="y on the rail [mm]; gauge corner below")
    for axle in (0, len(powers) - 8, len(powers) - 1):
        right.plot(places, 1e-3 * powers[axle], label=f"axle {axle + 1}, up to {1e3 * np.ptp(shifts[axle]):.0f} mm from the flange")
    right.set(xlabel="distance [m]", ylabel="frictional power [kW]", ylim=(0, None))
    right.legend()
    return figure


def print_lubricator(run):
    rail, _, _, powers = run
    grams = 1e3 * rail.values("LUBRICANT")
    middles = 1e3 * (rail.struct.row_first + rail.struct.width * (np.arange(rail.struct.rows) + 0.5))
    print("lubricant [g/m2] at y [mm]" + "".join(f"{y:10.0f}" for y in middles))
    for place in (5, 10, 15, 35):
        print(f"  {place:2d} to {place + 1:2d} m             " + "".join(f"{each:10.3g}" for each in grams[:, place]))
    print("mean frictional power of axles 1, 9 and the last [kW]: " + ", ".join(f"{1e-3 * powers[axle].mean():.2f}" for axle in (0, 8, -1)))


def print_runs(runs):
    for label, train in runs.items():
        print(f"{label}: {train.place:.0f} m, {train.time:.1f} s, {3.6 * train.speed:.1f} km/h at the end")
        print("  adhesion of the axles over the way: " + " ".join(f"{each:.3f}" for each in train.mean_adhesions()))
        print("  energy of their wheels [kJ]:        " + " ".join(f"{2e-3 * axle.energy:.0f}" for axle in train.axles))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    stories = parser.add_subparsers(dest="story", required=True)
    for name in ("stop", "traction", "start", "curve", "lubricator"):
        story = stories.add_parser(name)
        story.add_argument("--picture", help="file")
        if name == "stop":
            story.add_argument("--speed", type=float, default=20.0, help="at which they brake [km/h]; 20")
            story.add_argument("--cars", type=int, default=2, help="of four axles; 2")
    told = parser.parse_args()
    if told.story == "traction":
        shown, wishes, pulls = traction()
        for second in (1, len(pulls) - 1):  # the motors are there in the second one
            print(f"second {second + 1}: {1e-3 * pulls[second]:.0f} kN at {100 * wishes[second]:.0f} % slip")
        print("adhesion of the axles at the end: " + " ".join(f"{axle.force / shown.load:.3f}" for axle in shown.axles))
    elif told.story == "curve":
        shown = curve()
        print("adhesion at 5 % slip: up {:.3f}, down {:.3f}, up again {:.3f}, down again {:.3f}".format(*at_half(shown)))
    elif told.story == "lubricator":
        shown = lubricator()
        print_lubricator(shown)
    else:
        shown = {label: stop(told.speed, sand, told.cars) if told.story == "stop" else start(sand)
                 for label, sand in (("without sand", False), ("with sand", True))}
        print_runs(shown)
    if told.picture:
        {"traction": draw_traction, "curve": draw_curve, "lubricator": draw_lubricator}.get(told.story, draw_runs)(shown).savefig(told.picture)


if __name__ == "__main__":
    main()
