"""A wheel over a network of curves with dask.distributed: what examples_c/wheel_wear.c does, curves dealt out to a cluster.

    wear.py FOLDER [--km 100000] [--curves 1000] [--workers 2 | --address tcp://HOST:8786]

FOLDER gets wheel_wear.csv, a line for every update of the profile, profile_NNNNNN.csv every 10 000 km, and state.npz, from
which the next call goes on where this one ended or was ended; draw_wheel_wear.py of examples_c draws them. A worker that dies
is replaced and its curves are run again. The bits are the same whatever the number of workers: lots of neighbouring curves
begin alike whoever runs them, and bins add up exactly, in any order."""
import argparse
import math
import os
import pathlib
import sys

import numpy as np

BINS, FIRST, WIDTH = 280, -0.080, 0.5e-3  # of the wheel's profile, by arc length [m]
TOGETHER = 25  # curves of a lot
RADIUS, LOAD, FRICTION, BASE, GRAVITY = 0.46, 70e3, 0.3, 1.5, 9.81
LUBRICATION = 0.05  # dry coefficients of the KTH map times this: rails are wet and greasy for most of a year


def network(curves):
    """Rows: curvature [1/m], > 0 to the right; length [m]; cant deficiency over the gauge; speed [m/s]. Half of the length is
    tangent, radii from 400 m on; sorted, so that neighbours are alike."""
    seed, rows = 2026, []

    def random():
        nonlocal seed
        seed = (1664525 * seed + 1013904223) % 2 ** 32
        return seed / 2 ** 32

    for i in range(curves):
        pick = random()
        r = 0.0 if pick < 0.5 else 400.0 / (1.0 - 0.94 * (pick - 0.5) / 0.5)
        length = 200.0 + 600.0 * random()
        deficiency = (-0.02 + 0.12 * random()) / BASE if r else 0.0
        rows.append(((1 if i % 2 == 0 else -1) / r if r else 0.0, length, deficiency,
                     min(45.0, math.sqrt(GRAVITY * r * (0.08 + deficiency))) if r else 40.0))
    return np.array(sorted(rows, key=lambda row: row[0]))


def model_of(profile):
    import wrc
    wheel = "S1002" if profile is None else wrc.Profile(kind="POINTS", y=profile[0], z=profile[1])
    return wrc.Model(wheel=wheel, rail="60E1", wheelset={"wheel_radius": RADIUS}, track={"rail_inclination": 1.0 / 40.0})


