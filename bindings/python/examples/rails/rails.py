"""Rails that change along the track, made of sections as an instrument has them, and a wheel that rolls over each.

    rails.py FOLDER        pictures and a table: a crossing, a blade at its stock rail, a frog with flange running, an expansion
                           joint, an insulated joint

Each function gives measured sections: one line from the gauge side to the field side, flangeways in between."""
import sys

import numpy as np
import wrc

SPACING = 5e-4  # of points along a line [m]
GROOVE = 45e-3  # depth of a flangeway [m]


def head(gauge, field, top, corner=12e-3, depth=GROOVE, lean=0.05, field_depth=None):
    """A rail's head between two edges: flanks that lean, elliptic corners twice as wide as high, a crown of 300 mm radius, canted
    1:40 where it is 70 mm wide. `corner` is the height of both corners [m]."""
    angle = np.linspace(0.0, np.pi / 2, 40)
    wide = min(2.0 * corner, 0.45 * (field - gauge))
    y_round, z_round = wide * (1.0 - np.cos(angle)), corner * (1.0 - np.sin(angle))
    across = np.arange(gauge + wide, field - wide, SPACING)[1:]
    down = np.arange(corner + SPACING, depth, SPACING)[::-1]
    right = np.arange(corner + SPACING, depth if field_depth is None else max(field_depth, corner), SPACING)
    y = np.concatenate([gauge - lean * (down - corner), gauge + y_round, across, field - y_round[::-1], field + lean * (right - corner)])
    z = np.concatenate([down, z_round, np.zeros_like(across), z_round[::-1], right])
    from_middle = np.clip(y - gauge - min(35e-3, 0.5 * (field - gauge)), -35e-3, 35e-3)
    crown = from_middle ** 2 / 0.6 - from_middle / 40 * min(1.0, (field - gauge) / 0.07)
    z = z + crown * np.clip(1.0 - z / corner, 0.0, 1.0)
    return y, top + z - z.min()


def joined(*parts):
    """Parts side by side as one line, a round bottom between them."""
    y, z = [parts[0][0]], [parts[0][1]]
    for (y0, z0), (y1, z1) in zip(parts, parts[1:]):
        share = np.linspace(0.0, 1.0, 40)[1:-1]
        y.append(y0[-1] + share * (y1[0] - y0[-1]))
        z.append(z0[-1] + share * (z1[0] - z0[-1]) + 4e-3 * np.sin(np.pi * share))
        y.append(y1), z.append(z1)
    return np.concatenate(y), np.concatenate(z)


def section(distance, *parts):
    return wrc.MeasuredSection(distance, *joined(*parts))


def crossing():
    """A wing rail that leaves sideways 1:10, and a nose that rises from 20 mm below within 60 mm."""
    made = []
    for x in np.r_[np.arange(-0.5, 0.1, 0.05), np.arange(0.1, 0.24, 0.005), np.arange(0.25, 1.0, 0.05)]:
        wing = head(-35e-3 + 0.1 * max(0.0, x + 0.4), 0.035 + 0.1 * (x + 0.5), -1.5e-3, field_depth=10e-3)
        if x < 0.119:
            made.append(section(x, wing))
            continue
        rise = np.clip((x - 0.12) / 0.06, 0.0, 1.0)
        top = 20e-3 * (1.0 - rise) ** 2 + 3e-3 * np.clip(1.0 - (x - 0.18) / 0.3, 0.0, 1.0)
        nose = head(-37e-3 + 2e-3 * rise, -19e-3 + 0.1 * (x - 0.12), top, corner=8e-3, depth=GROOVE - top)
        made.append(section(x, nose, wing))
    return made


def blade():
    """A blade against its stock rail, which leaves sideways 1:55: from 4 to 40 mm wide in 2 m, from 14 mm below to level."""
    made = []
    for x in np.arange(0.0, 2.01, 0.05):
        width = 4e-3 + 18e-3 * x
        top = 14e-3 * max(0.0, 1.0 - x / 1.2) ** 1.5
        stock = head(-34e-3 + width, 36e-3 + width, 0.0, field_depth=15e-3, depth=20e-3, lean=0.02)
        leaf = head(-35e-3, -35e-3 + width, top, corner=min(1.9e-3, 0.4 * width), depth=GROOVE - top, field_depth=20e-3 - top, lean=0.02)
        made.append(section(x, leaf, stock))
    return made


