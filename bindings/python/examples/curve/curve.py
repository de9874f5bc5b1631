"""A wheelset through a curve, as a moving picture: curve.py [PICTURE.gif]

The leading wheelset of a bogie enters a curve of 300 m to the right, at 15 m/s. At each place its forces balance: lateral shift, yaw and
turning about the axle are found by Newton's method from the wrenches of both wheels. Each wheel carries its load at its own height: roll
is left out."""
import sys

import numpy as np
import wrc

SPEED, LOAD, RADIUS = 15.0, 80e3, 0.46  # m/s, N a wheel, m
CURVE, BEGIN, TRANSITION, END = 300.0, 10.0, 40.0, 70.0  # m
ACROSS, ABOUT, HALF_WHEELBASE = 1e6, 1e7, 1.25  # springs to the bogie [N/m, N m/rad]; m


def inputs(curvature, y, yaw, turning):
    """A wheelset in the track's axes at a place; `turning` about the axle over that of free rolling."""
    wheel = {"y": y, "yaw": yaw, "velocity": (SPEED, 0, 0), "yaw_rate": SPEED * curvature, "pitch_rate": -SPEED / RADIUS * (1 + turning)}
    return wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=LOAD, wheel=wheel, friction={"coefficient": 0.3})


def unbalanced(wheels, curvature, state):
    """Lateral force [N] and moments about the vertical and the axle [N m] that are left over."""
    found = [wheel.wrench(inputs(curvature, *state)) for wheel in wheels]
    force, moment = sum(each.force for each in found), sum(each.moment for each in found)
    y, yaw, _ = state
    # the bogie's frame lies along the chord between its wheelsets: the leading one points out of the curve
    return np.array([force[1] - ACROSS * y, moment[2] - ABOUT * (yaw + HALF_WHEELBASE * curvature), moment[1]])


def balance(wheels, curvature, state):
    scale, unit = np.array([1e4, 1e4, 1e2]), np.array([1e-6, 1e-6, 1e-7])
    for _ in range(60):
        left = unbalanced(wheels, curvature, state)
        if np.all(np.abs(left) < 1e-3 * scale):
            return state
        slopes = np.column_stack([(unbalanced(wheels, curvature, state + step) - left) / step.sum() for step in np.diag(unit)])
        change = np.linalg.solve(slopes, -left)
        state = state + change * min(1.0, *(np.array([5e-4, 5e-4, 5e-4]) / np.maximum(np.abs(change), 1e-12)))
    raise RuntimeError(f"no balance at a curvature of {curvature:g} 1/m: {left}")


def course(count):
    """Places [m], curvatures [1/m], and the inputs that balance there."""
    model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40})
    wheels = [model.contact("LEFT"), model.contact("RIGHT")]
    places = np.linspace(0.0, END, count)
    curvatures = np.clip((places - BEGIN) / TRANSITION, 0.0, 1.0) / CURVE
    state, states = np.zeros(3), []
    for each in curvatures:
        state = balance(wheels, each, state)
        states.append(state)
    return wheels, places, curvatures, np.array(states)


def main(path="curve.gif", count=50):
    wheels, places, curvatures, states = course(count)
    told = [inputs(curvature, *state) for curvature, state in zip(curvatures, states)]
    titles = [f"{place:.0f} m, curvature {1e3 * curvature:.1f} 1/km: shift {1e3 * y:.1f} mm, yaw {1e3 * yaw:.1f} mrad"
              for place, curvature, (y, yaw, _) in zip(places, curvatures, states)]
    wrc.plot.animation(wheels, told, path, titles, seconds=0.12)
    return states


if __name__ == "__main__":
    print(main(*sys.argv[1:2])[-1])
