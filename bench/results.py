"""The table, the list of targets and the text of RESULTS.md from what was measured."""

import math
import platform
import subprocess
from datetime import date

import picture

NAMES = ("IAE", "ISE", "ITAE", "energy")


def error(values, reference):
    """Greatest relative error of the numbers."""
    errors = [abs(a / b - 1) for a, b in zip(values, reference)]
    return math.inf if any(math.isnan(e) for e in errors) else max(errors)


def best_pade(found):
    """The order of Padé approximation whose integrals are nearest to the reference."""
    rows = {k[2]: v for k, v in found.items() if k[:2] == ("control", "points")}
    return min(rows, key=lambda order: error(rows[order]["values"], found["reference"]["values"]))


def margins_pade(found):
    """The lowest order of Padé approximation whose margins are right to 1e-6: no more than is needed."""
    reference = found["reference", "margins", 1]["values"]
    rows = {k[2]: v for k, v in found.items() if k[:2] == ("control", "margins-pade")}
    good = [order for order in sorted(rows) if error(rows[order]["values"], reference) < 1e-6]
    return good[0] if good else max(rows)


def duration(seconds):
    for unit, scale in (("s", 1), ("ms", 1e3), ("µs", 1e6), ("ns", 1e9)):
        if seconds * scale >= 1:
            return f"{seconds * scale:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def ratio(value):
    digits = max(0, 1 - math.floor(math.log10(value))) if value < 10 else 0
    return f"{value:.{digits}f}×" if value < 1000 else f"{float(f'{value:.3g}'):,.0f}×".replace(",", " ")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


class Chosen:
    """The measurements that the targets speak of."""

    def __init__(self, found):
        self.found, self.reference = found, found["reference"]["values"]
        self.metrics, self.points = found["ours", "metrics", 1], found["ours", "points", 1]
        self.margins = found["ours", "margins", 1]
        self.order, self.margin_order = best_pade(found), margins_pade(found)
        self.control = found["control", "points", self.order]
        self.control_margins = found["control", "margins-pade", self.margin_order]
        self.crate = self.nearest("crate", "metrics")
        self.c = self.nearest("c", "metrics")
        self.euler = found["c-euler", "points", 600]

    def nearest(self, program, what):
        """The cheapest setting with an error of at most 1e-9, or the most accurate where none has."""
        rows = [(error(v["values"], self.reference), v["seconds"], k, v) for k, v in self.found.items()
                if k[:2] == (program, what) and v["values"]]
        good = [row for row in rows if row[0] <= 1e-9]
        return min(good, key=lambda row: row[1])[3] if good else min(rows, key=lambda row: row[0])[3]

    def many(self, what, threads=1):
        rows = [(k[2], v) for k, v in self.found.items() if k[:2] == ("ours", what) and k[-1] == threads]
        return max(rows, key=lambda row: row[0])[1]

    def identified(self):
        """curve_fit from the start that found the dead time in the least time; all starts are in the table."""
        rows = [v for k, v in self.found.items() if k[:2] == ("scipy", "identify")]
        good = [v for v in rows if abs(v["values"][1] - 7.3) < 0.5]
        return min(good or rows, key=lambda v: v["seconds"])


def targets(c):
    found = c.found
    rows = []

    def at_least(work, text, value, wanted, note=""):
        rows.append((work, text, ratio(value), f"≥ {ratio(wanted)}", value / wanted, note))

    def at_most(work, text, value, wanted):
        rows.append((work, text, duration(value), f"≤ {duration(wanted)}", wanted / value, ""))

    at_least("W1", "python-control, 20 001 points", c.control["seconds"] / c.points["seconds"], 2000)
    at_least("W1", "python-control, metrics only", c.control["seconds"] / c.metrics["seconds"], 10_000)
    at_least("W1", "crate differential-equations", c.crate["seconds"] / c.metrics["seconds"], 50)
    at_least("W1", "C, fourth order, equal accuracy", c.c["seconds"] / c.metrics["seconds"], 100)
    at_least("W1", "C, Euler at 0.01 s, 20 001 points", c.euler["seconds"] / c.points["seconds"], 1)
    at_least("W2", "python-control", c.control_margins["seconds"] / c.margins["seconds"], 200)
    if ("control", "processes", 20) in found:
        at_least("W3", "python-control", found["control", "processes", 20]["seconds"] / c.many("processes")["seconds"],
                 10_000)
    at_most("W3", "time a process", c.many("processes")["seconds"], 12e-6)
    if ("control", "controllers", 50) in found:
        at_least("W4", "python-control",
                 found["control", "controllers", 50]["seconds"] / c.many("controllers")["seconds"], 30_000)
    at_most("W4", "time a controller", c.many("controllers")["seconds"], 80e-9)
    if ("ours", "identify", 10_000) in found:
        at_least("W5", "curve_fit", c.identified()["seconds"] / found["ours", "identify", 10_000]["seconds"], 150)
    for work, what in (("W3", "processes"), ("W4", "controllers")):
        one, two = (c.many(what, threads)["values"]["wall"] for threads in (1, 2))
        at_least(work, "two cores against one, on the wall", one / two, 1.8)
    return rows


