"""Two bogie cars, eight axles, stop on wet leaves, without and with sand: each axle finds the rail as those before it left it.

    python low_adhesion.py [km/h] [picture.png]

One wheel of each axle is computed, at 1 ms steps. examples_c/low_adhesion.c has a longer train, traction, a start and a creep curve.
"""
import sys

import numpy as np

import wrc

STEP, RADIUS, LOAD, INERTIA = 1e-3, 0.46, 0.5 * 11.5e3 * 9.81, 110.0  # s, m, N of a wheel, kg m^2 of an axle
BEHIND = np.array([0.0, 2.5, 19.0, 21.5, 26.4, 28.9, 45.4, 47.9])  # the front of the train [m]
DEMAND = 1.0  # of braking [m/s^2]


class Axle:
    """A wheel of it: contact, tread, how far and how fast it has turned."""

    def __init__(self, model, speed):
        self.contact = model.contact()
        self.tread = wrc.Band(24, 2 * np.pi * RADIUS / 24, closed=True)
        self.turning, self.arc, self.brake, self.energy, self.force = speed, 0.0, 0.0, 0.0, 0.0


def step(axle, rail, laws, dry, data, speed, place):
    """Friction of the films, wrench, rotation, passage. Slides are soft; where the wheel rolls a difference gives the slope."""
    passage = wrc.SurfacePassage(rail_from=place, rail_to=place + speed * STEP, wheel_from=axle.arc, wheel_to=axle.arc + axle.turning * STEP)
    data.friction = wrc.surface_friction(rail, axle.tread, laws, passage, dry)

    def solve(turning):
        data.wheel.velocity = (speed, 0.0, 0.0)
        data.wheel.pitch_rate = -turning / RADIUS
        wrench = axle.contact.wrench(data)
        return wrench.force[0], wrench.moment[1], wrench.power

    force, moment, power = solve(axle.turning)
    by_force = by_moment = 0.0
    if abs(axle.turning - speed) < 0.03 * speed:
        little = 1e-4 * speed
        more, turned, _ = solve(axle.turning + little)
        by_force, by_moment = (more - force) / little, max(0.0, (turned - moment) / little)
    torque = 2.0 * moment + axle.brake * 11.5e3 * DEMAND * RADIUS
    change = max(-axle.turning, -STEP * RADIUS * torque / (INERTIA + STEP * RADIUS * 2.0 * by_moment))
    passage.energy = power * STEP
    wrc.surface_pass(rail, axle.tread, laws, passage)
    axle.tread.rest(laws, STEP)
    axle.arc, axle.turning, axle.force = passage.wheel_to, axle.turning + change, force + by_force * change
    axle.energy += passage.energy


def stop(kmh=20.0, sand=False):
    """Distance [m], time [s], energy of each axle's wheels [J], lines of time, speed, adhesions; the rail and the axles."""
    model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}, preset="real time")
    speed = kmh / 3.6
    axles = [Axle(model, speed) for _ in BEHIND]
    data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=LOAD, wheel={"velocity": (speed, 0, 0), "pitch_rate": -speed / RADIUS})
    standing = axles[0].contact.wrench(data).z
    data = wrc.WheelInput(start="WARM", wheel={"z": standing})
    rail = wrc.Band(200 + int(kmh**2 / 10), 1.0, first=-60.0)
    rail.add("FILM", 0.009, *rail_ends(rail)).add("WATER", 0.02, *rail_ends(rail))
    laws, dry = wrc.surface_laws("low adhesion"), wrc.Friction(coefficient=0.4)
    place, time, lines = 0.0, 0.0, []
    while speed > 0.5:
        for axle, behind in zip(axles, BEHIND):
            slide = 1.0 - axle.turning / speed  # slide protection: lets go above 15 %, builds up below 5 %
            axle.brake = min(1.0, max(0.0, axle.brake + STEP * (-4.0 if slide > 0.15 else 1.0 if slide < 0.05 else 0.0)))
            at = place - behind
            if sand and axle is axles[0] and slide > 0.03:
                rail.add("SAND", 2.0 / 60.0 / (rail.struct.width * speed), at, at + speed * STEP)
            step(axle, rail, laws, dry, data, speed, at)
        place += speed * STEP
        speed += STEP * 2.0 * sum(axle.force for axle in axles) / (len(axles) * 11.5e3)
        time += STEP
        lines.append([time, speed, *(-axle.force / LOAD for axle in axles)])
    return place, time, np.array([2.0 * axle.energy for axle in axles]), np.array(lines), rail, axles


def rail_ends(rail):
    return rail.struct.first, rail.struct.first + rail.struct.count * rail.struct.length


def draw(runs, path):
    figure = wrc.plot.figure(figsize=(9, 4))
    left, right = figure.subplots(1, 2)
    for label, (place, _, energy, lines, _, _) in runs.items():
        left.plot(lines[:, 0], 3.6 * lines[:, 1], label=f"{label}: {place:.1f} m")
        right.plot(np.arange(1, 9), lines[:, 2:].mean(axis=0), "o-", label=label)
    left.set(xlabel="time [s]", ylabel="speed [km/h]")
    right.set(xlabel="axle", ylabel="adhesion, mean over the stop [-]", ylim=(0, None))
    left.legend()
    figure.savefig(path)


def main():
    kmh = float(sys.argv[1]) if len(sys.argv) > 1 else 20.0
    runs = {"without sand": stop(kmh), "with sand at axle 1": stop(kmh, sand=True)}
    for label, (place, time, energy, _, _, _) in runs.items():
        print(f"{label}: {place:.1f} m, {time:.1f} s, kJ of the axles: " + " ".join(f"{1e-3 * each:.1f}" for each in energy))
    if len(sys.argv) > 2:
        draw(runs, sys.argv[2])


if __name__ == "__main__":
    main()
