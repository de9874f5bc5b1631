"""A wheel over a network of curves: one that stops and goes on with two workers ends at the bytes of one in one go."""
import pathlib
import sys

import pytest

SCRIPT = pathlib.Path(__file__).parents[1] / "examples" / "wear" / "wear.py"


def test_workers_and_resuming_leave_the_bytes(tmp_path, monkeypatch, capfd):
    pytest.importorskip("distributed")
    from dask.distributed import Client, LocalCluster

    monkeypatch.syspath_prepend(str(SCRIPT.parent))  # the workers' too
    import wear

    whole, parts = tmp_path / "whole", tmp_path / "parts"
    updates = wear.run(whole, 10e3, 28)
    assert updates >= 2
    take_off, calls = wear.worn, []

    def stop_at_second(*given):
        calls.append(given)
        if len(calls) == 2:
            raise KeyboardInterrupt
        return take_off(*given)

    monkeypatch.setattr(wear, "worn", stop_at_second)
    with pytest.raises(KeyboardInterrupt):
        wear.run(parts, 10e3, 28)
    monkeypatch.setattr(wear, "worn", take_off)
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster, Client(cluster) as client:
        assert wear.run(parts, 10e3, 28, client) == updates - 1
    assert "going on from" in capfd.readouterr().out
    names = sorted(each.name for each in whole.iterdir())
    assert names == sorted(each.name for each in parts.iterdir()) and "profile_010000.csv" in names
    for name in names:
        if name.endswith(".csv"):
            assert (whole / name).read_bytes() == (parts / name).read_bytes(), name
    rows = (whole / "wheel_wear.csv").read_text().split()[1:]
    assert rows[-1].startswith("10000.0,") and all(row.endswith(",0") for row in rows)  # none left out
    heights = [float(row.split(",")[2]) for row in rows]
    assert heights == sorted(heights) and heights[-1] > heights[0] + 1e-3  # the tread is worn
    with pytest.raises(SystemExit, match="of 28 curves"):
        wear.run(whole, 20e3, 20)
