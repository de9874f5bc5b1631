"""The source paper's tables and figures from Python: the same numbers as from C."""
import pathlib
import re

from wrc import paper

ROOT = pathlib.Path(__file__).parents[3]


def table(text):
    """{(case's power in CONTACT, model, bound): power}; the two programs name cases differently."""
    found, case, rows = {}, None, []
    for line in text.splitlines():
        row = re.search(r"(\S+(?: \S+)*?) +(parabola|pressure) +(.*)", line.split("  ", 1)[1] if line.startswith("Case") else line)
        if row is None:
            continue
        model, bound, numbers = row[1].strip(), row[2], re.findall(r"(?<= )-?\d+\.\d\d(?= |$)", line)
        model = re.sub(r"^.*  ", "", model)
        if model == "CONTACT":
            case = next(each for each in numbers if float(each) in (68.68, 30.60, 19.10, 10.31, 6.04))
            found.update({(case, name, limit): power for name, limit, power in rows})
            rows = []
        else:
            rows.append((model.replace("exact (wrc)", "wrc, exact"), bound, line))
    return found


def power(line):
    """Behind Mz, the first number with two decimals."""
    return re.search(r"-?\d+ +-?\d+ +-?\d+\.\d +(\d+\.\d\d)", line)[1]


def test_tables_and_figures(tmp_path, capsys):
    paper.main([str(tmp_path), "--formats", "png", "--dpi", "60"])
    told = capsys.readouterr().out
    from_python, from_c = table(told), table((ROOT / "tests/examples/paper_cases.txt").read_text())
    both = from_python.keys() & from_c.keys()
    assert len(both) >= 5 * 7
    assert all(abs(float(power(from_python[each])) - float(power(from_c[each]))) < 0.011 for each in both)
    names = {each.stem for each in tmp_path.glob("*.png")}
    assert names >= {"figure_1", "figure_3", "figure_4", "figure_7", "figure_8", "ekp_readings"}
    assert names >= {f"figure_{number}_{bound}" for number in (2, 5, 6, 9) for bound in ("parabola", "pressure")}
    readings = dict(re.findall(r"^(.{60})(.*)$", told[told.index("Readings of EKP"):], re.M))
    peak = {name.strip(): int(numbers.split()[3]) for name, numbers in readings.items() if "0.2" in numbers}
    assert peak["strip length (wrc's EKP)"] == 604 and peak["exact (wrc)"] == 860
    assert "load factor of 300 MPa is 1.2" in told and "0.905 mu N" in told


def test_hertz():
    """Of a circle: p0 = 2 E* d / (pi a), a^2 = d / (2 A)."""
    import numpy as np
    found = paper.hertz_peak(np.array([1.0]), np.array([1.0 + 1e-6]), 1e-5)[0]
    assert abs(found / (2 * 80e9 / 0.75 * 1e-5 / (np.pi * np.sqrt(0.5e-5))) - 1) < 1e-4
