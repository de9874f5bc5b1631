"""A wheel over a dipped joint, beside the formula by which railways limit its P2 force.

    dipped_joint.py FOLDER    a table, and dipped_joint.png

The rail bends down and up again by a total angle of 0.02 rad, rounded over 0.1 m. The wheel has its unsprung mass alone, under the
constant load of its suspension. The track is one mass on a spring and a damper. P2 is the second, slower blow: wheel and rail
move together on the track's spring. The formula is that of Jenkins and others (Railway Engineering Journal, 1974),

    P2 = P0 + 2 alpha V sqrt(m / (m + m_t)) (1 - pi c_t / (4 sqrt(k_t (m + m_t)))) sqrt(k_t m),

with the numbers that GM/TT0088 gives an average track, quoted from memory. It is the largest force of that spring after an impact
without rebound; the contact's slow force is less, by m / (m + m_t) of its growth."""
import pathlib
import sys

import numpy as np
import wrc

import rails

LOAD, MASS = 81e3, 1680.0  # of one wheel: static load [N], unsprung mass [kg]
TRACK_MASS, TRACK_STIFFNESS, TRACK_DAMPING = 245.0, 62e6, 55.4e3  # effective, of the track below it [kg, N/m, N s/m]
ANGLE, ROUNDED = 0.02, 0.1  # of the dip in total [rad], and the length over which it is rounded [m]
SPEEDS = (80, 120, 160)  # km/h
STEP, TIME = 5e-5, 0.025  # of the integration, and how long after the joint it goes on [s]


def formula(speed):
    """P2 [N] at a speed [m/s]."""
    together = MASS + TRACK_MASS
    damped = 1.0 - np.pi * TRACK_DAMPING / (4.0 * np.sqrt(TRACK_STIFFNESS * together))
    return LOAD + ANGLE * speed * np.sqrt(MASS / together) * damped * np.sqrt(TRACK_STIFFNESS * MASS)


def dip(x):
    """Height of the rail [m, downwards] at x [m] from the joint: two straight lines that a parabola joins."""
    half = 0.5 * ROUNDED
    return 0.5 * ANGLE * (1.0 - np.where(abs(x) < half, 0.5 * (x * x / half + half), abs(x)))


def rail():
    """Sections of the dipped rail, 1.2 m to either side."""
    return [rails.section(x, rails.head(-35e-3, 35e-3, float(dip(x)), field_depth=20e-3)) for x in np.linspace(-1.2, 1.2, 241)]


def rolled(contact, speed):
    """Places [m], forces on the wheel and of the track's spring [N], by semi-implicit steps; the spring is at rest before the joint."""
    data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=LOAD, distance=-0.5, friction={"coefficient": 0.0})
    track, track_speed = LOAD / TRACK_STIFFNESS, 0.0
    ramp = 0.5 * ANGLE * speed  # both go down the first ramp
    wheel, wheel_speed = contact.wrench(data).z + track, ramp
    told = []
    data = wrc.WheelInput(friction={"coefficient": 0.0})
    for k in range(int((0.5 / speed + TIME) / STEP)):
        data.distance = -0.5 + speed * STEP * k
        data.wheel.z = wheel - track
        force = contact.wrench(data).normal_force
        told.append((data.distance, force, TRACK_STIFFNESS * track))
        wheel_speed += STEP * (LOAD - force) / MASS
        track_speed += STEP * (force - TRACK_STIFFNESS * track - TRACK_DAMPING * track_speed) / TRACK_MASS
        wheel += STEP * wheel_speed
        track += STEP * track_speed
    return np.array(told)


def main(folder):
    contact = rails.model_of(wrc.rail_faces(rail())).contact("RIGHT")
    made = wrc.plot.figure(figsize=(8, 5))
    panel = made.subplots()
    for colour, speed in zip(wrc.plot.COLOURS, SPEEDS):
        place, force, spring = rolled(contact, speed / 3.6).T
        p2, expected = spring.max(), formula(speed / 3.6)
        print(f"{speed:4} km/h: spring {p2 / 1e3:4.0f} kN, P2 by the formula {expected / 1e3:4.0f} kN ({100 * (p2 / expected - 1):+.1f} %), wheel {force.max() / 1e3:4.0f} kN")
        panel.plot(place, force / 1e3, color=colour, linewidth=0.7)
        panel.plot(place, spring / 1e3, color=colour, label=f"{speed} km/h")
        panel.axhline(expected / 1e3, color=colour, linestyle=":")
    panel.set(xlabel="wheel along the rail from the joint [m]", ylabel="force on the wheel (thin), of the spring [kN]")
    panel.legend()
    panel.grid(alpha=0.3)
    made.savefig(pathlib.Path(folder) / "dipped_joint.png", dpi=90)


if __name__ == "__main__":
    main(sys.argv[1])