def loop_rows(c):
    """W1: program, setting, time, ratio to ours, error of every integral."""
    labels = {("ours", "metrics"): "holdup, four integrals", ("ours", "all_metrics"): "holdup, all metrics",
              ("ours", "points"): "holdup, 20 001 points",
              ("c", "metrics"): "C, fourth order", ("c", "points"): "C, fourth order, 20 001 points",
              ("c-euler", "metrics"): "C, Euler", ("c-euler", "points"): "C, Euler, 20 001 points",
              ("numba", "points"): "numba, Euler, 20 001 points", ("crate", "metrics"): "crate differential-equations",
              ("scipy", "metrics"): "scipy solve_ivp by steps", ("control", "points"): "python-control, 20 001 points",
              ("control", "points-2001"): "python-control, 2001 points",
              ("control", "shift-register"): "python-control, delay as shift register"}
    setting = {"c": "{} steps a dead time", "c-euler": "h = 0.01 s", "numba": "h = 0.01 s", "crate": "tolerance 1e-{}",
               "scipy": "tolerance 1e-{}", "control": "Padé order {}", "ours": "exact"}
    for key, label in labels.items():
        for k, v in sorted((k, v) for k, v in c.found.items() if isinstance(k, tuple) and k[:2] == key):
            if not v["values"]:
                continue
            errors = [f"{abs(a / b - 1):.0e}" for a, b in zip(v["values"], c.reference)]
            ours = c.points if "points" in k[1] else c.metrics
            how = "0.05 s a sample" if k[1] == "shift-register" else setting[k[0]].format(k[2])
            yield label, how, duration(v["seconds"]), ratio(v["seconds"] / ours["seconds"]), *errors


def margin_rows(c):
    reference = c.found["reference", "margins", 1]["values"]
    labels = {"ours": "holdup", "control": "python-control"}
    for k, v in sorted((k, v) for k, v in c.found.items() if isinstance(k, tuple) and k[0] in labels and "margins" in k[1]):
        how = {("control", "margins-pade"): f"Padé order {k[2]}", ("control", "margins"): f"exact delay, grid of {k[2]}",
               ("ours", "margins"): "exact", ("ours", "margins-all"): "exact, with M_t, all crossovers and warnings"}[k[:2]]
        yield (labels[k[0]], how, duration(v["seconds"]), ratio(v["seconds"] / c.margins["seconds"]),
               f"{error(v['values'], reference):.0e}")


def many_rows(c):
    for what, work in (("processes", "W3 perturbed processes"), ("controllers", "W4 controllers")):
        reference = c.found["reference", what, {"processes": 3, "controllers": 20}[what]]["values"]
        for k, v in sorted(((k, v) for k, v in c.found.items() if isinstance(k, tuple) and k[1] == what and k[0] != "reference"),
                           key=str):
            mine = k[0] == "ours"
            listed = v["values"]["listed"] if mine else v["values"]
            worst = max(error(a, b) for a, b in zip(listed, reference))
            program = f"holdup, {k[3]} thread{'s' * (k[3] > 1)}" if mine else "python-control, 1 thread, scaled"
            wall = duration(v["values"]["wall"]) if mine else "–"
            yield work, program, f"{k[2]:,}".replace(",", " "), duration(v["seconds"]), wall, f"{worst:.0e}"


