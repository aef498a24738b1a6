/* The loop in C, as a good engineer writes it: fixed step, ring buffer for the dead time, no allocation in the loop.
 *
 * The step divides the dead time, so that no delayed value has to be searched for. The fourth-order method needs the
 * delayed input in the middle of a step too: it is stored when the step is made, from the cubic through value and slope
 * at both ends, which is of the same order. A step keeps the input at its start (from the right) and at its end (from
 * the left), so that jumps lie between steps. Integrals are Simpson's on that cubic; a step in which the error changes
 * sign is cut at the root.
 *
 *   loop time STEPS HORIZON LOAD_AT      fourth order, STEPS a dead time: best time, with and without output
 *   loop value STEPS                     the four integrals only, printed in full (compiled with REAL=long double: the
 *                                        reference)
 *   loop euler                           plain Euler at 0.01 s, as it is often written
 */
#include <tgmath.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#ifndef REAL
#define REAL double
#endif
typedef REAL real;

enum { MOST_STEPS = 200000, POINTS = 20001 };

typedef struct {
    real gain, dead_time, kc, ti, td, tf, load_at, horizon;
} loop_t;

typedef struct {
    real iae, ise, itae, energy;
} integrals_t;

static real start_of[MOST_STEPS], middle_of[MOST_STEPS], end_of[MOST_STEPS];
static double level[POINTS], valve[POINTS];

static loop_t paper(void)
{
    real td = 3;
    return (loop_t){(real)506 / 10000, 6, (real)295 / 100, 15, td, td / 100, 100, 200};
}

/* |e| and t|e| over [from, to] of a step, e being the cubic c: Simpson is exact for the first. */
static inline void absolute(const real c[4], real t, real from, real to, integrals_t *sum)
{
    real middle = (from + to) / 2, third = (to - from) / 6, e[3], at[3] = {from, middle, to};
    for (int i = 0; i < 3; i++)
        e[i] = fabs(c[0] + at[i] * (c[1] + at[i] * (c[2] + at[i] * c[3])));
    sum->iae += third * (e[0] + 4 * e[1] + e[2]);
    sum->itae += third * ((t + from) * e[0] + 4 * (t + middle) * e[1] + (t + to) * e[2]);
}

/* A step in which the error changes sign: the cubic's root by regula falsi with Newton, then both sides. */
static void __attribute__((noinline)) split(real t, real h, real e0, real s0, real e1, real s1, integrals_t *sum)
{
    real c[4] = {e0, s0, (3 * (e1 - e0) / h - 2 * s0 - s1) / h, (2 * (e0 - e1) / h + s0 + s1) / (h * h)};
    real root = h * e0 / (e0 - e1);
    for (int i = 0; i < 8; i++) {
        real value = c[0] + root * (c[1] + root * (c[2] + root * c[3]));
        real slope = c[1] + root * (2 * c[2] + root * 3 * c[3]);
        root = fmin(h, fmax(0, root - value / slope));
    }
    absolute(c, t, 0, root, sum);
    absolute(c, t, root, h, sum);
}

/* Fourth-order Runge–Kutta, n steps a dead time; every `every`th point is stored where every > 0. */
static integrals_t rk4(const loop_t *p, int n, int every)
{
    const real h = p->dead_time / n, K = p->gain, Kc = p->kc, ki = 1 / p->ti, kd = p->td / p->tf, kf = 1 / p->tf;
    const long steps = lround(p->horizon / h), load_step = lround(p->load_at / h);
    real y = 0, area = 0, x = 0; /* output, integral of the error, filtered error */
    integrals_t sum = {0, 0, 0, 0};
    for (int i = 0; i < n; i++)
        start_of[i] = middle_of[i] = end_of[i] = 0;
    int slot = 0, left = 1;
    long point = 0;
    for (long k = 0; k < steps; k++) {
        const real w0 = K * start_of[slot], wm = K * middle_of[slot], w1 = K * end_of[slot];
        const real load = k >= load_step;
        const real e0 = 1 - y, f0 = kf * (e0 - x);
        const real u0 = Kc * (e0 + ki * area + kd * (e0 - x));
        if (every && --left == 0) {
            level[point] = (double)y;
            valve[point++] = (double)u0;
            left = every;
        }
        /* The four stages; y' is the delayed input alone. */
        const real e2 = 1 - (y + h / 2 * w0), f2 = kf * (e2 - (x + h / 2 * f0));
        const real e3 = 1 - (y + h / 2 * wm), f3 = kf * (e3 - (x + h / 2 * f2));
        const real e4 = 1 - (y + h * wm), f4 = kf * (e4 - (x + h * f3));
        y += h / 6 * (w0 + 4 * wm + w1);
        area += h / 6 * (e0 + 2 * (e2 + e3) + e4);
        x += h / 6 * (f0 + 2 * (f2 + f3) + f4);
        const real e1 = 1 - y, u1 = Kc * (e1 + ki * area + kd * (e1 - x));
        /* Slopes of u at both ends of the step, and u and e in its middle. */
        const real s0 = Kc * (-w0 + ki * e0 + kd * (-w0 - f0));
        const real s1 = Kc * (-w1 + ki * e1 + kd * (-w1 - kf * (e1 - x)));
        const real um = (u0 + u1) / 2 + h / 8 * (s0 - s1), em = (e0 + e1) / 2 + h / 8 * (w1 - w0);
        start_of[slot] = u0 + load;
        middle_of[slot] = um + load;
        end_of[slot] = u1 + load;
        if (++slot == n)
            slot = 0;
        sum.ise += e0 * e0 + 4 * em * em + e1 * e1;
        sum.energy += u0 * u0 + 4 * um * um + u1 * u1;
        const real t = k * h;
        /* At rest the sign is rounding: no root is looked for there. */
        if (e0 * e1 >= 0 || fabs(e0) + fabs(e1) < 1e-13) {
            sum.iae += h / 6 * fabs(e0 + 4 * em + e1);
            sum.itae += h / 6 * fabs(t * e0 + 4 * (t + h / 2) * em + (t + h) * e1);
        } else {
            split(t, h, e0, -w0, e1, -w1, &sum);
        }
    }
    if (every) {
        level[point] = (double)y;
        valve[point] = (double)(Kc * (1 - y + ki * area + kd * (1 - y - x)));
    }
    sum.ise *= h / 6;
    sum.energy *= h / 6;
    return sum;
}

