"""A wheelset with a share of a vehicle, along the track, with a brake: for the programs beside. One wheel is solved; the other is its
mirror image. Speed v and angular velocity w about the axle (rolling forwards < 0), x and angle are their integrals."""
import numpy as np
import wrc

SLOPE, TORQUE, STIFFNESS, DAMPING = 0.02, 3e3, 1e6, 4e4  # of the track; of both hosts' brake N m, N m/rad, N m s/rad
MASS, INERTIA, RADIUS, LOAD, GRAVITY = 10e3, 120.0, 0.46, 50e3, 9.81  # kg of a vehicle on it, kg m2, m, N a wheel, m/s2


class Braked:
    """With memory: the contact remembers its tractions. Without it forces below 0.1 m/s are those of a damper."""

    def __init__(self, memory=True, friction=0.3):
        model = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}, surface={"memory": int(memory)})
        self.wheel, self.memory, self.calls = model.contact(), memory, 0
        self.input, self.wrench = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=LOAD, friction={"coefficient": friction}), wrc.Wrench()
        self.input.wheel.z = self.wheel.wrench(self.input).z  # its height under the load stays
        self.input.prescribed, self.input.vertical_load = "HEIGHT", 0.0
        self.forces(0.0, 0.0, 0.0)  # a contact begins without tractions
        self.commit()

    def forces(self, v, w, step):
        """Force along the track [N] and moment about the axle [N m] of both wheels at the end of a step: a trial, without a trace."""
        self.calls += 1
        self.input.wheel.velocity[0], self.input.wheel.pitch_rate = v, w
        if self.memory:
            self.input.time_step = step
        self.wheel.wrench(self.input, out=self.wrench)
        return 2.0 * np.array([self.wrench.force[0], self.wrench.moment[1]])

    def commit(self):
        """Accepts the last trial."""
        if self.memory:
            self.wheel.commit()
