"""A parameter study over poses, loads and creepages with dask.distributed, 10^6 planar steps as one program.

    sweep.py FOLDER [--count 1000000] [--chunk 10000] [--workers 2 | --address tcp://HOST:8786]
    sweep.py FOLDER --compare [--count 100000]      serially, on one worker, on two: times, speed-up, overhead, bits

Without an address it makes a cluster on this machine, of one process a worker. Every chunk is a Parquet file in FOLDER as
soon as it is solved, written by this program: workers need nothing but the wrc package. Called again it goes on where it
stopped; what a worker that dies was doing is done by another. The numbers are the same bits however it ran: the last line is
their hash."""
import argparse
import hashlib
import json
import os
import pathlib
import sys
import time

import numpy as np
import pyarrow
import pyarrow.parquet

MODEL = {"wheel": "S1002", "rail": "UIC60_BENCHMARK"}
AXES = {  # of the grid; all their products are 10^6
    "lateral": np.linspace(-6e-3, 6e-3, 50), "load": np.linspace(40e3, 120e3, 5), "longitudinal": np.linspace(-5e-3, 5e-3, 20),
    "lateral_creepage": np.linspace(-5e-3, 5e-3, 20), "spin": np.linspace(-1.0, 1.0, 10)}
FRICTION = 0.35


def inputs_of(start, stop, count):
    """Columns of elements start..stop of a study of `count`, which takes every so many of the grid's points."""
    index = np.arange(start, stop, dtype=np.int64)
    rest = index * int(np.prod([len(each) for each in AXES.values()])) // count
    columns = {"index": index}
    for name, values in AXES.items():
        rest, here = np.divmod(rest, len(values))
        columns[name] = values[here]
    return columns


def solve(told, start, stop, count):
    """What a worker does: the columns of a chunk, inputs and results."""
    import wrc
    columns = inputs_of(start, stop, count)
    inputs = wrc.PlanarInput.array(stop - start, like=wrc.PlanarInput(friction={"coefficient": FRICTION}))
    inputs["pose"]["lateral"], inputs["load"]["normal_force"] = columns["lateral"], columns["load"]
    creepage = inputs["creepage"]
    creepage["longitudinal"], creepage["lateral"], creepage["spin"] = (columns[name] for name in ("longitudinal", "lateral_creepage", "spin"))
    out, statuses = wrc.sweep(wrc.Model.shared(**json.loads(told)), inputs)
    columns.update({name: out["forces"][name].copy() for name in ("fx", "fy", "mz", "power")})
    columns.update({name: out["normal"][name].copy() for name in ("peak_pressure", "area", "approach")})
    return {**columns, "status": statuses}


def write(path, columns, study):
    table = pyarrow.table(columns).replace_schema_metadata({"study": study})
    pyarrow.parquet.write_table(table, f"{path}.part")
    os.replace(f"{path}.part", path)  # whole or not at all


def run(folder, count, chunk, client=None, on_part=None):
    """Solves what is not there yet, serially without a client; the number of chunks solved."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    told = json.dumps(MODEL)
    study = json.dumps({"model": MODEL, "friction": FRICTION, "count": count, "chunk": chunk,
                        "axes": hashlib.sha256(b"".join(each.tobytes() for each in AXES.values())).hexdigest()})
    paths = {start: folder / f"part-{start:09d}.parquet" for start in range(0, count, chunk)}
    for each in folder.glob("part-*.parquet"):
        if pyarrow.parquet.read_schema(each).metadata.get(b"study", b"").decode() != study:
            sys.exit(f"{each} is of another study: choose another folder, or remove it")
    todo = [start for start, path in paths.items() if not path.exists()]
    if len(todo) < len(paths):
        print(f"{len(paths) - len(todo)} of {len(paths)} chunks are there already")
    began, done = time.perf_counter(), 0

    def finish(start, columns):
        nonlocal done
        write(paths[start], columns, study)
        done += 1
        took = time.perf_counter() - began
        print(f"\r{done} of {len(todo)} chunks, {done * chunk / took:.0f} steps per second, {took * (len(todo) - done) / done:.0f} s left ",
              end="", file=sys.stderr, flush=True)
        if on_part:
            on_part(done)

    def task(start):
        return told, start, min(start + chunk, count), count

    if client is None:
        for start in todo:
            finish(start, solve(*task(start)))
    else:
        from dask.distributed import as_completed
        ahead = 3 * max(1, sum(client.nthreads().values()))  # chunks under way: what is not written yet fits into memory
        waiting, starts = iter(todo), {}

        def submit():
            start = next(waiting, None)
            if start is not None:
                future = client.submit(solve, *task(start), pure=False, retries=3)
                starts[future] = start
                return future

        under_way = as_completed([each for each in (submit() for _ in range(ahead)) if each is not None])
        try:
            for future in under_way:
                finish(starts.pop(future), future.result())
                following = submit()
                if following is not None:
                    under_way.add(following)
        finally:
            client.cancel(list(starts))
    print(file=sys.stderr)
    return len(todo)


def bits(folder):
    """Hash of every number, in the order of the study."""
    found = hashlib.sha256()
    for each in sorted(pathlib.Path(folder).glob("part-*.parquet")):
        for column in pyarrow.parquet.read_table(each).itercolumns():
            found.update(column.to_numpy().tobytes())
    return found.hexdigest()[:16]


def cluster(workers):
    from dask.distributed import LocalCluster
    return LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address="127.0.0.1:0")


def compare(folder, count, chunk):
    """Times of a serial run, one worker and two."""
    from dask.distributed import Client
    folder = pathlib.Path(folder)
    times, hashes = {}, set()
    for workers in (0, 1, 2):
        part = folder / f"workers_{workers}"
        if list(part.glob("part-*")):
            sys.exit(f"{part} has results: a comparison begins with an empty folder")
        if workers:
            with cluster(workers) as local, Client(local) as client:
                client.wait_for_workers(workers)
                start = time.perf_counter()
                run(part, count, chunk, client)
                times[workers] = time.perf_counter() - start
        else:
            start = time.perf_counter()
            run(part, count, chunk)
            times[0] = time.perf_counter() - start
        hashes.add(bits(part))
    print(f"{count} steps in chunks of {chunk}: serial {times[0]:.2f} s; one worker {times[1]:.2f} s, overhead {100 * (times[1] / times[0] - 1):.1f} %; "
          f"two workers {times[2]:.2f} s, speed-up over one {times[1] / times[2]:.2f}, over serial {times[0] / times[2]:.2f}")
    print("bits", "the same:" if len(hashes) == 1 else "DIFFER:", *hashes)
    return len(hashes) == 1


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder")
    arguments.add_argument("--count", type=int, default=1_000_000)
    arguments.add_argument("--chunk", type=int, default=10_000)
    arguments.add_argument("--workers", type=int, default=os.cpu_count())
    arguments.add_argument("--address")
    arguments.add_argument("--compare", action="store_true")
    options = arguments.parse_args()
    if options.compare:
        return 0 if compare(options.folder, options.count, options.chunk) else 1
    from dask.distributed import Client
    local = None if options.address else cluster(options.workers)
    with Client(options.address or local) as client:
        run(options.folder, options.count, options.chunk, client)
    if local:
        local.close()
    print("bits", bits(options.folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
