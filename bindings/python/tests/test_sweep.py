"""The sweep on a local cluster: bits, a worker that is killed, a run that is stopped and resumed."""
import os
import pathlib
import signal
import sys

import pytest

SCRIPT = pathlib.Path(__file__).parents[1] / "examples" / "sweep" / "sweep.py"
COUNT, CHUNK = 480, 40


@pytest.fixture(scope="module")
def sweep():
    pytest.importorskip("distributed")
    sys.path.insert(0, str(SCRIPT.parent))  # the workers' too
    import sweep as module

    return module


def test_grid(sweep):
    import numpy as np

    whole = sweep.inputs_of(0, 10 ** 6, 10 ** 6)
    number = 0
    for name, values in sweep.AXES.items():
        number = number * len(values) + np.searchsorted(values, whole[name])
    assert len(np.unique(number)) == 10 ** 6
    part = sweep.inputs_of(500, 600, 1000)
    assert (part["lateral"] == whole["lateral"][500_000:600_000:1000]).all()


def test_workers_kills_and_resuming_leave_the_bits(sweep, tmp_path, capfd):
    from dask.distributed import Client

    assert sweep.run(tmp_path / "serial", COUNT, CHUNK) == 12
    expected = sweep.bits(tmp_path / "serial")
    with sweep.cluster(2) as cluster, Client(cluster) as client:
        client.wait_for_workers(2)

        def kill(done):
            if done == 2:
                os.kill(next(iter(cluster.workers.values())).process.process.pid, signal.SIGKILL)

        assert sweep.run(tmp_path / "killed", COUNT, CHUNK, client, kill) == 12
        assert sweep.bits(tmp_path / "killed") == expected

        def stop(done):
            if done == 3:
                raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            sweep.run(tmp_path / "stopped", COUNT, CHUNK, client, stop)
        (tmp_path / "stopped" / "part-000000360.parquet.part").write_text("half of a file")
        there = len(list((tmp_path / "stopped").glob("*.parquet")))
        assert 3 <= there < 12
        assert sweep.run(tmp_path / "stopped", COUNT, CHUNK, client) == 12 - there
        assert sweep.bits(tmp_path / "stopped") == expected and "chunks are there already" in capfd.readouterr().out
    with pytest.raises(SystemExit, match="of another study"):
        sweep.run(tmp_path / "serial", COUNT, 2 * CHUNK)
    table = sweep.pyarrow.parquet.read_table(tmp_path / "serial")
    assert table.num_rows == COUNT and table["index"].to_pylist() == list(range(COUNT))
    assert min(table["status"].to_pylist()) >= 0
