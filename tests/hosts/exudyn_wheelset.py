"""A wheelset on an irregular track in Exudyn (generalised alpha, fixed step), wrc as its force element.

    exudyn_wheelset.py libwrc.so [--seconds 8] [--speed 40] [--picture FILE.png]

Wheelset 1500 kg, Ix = Iz = 800, Iy = 100 kg m2; 160 kN on the rails; per axle box at +-1 m 4, 2, 1 MN/m along x, y, z to a
frame that moves at constant speed. Lateral irregularity of both rails, rms 1.5 mm: 40 cosines, wave lengths 3 to 60 m in
geometric steps, amplitudes proportional to them. Prints failed steps, Newton iterations, flange contact. Exit status 1 if
the run does not reach its end.
"""
import argparse
import sys

import numpy as np
import exudyn as exu
from exudyn.utilities import *  # noqa: F403 (how Exudyn's items are named)

from wrc_flat import HEIGHT, LEFT, RIGHT, Model

arguments = argparse.ArgumentParser()
arguments.add_argument("library")
arguments.add_argument("--seconds", type=float, default=8.0)
arguments.add_argument("--speed", type=float, default=40.0)
arguments.add_argument("--step", type=float, default=1e-3)
arguments.add_argument("--friction", type=float, default=0.3)
arguments.add_argument("--rms", type=float, default=1.5e-3)
arguments.add_argument("--picture")
options = arguments.parse_args()

MASS, IX, IY, IZ = 1500.0, 800.0, 100.0, 800.0
LOAD, ARM, K = 160e3, 1.0, np.array([4e6, 2e6, 1e6])
R0, V = 0.46, options.speed
OMEGA = V / R0

waves = 3.0 * (60.0 / 3.0) ** (np.arange(40) / 39.0)
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


model = Model(options.library, warm_start=0)
contacts = {side: model.contact() for side in (RIGHT, LEFT)}


def wheels(t, x, y, z, roll, yaw, velocity, angular):
    """Force and moment on the wheelset about its middle, track axes."""
    rail_y, slope = irregularity(V * t + x)
    total = np.zeros(6)
    regions = []
    for side, contact in contacts.items():
        out = model.step(contact, [side, 0, y, z, roll, yaw, *velocity, *angular,
                                   rail_y, 0, 0, velocity[0] * slope, 0, 0, options.friction, HEIGHT, 0, 0])
        total += out[0:6]
        regions.append((out[17], out[0:3]))
    return total, regions


# the height at which both wheels carry the load together
static = [model.step(contacts[side], [side, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.0, 1, LOAD / 2, 0])
          for side in (RIGHT, LEFT)]
Z0 = static[0][12]

# coordinates: x (against the moving frame), y, z, roll, pitch (against free rolling), yaw
M = np.diag([MASS, MASS, MASS, IX, IY, IZ])


def forces(mbs, t, item, q, q_t):
    x, y, z, roll, pitch, yaw = q
    velocity = np.array([V + q_t[0], q_t[1], q_t[2]])
    # about track axes: roll, the axle's turning, yaw about the rolled axis
    cr, sr, cy, sy = np.cos(roll), np.sin(roll), np.cos(yaw), np.sin(yaw)
    axle = np.array([-sy, cr * cy, sr * cy])
    turning = -OMEGA + q_t[4]
    angular = np.array([q_t[3], 0, 0]) + q_t[5] * np.array([0, -sr, cr]) + turning * axle
    contact, _ = wheels(t, x, y, Z0 + z, roll, yaw, velocity, angular)
    f = np.zeros(6)
    f += contact
    f[2] += LOAD - 2 * K[2] * z
    f[0] -= 2 * K[0] * x
    f[1] -= 2 * K[1] * y
    f[3] -= 2 * K[2] * ARM ** 2 * roll
    f[5] -= 2 * K[0] * ARM ** 2 * yaw
    # gyroscopic: the axle's spin turned by roll and yaw
    f[3] += IY * turning * q_t[5]
    f[5] -= IY * turning * q_t[3]
    # the moment about the axle alone turns it
    f[4] = contact[3:6] @ axle
    return f


