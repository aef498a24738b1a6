"""The work that all peers in Python share: the loop, the sequences of processes and controllers, timing, output."""

import json
import time

import numpy as np

GAIN, DEAD_TIME = 0.0506, 6.0
KC, TI, TD = 2.95, 15.0, 3.0
HORIZON, LOAD_AT = 200.0, 100.0


def even(steps, index):
    """Member `index` of an even sequence over the unit cube; holdup's example has the same."""
    return [(0.5 + index * step) % 1.0 for step in steps]


def perturbed(index):
    """Gain and dead time of process `index`, within ±20 %."""
    k, d = even((0.7548776662466927, 0.5698402909980532), index)
    return GAIN * (0.8 + 0.4 * k), DEAD_TIME * (0.8 + 0.4 * d)


def settings(index):
    """Kc, Ti, Td of controller `index`."""
    kc, ti, td = even((0.8191725133961645, 0.6710436067037893, 0.5497004779019703), index)
    return 1 + 2 * kc, 20 + 60 * ti, 0.5 + 2.5 * td


def open_loop(w, kc=KC, ti=TI, td=TD, gain=GAIN, dead_time=DEAD_TIME):
    """L(jω), the dead time as it is."""
    s = 1j * np.asarray(w)
    return gain * np.exp(-dead_time * s) / s * kc * (1 + 1 / (ti * s) + td * s / (td / 100 * s + 1))


def best(call, spend=1.0, least_calls=3):
    """The result, and the best processor time of one call [s]: calls until the time is spent.

    Processor time, because other programs on the machine lengthen the time on the wall of a call that takes longer than
    the scheduler's slice; the peers here run on one thread."""
    begin, least, calls, result = time.process_time(), float("inf"), 0, None
    while calls < least_calls or time.process_time() - begin < spend:
        start = time.process_time()
        result = call()
        least = min(least, time.process_time() - start)
        calls += 1
    return result, least


def report(what, size, seconds, values):
    """One line of JSON, as the other programs print it."""
    values = np.asarray(values, dtype=float).tolist() if values is not None else None
    print(json.dumps({"what": what, "size": size, "seconds": seconds, "values": values}), flush=True)
