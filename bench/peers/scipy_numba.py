"""scipy and numba as a good engineer would use them.

scipy_numba.py steps | numba | identify FILE | reference
"""

import sys
import warnings
from bisect import bisect_right
from math import pi

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, curve_fit, minimize_scalar

from work import (DEAD_TIME, GAIN, HORIZON, KC, LOAD_AT, TD, TI, best, open_loop, perturbed, report, settings)

warnings.filterwarnings("ignore")


def by_steps(tolerance, gain=GAIN, dead_time=DEAD_TIME):
    """solve_ivp (DOP853) from breakpoint to breakpoint, and from root to root of the error; the delayed input from the
    dense output of what has been solved."""
    tf = TD / 100
    breaks = {0.0, LOAD_AT, HORIZON}
    for start in (0.0, LOAD_AT):
        breaks |= {start + k * dead_time for k in range(1, int((HORIZON - start) / dead_time) + 1)}
    breaks = sorted(breaks)
    breaks = [t for t, after in zip(breaks, breaks[1:] + [np.inf]) if after - t > 1e-9]
    starts, pieces = [], []

    def output(x):
        e = 1 - x[0]
        return KC * (e + x[1] / TI + TD / tf * (e - x[2]))

    def delayed(t, inside):
        """u + D one dead time ago; `inside` says on which side of a jump the step lies."""
        if inside - dead_time < 0:
            return 0.0
        at = t - dead_time
        piece = pieces[max(0, bisect_right(starts, at if at > starts[0] else starts[0]) - 1)]
        return output(piece(at)) + (inside - dead_time >= LOAD_AT)

    state, t = np.zeros(7), 0.0
    for end in breaks[1:]:
        middle = (t + end) / 2

        def rates(at, x, middle=middle, end=end, begin=t):
            e, u = 1 - x[0], output(x)
            w = delayed(min(max(at, begin), end), middle)
            return [gain * w, e, (e - x[2]) / tf, abs(e), e * e, at * abs(e), u * u]

        def crosses(at, x, begin=None):
            return 1 - x[0] if at > t + 1e-9 else np.copysign(1.0, sign)

        crosses.terminal = True
        while t < end - 1e-12:
            slope = -gain * delayed(t, middle)
            sign = 1 - state[0] if abs(1 - state[0]) > 1e-12 else slope
            part = solve_ivp(rates, (t, end), state, "DOP853", dense_output=True, events=crosses, rtol=tolerance,
                             atol=tolerance * 1e-2)
            starts.append(t)
            pieces.append(part.sol)
            t, state = part.t[-1], part.y[:, -1]
        t = end
    return state[3:]


def identify(file):
    """curve_fit of gain, dead time, initial value and constant load; the input's integral by interpolation."""
    time, level, valve = np.loadtxt(file, delimiter=",", skiprows=1).T
    step = time[1] - time[0]
    integral = np.concatenate([[0.0], np.cumsum(valve[:-1] - valve[0]) * step])

    def model(t, gain, dead_time, initial, drift):
        return initial + drift * t + gain * np.interp(t - dead_time, time, integral)

    for start in (1.0, 5.0, 10.0, 20.0):
        (fit, _), seconds = best(lambda: curve_fit(model, time, level, [1e-4, start, level[0], 0.0]))
        report("identify", start, seconds, fit[:2])


def reference():
    """Margins of the paper's loop and of the first controllers, by root finding on L(jω); metrics of the first processes."""

    def exact(kc=KC, ti=TI, td=TD):
        w = np.logspace(-2.5, 1.5, 40001)
        values = open_loop(w, kc, ti, td)
        def crossings(of, samples):
            where = np.nonzero(samples[:-1] * samples[1:] < 0)[0]
            return [brentq(of, w[i], w[i + 1], xtol=1e-15, rtol=1e-14) for i in where]
        gain = crossings(lambda x: abs(open_loop(x, kc, ti, td)) - 1, abs(values) - 1)
        phase = [x for x in crossings(lambda x: open_loop(x, kc, ti, td).imag, values.imag)
                 if open_loop(x, kc, ti, td).real < 0]
        factors = [1 / abs(open_loop(x, kc, ti, td)) for x in phase]
        gm = min((f for f in factors if f > 1), default=np.nan)
        angles = [np.angle(-open_loop(x, kc, ti, td)) for x in gain]
        pm = min(angles, key=abs)
        dm = min((a % (2 * pi)) / x for a, x in zip(angles, gain))
        i = np.argmin(abs(1 + values))
        peak = minimize_scalar(lambda x: abs(1 + open_loop(x, kc, ti, td)), bounds=(w[i - 1], w[i + 1]),
                               method="bounded", options={"xatol": 1e-10})
        return gm, pm, dm, 1 / peak.fun

    report("margins", 1, 0, exact())
    report("controllers", 20, 0, [exact(*settings(i)) for i in range(20)])
    report("processes", 3, 0, [by_steps(1e-12, *perturbed(i)) for i in range(3)])
    report("metrics", 1, 0, by_steps(1e-12))


def numba_loop():
    """The Euler and fourth-order loops of loop.c in numba (the latter without cutting steps at roots)."""
    from numba import njit

    @njit(fastmath=True)
    def euler(h, level, valve, past):
        n, steps, load_step = len(past), round(HORIZON / h), round(LOAD_AT / h)
        kd, kf = TD / (TD / 100), h / (TD / 100)
        y = area = x = iae = ise = itae = energy = 0.0
        past[:] = 0.0
        slot = 0
        for k in range(steps):
            e = 1 - y
            u = KC * (e + area / TI + kd * (e - x))
            level[k] = y
            valve[k] = u
            iae += abs(e)
            ise += e * e
            itae += k * h * abs(e)
            energy += u * u
            y += h * GAIN * past[slot]
            area += h * e
            x += kf * (e - x)
            past[slot] = u + (1.0 if k >= load_step else 0.0)
            slot += 1
            if slot == n:
                slot = 0
        return h * iae, h * ise, h * itae, h * energy

    h = 0.01
    level, valve, past = np.zeros(POINTS), np.zeros(POINTS), np.zeros(round(DEAD_TIME / h))
    euler(h, level, valve, past)
    values, seconds = best(lambda: euler(h, level, valve, past))
    report("points", 600, seconds, values)


POINTS = 20001


def main():
    job = sys.argv[1]
    if job == "steps":
        for exponent in (6, 8, 10):
            values, seconds = best(lambda: by_steps(10.0 ** -exponent), spend=0, least_calls=2)
            report("metrics", exponent, seconds, values)
    elif job == "numba":
        numba_loop()
    elif job == "identify":
        identify(sys.argv[2])
    else:
        reference()


main()
