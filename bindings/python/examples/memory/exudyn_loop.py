"""The wheelset beside in Exudyn, in steps of 1 ms: exudyn_loop.py [--seconds 5] [--step 1] [--forget]

The state is that of cvode.py. Exudyn's generalised alpha calls the force at trial states of Newton's method and for its Jacobian by
differences; its user function before each step commits the step that has just ended. --forget runs it without memory."""
import argparse

import exudyn
import exudyn.itemInterface as items
import numpy as np
from braked import DAMPING, GRAVITY, INERTIA, MASS, RADIUS, SLOPE, STIFFNESS, TORQUE, Braked


class Host:
    """Coordinates: x less free rolling's, angle of the axle less free rolling's."""

    def __init__(self, memory, step):
        self.wheelset, self.step = Braked(memory), step
        self.begin, self.place, self.twist, self.end = 0.0, np.zeros(2), 0.0, None

    def brake(self, turned):
        """Torque at the end of a step in which the axle has turned by that, and the twist of the brake's spring there."""
        twist = (self.twist + turned) / (1.0 + abs(turned) * STIFFNESS / TORQUE)  # Dahl's equation, implicitly
        return -STIFFNESS * twist - DAMPING * (twist - self.twist) / self.step, twist

    def forces(self, mbs, t, item, q, v):
        q, v, step = np.array(q), np.array(v), t - self.begin
        moved = (q - self.place) / step if self.wheelset.memory and step > 0.0 else v
        force, moment = self.wheelset.forces(moved[0], moved[1], max(step, 0.0))
        brake, twist = self.brake(q[1] - self.place[1])
        self.end = (t, q, twist)
        return np.array([force - MASS * GRAVITY * SLOPE, moment + brake])

    def commit(self, mbs, t):
        """Before a step: the last one is accepted."""
        if self.end is not None:
            q, v = (np.array(mbs.GetNodeOutput(0, kind)) for kind in (exudyn.OutputVariableType.Coordinates, exudyn.OutputVariableType.Coordinates_t))
            self.forces(mbs, self.end[0], 0, q, v)
            self.wheelset.commit()
            self.begin, self.place, self.twist = self.end
        return True


def run(memory, seconds, step):
    host, container = Host(memory, step), exudyn.SystemContainer()
    mbs = container.AddSystem()
    node = mbs.AddNode(items.NodeGenericODE2(referenceCoordinates=[0] * 2, initialCoordinates=[0] * 2, initialCoordinates_t=[2.0, -2.0 / RADIUS],
                                             numberOfODE2Coordinates=2))
    mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.diag([MASS, INERTIA]), forceUserFunction=host.forces))
    sensor = mbs.AddSensor(items.SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=exudyn.OutputVariableType.Coordinates))
    mbs.SetPreStepUserFunction(host.commit)
    mbs.Assemble()
    settings = exudyn.SimulationSettings()
    settings.timeIntegration.numberOfSteps = round(seconds / step)
    settings.timeIntegration.endTime = seconds
    settings.timeIntegration.adaptiveStep = False
    settings.timeIntegration.newton.useModifiedNewton = False
    settings.timeIntegration.newton.absoluteTolerance = 1e-8
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.5
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = step
    solver = exudyn.MainSolverImplicitSecondOrder()
    done = solver.SolveSystem(mbs, settings)
    return done, mbs.GetSensorStoredData(sensor), solver.it.newtonStepsCount / settings.timeIntegration.numberOfSteps, host.wheelset.calls


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--seconds", type=float, default=5.0)
    arguments.add_argument("--step", type=float, default=1.0, help="ms")
    arguments.add_argument("--forget", action="store_true")
    options = arguments.parse_args()
    done, rows, iterations, calls = run(not options.forget, options.seconds, 1e-3 * options.step)
    last = rows[rows[:, 0] > rows[-1, 0] - 1.0]
    print(f"{'without memory' if options.forget else 'memory'}: {'no step failed' if done else f'fails at {rows[-1, 0]:.3f} s'}, {iterations:.2f} Newton iterations per step, {calls} calls; "
          f"stops after {rows[:, 1].max():.4f} m; in the last second it moves {1e6 * (last[-1, 1] - last[0, 1]):+.3g} um")


if __name__ == "__main__":
    main()