def identification_rows(c):
    ours = c.found.get(("ours", "identify", 10_000))
    if ours:
        yield "holdup", "all dead times to 2000 s", duration(ours["seconds"]), *(f"{x:.9g}" for x in ours["values"])
    for k, v in sorted((k, v) for k, v in c.found.items() if isinstance(k, tuple) and k[:2] == ("scipy", "identify")):
        yield "scipy curve_fit", f"starts at d = {k[2]:g} s", duration(v["seconds"]), *(f"{x:.9g}" for x in v["values"])


def horizon_rows(c):
    for n in (10, 30, 100, 300, 1000, 3000, 10_000):
        cells = [duration(c.found["ours", what, n]["seconds"]) for what in ("paper", "oscillating")]
        loop = c.found.get((f"c-horizon-{n}", "metrics", 1200))
        yield n, *cells, duration(loop["seconds"]) if loop else "–"


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.split(":")[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def version(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0]


def write(found, folder, reasons):
    c = Chosen(found)
    goals = targets(c)
    head = (f"Measured on {date.today()} on {processor()}, {version('rustc', '--version')}, {version('gcc', '--version')}, "
            f"Python {platform.python_version()}. {found['how']}, peers and holdup in turn. Load average of the "
            f"machine meanwhile {min(found['load']):.1f} to {max(found['load']):.1f}: machines are noisy, and ratios move "
            f"by tens of per cent between runs, more so under load.")
    goal_rows = [(w, t, v, g, "reached" if share >= 1 else f"missed ({share:.2f} of it): {reasons.get((w, t), 'no reason known')}")
                 for w, t, v, g, share, _ in goals]
    memory = [(f"{m['samples']:,}".replace(",", " "), duration(m["wall"]), duration(m["processor"]), f"{m['mib']:.0f} MiB")
              for m in found["memory"]]
    pade = f"Padé order {c.order} for the response (the order with the least error), {c.margin_order} for margins"
    text = "\n\n".join([
        "# Results", "Made by `bench/run`; definitions in [README.md](README.md).", head, "![](results.svg)",
        "## Targets", f"python-control with {pade}. The crate and C: the cheapest setting with an error of at most 1e-9, or "
        f"the most accurate one where none has that (here the crate's error is {error(c.crate['values'], c.reference):.0e}, "
        f"C's {error(c.c['values'], c.reference):.0e}).",
        table(("work", "against", "measured", "target", "verdict"), goal_rows),
        "## W1: one loop", f"Errors are relative, against Richardson's extrapolation of the fourth-order loop in 80-bit "
        f"numbers (uncertainty {found['reference']['uncertainty']:.0e}; scipy by steps at 1e-12 agrees to "
        f"{error(found['reference', 'metrics', 1]['values'], c.reference):.0e}). Ratios are to holdup on the same work.",
        table(("program", "setting", "time", "time / holdup's", *NAMES), loop_rows(c)),
        "## W2: margins of one loop", "Gain margin, phase margin, delay margin and M_s; error against root finding on L(jω).",
        table(("program", "setting", "time", "time / holdup's", "error"), margin_rows(c)),
        "## W3, W4: many loops", "Processor time and time on the wall of one loop; error over the first of them.",
        table(("work", "program", "loops", "time each", "wall each", "error"), many_rows(c)),
        "## W5: identification", "10 000 rows; the record was made with gain 0.0005 and dead time 7.3 s.",
        table(("program", "setting", "time", "gain", "dead time"), identification_rows(c)),
        "## Growth with the horizon", "The paper's loop comes to rest and is then finished in closed form; P control with "
        "K·Kc·d = 1.57 hardly decays. C: fourth order, 1200 steps a dead time.",
        table(("dead times", "paper's loop", "oscillating loop", "C, paper's loop"), horizon_rows(c)),
        "## Memory", "`holdup robust` on the paper's loop with W1's scenario: margins and all metrics, two threads.",
        table(("runs", "wall", "processor", "greatest memory"), memory) if memory else "Not measured in this run."])
    (folder / "RESULTS.md").write_text(text + "\n", encoding="utf-8")
    picture.draw(goals, c, folder / "results.svg")
