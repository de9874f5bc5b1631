"""A wheelset on an irregular track in Exudyn (generalised alpha, fixed steps), wrc as its force element.

    exudyn_wheelset.py libwrc.so [--seconds 8] [--speed 40] [--rms 0.0015] [--full] [--most 25]
                       [--rows FILE.csv]

The wheelset, its springs and the track are those of docs/hosts.md. Prints failed steps, Newton iterations per step and
how often a flange touches. Exit status 1 if a step fails or takes more than --most iterations.
"""
import argparse
import collections
import sys

import numpy as np
import exudyn as exu
import exudyn.itemInterface as items

from wrc_flat import HEIGHT, LEFT, LOAD, RIGHT, Model

arguments = argparse.ArgumentParser()
arguments.add_argument("library")
arguments.add_argument("--seconds", type=float, default=8.0)
arguments.add_argument("--speed", type=float, default=40.0)
arguments.add_argument("--step", type=float, default=1e-3)
arguments.add_argument("--rms", type=float, default=1.5e-3)
arguments.add_argument("--full", action="store_true",
                       help="a Jacobian in every iteration, not only where convergence is slow")
arguments.add_argument("--most", type=int, default=25, help="Newton iterations a step may take")
arguments.add_argument("--rows")
options = arguments.parse_args()

MASS, ACROSS, ABOUT = 1500.0, 800.0, 100.0  # kg, kg m2 across and about the axle
CARRIED, ARM, BOX = 160e3, 1.0, np.array([4e6, 2e6, 1e6])  # N, m, N/m
RADIUS, FRICTION = 0.46, 0.3
ROOT, FLANGE = 12, 40  # regions with a steeper resultant are on the flange's root, on the flange [deg]

waves = 3.0 * 20.0 ** (np.arange(40) / 39.0)
amplitudes = waves * options.rms / np.sqrt(0.5 * np.sum(waves ** 2))
phases = 2 * np.pi * np.mod(0.618034 * np.arange(1, 41), 1.0)


def irregularity(x):
    """Lateral displacement of both rails and its slope; faded in over the first 10 m."""
    angle = 2 * np.pi * x / waves + phases
    y = np.sum(amplitudes * np.cos(angle))
    slope = -np.sum(amplitudes * 2 * np.pi / waves * np.sin(angle))
    t = min(max(x / 10.0, 0.0), 1.0)
    fade, rate = t * t * (3 - 2 * t), 6 * t * (1 - t) / 10.0
    return fade * y, fade * slope + rate * y


model = Model(options.library)
contacts = {side: model.contact(side) for side in (RIGHT, LEFT)}
HEIGHT0 = model.step(contacts[RIGHT], 18 * [0] + [LOAD, CARRIED / 2, 0])[12]  # of the middle at rest


def axes(roll, yaw):
    """Of the wheelset without its turning about the axle: forward, axle, third, as columns."""
    cr, sr, cy, sy = np.cos(roll), np.sin(roll), np.cos(yaw), np.sin(yaw)
    return np.array([[cy, -sy, 0], [cr * sy, cr * cy, -sr], [sr * sy, sr * cy, cr]])


def contact(t, q, v, tell=None):
    """Force and moment of both rails on the wheelset about its middle, axes of the straight track."""
    body = axes(q[3], q[5])
    angular = body @ np.array([v[3] * np.cos(q[5]), -options.speed / RADIUS + v[4], v[5]])
    velocity = np.array([options.speed + v[0], v[1], v[2]])
    rail_y, slope = irregularity(options.speed * t + q[0])
    # the rails run in the direction of the slope here: all the library is given is seen in axes along them
    along = axes(0, np.arctan(slope))
    axle, angular, velocity = along.T @ body[:, 1], along.T @ angular, along.T @ velocity
    roll, yaw = np.arctan2(axle[2], axle[1]), -np.arcsin(axle[0])
    force, moment = np.zeros(3), np.zeros(3)
    for side in (RIGHT, LEFT):
        out = model.step(contacts[side], [0, q[1], HEIGHT0 + q[2], roll, yaw, *velocity, *angular,
                                          rail_y, 0, 0, 0, 0, 0, FRICTION, HEIGHT, 0, 0])
        force += out[0:3]
        moment += out[3:6]
        if tell is not None:
            tell.append((rail_y, out[1], out[2], model.regions(contacts[side])))
    return along @ force, along @ moment


