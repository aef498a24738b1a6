"""Runs every program of the benchmark in turn, several rounds, keeps the best time of each, and writes the results."""

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import results

ROOT = Path(__file__).resolve().parent.parent
PLACE = ROOT / "target" / "bench"
PEERS = ROOT / "bench" / "peers"
OURS = [str(ROOT / "target/release/examples/bench")]
COMMAND = str(ROOT / "target/release/holdup")
PYTHON = sys.executable
CONTROL = [PYTHON, str(PEERS / "python_control.py")]
SCIPY = [PYTHON, str(PEERS / "scipy_numba.py")]
LOOP = [str(PLACE / "loop")]
LOOP_STEPS = (600, 1200, 2400, 4800, 9600, 12000, 19200)
# Why a target is missed, where something is known about it: (work, against) → sentence. To be kept true by hand.
LAYERS = ("the layers of the filter are carried exactly from dead time to dead time; each waits for the one before: by a "
          "profile two fifths of the time is that, a tenth each squares, the sign of the error and bringing eight segments together; with "
          "points, half is their evaluation and a fifth memory")
LANES = ("eight processes to a vector; by a profile a quarter each is integrals of squares, the states, and the sign of the error; a "
         "twentieth segments whose roots are not proven at once")
BUSY = "a processor shared with others: the same run took up to 1.8 times its least time within minutes"
REASONS = {
    ("W1", "python-control, 20 001 points"): LAYERS,
    ("W1", "python-control, metrics only"): LAYERS,
    ("W1", "crate differential-equations"): LAYERS,
    ("W1", "C, fourth order, equal accuracy"): LAYERS,
    ("W1", "C, Euler at 0.01 s, 20 001 points"): LAYERS,
    ("W2", "python-control"): "one loop takes the lanes of thirty-two",
    ("W3", "python-control"): LANES,
    ("W3", "time a process"): LANES,
    ("W4", "python-control"): "as the time of a controller, below",
    ("W4", "time a controller"): "by a profile three fifths is arithmetic, most of it the peak and its proof; the rest reading controllers and writing results",
    ("W5", "curve_fit"): "holdup weighs all dead times to 2000 s, curve_fit polishes a start that is near; a dozen passes over the rows take "
                          "about the same each, most of them held up by memory",
    ("W3", "two cores against one, on the wall"): BUSY,
    ("W4", "two cores against one, on the wall"): BUSY,
}


class Results(dict):
    """Best of all rounds: (program, what, size) → seconds and values."""

    def run(self, name, command):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode != 0:
            print(f"  {name}: {done.stderr.strip()[-300:]}", file=sys.stderr)
        for line in done.stdout.splitlines():
            row = json.loads(line)
            key = (name, row["what"], row.get("size", row.get("steps")))
            if isinstance(row["values"], dict):
                key += (row["values"].get("threads"),)
            if key not in self or row["seconds"] < self[key]["seconds"]:
                self[key] = row


def record():
    """A tank whose valve moves at random every twenty rows: 10 000 rows, one a second, dead time 7.3 s."""
    random = np.random.default_rng(1)
    rows, gain, dead_time = 10_000, 5e-4, 7.3
    time_ = np.arange(rows, dtype=float)
    moves = random.random(rows) < 0.05
    valve = np.where(moves, random.uniform(40, 60, rows), np.nan)
    valve[0] = 50.0
    valve = valve[np.maximum.accumulate(np.where(np.isnan(valve), 0, np.arange(rows)))]
    integral = np.concatenate([[0.0], np.cumsum(valve[:-1] - 50.0)])
    level = 40 + gain * np.interp(time_ - dead_time, time_, integral) + random.uniform(-0.05, 0.05, rows)
    file = PLACE / "record.csv"
    rows = zip(time_.tolist(), level.tolist(), valve.tolist())
    file.write_text("time,level,valve\n" + "".join(f"{t!r},{y!r},{u!r}\n" for t, y, u in rows))
    return file