class Wheelset:
    """Free to roll and to move sideways, and radial in each curve: without an angle of attack."""

    def __init__(self, model):
        import wrc
        self.contacts, self.wrench = [model.contact("RIGHT"), model.contact("LEFT")], wrc.Wrench()
        self.input = wrc.WheelInput(prescribed="VERTICAL_LOAD", start="WARM", friction={"coefficient": FRICTION})
        self.y = self.rotation = 0.0

    def forces(self, curve, y, rotation):
        """Lateral force on the wheelset [N] and moment about the axle [N m]; None where a wheel climbs."""
        import wrc
        curvature, _, deficiency, speed = (float(each) for each in curve)
        given, lateral, moment = self.input, 0.0, 0.0
        given.wheel.y = y
        given.wheel.velocity[0] = speed
        given.wheel.pitch_rate, given.wheel.yaw_rate = -speed / RADIUS * (1.0 + rotation), speed * curvature
        way = (curvature > 0.0) - (curvature < 0.0)
        for contact, outer in zip(self.contacts, (-1.0, 1.0)):  # a curve to the right loads the left wheel
            given.vertical_load = LOAD * (1.0 + outer * 1.2 * way * deficiency)
            try:
                contact.wrench(given, out=self.wrench)
            except wrc.Error:
                return None
            if wrc.Flags.CLIMBING in self.wrench.flags:
                return None
            lateral += self.wrench.force[1]
            moment += self.wrench.moment[1]
        return lateral - way * 2.0 * LOAD * deficiency, moment

    def spin_free(self, curve, y):
        """Finds the rotation at which nothing turns the axle, by secants; gives the lateral force there."""
        a, b = self.rotation, self.rotation + 1e-4
        found = self.forces(curve, y, a)
        if found is None:
            return None
        fa = found[1]
        for _ in range(8):
            found = self.forces(curve, y, b)
            if found is None:
                return None
            fb = found[1]
            if abs(fb) < 20.0 or fb == fa:
                break
            step = min(3e-3, max(-3e-3, -fb * (b - a) / (fb - fa)))
            a, fa, b = b, fb, b + step
        self.rotation = b
        return found[0]

    def settle(self, curve):
        """Finds the place at which the lateral forces balance, between the two flanges: steps that grow until the force
        changes its sign, then regula falsi (Illinois)."""
        left, right, last = [-0.0085, None], [0.0085, None], None
        y, step = self.y, 0.1e-3
        for _ in range(24):
            if right[0] - left[0] <= 1e-5:
                break
            force = self.spin_free(curve, y)
            if force is None:
                return False
            if abs(force) < 300.0:
                break
            end, other = (left, right) if force > 0.0 else (right, left)
            if last is end and other[1] is not None:
                other[1] *= 0.5
            end[:], last = [y, force], end
            if left[1] is not None and right[1] is not None:
                y = left[0] + (right[0] - left[0]) * left[1] / (left[1] - right[1])
            else:
                y, step = y + math.copysign(step, force), 3.0 * step
                if not left[0] < y < right[0]:
                    y = 0.5 * (left[0] + right[0])
        self.y = y
        return True

    def slopes(self, curve):
        """How y and rotation move by unit force and moment; None where they do not."""
        dy, dr = 2e-6, 2e-5
        at = [self.forces(curve, self.y + a, self.rotation + b) for a, b in ((0.0, 0.0), (dy, 0.0), (0.0, dr), (0.0, 0.0))]
        if any(each is None for each in at):
            return None
        slope = np.array([(np.array(at[1]) - at[0]) / dy, (np.array(at[2]) - at[0]) / dr]).T
        return np.linalg.inv(slope) if np.linalg.det(slope) else None

    def settle_again(self, curve, place):
        """From where the curve was run through last, when the profile was hardly another one: Broyden's steps. None where
        they do not arrive."""
        at, slope, scale = place[:2].copy(), place[2:].reshape(2, 2).copy(), np.array([0.3e-3, 1e-3])
        now = self.forces(curve, *at)
        for _ in range(7):
            if now is None or (abs(now[0]) < 300.0 and abs(now[1]) < 20.0):
                break
            step = -(slope @ now)
            step /= max(1.0, np.max(np.abs(step) / scale))
            then = self.forces(curve, *(at + step))
            if then is None:
                return None
            moved, weight = slope @ np.subtract(then, now), step / scale ** 2
            if weight @ moved == 0.0:
                return None
            slope += np.outer(step - moved, weight @ slope) / (weight @ moved)
            at, now = at + step, then
        if now is None or not (abs(now[0]) < 300.0 and abs(now[1]) < 20.0):
            return None
        self.y, self.rotation = at
        return np.concatenate([at, slope.ravel()])


def run_lot(profile, curves, places):
    """What a worker does with neighbouring curves: the bins after a passage of each, the places for the next round, and how
    many curves could not be run."""
    import wrc
    model = model_of(profile)
    wheelset, lost, places = Wheelset(model), 0, places.copy()
    bins = wrc.Bins(BINS, FIRST, WIDTH)
    laws = wrc.WearLaws()
    for name in ("archard_slow", "archard_severe", "archard_fast", "archard_seizure"):
        setattr(laws, name, LUBRICATION * getattr(laws, name))
    for i, curve in enumerate(curves):
        place = None if np.isnan(places[i, 0]) else wheelset.settle_again(curve, places[i])
        if place is None:
            places[i] = np.nan
            if i > 0 and curve[0] * curves[i - 1, 0] <= 0.0:
                wheelset.y = wheelset.rotation = 0.0
            if not wheelset.settle(curve):
                lost += 1
                wheelset.y = wheelset.rotation = 0.0
                continue
            slope = wheelset.slopes(curve)
            if slope is not None:
                place = np.concatenate([[wheelset.y, wheelset.rotation], slope.ravel()])
        if place is not None:
            places[i] = place
        for contact in wheelset.contacts:  # both ways: the wheel is the outer as often as the inner one
            contact.accumulate(bins, duration=float(curve[1] / curve[3]), wear=laws)
    return bins, places, lost


def worn(profile, depth, passages):
    """The profile after so many passages, or as many as take off 0.2 mm: points, passages, largest depth [m]."""
    import wrc
    found, y, z = wrc.remove_wear(*profile, depth, first=FIRST, width=WIDTH, passages=passages, largest_depth=0.2e-3)
    return np.array([y, z]), found.passages, found.depth


def first_points(model):
    """Of the model's wheel, every half millimetre."""
    y, z = model.arc_places(-0.0795 + 0.5e-3 * np.arange(262))
    kept = np.concatenate([[True], np.diff(y) > 1e-5])
    return np.array([y[kept], z[kept]])


