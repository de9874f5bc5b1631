"""Numbers of linear theory for a wheelset on its track, by every contact method and by exact contact.

    linear_numbers.py FOLDER [--exact 0.2,0.1] [--case NAME]

For five pairs of profiles under 70 kN a wheel: creep coefficients, gravitational stiffness, conicity, kinematic wave, and at 240 km/h
the damping of a free wheelset, of one on springs, and of the bogie of examples_c/vehicle. FOLDER gets linear_numbers.csv and
linear_numbers.png. --exact: cells in mm, with which wrc_exact_wrench solves as well. The cone has a
row by hand as well: Hertz's ellipse, Kalker's printed coefficients, Klingel's conicity, two degrees of freedom.

All are derivatives of the wrench about a wheelset in the middle that rolls straight: differences over 0.1 mm to the side, 2 um of height
at the wheels, 50 urad about z and creepages of 5e-5, both ways."""
import argparse
import csv
import pathlib

import numpy as np
import scipy.linalg
import wrc

LOAD, SPEED, FRICTION, RADIUS, HALF = 70e3, 240 / 3.6, 0.4, 0.46, 0.75  # N, m/s, -, m, m
STEPS = {"y": 1e-4, "roll": 2e-6 / HALF, "yaw": 5e-5, "vy": 5e-5 * SPEED, "vroll": 5e-5 * SPEED / RADIUS, "vyaw": 5e-5 * SPEED / HALF,
         "vpitch": 5e-5 * SPEED / RADIUS}
INERTIA = np.array([1500.0, 900.0, 900.0])  # of the wheelset of examples_c/vehicle: mass, about x, about z [kg, kg m^2]
ABOUT_AXLE = 110.0  # kg m^2
SOFT = np.diag([1e6, 0.0, 2e6])  # springs of the single wheelset to the ground: across, about x, about z [N/m, N m]
NORMAL = ["HERTZ", "KIK_PIOTROWSKI", "EKP", "EKP_ELLIPSE", "ANALYN", "STRIPES"]
TANGENTIAL = ["FASTSIM", "FASTSIM-EQ.E", "FASTSIM-EQ.L", "FASTSIM-SDEC", "FaStrip", "modified FaStrip", "FaStrip-SDEC"]


def hollow():
    """S1002, 1 mm hollow over the running circle."""
    y, z, _ = wrc.Model(wheel="S1002", rail="60E1").profile("WHEEL")
    y = y - HALF
    z = z - 1e-3 * np.exp(-(y / 0.018) ** 2) + 1e-3
    return {"kind": "POINTS", "y": y, "z": z - np.interp(0.0, y, z)}


def cone():
    """A tread of 1:20 with a flange of 60 degrees."""
    y = np.linspace(-0.045, 0.06, 400)
    z = np.where(y > -0.03, -y / 20, 0.03 / 20 + 1.7 * (-0.03 - y))
    return {"kind": "POINTS", "y": y, "z": z}


CASES = {
    "S1002, 60E1 1:40": dict(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}),
    "S1002, 60E1 1:20": dict(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 20}),
    "S1002, 60E1 1:40, gauge 1430": dict(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40, "gauge": 1.430}),
    "hollow S1002, 60E1 1:40": dict(wheel=hollow(), rail="60E1", track={"rail_inclination": 1 / 40}),
    "cone 1:20, 60E1 1:40": dict(wheel=cone(), rail="60E1", track={"rail_inclination": 1 / 40}),
}


def state(z=0.0, friction=FRICTION, **moved):
    """A wheelset in the middle that rolls straight, but for what is moved."""
    rate = {name: moved.get(name, 0.0) for name in ("vy", "vroll", "vyaw", "vpitch")}
    wheel = dict(y=moved.get("y", 0.0), z=z, roll=moved.get("roll", 0.0), yaw=moved.get("yaw", 0.0), velocity=(SPEED, rate["vy"], 0.0),
                 roll_rate=rate["vroll"], yaw_rate=rate["vyaw"], pitch_rate=-SPEED / RADIUS + rate["vpitch"])
    return wrc.WheelInput(wheel=wheel, friction={"coefficient": friction})


def wrench_of(solve, data):
    found = solve(data)
    return np.r_[found.force, found.moment]


def derivatives(solve, z, friction=FRICTION):
    """Of the right wheel's force and moment by what is moved, at a height."""
    return {name: (wrench_of(solve, state(z, friction, **{name: step})) - wrench_of(solve, state(z, friction, **{name: -step}))) / (2.0 * step)
            for name, step in STEPS.items()}


