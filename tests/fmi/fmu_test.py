"""The FMUs in fmpy: valid, beside the C example's motion, the same bits on every run and after restoring, derivatives.

    fmu_test.py FOLDER_OF_FMUS free_wheelset PROFILE_FOLDER make_fmu.py"""
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

import numpy
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu

folder, free_wheelset, profiles, make_fmu = map(pathlib.Path, sys.argv[1:5])
scratch = pathlib.Path(tempfile.mkdtemp())
checks = 0


def check(holds, what):
    global checks
    checks += 1
    if not holds:
        sys.exit(f"WRONG: {what}")


class Fmu:
    """One instance by variables' names, of either version of FMI."""

    def __init__(self, file, start={}):
        self.described = read_model_description(str(file))
        self.three = self.described.fmiVersion.startswith("3")
        self.numbers = {each.name: each.valueReference for each in self.described.modelVariables}
        exchange = self.described.modelExchange is not None
        kind = {(False, True): FMU2Model, (False, False): FMU2Slave, (True, True): FMU3Model, (True, False): FMU3Slave}
        identifier = (self.described.modelExchange or self.described.coSimulation).modelIdentifier
        self.fmu = kind[self.three, exchange](guid=self.described.guid, unzipDirectory=extract(str(file)),
                                              modelIdentifier=identifier, instanceName=identifier)
        self.fmu.instantiate()
        for name, value in start.items():
            self.set(name, value)
        if not self.three:
            self.fmu.setupExperiment(startTime=0.0)
        self.time = 0.0
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def set(self, name, value):
        number = [self.numbers[name]]
        if number[0] >= 1000:
            (self.fmu.setInt32 if self.three else self.fmu.setInteger)(number, [value])
        else:
            (self.fmu.setFloat64 if self.three else self.fmu.setReal)(number, [value])

    def get(self, *names):
        get = self.fmu.getFloat64 if self.three else self.fmu.getReal
        return [float(each) for each in get([self.numbers[name] for name in names])]

    def slopes(self, unknowns, known):
        numbers = [self.numbers[name] for name in unknowns], [self.numbers[known]]
        return list(self.fmu.getDirectionalDerivative(numbers[0], numbers[1], [1.0]))

    def step(self, length):
        self.fmu.doStep(self.time, length)
        self.time += length

    def save(self):
        return (self.fmu.getFMUState if self.three else self.fmu.getFMUstate)(), self.time

    def restore(self, saved):
        (self.fmu.setFMUState if self.three else self.fmu.setFMUstate)(saved[0])
        self.time = saved[1]

    def to_bytes(self, state):
        return self.fmu.serializeFMUState(state) if self.three else self.fmu.serializeFMUstate(state)

    def from_bytes(self, data):
        return self.fmu.deserializeFMUState(data) if self.three else self.fmu.deSerializeFMUstate(data)


every = sorted(folder.glob("*.fmu"))
check(len(every) == 4, f"four FMUs in {folder}")
for each in every:
    problems = validate_fmu(str(each))
    check(not problems, f"{each.name}: {problems}")

# --- co-simulation beside the C example, whose scheme is of first order
printed = subprocess.run([free_wheelset, "0.5"], check=True, capture_output=True, text=True).stdout
rows = [line.split() for line in printed.splitlines() if re.match(r"\s*\d", line)]
check(len(rows) > 20, "the C example's rows")
STEP, SPEED = 2e-4, 5.0
# it prints every so many steps
every_so_many = next(k for k in range(1, 100) if all(f"{SPEED * STEP * (k * i):.2f}" == row[0] for i, row in enumerate(rows)))
OUTPUTS = ("y", "z", "roll", "yaw", "y_rate", "z_rate", "roll_rate", "yaw_rate", "pitch_rate", "right_fy", "right_fz", "left_fy",
           "left_fz", "power")


def run(instance, count, length=STEP):
    for _ in range(count):
        instance.step(length)
    return instance.get(*OUTPUTS)


for version in (2, 3):
    file = folder / f"wrc_wheelset_fmi{version}.fmu"
    instance, again = (Fmu(file, {"start_y": 1e-3}) for _ in range(2))
    for i, row in enumerate(rows):
        run(instance, every_so_many if i else 0)
        y, yaw = instance.get("y", "yaw")
        check(abs(1e3 * y - float(row[1])) < 5e-3 and abs(1e3 * yaw - float(row[2])) < 2e-3,
              f"x = {row[0]}: C {row[1:]}, FMU {1e3 * y} mm, {1e3 * yaw} mrad")
    check(run(again, (len(rows) - 1) * every_so_many) == instance.get(*OUTPUTS), "the same run has other bits")
    # restored in the same instance, and in another one from bytes
    state = again.save()
    data = again.to_bytes(state[0])
    later = run(again, 50)
    again.restore(state)
    check(run(again, 50) == later, "other bits after restoring")
    fresh = Fmu(file)
    fresh.restore((fresh.from_bytes(data), state[1]))
    check(run(fresh, 50) == later, "other bits in another instance")
    ten = Fmu(file, {"start_y": 1e-3, "step": STEP})
    one = Fmu(file, {"start_y": 1e-3, "step": STEP})
    check(run(ten, 5, 10 * STEP) == run(one, 50), "ten inner steps are not ten outer ones")
    # a force to the right moves it there
    ten.set("force_y", 5e3)
    check(run(ten, 5, 1e-3)[0] > run(one, 5, 1e-3)[0], "a force to the right")

