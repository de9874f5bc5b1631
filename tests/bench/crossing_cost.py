#!/usr/bin/env python3
"""Instructions of calls along a crossing, over those on a plain rail: the rail of its first section, held constant.

    crossing_cost.py WRC_COMPARE FILE [--y MM,MM] [--step MM] [--setting NAME[,NAME]] [--list]

WRC_COMPARE is the program, FILE as of its kind `track` (tests/data/README.md). Each call of `wrc_compare cost` is counted
by valgrind. Cold calls are `step` apart; calls from the mark are those of a host's run in steps of 1 ms at 80 km/h. Ways: load
or height given. Ratios are over the mean of the plain rail at the same y, in the same way: mean, median, largest with its
place. --list: each call. Exit status 77 (skipped) without valgrind.
"""
import argparse
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path


def counted(arguments, setting):
    """(rail, way, line's y, distance, instructions) of each call, in their order."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out"
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--toggle-collect=measured_steps", "--dump-after=measured_steps",
             f"--callgrind-out-file={out}", arguments.program, "cost", arguments.file, "--setting", setting, "--y",
             arguments.y, "--step", arguments.step], check=True, capture_output=True, text=True)
        calls = re.findall(r"^call (\w+), (\w+, \w+), y (\S+) mm, at (\S+) mm:", run.stdout, re.MULTILINE)
        counts = []
        for number in range(1, len(calls) + 1):
            text = Path(f"{out}.{number}").read_text(encoding="ascii")
            counts.append(int(re.search(r"^(?:totals|summary): (\d+)", text, re.MULTILINE).group(1)))
    return [(rail, way, float(y), float(at), count) for (rail, way, y, at), count in zip(calls, counts)]


def report(calls, setting, listed):
    print(f"{setting}\n{'call':14} {'plain':>11} {'crossing':>11} {'ratio':>6} {'median':>7} {'worst':>6}  at")
    for way in dict.fromkeys(call[1] for call in calls):
        own = [call for call in calls if call[1] == way]
        plain = [count for rail, _, _, _, count in own if rail == "constant"]
        crossing = [call for call in own if call[0] == "sections"]
        mean = statistics.mean(plain)
        ratios = [call[4] / mean for call in crossing]
        worst = crossing[max(range(len(ratios)), key=ratios.__getitem__)]
        print(f"{way:14} {mean:11.0f} {mean * statistics.mean(ratios):11.0f} {statistics.mean(ratios):6.2f} "
              f"{statistics.median(ratios):7.2f} {max(ratios):6.1f}  y {worst[2]:.1f}, {worst[3]:.0f} mm")
        if listed:
            for call, ratio in zip(crossing, ratios):
                print(f"    y {call[2]:6.2f} mm, at {call[3]:7.2f} mm: {call[4]:9} {ratio:6.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("file")
    parser.add_argument("--y", default="-4,0,3")
    parser.add_argument("--step", default="13")
    parser.add_argument("--setting", default="default,real time")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    if shutil.which("valgrind") is None:
        print("skipped: there is no valgrind")
        sys.exit(77)
    for setting in arguments.setting.split(","):
        report(counted(arguments, setting), setting, arguments.list)


main()