def numbers(solve):
    """The numbers of one method. Of both wheels the lateral force and the moments about x and z are twice those of the right one by
    y, roll, yaw and their rates: the left wheel is its mirror image."""
    loaded = state()
    loaded.prescribed, loaded.vertical_load = "VERTICAL_LOAD", LOAD
    z = solve(loaded).z
    by = derivatives(solve, z)
    rows = [1, 3, 5]  # Fy, Mx, Mz
    stiffness = -2.0 * np.column_stack([by[name][rows] for name in ("y", "roll", "yaw")])
    damping = -2.0 * np.column_stack([by[name][rows] for name in ("vy", "vroll", "vyaw")])
    loaded = state(friction=0.0)
    loaded.prescribed, loaded.vertical_load = "VERTICAL_LOAD", LOAD
    bare = derivatives(solve, solve(loaded).z, 0.0)
    gravity = without_roll(-2.0 * np.column_stack([bare[name][rows] for name in ("y", "roll", "yaw")]))
    return {**summed(stiffness, damping), "f11 [MN]": -by["vpitch"][0] * SPEED / RADIUS * 1e-6, "f22 [MN]": -by["vy"][1] * SPEED * 1e-6,
            "f23 [kN m]": -by["vyaw"][1] * SPEED * 1e-3, "f33 [kN m2]": -by["vyaw"][5] * SPEED * 1e-3, "gravity y [MN/m]": gravity[0, 0] * 1e-6,
            "gravity yaw [MN m]": gravity[1, 1] * 1e-6}


def summed(stiffness, damping):
    """Kinematic wave, and damping with inertia, of K q + C q' by y, roll, yaw."""
    # a wheelset so slow that it has no inertia
    left = [0, 1, 2] if np.linalg.matrix_rank(damping) == 3 else [0, 2]
    roots = scipy.linalg.eigvals(-stiffness[np.ix_(left, left)], damping[np.ix_(left, left)])
    roots = roots[roots.imag > 1e-3 * np.abs(roots)]
    slow = roots[np.argmin(np.abs(roots))] if len(roots) else complex(np.nan, np.nan)
    wave = 2.0 * np.pi * SPEED / slow.imag
    found = {"conicity": (2.0 * np.pi / wave) ** 2 * HALF * RADIUS, "wave [m]": wave, "slow damping [1/m]": -slow.real / SPEED}
    for name, root in {"free": least_damped(INERTIA, stiffness, damping), "springs": least_damped(INERTIA, stiffness + SOFT, damping),
                       "bogie": bogie(stiffness, damping)}.items():
        found[f"{name} damping [1/s]"] = -root.real
        found[f"{name} [Hz]"] = abs(root.imag) / (2.0 * np.pi)
    return found


def by_hand():
    """The cone on the rail's arc of 300 mm in closed form, without slip: Kalker's coefficients at a/b = 1.31, nu = 0.28, from his
    table; the rail's roll is held."""
    modulus, poisson, rail, cone_angle = 82e9, 0.28, 0.3, 1 / 20
    mean = np.sqrt(RADIUS * rail)
    c = (3.0 * LOAD * mean / 4.0 * (1.0 - poisson) / modulus) ** (1 / 3)  # sqrt(a b): a circle's, within 1 %
    c11, c22, c23 = 4.49, 4.16, 1.85
    f11, f22, f23 = modulus * c ** 2 * c11, modulus * c ** 2 * c22, modulus * c ** 3 * c23
    stiff = 1e9  # N m: roll is none of the two degrees of freedom
    gravity_y, gravity_yaw = 0.0, -2.0 * LOAD * cone_angle * HALF
    stiffness = np.array([[gravity_y, 0.0, -2.0 * f22], [0.0, stiff, 0.0], [2.0 * f11 * HALF * cone_angle / RADIUS, 0.0, 2.0 * f23 + gravity_yaw]])
    damping = np.array([[2.0 * f22, 0.0, 2.0 * f23], [0.0, 0.0, 0.0], [-2.0 * f23, 0.0, 2.0 * f11 * HALF ** 2]]) / SPEED
    return {**summed(stiffness, damping), "f11 [MN]": f11 * 1e-6, "f22 [MN]": f22 * 1e-6, "f23 [kN m]": f23 * 1e-3, "f33 [kN m2]": f11 * HALF ** 2 * 1e-3,
            "gravity y [MN/m]": gravity_y * 1e-6, "gravity yaw [MN m]": gravity_yaw * 1e-6}


def without_roll(stiffness):
    """Of y and yaw, the roll such that nothing turns the wheelset about x."""
    keep = [0, 2]
    return stiffness[np.ix_(keep, keep)] - np.outer(stiffness[keep, 1], stiffness[1, keep]) / stiffness[1, 1]


def spinning(damping):
    """Adds to a wheelset's damping that what turns about its axle resists other turning."""
    spin = ABOUT_AXLE * SPEED / RADIUS
    return damping + np.array([[0.0, 0.0, 0.0], [0.0, 0.0, spin], [0.0, -spin, 0.0]])


def eigenvalues(mass, stiffness, damping):
    count = len(mass)
    matrix = np.block([[np.zeros((count, count)), np.eye(count)], [-stiffness / mass[:, None], -damping / mass[:, None]]])
    return np.linalg.eigvals(matrix)