SC = exu.SystemContainer()
mbs = SC.AddSystem()
node = mbs.AddNode(NodeGenericODE2(referenceCoordinates=[0] * 6, initialCoordinates=[0] * 6,
                                   initialCoordinates_t=[0] * 6, numberOfODE2Coordinates=6))
mbs.AddObject(ObjectGenericODE2(nodeNumbers=[node], massMatrix=M, forceUserFunction=forces))
rows = []


def record(mbs, t):
    q = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)
    q_t = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates_t)
    velocity = np.array([V + q_t[0], q_t[1], q_t[2]])
    angular = np.array([q_t[3] + 0.0, -OMEGA + q_t[4], q_t[5]])
    total, regions = wheels(t, q[0], q[1], Z0 + q[2], q[3], q[5], velocity, angular)
    rows.append([t, *q, irregularity(V * t + q[0])[0], regions[0][1][1], regions[1][1][1], regions[0][1][2],
                 regions[1][1][2], regions[0][0], regions[1][0]])
    return True


mbs.SetPreStepUserFunction(record)
mbs.Assemble()
settings = exu.SimulationSettings()
steps = int(round(options.seconds / options.step))
settings.timeIntegration.numberOfSteps = steps
settings.timeIntegration.endTime = options.seconds
settings.timeIntegration.adaptiveStep = False
settings.timeIntegration.newton.relativeTolerance = 1e-8
settings.timeIntegration.newton.absoluteTolerance = 1e-8
settings.timeIntegration.newton.maxIterations = 25
settings.timeIntegration.newton.useModifiedNewton = False
settings.timeIntegration.newton.numericalDifferentiation.relativeEpsilon = 1e-7
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
settings.timeIntegration.verboseMode = 0
settings.solutionSettings.writeSolutionToFile = False
settings.displayStatistics = False
solver = exu.MainSolverImplicitSecondOrder()
try:
    success = solver.SolveSystem(mbs, settings)
except Exception as error:  # Exudyn raises where a step fails
    print("Exudyn stopped:", str(error).splitlines()[0])
    success = False
data = np.array(rows)
newton, jacobians = solver.it.newtonStepsCount, solver.it.newtonJacobiCount
reached = data[-1, 0]
y = data[:, 2] - data[:, 7]
flange = np.mean(np.maximum(np.abs(data[:, 8]), np.abs(data[:, 9])) > 0.35 * np.maximum(np.abs(data[:, 10]), np.abs(data[:, 11])))
print(f"reached {reached:.3f} of {options.seconds} s; steps {len(data) - 1}, Newton iterations {newton}, Jacobians {jacobians}")
print(f"lateral against the track: rms {1e3 * np.std(y):.2f} mm, largest {1e3 * np.max(np.abs(y)):.2f} mm; flange in contact in "
      f"{100 * flange:.1f} % of the steps")
print(f"contact calls {model.calls}; statuses {model.statuses}")
if options.picture:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    fig, axes = plt.subplots(3, 1, figsize=(9, 8), sharex=True)
    axes[0].plot(data[:, 0], 1e3 * data[:, 2], label="wheelset")
    axes[0].plot(data[:, 0], 1e3 * data[:, 7], label="rails", lw=0.8)
    axes[0].set_ylabel("lateral [mm]")
    axes[0].legend()
    axes[1].plot(data[:, 0], 1e-3 * data[:, 8], label="right")
    axes[1].plot(data[:, 0], 1e-3 * data[:, 9], label="left")
    axes[1].set_ylabel("lateral force on the wheel [kN]")
    axes[1].legend()
    axes[2].plot(data[:, 0], -1e-3 * data[:, 10], label="right")
    axes[2].plot(data[:, 0], -1e-3 * data[:, 11], label="left")
    axes[2].set_ylabel("vertical force [kN]")
    axes[2].set_xlabel("time [s]")
    fig.tight_layout()
    fig.savefig(options.picture, dpi=110)
sys.exit(0 if success and reached > options.seconds - 2 * options.step else 1)