def memory(samples):
    """`holdup robust` with so many random processes: time on the wall [s] and greatest memory [MiB]."""
    command = [COMMAND, "robust", "-p", "K=0.0506,d=6", "-c", "Kc=2.95,Ti=15,Td=3,Tf=0.03", "--setpoint", "0:1",
               "--load", "100:1", "--horizon", "200", "--samples", str(samples), "--json"]
    start = time.perf_counter()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    error = child.stderr.read().decode()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        print(f"  robust: {error.strip()[-300:]}", file=sys.stderr)
        return None
    return {"samples": samples, "wall": time.perf_counter() - start, "mib": usage.ru_maxrss / 1024,
            "processor": usage.ru_utime + usage.ru_stime}


def reference():
    """The integrals of W1 by Richardson's extrapolation of the fourth-order loop in 80-bit numbers."""
    fine, finer, finest = (
        json.loads(subprocess.run([str(PLACE / "loop-reference"), "value", str(n)], capture_output=True,
                                  text=True, check=True).stdout, parse_float=np.longdouble)["values"]
        for n in (12000, 24000, 48000))
    values = [float(b + (b - a) / 15) for a, b in zip(finer, finest)]
    before = [float(b + (b - a) / 15) for a, b in zip(fine, finer)]
    return {"values": values, "uncertainty": max(abs(a / b - 1) for a, b in zip(before, values))}


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--quick", action="store_true", help="one round, a tenth of the loops")
    options.add_argument("--full", action="store_true", help="Monte Carlo of 10 million runs, five rounds")
    options = options.parse_args()
    rounds = 1 if options.quick else 5 if options.full else 3
    share = 10 if options.quick else 1
    processes, controllers = 100_000 // share, 1_000_000 // share
    found, file, load = Results(), record(), [os.getloadavg()[0]]
    found["reference"] = reference()
    found.run("reference", [*SCIPY, "reference"])
    for number in range(rounds):
        print(f"round {number + 1} of {rounds}", flush=True)
        found.run("ours", [*OURS, "single"])
        for steps in LOOP_STEPS:
            found.run("c", [*LOOP, "time", steps, 200, 100])
        found.run("c-euler", [*LOOP, "euler"])
        found.run("ours", [*OURS, "single"])
        found.run("numba", [*SCIPY, "numba"])
        found.run("ours", [*OURS, "identify", file])
        found.run("scipy", [*SCIPY, "identify", file])
        found.run("ours", [*OURS, "horizon"])
        found.run("crate", [*OURS, "crate"])
        found.run("control", [*CONTROL, "single"])
        load.append(os.getloadavg()[0])
    order = results.best_pade(found)
    found.run("control", [*CONTROL, "processes", order])
    found.run("control", [*CONTROL, "controllers", results.margins_pade(found)])
    found.run("scipy", [*SCIPY, "steps"])
    for dead_times in (10, 30, 100, 300, 1000, 3000):
        found.run(f"c-horizon-{dead_times}", [*LOOP, "time", 1200, 6 * dead_times, 3 * dead_times])
    for count in (100, 1000, 10_000):
        found.run("ours", [*OURS, "processes", count, 1])
    for _ in range(min(rounds, 2)):
        for threads in (1, 2):
            found.run("ours", [*OURS, "processes", processes, threads])
            found.run("ours", [*OURS, "controllers", controllers, threads])
    counts = (100_000,) if options.quick else (10_000, 1_000_000, 10_000_000) if options.full else (10_000, 1_000_000)
    found["memory"] = [m for m in map(memory, counts) if m]
    load.append(os.getloadavg()[0])
    found["load"] = load
    found["how"] = "One round with a tenth of the loops (--quick)" if options.quick else f"Best of {rounds} rounds"
    results.write(found, ROOT / "bench", REASONS)


if __name__ == "__main__":
    main()