def frog_with_flange_running():
    """A flangeway whose bottom rises 1:20 until the flange's tip, 28 mm below the tread, carries the wheel; the head ends and
    begins again 60 mm on."""
    made = []
    for x in np.arange(-0.6, 0.61, 0.02):
        floor = 26.5e-3 + 0.05 * max(0.0, abs(x) - 0.25)
        running = head(-35e-3, 35e-3, 0.0 if abs(x) >= 0.04 else 29e-3, field_depth=10e-3, depth=GROOVE if abs(x) >= 0.04 else 16e-3)
        parts = [head(-85e-3, -45e-3, floor, corner=3e-3, depth=50e-3 - floor), running] if floor < 30e-3 else [running]
        made.append(section(x, *(part for part in parts if part[1].min() < 28.9e-3)))
    return made


def expansion_joint():
    """Two rails that overlap over 0.8 m: one leaves to the field side as it ends, the other comes from the gauge side."""
    made = []
    for x in np.arange(-0.8, 0.81, 0.025):
        share = np.clip((x + 0.4) / 0.8, 0.0, 1.0)
        edge = -35e-3 + 70e-3 * share  # between both
        parts = []
        if share > 0.15:
            parts.append(head(-35e-3, edge - 1e-3, 0.2e-3 * (1.0 - share), corner=min(10e-3, 0.4 * (edge + 34e-3)), depth=20e-3, lean=0.0))
        if share < 0.85:
            parts.append(head(edge + 1e-3, 35e-3, 0.2e-3 * share, corner=min(10e-3, 0.4 * (34e-3 - edge)), depth=20e-3, lean=0.0))
        y, z = (np.concatenate([part[k] for part in parts]) for k in (0, 1))
        made.append(wrc.MeasuredSection(x, y, z))
    return made


def insulated_joint(gap=6e-3, step=0.5e-3):
    """Two rail ends with a gap between them, the second lower by a step: no section lies in the gap."""
    places = np.r_[-0.6, -0.3, -0.1, -gap / 2, gap / 2, 0.1, 0.3, 0.6]
    return [section(x, head(-35e-3, 35e-3, 0.0 if x < 0.0 else step, field_depth=20e-3)) for x in places]


# sections, and what rail_faces() must be told beside them
RAILS = {"crossing": (crossing, {}), "blade": (blade, {}), "frog": (frog_with_flange_running, {}), "expansion": (expansion_joint, {}),
         "insulated": (insulated_joint, {"interruptions": (0.0,)})}


def model_of(faces, part=None):
    """A wheel S1002 on the faces; the rails' origin is 750 mm from the middle of the track."""
    return wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK", rail_sections=(faces.part(*part) if part else faces).rail_sections,
                     track={"placement": "ORIGIN", "rail_origin": 0.7525})


def rolled(contact, places, load=60e3):
    """Height, normal force, peak pressure, flags under a load, from place to place; NaN where the call fails."""
    found = []
    for x in places:
        data = wrc.WheelInput(prescribed="VERTICAL_LOAD", vertical_load=load, distance=float(x), friction={"coefficient": 0.0})
        try:
            wrench = contact.wrench(data)
            found.append((wrench.z, wrench.normal_force, wrench.peak_pressure, int(wrench.flags)))
        except wrc.Error:
            found.append((np.nan, np.nan, np.nan, -1))
    return np.array(found)


def main(folder):
    for name, (make, options) in RAILS.items():
        faces = wrc.rail_faces(make(), **options)
        print(f"\n{name}: {faces}")
        wrc.plot.rail(faces, path=f"{folder}/{name}.png")
        low, high = min(face.distances[0] for face in faces.faces), max(face.distances[-1] for face in faces.faces)
        places = np.arange(low + 0.05, high - 0.05, 2e-3)
        found = rolled(model_of(faces).contact("RIGHT"), places)
        good = np.isfinite(found[:, 0])
        print(f"  {len(places)} places under 60 kN: {np.sum(~good)} without a result, {np.sum(good & (found[:, 3] != 0))} flagged, height "
              f"{1e3 * np.nanmin(found[:, 0]):.3f} .. {1e3 * np.nanmax(found[:, 0]):.3f} mm, peak pressure up to {1e-6 * np.nanmax(found[:, 2]):.0f} MPa")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
