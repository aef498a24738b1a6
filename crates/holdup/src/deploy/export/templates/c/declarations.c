/*
 * @header@
 *
 * Units: times in s; controlled variable and setpoint in the input unit; manipulated variable, feed-forward, load
 * estimate, bias and limits in the output unit.
 *
 * To use it, compile this file as one of the program's, and include it where it is called for its declarations only:
 *
 *     #define @NAME@_DECLARATIONS_ONLY
 *     #include "@name@.c"
 *
 *     static @name@_state state;
 *
 * Once, when it is switched on, so that the output begins where the actuator stands:
 *
 *     @name@_switch_on(&state, &@name@_design, actuator_position());
 *
 * Then about every @nominal_period@ s:
 *
 *     @name@_input input = @name@_automatic(seconds_since_the_last_update(), setpoint(), measurement());
 *     @name@_output output = @name@_update(&state, &@name@_design, &input);
 *     write_actuator(output.manipulated_variable);
 *
 * Time is measured: `sample_period` is the time since the last call, whatever it was meant to be. A bad measurement
 * is a NaN, an absent one `measured = false`. A copy of the state is a save: running on from it continues bit for bit.
 *
 * To change the settings, change the numbers of `@name@_design` below, or give `@name@_update` other settings
 * while running: they take over without bump. Settings that no controller can run with are refused, the last good
 * ones run on, and the status says so; `@name@_fault` names what is wrong with them. A longer dead time or a
 * shorter sample period needs more segments: dead_time / sample_period must stay below @NAME@_SEGMENTS - 2.
 *
 * C99, no library, no allocation, no clock. Bit for bit the law of holdup-control, from which it is made, when
 * compiled with IEEE 754 arithmetic and without contraction: gcc and clang -ffp-contract=off, never -ffast-math.
 */
#ifndef @NAME@_H
#define @NAME@_H

#include <float.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Segments of the delay line: what the dead time needs, and spare ones. */
#define @NAME@_SEGMENTS @segments@u

/* Settings: each term that may be absent has a flag; the value of an absent term is not looked at. */

/* u = Kc (b r - y) + Kc/Ti integral of (r - y) + Kc Td s/(1 + Tf s) (c r - y) + bias + feed-forward - load estimate */
typedef struct {
    @real@ proportional_gain;          /* Kc, not 0; negative where the output must rise with the measurement */
    @real@ setpoint_weight;            /* b */
    @real@ derivative_setpoint_weight; /* c */
    bool has_integral;
    @real@ integral_time;              /* Ti [s] > 0 */
    bool has_tracking_time;
    @real@ tracking_time;              /* Tt [s] >= 0: how fast the integral follows what was applied; absent, Ti */
    bool has_derivative;
    @real@ derivative_time;            /* Td [s] >= 0 */
    bool has_derivative_filter;
    @real@ filter_time;                /* Tf [s] > 0 */
    @real@ bias;                       /* added to the output */
    bool has_bleed_time;
    @real@ bleed_time;                 /* [s] > 0: in which a bias that a transfer moved returns; absent, it stays */
} @name@_pid;

/* Load estimate = Ko (y - ym), with the model ym = Km/s exp(-dm s) of what was applied and of the estimate. */
typedef struct {
    @real@ observer_gain;   /* Ko, with the sign of Km */
    @real@ model_gain;      /* Km [input unit/(output unit s)], with the sign of Kc */
    @real@ dead_time;       /* dm [s] > 0 */
    @real@ sample_period;   /* nominal [s] > 0: says how long the delay line must be, nothing else */
    bool predicts;          /* the PID terms act on the predicted y: a modified Smith predictor */
    bool has_lead;          /* load estimate = Ko (1 + Td s)/(1 + Tf s) (y - ym) */
    @real@ lead_time;       /* Td of the lead [s] >= 0 */
    @real@ lead_filter_time; /* Tf of the lead [s] > 0 */
} @name@_observer;

/* What computes the wanted output. */
typedef struct {
    @name@_pid pid;
    bool has_observer;
    @name@_observer observer;
} @name@_law;

/* What the actuator allows. */
typedef struct {
    bool has_low;
    @real@ low;
    bool has_high;
    @real@ high;  /* above low */
    bool has_rate;
    @real@ rate;  /* [output unit/s] > 0, up and down */
} @name@_limits;

/* What happens when the measurement fails. */
typedef struct {
    bool has_range;
    @real@ range_low;    /* a measurement outside the range is none */
    @real@ range_high;
    bool has_stale_time;
    @real@ stale_time;   /* [s] > 0: an older measurement holds the output */
    bool has_failure;
    @real@ failure_time; /* [s], not below stale_time: after it the safe output is taken */
    @real@ safe_output;  /* within the limits */
} @name@_watch;

