"""Creep forces on corrugation, by a contact that remembers and by steady rolling: corrugation.py [--waves 4] [--picture corrugation.png]

A wheel rolls at constant height over a rail whose height is a wave of 20 to 100 mm, or with creepage that is such a wave, at 100, 200 and
300 km/h. Printed are, against steady rolling at each moment, the ratio of the amplitudes of the longitudinal force and how far it lags.
The rail rises and falls as a whole: the geometry's own filter of waves shorter than the patch is not in it. Exact contact,
cell by cell (wrc.exact.Transient), stands beside for the wave of creepage, on the contact plane of the same wheel."""
import argparse

import numpy as np
import wrc

RADIUS, LOAD, FRICTION = 0.46, 80e3, 0.3  # m, N, -
MEAN, SWING, HEIGHT = 1e-3, 0.3e-3, 5e-6  # creepage, its wave; amplitude of the rail's wave [m]
WAVES = np.array([20e-3, 25e-3, 30e-3, 40e-3, 55e-3, 75e-3, 100e-3])  # m


def forces(contact, standing, wave, speed, kind, waves, points=32):
    """Longitudinal force at `points` places of the last of `waves` waves [N]. A contact without memory forgets the others."""
    data = wrc.WheelInput(wheel={"z": standing, "velocity": (speed, 0, 0)}, friction={"coefficient": FRICTION})
    remembers = contact.model.config.surface.memory == 1
    found, step = [], wave / points / speed
    for k in range(-4 * points if remembers else (waves - 1) * points, waves * points):
        phase = 2 * np.pi * k / points
        creepage = MEAN + (SWING * np.sin(phase) if kind == "creepage" else 0.0)
        data.wheel.pitch_rate = -speed / RADIUS * (1 - creepage)
        data.rail.z = -HEIGHT * np.sin(phase) if kind == "height" else 0.0  # up is more load
        if remembers:
            data.time_step = step
        found.append(contact.wrench(data).force[0])
        if remembers:
            contact.commit()
    return np.array(found[-points:])


def first_harmonic(values):
    """Amplitude, with its phase against a sine, as a complex number."""
    return 2j * np.mean(values * np.exp(-2j * np.pi * np.arange(len(values)) / len(values)))


def compare(waves, kinds, speeds, count):
    remembering, steady = (wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}, surface={"memory": each}) for each in (1, 0))
    contact = steady.contact()
    standing = contact.wrench(wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=LOAD, wheel={"velocity": (30, 0, 0), "pitch_rate": -30 / RADIUS})).z
    # the length of the patch: the longest of its strips
    length = 2 * max(float(contact.field("STRIP_HALF_LENGTH", region).max()) for region in range(len(contact.regions())))
    rows = []
    for kind in kinds:
        for speed in speeds:
            for wave in waves:
                followed = first_harmonic(forces(remembering.contact(), standing, wave, speed / 3.6, kind, count))
                at_once = first_harmonic(forces(contact, standing, wave, speed / 3.6, kind, count))
                rows.append((kind, speed, wave, abs(followed / at_once), np.degrees(np.angle(at_once / followed)), abs(at_once)))
    return length, rows


def exact(waves, count, cell=0.45e-3):
    """Ratio and lag for waves of creepage, by exact contact of cells: rows as compare() has them, with speed 0."""
    contact = wrc.Model(wheel="S1002", rail="60E1", track={"rail_inclination": 1 / 40}).contact()
    contact.planar_geometry(wrc.PlanarPose())
    grid = wrc.exact.grid(32, 60, cell)
    _, pressure = wrc.exact.normal(grid, contact.exact_gap(grid), normal_force=LOAD)

    def steady(creepage):
        return wrc.exact.rolling(grid, pressure, friction=FRICTION, creepage={"longitudinal": creepage})[0].fx

    rows = []
    for wave in waves:
        points = round(wave / cell)
        creepages = MEAN + SWING * np.sin(2 * np.pi * np.arange(-points, (count - 1) * points) / points)
        bodies = wrc.exact.Transient(grid)
        followed = first_harmonic(np.array([bodies.step(pressure, friction=FRICTION, creepage={"longitudinal": -each})[0].fx
                                            for each in creepages])[-points:])
        at_once = first_harmonic(np.array([steady(-each) for each in creepages[-points:]]))
        rows.append(("exact", 0, points * cell, abs(followed / at_once), np.degrees(np.angle(at_once / followed)), abs(at_once)))
    return rows


def draw(length, rows, path):
    figure = wrc.plot.figure(figsize=(11, 4.6))
    panels = figure.subplots(1, 2)
    for kind, colour, name in (("creepage", "#0072B2", "creepage is a wave"), ("height", "#D55E00", "the rail's height is a wave")):
        for speed, mark in ((100, "o"), (200, "+"), (300, "x")):
            these = np.array([each[2:5] for each in rows if each[0] == kind and each[1] == speed])
            for axes, values in zip(panels, these.T[1:]):
                axes.plot(these[:, 0] / length, values, mark + ("-" if speed == 100 else ""), color=colour, lw=1.2, ms=6, mfc="none",
                          label=f"{name}, {speed} km/h")
    these = np.array([each[2:5] for each in rows if each[0] == "exact"])
    for axes, values in zip(panels, these.T[1:]):
        axes.plot(these[:, 0] / length, values, "ks", ms=4, label="creepage is a wave, exact")
    panels[0].set(ylabel="amplitude of the force / that of steady rolling", ylim=(0, 1.1))
    panels[1].set(ylabel="lag behind steady rolling [degrees]")
    for axes in panels:
        axes.set(xlabel="wavelength / length of the patch")
        axes.grid(alpha=0.3)
    panels[0].legend(fontsize=8)
    figure.savefig(path)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--waves", type=int, default=4, help="waves run through")
    arguments.add_argument("--short", action="store_true", help="two wavelengths at one speed, one of exact contact")
    arguments.add_argument("--picture")
    options = arguments.parse_args()
    length, rows = compare(WAVES[[0, -1]] if options.short else WAVES, ("creepage", "height"), (200,) if options.short else (100, 200, 300), options.waves)
    rows += exact(WAVES[:1] if options.short else WAVES, 3)
    print(f"patch {1e3 * length:.1f} mm long")
    for kind, speed, wave, ratio, lag, steady in rows:
        print(f"{kind:9s} {f'{speed:4d} km/h' if speed else '  any v  '}, wave {1e3 * wave:5.1f} mm = {wave / length:4.1f} patches: force {ratio:.3f} of steady rolling ({steady:6.0f} N), "
              f"lags by {lag:6.1f} degrees")
    if options.picture:
        draw(length, rows, options.picture)


if __name__ == "__main__":
    main()
