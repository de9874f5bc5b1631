"""What a call costs from Python beyond C: in a loop over contacts, and in a batch. Run from an installed wheel:

    overhead.py        prints microseconds per call and the share in a batch; the C side is loop.c, compiled by cc

The loop is over wheels that are lifted, whose calls take C three microseconds, so that the difference is no difference of
large numbers; the batch is of wheels on rails. Both sides alternate, and the least of many counts."""
import ctypes
import pathlib
import subprocess
import tempfile
import time

import wrc

CONTACTS, REPEATS, ROUNDS = 16, 30, 25


def c_side():
    source = pathlib.Path(__file__).with_name("loop.c")
    library = pathlib.Path(tempfile.mkdtemp()) / "loop.so"
    subprocess.run(["cc", "-O2", "-shared", "-fPIC", source, "-o", library], check=True)
    loaded = ctypes.CDLL(str(library))
    loaded.loop_seconds.restype = loaded.batch_seconds.restype = ctypes.c_double
    return loaded


def address(function):
    return ctypes.cast(function, ctypes.c_void_p)


def loop_overhead(loaded):
    """Microseconds per call of contact.wrench(input): {way: (Python, C)}."""
    model = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK")
    contacts = [model.contact() for _ in range(CONTACTS)]
    handles = (ctypes.c_void_p * CONTACTS)(*[each._handle for each in contacts])
    data = wrc.WheelInput(wheel={"z": -0.2})
    out = wrc.Wrench()
    wheel = data.wheel

    def fresh():
        for contact in contacts:
            contact.wrench(data)

    def reused():
        for contact in contacts:
            contact.wrench(data, out=out)

    def moved():
        for contact in contacts:
            wheel.y, wheel.z, wheel.roll, wheel.yaw = 1e-3, -0.2, 1e-3, 1e-4
            contact.wrench(data, out=out)

    found = {}
    for name, work in (("a new result each", fresh), ("result reused", reused), ("four numbers set, result reused", moved)):
        python, c = [], []
        for _ in range(ROUNDS):
            start = time.thread_time()
            for _ in range(REPEATS):
                work()
            python.append(time.thread_time() - start)
            c.append(loaded.loop_seconds(address(wrc.raw.wrc_contact_wrench), handles, CONTACTS, ctypes.byref(data), ctypes.byref(out), REPEATS))
        calls = 1e-6 * CONTACTS * REPEATS
        found[name] = (min(python) / calls, min(c) / calls)
    return found


def batch_overhead(loaded):
    """Microseconds of Batch.wrench() over 16 wheels on rails, Python and C."""
    model = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK")
    batch = wrc.Batch([model.contact() for _ in range(CONTACTS)])
    inputs, out = wrc.WheelInput.array(CONTACTS), wrc.Wrench.array(CONTACTS)
    inputs["wheel"]["z"] = 2.5e-4
    inputs["wheel"]["velocity"][:, 0], inputs["wheel"]["pitch_rate"] = 40.0, -40.0 / 0.46
    python, c = [], []
    for _ in range(ROUNDS):
        start = time.thread_time()
        batch.wrench(inputs, out)
        python.append(time.thread_time() - start)
        c.append(loaded.batch_seconds(address(wrc.raw.wrc_contact_wrench_batch), batch._handles, CONTACTS, ctypes.c_void_p(inputs.ctypes.data),
                                      ctypes.c_uint64(inputs.strides[0]), ctypes.c_void_p(out.ctypes.data), ctypes.c_uint64(out.strides[0]),
                                      ctypes.c_void_p(batch.statuses.ctypes.data), 1))
    return 1e6 * min(python), 1e6 * min(c)


def batch_dispatch(loaded):
    """The same over wheels that are lifted: microseconds that a batch call costs Python beyond C."""
    model = wrc.Model(wheel="S1002", rail="UIC60_BENCHMARK")
    batch = wrc.Batch([model.contact() for _ in range(CONTACTS)])
    inputs, out = wrc.WheelInput.array(CONTACTS, like=wrc.WheelInput(wheel={"z": -0.2})), wrc.Wrench.array(CONTACTS)
    python, c = [], []
    for _ in range(ROUNDS * REPEATS):
        start = time.thread_time()
        batch.wrench(inputs, out)
        python.append(time.thread_time() - start)
        c.append(loaded.batch_seconds(address(wrc.raw.wrc_contact_wrench_batch), batch._handles, CONTACTS, ctypes.c_void_p(inputs.ctypes.data),
                                      ctypes.c_uint64(inputs.strides[0]), ctypes.c_void_p(out.ctypes.data), ctypes.c_uint64(out.strides[0]),
                                      ctypes.c_void_p(batch.statuses.ctypes.data), 1))
    return 1e6 * (min(python) - min(c))


def main():
    loaded = c_side()
    for name, (python, c) in loop_overhead(loaded).items():
        print(f"loop over contacts, {name}: Python {python:.2f} us, C {c:.2f} us, {python - c:.2f} us beyond C per call")
    python, c = batch_overhead(loaded)
    beyond = batch_dispatch(loaded)
    print(f"batch of {CONTACTS} wheels: Python {python:.1f} us, C {c:.1f} us; a call costs {beyond:.1f} us beyond C, {100 * beyond / c:.2f} %")


if __name__ == "__main__":
    main()