# --- model exchange: derivatives, against differences of the FMU itself
WRENCH, POSE = ("fx", "fy", "fz", "mx", "my", "mz"), {"y": 1e-3, "z": 2.8e-4, "yaw": 1e-3, "vx": 20.0, "pitch_rate": -20.0 / 0.46}
STEPS = {"y": 1e-7, "z": 1e-8, "roll": 1e-7, "yaw": 1e-6, "vy": 1e-5, "yaw_rate": 1e-5, "rail_z": 1e-8,
         "pitch_rate": 1e-4, "rail_y_slope": 1e-6, "rail_z_slope": 1e-6}
for version in (2, 3):
    wheel = Fmu(folder / f"wrc_wheel_fmi{version}.fmu", {"side": 1})
    for name, value in POSE.items():
        wheel.set(name, value)
    check(wheel.get("fz")[0] < -2e4, "the left wheel carries")
    for name, step in STEPS.items():
        found = wheel.slopes(WRENCH, name)
        value = POSE.get(name, 0.0)
        ends = []
        for end in (value + step, value - step):
            wheel.set(name, end)
            ends.append(numpy.array(wheel.get(*WRENCH)))
        wheel.set(name, value)
        difference = (ends[0] - ends[1]) / (2 * step)
        scale = numpy.abs(difference).max()
        error = numpy.abs(difference - found).max() / scale
        check(error < 1e-3, f"derivative by {name}: {found}, differences {difference}")
        if wheel.three:
            seed = [0.3, -1.0, 0.7, 0.1, -0.2, 0.5]
            unknowns = [wheel.numbers[each] for each in WRENCH]
            adjoint = wheel.fmu.getAdjointDerivative(unknowns, [wheel.numbers[name]], seed, 1)
            check(abs(adjoint[0] - numpy.dot(seed, found)) <= 1e-12 * numpy.abs(found).max(), "adjoint")
    state = wheel.save()
    here = wheel.get(*WRENCH)
    wheel.set("z", 3e-4)
    check(wheel.get(*WRENCH) != here, "z moves")
    wheel.restore(state)
    check(wheel.get(*WRENCH) == here, "a wheel restored")

# --- both through fmpy's own integration
for version in (2, 3):
    signals = numpy.array([(0.0, 2.6e-4, 20.0, -20 / 0.46), (0.1, 3e-4, 20.0, -20 / 0.46)],
                          dtype=[("time", float), ("z", float), ("vx", float), ("pitch_rate", float)])
    result = simulate_fmu(str(folder / f"wrc_wheel_fmi{version}.fmu"), stop_time=0.1, output_interval=0.01, input=signals,
                          output=["fz"], solver="Euler", step_size=0.01)
    check(len(result) == 11 and result["fz"][-1] < result["fz"][0] < 0, f"simulated: {result}")
    result = simulate_fmu(str(folder / f"wrc_wheelset_fmi{version}.fmu"), stop_time=0.02, output_interval=1e-3,
                          start_values={"start_y": 2e-3}, output=["y"])
    check(len(result) == 21 and 1e-3 < result["y"][-1] < 2e-3, f"simulated: {result}")

# --- profiles as resources, and a mistake in one
base = folder / "wrc_wheel_fmi3.fmu"
own = scratch / "own.fmu"


def with_profiles(**files):
    words = [word for body, file in files.items() for word in (f"--{body}", str(file))]
    subprocess.run([sys.executable, str(make_fmu), "profiles", str(base), str(own), *words], check=True)
    return own


wheel_points, rail_points = profiles / "wheel.txt", profiles / "rail.txt"
wheel = Fmu(with_profiles(wheel=wheel_points, rail=rail_points), {"side": 0})
check(not validate_fmu(str(own)), "with profiles it is valid")
built_in = Fmu(base, {"side": 0})
for each in (wheel, built_in):
    for name, value in POSE.items():
        each.set(name, value)
of_points, of_formulas = wheel.get("fz", "peak_pressure"), built_in.get("fz", "peak_pressure")
check(abs(of_points[0] / of_formulas[0] - 1) < 0.02 and of_points != of_formulas, f"points {of_points}, formulas {of_formulas}")
other = scratch / "other.csv"
plain = [line.split() for line in wheel_points.read_text().splitlines() if not line.startswith("#")]
other.write_text("y;z\n" + "".join(f"{y};{z}\n".replace(".", ",") for y, z in plain))
same = Fmu(with_profiles(wheel=other, rail=rail_points), {"side": 0})
for name, value in POSE.items():
    same.set(name, value)
check(same.get("fz", "peak_pressure") == of_points, "decimal commas beside semicolons")
for change, why in ((lambda y, z: f"{y} {z} 0", "3 numbers"), (lambda y, z: f"{float(y) / 1e3} {z}", "over 0.1"), (lambda y, z: f"{y} {z}x", "over 0 mm")):
    other.write_text("".join(change(y, z) + "\n" for y, z in plain))
    said = subprocess.run([sys.executable, str(make_fmu), "profiles", str(base), str(own), "--wheel", str(other)], capture_output=True, text=True)
    check(said.returncode != 0 and why in said.stderr and "Traceback" not in said.stderr, said.stderr)
with_profiles(wheel=wheel_points)
with zipfile.ZipFile(own) as packed:
    files = {name: packed.read(name) for name in packed.namelist()}
files["resources/wheel.txt"] = files["resources/wheel.txt"].replace(b"\n", b"\n1,5 2\n", 1)
with zipfile.ZipFile(own, "w") as packed:
    for name, data in files.items():
        packed.writestr(name, data)
try:
    Fmu(own)
    check(False, "a broken line is refused")
except Exception as refused:  # of fmpy
    check(True, str(refused))
print(f"{checks} checks, fmpy {__import__('fmpy').__version__}")