def least_damped(mass, stiffness, damping, spin=True):
    roots = eigenvalues(mass, stiffness, spinning(damping) if spin else damping)
    swinging = roots[(roots.imag > 0.5) & (roots.imag < 200.0)]  # the contact's own vibration lies above 100 Hz
    return swinging[np.argmax(swinging.real)] if len(swinging) else complex(np.nan, np.nan)


def bogie(stiffness, damping):
    """The least damped motion of two wheelsets and their frame, springs as in examples_c/vehicle; y, roll, yaw of each."""
    K, C = np.zeros((9, 9)), np.zeros((9, 9))
    for wheelset, ahead in ((0, 1.25), (1, -1.25)):
        at = slice(3 * wheelset, 3 * wheelset + 3)
        K[at, at] += stiffness
        C[at, at] += spinning(damping)
        for out in (1.0, -1.0):
            for own, frame, spring, damper in (((0.0, 0.0, -out), (0.0, 0.0, out), 12e6, 0.0), ((1.0, 0.0, 0.0), (-1.0, 0.0, -ahead), 5e6, 0.0),
                                               ((0.0, out, 0.0), (0.0, -out, 0.0), 1.2e6, 8e3)):
                row = np.zeros(9)
                row[at], row[6:] = own, frame
                K += spring * np.outer(row, row)
                C += damper * np.outer(row, row)
    K[6:, 6:] += np.diag([160e3, 430e3, 250e3])
    C[6:, 6:] += np.diag([32e3, 30e3, 30e3])
    return least_damped(np.array([*INERTIA, *INERTIA, 2600.0, 1500.0, 2800.0]), K, C, spin=False)


def contact_of(case, normal=None, tangential=None):
    model = dict(CASES[case])
    config = wrc.Config()
    config.set(**model)
    config.wheelset.wheel_radius = RADIUS
    if tangential:
        wrc.use(config, tangential)
    if normal:
        config.normal.method = normal
    return wrc.Model(config).contact("RIGHT")


def methods(cells):
    """By name: what makes a contact of a case, and what solves an input."""
    found = {"default": (lambda case: contact_of(case), lambda contact: contact.wrench)}
    for normal in NORMAL:
        for tangential in ("FASTSIM", "strip FASTSIM"):
            found[f"{normal.lower()} + {tangential}"] = (lambda case, n=normal, t=tangential: contact_of(case, n, t), lambda contact: contact.wrench)
    for tangential in TANGENTIAL:
        found[f"strip half-space + {tangential}"] = (lambda case, t=tangential: contact_of(case, None, t), lambda contact: contact.wrench)
    for cell in cells:
        options = wrc.ExactWrenchOptions(cell_x=1e-3 * cell, cell_s=1e-3 * cell)
        found[f"exact, {cell:g} mm"] = (lambda case: contact_of(case), lambda contact, o=options: lambda data: contact.exact_wrench(data, o))
    return found


def draw(table, path):
    made = wrc.plot.figure(figsize=(13, 10))
    names = ["conicity", "slow damping [1/m]", "f11 [MN]", "f22 [MN]", "f23 [kN m]", "bogie damping [1/s]"]
    panels = made.subplots(2, 3)
    cases = list(dict.fromkeys(row["case"] for row in table))
    labels = list(dict.fromkeys(row["method"] for row in table))
    for panel, name in zip(panels.flat, names):
        for case, colour in zip(cases, wrc.plot.COLOURS):
            rows = [row for row in table if row["case"] == case]
            best = rows[-1][name]
            panel.plot([row[name] for row in rows], [labels.index(row["method"]) for row in rows], "o", color=colour, markersize=4, label=case)
            panel.axvline(best, color=colour, linewidth=0.8)
        panel.set(title=name, yticks=range(len(labels)), yticklabels=labels)
        panel.tick_params(labelsize=7, labelleft=panel in panels[:, 0])
        panel.invert_yaxis()
        panel.grid(alpha=0.3)
    panels[0, 0].legend(fontsize=6)
    made.suptitle("lines: the last row, exact contact" if "exact" in labels[-1] else "")
    made.savefig(path, dpi=90)


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("folder", type=pathlib.Path)
    asked.add_argument("--exact", default="", help="cells [mm], as in 0.2,0.1")
    asked.add_argument("--case", default="", help="part of the name of a case")
    told = asked.parse_args()
    cells = [float(each) for each in told.exact.split(",") if each]
    table = []
    for case in CASES:
        if told.case not in case:
            continue
        rows = {"by hand": by_hand} if case.startswith("cone") else {}
        rows.update({name: lambda each=each: numbers(each[1](each[0](case))) for name, each in methods(cells).items()})
        for name, found in rows.items():
            row = {"case": case, "method": name, **found()}
            table.append(row)
            print(" | ".join([f"{name:36}"] + [f"{value:.4g}" for value in list(row.values())[2:]]), flush=True)
    with open(told.folder / "linear_numbers.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, table[0])
        writer.writeheader()
        writer.writerows(table)
    draw(table, told.folder / "linear_numbers.png")


if __name__ == "__main__":
    main()
