"""What the rails did to the wheelset along a run of bindings/python/examples: the rows that draw_wheelset.py draws, in the
run's place.

    wheelset_rows.py FILE.csv [RMS]      time, coordinates and their rates as the example wrote them; RMS of the track [0.0015]
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bindings/python/examples"))
from wheelset import SPEED, Wheelset

wheelset = Wheelset(*map(float, sys.argv[2:]))
rows = []
for t, *state in np.genfromtxt(sys.argv[1], delimiter=","):
    q, v = np.array(state[:6]), np.array(state[6:])
    wheelset.forces(t, q, v)
    regions = [contact.regions() for contact in wheelset.wheels.contacts]
    steepest = max((abs(each.angle) for side in regions for each in side), default=0.0)
    rows.append([t, *q[:4], q[5], v[4], wheelset.track(SPEED * t + q[0]), *wheelset.out["force"][:, 1:].ravel(),
                 len(regions[0]), len(regions[1]), np.degrees(steepest)])
data = np.array(rows)
y = data[:, 2] - data[:, 7]
print(f"lateral against the rails: rms {1e3 * np.std(y):.2f} mm, largest {1e3 * np.max(np.abs(y)):.2f} mm; "
      f"largest lateral force of a wheel {1e-3 * np.max(np.abs(data[:, [8, 10]])):.0f} kN")
print(f"rows with contact on a flange's root {np.sum(data[:, 14] > 12)}, on a flange {np.sum(data[:, 14] > 40)}, "
      f"with two regions on a wheel {np.sum(np.max(data[:, 12:14], axis=1) > 1)} of {len(data)}")
np.savetxt(sys.argv[1], data, "%.9g", ",", comments="",
           header="t,x,y,z,roll,yaw,spin,rail_y,y_right,z_right,y_left,z_left,regions_right,regions_left,steepest")