def gauged(profile):
    """Flange height, thickness, qR [mm], equivalent conicity at 3 mm."""
    import wrc
    flange, lateral = wrc.flange_dimensions(*profile, 0.070), 1e-4 * np.arange(-40, 41)
    difference = model_of(profile).wheelset_geometry(lateral)["radius_difference"]
    conicity = wrc.conicity(lateral, difference, 3e-3, radius=RADIUS)["conicity"][0]
    return 1e3 * flange.height, 1e3 * flange.thickness, 1e3 * flange.slope, conicity


def run(folder, km, curves, client=None):
    """Goes on to that distance, serially without a client; the number of updates made."""
    import wrc
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    state_file, table, rows = folder / "state.npz", folder / "wheel_wear.csv", network(curves)
    length = float(np.sum(rows[:, 1])) * 1e-3

    def keep(distance, profile, places, lines):
        """The state last, whole or not at all: what stands beside it can be written again from it."""
        table.write_text("\n".join(lines) + "\n")
        with open(folder / "state.part", "wb") as part:
            np.savez(part, distance=distance, profile=profile, places=places, curves=curves, lines=np.array(lines))
        os.replace(folder / "state.part", state_file)

    def write_profile(distance, profile):
        np.savetxt(folder / f"profile_{distance:06.0f}.csv", 1e3 * profile.T, "%.6f", ",", header="y_mm,z_mm", comments="")

    def line(distance, depth, profile, lost):
        return f"{distance:.1f},{1e3 * depth:.4f},{{:.4f}},{{:.4f}},{{:.4f}},{{:.5f}},{lost}".format(*gauged(profile))

    if state_file.exists():
        state = np.load(state_file)
        if int(state["curves"]) != curves:
            sys.exit(f"{state_file} is of {state['curves']} curves: choose another folder, or remove it")
        distance, profile, places, lines = float(state["distance"]), state["profile"], state["places"], list(state["lines"])
        print(f"going on from {distance:.0f} km")
    else:
        distance, profile, places = 0.0, first_points(model_of(None)), np.full((curves, 6), np.nan)
        lines = ["distance_km,depth_mm,flange_height_mm,flange_thickness_mm,qR_mm,conicity,curves_left_out", line(0.0, 0.0, profile, 0)]
        write_profile(0.0, profile)
        keep(distance, profile, places, lines)
    updates = 0
    while distance < km:
        lots = [slice(first, min(first + TOGETHER, curves)) for first in range(0, curves, TOGETHER)]
        if client is None:
            results = ((lot, run_lot(profile, rows[lot], places[lot])) for lot in lots)
        else:
            from dask.distributed import as_completed
            futures = {client.submit(run_lot, profile, rows[lot], places[lot], pure=False, retries=3): lot for lot in lots}
            results = ((futures[each], each.result()) for each in as_completed(list(futures)))
        bins, lost, next_places = wrc.Bins(BINS, FIRST, WIDTH), 0, places.copy()
        for lot, (its, found, left_out) in results:
            bins.merge(its)
            next_places[lot] = found
            lost += left_out
        # of one wheel: both wheels' volumes are in there, of which it has half
        depth = 0.5 * bins.values("WEAR_ARCHARD")[0] / (WIDTH * 2.0 * math.pi * RADIUS)
        until = min(km, 10e3 * (math.floor(distance / 10e3 + 1e-9) + 1.0))
        profile, passages, deepest = worn(profile, depth, (until - distance) / length)
        if not passages > 0.0:
            sys.exit("takes off no whole passage")
        distance += passages * length
        distance = until if distance > until - 1e-6 else distance
        places, updates = next_places, updates + 1
        lines.append(line(distance, deepest, profile, lost))
        if distance == until:
            write_profile(distance, profile)
        keep(distance, profile, places, lines)
        print(lines[-1], flush=True)
    return updates


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder")
    arguments.add_argument("--km", type=float, default=100e3)
    arguments.add_argument("--curves", type=int, default=1000)
    arguments.add_argument("--workers", type=int, default=os.cpu_count())
    arguments.add_argument("--address")
    options = arguments.parse_args()
    from dask.distributed import Client, LocalCluster
    local = None if options.address else LocalCluster(n_workers=options.workers, threads_per_worker=1, processes=True,
                                                      dashboard_address="127.0.0.1:0")
    with Client(options.address or local) as client:
        run(options.folder, options.km, options.curves, client)
    if local:
        local.close()


if __name__ == "__main__":
    main()
