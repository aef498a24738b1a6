"""The picture of the results: every target as a bar, and error against time of W1."""

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "holdup", "font.size": 9, "axes.grid": True, "grid.alpha": 0.3})
import matplotlib.pyplot as plt  # noqa: E402 - the backend comes first


def draw(goals, c, file):
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 5), layout="constrained")
    labels = [f"{work}: {text}" for work, text, *_ in goals][::-1]
    shares = [goal[4] for goal in goals][::-1]
    left.barh(labels, shares, color=["#2b7a5b" if share >= 1 else "#c0562b" for share in shares], log=True)
    left.axvline(1, color="black", linewidth=1)
    for place, share in enumerate(shares):
        left.annotate(f"{share:.2f}", (share, place), xytext=(4, 0), textcoords="offset points", va="center",
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})
    # Room for the label of the longest bar.
    left.set_xlim(0.5 * min(shares), 1.6 * max(*shares, 1))
    ticks = [tick for tick in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20) if 0.5 * min(shares) < tick < 1.6 * max(*shares, 1)]
    left.set_xticks(ticks, labels=[f"{tick:g}" for tick in ticks])
    left.minorticks_off()
    left.set_xlabel("measured / target (right of 1: reached)")
    left.set_title("Targets")
    series = {("ours", "metrics"): ("holdup", "*"), ("c", "metrics"): ("C, fourth order", "o"),
              ("c-euler", "metrics"): ("C, Euler", "s"), ("crate", "metrics"): ("differential-equations", "^"),
              ("scipy", "metrics"): ("scipy by steps", "v"), ("control", "points"): ("python-control, Padé", "D")}
    for key, (label, marker) in series.items():
        rows = sorted((k[2], v) for k, v in c.found.items() if isinstance(k, tuple) and k[:2] == key and v["values"])
        times = [v["seconds"] * 1e3 for _, v in rows]
        errors = [max(max(abs(a / b - 1) for a, b in zip(v["values"], c.reference)), 1e-16) for _, v in rows]
        right.loglog(times, errors, marker=marker, label=label, markersize=11 if marker == "*" else 5, linewidth=1)
    right.axhline(1e-9, color="black", linewidth=1)
    right.set_xlabel("time of one run [ms]")
    right.set_ylabel("greatest relative error of the four integrals")
    right.set_title("W1: error against time (lower left is better)")
    right.legend()
    figure.savefig(file, metadata={"Date": None})
