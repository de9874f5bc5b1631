"""A wheelset brakes to a stop, is parked on a slope, rolls off backwards and stops again: parked.py [--parked 10] [--picture parked.png]

Implicit Euler steps of 10 ms, solved by Newton's method with differences of trials; each accepted step is committed. The brake is a torque
with friction of its own: it slides, or holds the axle. examples_c/parked_wheelset.c is the same in C."""
import argparse

import numpy as np
import wrc
from braked import GRAVITY, INERTIA, MASS, RADIUS, SLOPE, TORQUE, Braked

STEP = 10e-3  # s


def solve(wheelset, speeds, slope, torque, held):
    """Speeds (v, w) at the end of a step, and the wheels' force and moment. `held`: the brake holds the axle."""
    def residual(each):
        forces = wheelset.forces(*each, STEP)
        left = each - speeds - STEP * np.array([(forces[0] - MASS * GRAVITY * slope) / MASS, (forces[1] + torque) / INERTIA])
        return np.array([left[0], each[1]]) if held else left, forces

    scale, state = np.array([1.0, RADIUS]), np.array([speeds[0], 0.0 if held else speeds[1]])
    left, forces = residual(state)
    for _ in range(40):
        if np.linalg.norm(scale * left) < 1e-13:
            break
        unit = 1e-8 / scale
        slopes = np.column_stack([(residual(state + step)[0] - left) / step.sum() for step in np.diag(unit)])
        change = np.linalg.solve(slopes, -left)
        before = np.linalg.norm(scale * left)
        for part in 0.5 ** np.arange(8.0):  # half as far where it is no better
            left, forces = residual(state + part * change)
            if np.linalg.norm(scale * left) < before:
                break
        state = state + part * change
    wheelset.forces(*state, STEP)  # the last trial is the one to commit
    return state, forces


def advance(wheelset, speeds, slope, brake):
    """One step under a brake of that torque [N m]: it slides against the axle's turning, or holds it."""
    held = speeds[1] == 0.0 and brake > 0.0
    if not held:
        state, forces = solve(wheelset, speeds, slope, -np.sign(speeds[1]) * brake, False)
        held = brake > 0.0 and state[1] * speeds[1] <= 0.0  # it stops within the step
    if held:
        state, forces = solve(wheelset, speeds, slope, 0.0, True)
        if abs(forces[1] + INERTIA * speeds[1] / STEP) > brake:
            state, forces = solve(wheelset, speeds, slope, -np.sign(forces[1]) * brake, False)
    wheelset.commit()
    return state, forces


def journey(parked=10.0, memory=True):
    """Rows of time, x [m], v [m/s], w [rad/s], force of both wheels [N]; and when each part of the journey ends."""
    wheelset, speeds = Braked(memory), np.array([2.0, -2.0 / RADIUS])
    rows, ends, x = [], [], 0.0
    for seconds, slope, brake in ((2.0, 0.0, 0.0), (7.0, 0.0, TORQUE), (parked, SLOPE, TORQUE), (3.0, SLOPE, 0.0), (8.0, SLOPE, TORQUE)):
        for _ in range(round(seconds / STEP)):
            speeds, forces = advance(wheelset, speeds, slope, brake)
            x += STEP * speeds[0]
            rows.append([(len(rows) + 1) * STEP, x, *speeds, forces[0]])
        ends.append(rows[-1][0])
    return np.array(rows), ends


def draw(rows, forgetting, ends, path):
    """`forgetting`: the same journey without memory, its place while it is parked beside."""
    figure = wrc.plot.figure(figsize=(11, 7.5))
    panels = figure.subplots(2, 2)
    t, x, v, w, force = rows.T
    stop = t[np.argmax((w == 0.0) & (t > 2.0))]
    for axes, values, name in ((panels[0, 0], v, "speed [m/s]"), (panels[0, 1], force / 1e3, "force of both wheels [kN]")):
        axes.plot(t, values, color="#0072B2", lw=1.2)
        axes.set(xlabel="time [s]", ylabel=name)
        for end, what in zip(ends, ("rolls", "brakes, stops", "parked, 20 per mille", "brake released", "brakes, stops")):
            axes.axvline(end, color="0.8", lw=0.8)
        axes.margins(x=0.01)
    panels[0, 0].set_title("rolls, brakes, parked on 20 per mille, released, brakes", fontsize=10)
    near = (t > stop - 0.1) & (t < stop + 0.4)
    panels[1, 0].plot(t[near], 1e6 * (x[near] - x[near][-1]), ".-", color="#0072B2", ms=3, lw=1)
    panels[1, 0].set(xlabel="time [s]", ylabel="place before where it rests [um]", ylim=(-10, 10))
    panels[1, 0].set_title("the stop", fontsize=10)
    still = (t > ends[1] + 1.0) & (t <= ends[2])
    for place, colour, name in ((x, "#0072B2", "memory"), (forgetting[:, 1], "#D55E00", "without: a damper")):
        panels[1, 1].plot(t[still], 1e6 * (place[still] - place[still][0]), color=colour, lw=1.2, label=name)
    panels[1, 1].set(xlabel="time [s]", ylabel="place [um]")
    panels[1, 1].set_title("parked: the place from 1 s on", fontsize=10)
    panels[1, 1].legend()
    figure.savefig(path)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--parked", type=float, default=10.0, help="seconds on the slope")
    arguments.add_argument("--picture")
    options = arguments.parse_args()
    rows, ends = journey(options.parked)
    t, x, v, w, force = rows.T
    still = (t > ends[1] + 1.0) & (t <= ends[2])
    after = (t > t[np.argmax((w == 0.0) & (t > 2.0))]) & (t <= ends[1])
    turns = int(np.sum((v[after][1:] * v[after][:-1] < 0.0) & (np.abs(v[after][1:]) > 1e-9)))
    print(f"stops after {x[np.argmax((w == 0.0) & (t > 2.0))]:.3f} m; turns of its speed afterwards: {turns}")
    print(f"parked with {force[still][-1]:.1f} N ({MASS * GRAVITY * SLOPE:.1f} N of weight); creeps {1e6 * abs(x[still][-1] - x[still][0]):.2g} um")
    print(f"released it rolls off to {v[np.argmin(np.abs(t - ends[3]))]:.3f} m/s, and stops again with {v[-1]:.2g} m/s")
    if options.picture:
        draw(rows, journey(options.parked, memory=False)[0], ends, options.picture)


if __name__ == "__main__":
    main()