/* Everything that is set. */
typedef struct {
    @name@_law law;
    @name@_limits limits;
    @name@_watch watch;
} @name@_settings;

/* A sum, and what rounding dropped from it. */
typedef struct {
    @real@ value;
    @real@ correction;
} @name@_sum;

/* A value and how long it lasted [s]. */
typedef struct {
    @real@ value;
    @real@ duration;
} @name@_segment;

/* Running state of the PID terms. */
typedef struct {
    bool sampled;                      /* there was a good sample; the next two are the newest */
    @real@ sample_setpoint;
    @real@ sample_controlled_variable; /* the predicted one in a law that predicts */
    @real@ slope;                      /* filtered slope of c r - y [input unit/s] */
    @name@_sum integral;
    @real@ bias_offset;                /* what a transfer added to the bias and has not yet bled away */
    @real@ bleed_rate;                 /* [output unit/s] */
} @name@_pid_state;

/* Running state of the observer, its delay line apart. */
typedef struct {
    @name@_sum model;     /* ym */
    @real@ load_estimate;
    @real@ innovation;    /* y - ym at the newest good sample */
    @real@ slope;         /* of y - ym, filtered; moves only with a lead */
} @name@_observer_state;

/* Running state: plain data. */
typedef struct {
    @name@_law law;          /* in use: that of the good settings last given */
    @name@_limits limits;
    @name@_watch watch;
    @name@_pid_state pid;
    @name@_observer_state observer;
    @name@_segment line[@NAME@_SEGMENTS];
    uint32_t oldest;         /* place of the oldest segment */
    uint32_t count;          /* segments in use */
    @name@_sum span;         /* their durations together [s] */
    @real@ dead_time;        /* of the line [s] */
    @real@ setpoint;         /* last used, as the next two */
    @real@ feed_forward;
    @real@ controlled_variable;
    @name@_sum age;          /* of the last good measurement [s] */
    @real@ unassisted;       /* what the PID terms asked for last */
    @real@ wanted;           /* what the law wanted last, before the limits */
    @real@ manipulated_variable; /* returned last */
    bool follows;            /* the last measurement was good and the states follow it */
    bool automatic;          /* the last output was the law's */
} @name@_state;

typedef enum {
    @NAME@_AUTOMATIC, /* the law */
    @NAME@_MANUAL,    /* the operator's manual_output, within the limits */
    @NAME@_HOLD       /* the output stays: the way into manual without bump */
} @name@_mode;

typedef enum { @NAME@_FREE, @NAME@_AT_LOW, @NAME@_AT_HIGH, @NAME@_AT_RATE } @name@_limited;

typedef enum {
    @NAME@_GOOD,
    @NAME@_INPUT_REJECTED,         /* setpoint, feed-forward, applied or manual output: the last one stands */
    @NAME@_SETTINGS_REJECTED,      /* refused, or too few segments for the new dead time: the old ones run on */
    @NAME@_SAMPLE_PERIOD_REJECTED, /* not finite or not above 0: nothing moved, the output is held */
    @NAME@_MEASUREMENT_REJECTED,   /* not finite or out of its range: automatic holds the output */
    @NAME@_MEASUREMENT_STALE,      /* none for the stale time, or none yet: automatic holds the output */
    @NAME@_MEASUREMENT_FAILED      /* none for the failure time: automatic takes the safe output */
} @name@_status;

/* What the controller is told at one update. */
typedef struct {
    @real@ sample_period;       /* since the last update [s], measured */
    @real@ setpoint;
    bool measured;              /* a new sample came since the last update */
    @real@ controlled_variable; /* that sample; a bad one is NaN */
    @real@ feed_forward;        /* added to the output: the known part of what balances the load */
    bool applied_known;         /* otherwise the output returned last was applied */
    @real@ applied;             /* the manipulated variable really applied since the last update */
    @name@_mode mode;
    @real@ manual_output;
} @name@_input;

/* What it answers. */
typedef struct {
    @real@ manipulated_variable; /* finite and within the limits, always */
    @real@ wanted;               /* before the limits */
    @name@_limited limited;      /* the limit that it stands at */
    @real@ load_estimate;        /* less what feed-forward and bias balance; 0 without observer */
    @name@_status status;
} @name@_output;

extern const @name@_settings @name@_design;
const char *@name@_fault(const @name@_settings *settings);
bool @name@_switch_on(
    @name@_state *state, const @name@_settings *settings, @real@ manipulated_variable);
bool @name@_at_rest(
    @name@_state *state, const @name@_settings *settings, @real@ setpoint, @real@ controlled_variable,
    @real@ manipulated_variable);
@name@_input @name@_automatic(@real@ sample_period, @real@ setpoint, @real@ controlled_variable);
@name@_output @name@_update(
    @name@_state *state, const @name@_settings *settings, const @name@_input *input);

#ifdef __cplusplus
}
#endif

#endif

