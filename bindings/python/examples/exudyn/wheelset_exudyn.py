"""A wheelset on an irregular track in Exudyn (generalised alpha, fixed steps of 1 ms), wrc as its force element.

    wheelset_exudyn.py [--seconds 8] [--rms 0.0015] [--full] [--rows FILE.csv]     --full: a Jacobian in every iteration"""
import argparse
import sys

import exudyn
import exudyn.itemInterface as items
import numpy as np

sys.path.append(sys.path[0] + "/..")
from wheelset import MASS, Wheelset

arguments = argparse.ArgumentParser()
arguments.add_argument("--seconds", type=float, default=8.0)
arguments.add_argument("--rms", type=float, default=1.5e-3)
arguments.add_argument("--full", action="store_true")
arguments.add_argument("--rows", default="wheelset_exudyn.csv", help="time, coordinates, their rates")
options = arguments.parse_args()
wheelset = Wheelset(options.rms)
container = exudyn.SystemContainer()
mbs = container.AddSystem()
node = mbs.AddNode(items.NodeGenericODE2(referenceCoordinates=[0] * 6, initialCoordinates=[0] * 6, initialCoordinates_t=[0] * 6,
                                         numberOfODE2Coordinates=6))
mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.diag(MASS), forceUserFunction=lambda mbs, t, item, q, v:
                                      wheelset.forces(t, np.array(q), np.array(v))))
mbs.Assemble()
settings = exudyn.SimulationSettings()
settings.timeIntegration.numberOfSteps = round(1000 * options.seconds)
settings.timeIntegration.endTime = options.seconds
settings.timeIntegration.adaptiveStep = False
settings.timeIntegration.newton.absoluteTolerance = 1e-8
settings.timeIntegration.newton.useModifiedNewton = not options.full
settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
settings.solution.file.name = options.rows
settings.solution.file.writePeriod = 1e-3
settings.solution.file.export.accelerations = False
solver = exudyn.MainSolverImplicitSecondOrder()
solver.SolveSystem(mbs, settings)  # raises where a step fails
print(f"reached the end: {solver.it.newtonStepsCount / settings.timeIntegration.numberOfSteps:.2f} Newton iterations per step, "
      f"{solver.it.newtonJacobiCount} Jacobians")
