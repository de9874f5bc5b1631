"""A wheelset on an irregular track in Exudyn (generalised alpha, fixed steps), wrc as its force element.

    wheelset_exudyn.py [--seconds 8] [--speed 40] [--rms 0.0015] [--full] [--most 25] [--rows FILE.csv]

Prints failed steps, Newton iterations per step and how often a flange touches. Exit status 1 if a step fails or takes more
than --most iterations."""
import argparse
import collections
import pathlib
import sys
import time

import exudyn as exu
import exudyn.itemInterface as items
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from wheelset import MASS, Wheelset, report

arguments = argparse.ArgumentParser()
arguments.add_argument("--seconds", type=float, default=8.0)
arguments.add_argument("--speed", type=float, default=40.0)
arguments.add_argument("--step", type=float, default=1e-3)
arguments.add_argument("--rms", type=float, default=1.5e-3)
arguments.add_argument("--full", action="store_true", help="a Jacobian in every iteration, not only where convergence is slow")
arguments.add_argument("--most", type=int, default=25, help="Newton iterations a step may take")
arguments.add_argument("--rows")
options = arguments.parse_args()

wheelset = Wheelset(options.speed, options.rms)
container = exu.SystemContainer()
mbs = container.AddSystem()
node = mbs.AddNode(items.NodeGenericODE2(referenceCoordinates=[0] * 6, initialCoordinates=[0] * 6,
                                         initialCoordinates_t=[0] * 6, numberOfODE2Coordinates=6))
mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.diag(MASS),
                                      forceUserFunction=lambda mbs, t, item, q, v: wheelset.forces(t, q, v)))
rows, iterations = [], []


def record(mbs, t):
    if t > 0:
        iterations.append(solver.it.newtonSteps)
    rows.append(wheelset.row(t, mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates),
                             mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates_t)))
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
start = time.perf_counter()
try:
    whole = solver.SolveSystem(mbs, settings)
except Exception as error:  # Exudyn raises where a step fails
    print("Exudyn stopped:", *str(error).splitlines()[:1])
    whole = False
counts = collections.Counter(iterations)
print(f"{'reached the end' if whole else 'A STEP FAILED'} at {rows[-1][0]:.3f} of {options.seconds:g} s, "
      f"{options.speed:g} m/s, irregularity rms {1e3 * options.rms:g} mm")
print("Newton iterations per step:", ", ".join(f"{n}: {counts[n]} steps" for n in sorted(counts)),
      f"; Jacobians {solver.it.newtonJacobiCount}, steps begun again with a Jacobian in every iteration "
      f"{solver.it.rejectedModifiedNewtonSteps}")
report(rows, options.rows)
print(f"wheel calls {wheelset.calls} in {time.perf_counter() - start:.1f} s")
sys.exit(0 if whole and max(iterations) <= options.most else 1)