def forces(mbs, t, item, q, v):
    """Right-hand side for x (against a frame that moves at constant speed), y, z, roll, turning about the axle against
    free rolling, yaw about the rolled axis. The equations of roll and yaw are Euler's for a body of revolution."""
    force, moment = contact(t, q, v)
    body = axes(q[3], q[5])
    force[2] += CARRIED
    for side in (1, -1):
        box = side * ARM * body[:, 1]
        spring = -BOX * (np.array(q[0:3]) + box - np.array([0, side * ARM, 0]))
        force += spring
        moment += np.cross(box, spring)
    forward, axle, third = body.T @ moment
    spin = ABOUT * (-options.speed / RADIUS + v[4])
    cy, sy = np.cos(q[5]), np.sin(q[5])
    return [*force, (forward + v[5] * spin + 2 * ACROSS * v[3] * v[5] * sy) / cy, axle,
            third - v[3] * cy * spin - ACROSS * v[3] ** 2 * sy * cy]


container = exu.SystemContainer()
mbs = container.AddSystem()
node = mbs.AddNode(items.NodeGenericODE2(referenceCoordinates=[0] * 6, initialCoordinates=[0] * 6,
                                         initialCoordinates_t=[0] * 6, numberOfODE2Coordinates=6))
mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], forceUserFunction=forces,
                                      massMatrix=np.diag([MASS, MASS, MASS, ACROSS, ABOUT, ACROSS])))
rows, iterations = [], []


def record(mbs, t):
    if t > 0:
        iterations.append(solver.it.newtonSteps)
    q = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)
    v = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates_t)
    tell = []
    contact(t, q, v, tell)
    steepest = max((abs(angle) for side in tell for _, angle, _ in side[3]), default=0.0)
    rows.append([t, *q[0:4], q[5], v[4], tell[0][0], *tell[0][1:3], *tell[1][1:3],
                 len(tell[0][3]), len(tell[1][3]), np.degrees(steepest)])
    return True


mbs.SetPostStepUserFunction(record)
mbs.Assemble()
settings = exu.SimulationSettings()
settings.timeIntegration.numberOfSteps = int(round(options.seconds / options.step))
settings.timeIntegration.endTime = options.seconds
settings.timeIntegration.adaptiveStep = False
settings.timeIntegration.newton.relativeTolerance = 1e-8
settings.timeIntegration.newton.absoluteTolerance = 1e-8
settings.timeIntegration.newton.useModifiedNewton = not options.full
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
settings.timeIntegration.verboseMode = 0
settings.solution.file.write = False
solver = exu.MainSolverImplicitSecondOrder()
try:
    whole = solver.SolveSystem(mbs, settings)
except Exception as error:  # Exudyn raises where a step fails
    print("Exudyn stopped:", *str(error).splitlines()[:1])
    whole = False
data = np.array(rows)
y = data[:, 2] - data[:, 7]
counts = collections.Counter(iterations)
print(f"{'reached the end' if whole else 'A STEP FAILED'} at {data[-1, 0]:.3f} of {options.seconds:g} s, "
      f"{options.speed:g} m/s, irregularity rms {1e3 * options.rms:g} mm")
print("Newton iterations per step:", ", ".join(f"{n}: {counts[n]} steps" for n in sorted(counts)),
      f"; Jacobians {solver.it.newtonJacobiCount}, steps begun again with a Jacobian in every iteration "
      f"{solver.it.rejectedModifiedNewtonSteps}")
print(f"lateral against the rails: rms {1e3 * np.std(y):.2f} mm, largest {1e3 * np.max(np.abs(y)):.2f} mm; "
      f"largest lateral force of a wheel {1e-3 * np.max(np.abs(data[:, [8, 10]])):.0f} kN")
print(f"steps with contact on a flange's root {np.sum(data[:, 14] > ROOT)}, on a flange {np.sum(data[:, 14] > FLANGE)}, "
      f"with two regions on a wheel {np.sum(np.max(data[:, 12:14], axis=1) > 1)} of {len(iterations)}")
print(f"wheel calls {model.calls} ({model.calls / data[-1, 0]:.0f} per second), statuses {model.statuses}")
if options.rows:
    np.savetxt(options.rows, data, "%.9g", ",", comments="",
               header="t,x,y,z,roll,yaw,spin,rail_y,y_right,z_right,y_left,z_left,regions_right,regions_left,steepest")
sys.exit(0 if whole and max(iterations) <= options.most else 1)