/* Plain Euler: rectangles everywhere. */
static integrals_t euler(const loop_t *p, double h, int store)
{
    const int n = (int)lround((double)p->dead_time / h);
    const long steps = lround((double)p->horizon / h), load_step = lround((double)p->load_at / h);
    const double K = h * p->gain, Kc = p->kc, ki = 1 / p->ti, kd = p->td / p->tf, kf = h / p->tf;
    double y = 0, area = 0, x = 0, iae = 0, ise = 0, itae = 0, energy = 0;
    for (int i = 0; i < n; i++)
        start_of[i] = 0;
    int slot = 0;
    for (long k = 0; k < steps; k++) {
        const double e = 1 - y, u = Kc * (e + ki * area + kd * (e - x));
        if (store) {
            level[k] = y;
            valve[k] = u;
        }
        iae += fabs(e);
        ise += e * e;
        itae += k * h * fabs(e);
        energy += u * u;
        y += K * start_of[slot];
        area += h * e;
        x += kf * (e - x);
        start_of[slot] = u + (k >= load_step);
        if (++slot == n)
            slot = 0;
    }
    return (integrals_t){h * iae, h * ise, h * itae, h * energy};
}

/* Processor time: other programs on the machine do not lengthen it. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Best time of one run within half a second, at least three runs. */
static double best(const loop_t *p, int n, int every, integrals_t *sum)
{
    double least = 1e300, begin = now();
    for (int i = 0; i < 3 || (now() - begin < 0.5 && i < 1000); i++) {
        double from = now();
        *sum = n ? rk4(p, n, every) : euler(p, 0.01, every);
        double took = now() - from;
        least = took < least ? took : least;
    }
    return least;
}

static void print(const char *what, int n, double seconds, integrals_t s)
{
    printf("{\"what\":\"%s\",\"steps\":%d,\"seconds\":%.9g,\"values\":[%.20Lg,%.20Lg,%.20Lg,%.20Lg]}\n", what, n, seconds,
           (long double)s.iae, (long double)s.ise, (long double)s.itae, (long double)s.energy);
}

int main(int argc, char **argv)
{
#ifdef __SSE2__
    /* A loop at rest would otherwise compute with denormal numbers, ten times slower. */
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
#endif
    loop_t p = paper();
    integrals_t sum = {0, 0, 0, 0};
    if (argc > 2 && strcmp(argv[1], "value") == 0) {
        int n = atoi(argv[2]);
        sum = rk4(&p, n, 0);
        print("value", n, 0, sum);
    } else if (argc > 4 && strcmp(argv[1], "time") == 0) {
        int n = atoi(argv[2]);
        p.horizon = atof(argv[3]);
        p.load_at = atof(argv[4]);
        double seconds = best(&p, n, 0, &sum);
        print("metrics", n, seconds, sum);
        long every = lround(p.horizon / p.dead_time * n) / (POINTS - 1);
        if (every > 0 && every * (POINTS - 1) == lround(p.horizon / p.dead_time * n)) {
            seconds = best(&p, n, (int)every, &sum);
            print("points", n, seconds, sum);
        }
    } else if (argc > 1 && strcmp(argv[1], "euler") == 0) {
        double seconds = best(&p, 0, 0, &sum);
        print("metrics", 600, seconds, sum);
        seconds = best(&p, 0, 1, &sum);
        print("points", 600, seconds, sum);
    } else {
        fprintf(stderr, "usage: loop time STEPS HORIZON LOAD_AT | value STEPS | euler\n");
        return 2;
    }
    /* The stored points are read, or the compiler may leave them out. */
    return level[POINTS / 2] + valve[POINTS / 2] == 1e300;
}
