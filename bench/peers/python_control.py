"""python-control at its best: Padé with an exact propagation between the points, or the delay as a shift register.

python_control.py single | processes | controllers
"""

import sys
import warnings

import control as ct
import numpy as np
from scipy.integrate import simpson

from work import DEAD_TIME, GAIN, KC, LOAD_AT, TD, TI, best, open_loop, perturbed, report, settings

warnings.filterwarnings("ignore")
POINTS = 20001


def controller(kc=KC, ti=TI, td=TD):
    """PID in parallel states: no polynomial arithmetic, which would lose digits."""
    tf = td / 100
    a = np.diag([0.0, -1 / tf])
    return ct.ss(a, [[1.0], [1 / tf]], [[kc / ti, -kc * td / tf]], [[kc * (1 + td / tf)]])


def process(order, gain=GAIN, dead_time=DEAD_TIME):
    """Integrator with the Padé approximation of the dead time."""
    return ct.ss(ct.tf(*ct.pade(dead_time, order))) * ct.ss([[0.0]], [[1.0]], [[gain]], [[0.0]])


def closed(of_process, of_controller):
    """From setpoint and load to controller output and level."""
    return ct.feedback(ct.append(of_controller, of_process), np.array([[0.0, 1.0], [-1.0, 0.0]]))


def response(system, points):
    """Setpoint step at 0, load step at 100 s: in two halves, so that the jump of the load is no ramp between points."""
    half = points // 2 + 1
    time = np.linspace(0, LOAD_AT, half)
    ones, zeros = np.ones(half), np.zeros(half)
    first = ct.forced_response(system, time, np.array([ones, zeros]), return_states=True)
    second = ct.forced_response(system, time, np.array([ones, ones]), X0=first.states[:, -1], return_states=True)
    return time, first.outputs, second.outputs


def integrals(time, first, second):
    """IAE, ISE, ITAE and control energy by Simpson's rule on the points."""
    total = np.zeros(4)
    for start, (u, y) in ((0, first), (LOAD_AT, second)):
        e = 1 - y
        rows = np.array([np.abs(e), e * e, (time + start) * np.abs(e), u * u])
        total += simpson(rows, x=time, axis=1)
    return total


def run(points, order, gain=GAIN, dead_time=DEAD_TIME):
    return integrals(*response(closed(process(order, gain, dead_time), controller()), points))


def shift_register(period):
    """All in discrete time: the delay as a shift register, the controller by Tustin's rule."""
    n = round(DEAD_TIME / period)
    a = np.diag(np.ones(n), -1)
    a[0, 0] = 1.0
    # The integrator's state first, then its history.
    b = np.zeros((n + 1, 1))
    b[0, 0] = GAIN * period
    c = np.zeros((1, n + 1))
    c[0, n] = 1.0
    plant = ct.ss(a, b, c, [[0.0]], period)
    system = closed(plant, ct.sample_system(controller(), period, "tustin"))
    half = round(LOAD_AT / period)
    time = np.arange(2 * half + 1) * period
    load = (time >= LOAD_AT).astype(float)
    u, y = ct.forced_response(system, time, np.array([np.ones_like(time), load])).outputs
    e = 1 - y
    return simpson(np.array([np.abs(e), e * e, time * np.abs(e), u * u]), x=time, axis=1)


def margins(grid, settings=(KC, TI, TD)):
    """Margins on a grid of frequencies with the exact delay; python-control interpolates between them."""
    w = np.logspace(-2.5, 1.5, grid)
    frd = ct.frd(open_loop(w, *settings), w, smooth=True)
    gm, pm, sm, _, wgc, _ = ct.stability_margins(frd)
    pm = np.deg2rad(pm)
    return gm, pm, pm / wgc, 1 / sm


def margins_pade(order, settings=(KC, TI, TD)):
    """Margins of the Padé approximation: fast, and accurate where the approximation is good at the crossings."""
    gm, pm, sm, _, wgc, _ = ct.stability_margins(process(order) * controller(*settings))
    pm = np.deg2rad(pm)
    return gm, pm, pm / wgc, 1 / sm


def attempt(what, size, call, **options):
    """A setting that python-control cannot do is listed without a result."""
    try:
        values, seconds = best(call, **options)
    except Exception as error:  # noqa: BLE001 - whatever a peer raises is its answer
        print(f"{what} {size}: {type(error).__name__}: {error}", file=sys.stderr)
        return
    report(what, size, seconds, values)


def main():
    job = sys.argv[1]
    if job == "single":
        for order in (2, 4, 6, 8, 10, 12, 14, 16, 20, 24, 30):
            attempt("points", order, lambda order=order: run(POINTS, order), spend=0.6)
        for order in (6, 10):
            attempt("points-2001", order, lambda order=order: run(2001, order), spend=0.6)
        attempt("shift-register", 120, lambda: shift_register(0.05), spend=0.6)
        for grid in (300, 1000, 3000, 10000):
            attempt("margins", grid, lambda grid=grid: margins(grid), spend=0.6)
        for order in (4, 6, 8, 10):
            attempt("margins-pade", order, lambda order=order: margins_pade(order), spend=0.6)
    elif job == "processes":
        order, count = int(sys.argv[2]), 20
        def all_of_them():
            return [run(POINTS, order, *perturbed(i)) for i in range(count)]
        values, seconds = best(all_of_them, spend=0, least_calls=2)
        report("processes", count, seconds / count, values)
    elif job == "controllers":
        order, count = int(sys.argv[2]), 50
        def all_of_them():
            return [margins_pade(order, settings(i)) for i in range(count)]
        values, seconds = best(all_of_them, spend=0, least_calls=3)
        report("controllers", count, seconds / count, values)


main()
