"""What a call costs beyond C: overhead.py prints more."""
import shutil

import pytest

import overhead


@pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler for the C side")
def test_overhead():
    loaded = overhead.c_side()
    for name, (python, c) in overhead.loop_overhead(loaded).items():
        assert 0.0 < python - c < 3.0, name  # us
    assert overhead.batch_dispatch(loaded) < 0.02 * overhead.batch_overhead(loaded)[1]
