#ifndef @NAME@_DECLARATIONS_ONLY

#ifdef __FAST_MATH__
#error "-ffast-math: a measurement that is not a number would not be seen"
#endif

/* The settings as designed. */
const @name@_settings @name@_design = {
    .law = {
        .pid = {
            .proportional_gain = @proportional_gain@,
            .setpoint_weight = @setpoint_weight@,
            .derivative_setpoint_weight = @derivative_setpoint_weight@,
            .has_integral = @has_integral@,
            .integral_time = @integral_time@,
            .has_tracking_time = @has_tracking_time@,
            .tracking_time = @tracking_time@,
            .has_derivative = @has_derivative@,
            .derivative_time = @derivative_time@,
            .has_derivative_filter = @has_derivative_filter@,
            .filter_time = @filter_time@,
            .bias = @bias@,
            .has_bleed_time = @has_bleed_time@,
            .bleed_time = @bleed_time@,
        },
        .has_observer = @has_observer@,
        .observer = {
            .observer_gain = @observer_gain@,
            .model_gain = @model_gain@,
            .dead_time = @dead_time@,
            .sample_period = @sample_period@,
            .predicts = @predicts@,
            .has_lead = @has_lead@,
            .lead_time = @lead_time@,
            .lead_filter_time = @lead_filter_time@,
        },
    },
    .limits = {
        .has_low = @has_low@,
        .low = @low@,
        .has_high = @has_high@,
        .high = @high@,
        .has_rate = @has_rate@,
        .rate = @rate@,
    },
    .watch = {
        .has_range = @has_range@,
        .range_low = @range_low@,
        .range_high = @range_high@,
        .has_stale_time = @has_stale_time@,
        .stale_time = @stale_time@,
        .has_failure = @has_failure@,
        .failure_time = @failure_time@,
        .safe_output = @safe_output@,
    },
};

static bool is_finite(@real@ x)
{
    return -@real_max@ <= x && x <= @real_max@;
}

static bool is_positive(@real@ x)
{
    return is_finite(x) && x > 0;
}

/* Compensated sums: Knuth's two-sum, so that small terms are not lost. */

static @name@_sum sum_of(@real@ value)
{
    const @name@_sum sum = {value, 0};
    return sum;
}

static void sum_add(@name@_sum *sum, @real@ term)
{
    const @real@ rounded = sum->value + term;
    const @real@ added = rounded - sum->value;
    const @real@ lost = (sum->value - (rounded - added)) + (term - added);
    const @real@ correction = sum->correction + lost;
    sum->value = rounded + correction;
    sum->correction = correction - (sum->value - rounded);
}

/* The delay line: values with their durations, so that the dead time is exact between samples and under jitter. */

/* Place of the segment that is nth from the oldest. */
static uint32_t line_place(const @name@_state *state, uint32_t nth)
{
    const uint32_t place = state->oldest + nth;
    return place < @NAME@_SEGMENTS ? place : place - @NAME@_SEGMENTS;
}

static void line_put(@name@_state *state, @real@ value, @real@ duration)
{
    if (state->count < @NAME@_SEGMENTS) {
        @name@_segment *const place = &state->line[line_place(state, state->count)];
        place->value = value;
        place->duration = duration;
        state->count = state->count + 1u;
        sum_add(&state->span, duration);
    } else {
        /* Full, because samples came too fast: the newest two become one of the same area. */
        @name@_segment *const newest = &state->line[line_place(state, state->count - 1u)];
        const @real@ together = newest->duration + duration;
        const @real@ mean = newest->value + (value - newest->value) * (duration / together);
        const @real@ lasted = together - newest->duration;
        newest->value = is_finite(mean) ? mean : value;
        newest->duration = together;
        sum_add(&state->span, lasted);
    }
}

/* Makes the whole content one value, as after a long rest there. */
static void line_fill(@name@_state *state, @real@ value)
{
    state->oldest = 0;
    state->count = 0;
    state->span = sum_of(0);
    if (state->dead_time > 0) {
        line_put(state, value, state->dead_time);
    }
}

/* Takes the oldest segment, or so much of it as the excess [s] asks, and lessens the excess by that. */
static bool line_take(@name@_state *state, @real@ *excess, @name@_segment *taken)
{
    if (state->count == 0 || *excess <= 0) {
        return false;
    }
    @name@_segment *const oldest = &state->line[state->oldest];
    const @real@ left = oldest->duration - *excess;
    *taken = *oldest;
    if (left > 0) {
        /* What the rounded remainder lacks, so that span and segments agree to the last bit. */
        taken->duration = oldest->duration - left;
        oldest->duration = left;
        *excess = 0;
    } else {
        *excess = *excess - taken->duration;
        state->oldest = line_place(state, 1u);
        state->count = state->count - 1u;
    }
    sum_add(&state->span, -taken->duration);
    return true;
}

/* Area [output unit s] of all that was put in and has not yet come out. */
static @real@ line_area(const @name@_state *state)
{
    @real@ area = 0;
    for (uint32_t nth = 0; nth < state->count; nth++) {
        const @name@_segment *const segment = &state->line[line_place(state, nth)];
        area = area + segment->value * segment->duration;
    }
    return area;
}

/* Puts in a value that lasted so long [s]; returns the area [output unit s] of what came out in that time. */
static @real@ line_advance(@name@_state *state, @real@ value, @real@ duration)
{
    @real@ area = 0;
    if (duration >= state->dead_time) {
        area = line_area(state) + value * (duration - state->dead_time);
        line_fill(state, value);
        return area;
    }
    line_put(state, value, duration);
    @real@ excess = state->span.value - state->dead_time;
    @name@_segment taken;
    while (line_take(state, &excess, &taken)) {
        area = area + taken.value * taken.duration;
    }
    return area;
}

/* A shorter line forgets its oldest content; of a longer one the oldest value has lasted longer. */
static void line_set_dead_time(@name@_state *state, @real@ dead_time)
{
    const @real@ longer = dead_time - state->dead_time;
    state->dead_time = dead_time;
    if (longer > 0) {
        if (state->count > 0) {
            @name@_segment *const oldest = &state->line[state->oldest];
            const @real@ duration = oldest->duration + longer;
            sum_add(&state->span, duration - oldest->duration);
            oldest->duration = duration;
        } else {
            line_fill(state, 0);
        }
        return;
    }
    @real@ excess = state->span.value - dead_time;
    @name@_segment forgotten;
    while (line_take(state, &excess, &forgotten)) {
    }
}

static bool line_is_long_enough(const @name@_law *law)
{
    /* One segment for each whole sample within the dead time, one for the rest of it, one for the newest sample
       and one against rounding. */
    return !law->has_observer
        || law->observer.dead_time / law->observer.sample_period < (@real@)@NAME@_SEGMENTS - 2;
}

/* The disturbance observer. */

/* The model runs on by h [s], driven by this output. */
static void observer_advance(@name@_state *state, @real@ drive, @real@ h)
{
    sum_add(&state->observer.model, state->law.observer.model_gain * line_advance(state, drive, h));
}

/* A new sample came, so long [s] after the one before. */
static void observer_measure(@name@_state *state, @real@ controlled_variable, @real@ elapsed)
{
    const @name@_observer *const observer = &state->law.observer;
    const @real@ innovation = (controlled_variable - state->observer.model.value) - state->observer.model.correction;
    @real@ leading = innovation;
    if (observer->has_lead) {
        const @real@ td = observer->lead_time;
        const @real@ tf = observer->lead_filter_time;
        state->observer.slope =
            (tf * state->observer.slope + (innovation - state->observer.innovation)) / (tf + elapsed);
        leading = innovation + (td - tf) * state->observer.slope;
    }
    state->observer.innovation = innovation;
    state->observer.load_estimate = observer->observer_gain * leading;
}

/* Puts the model where the load estimate is this one at this controlled variable. */
static void observer_start(@name@_state *state, @real@ controlled_variable, @real@ load_estimate)
{
    state->observer.innovation = load_estimate / state->law.observer.observer_gain;
    state->observer.slope = 0;
    state->observer.load_estimate = load_estimate;
    state->observer.model = sum_of(controlled_variable - state->observer.innovation);
}

/* Shifts the model so that the load estimate would have been this one; what it has moved since stays. */
static void observer_seat(@name@_state *state, @real@ load_estimate)
{
    const @real@ innovation = load_estimate / state->law.observer.observer_gain;
    sum_add(&state->observer.model, state->observer.innovation - innovation);
    state->observer.innovation = innovation;
    state->observer.slope = 0;
    state->observer.load_estimate = load_estimate;
}

/* The PID terms. */

/* The controlled variable that they look at: the predicted one where the law predicts. */
static @real@ pid_seen(const @name@_state *state)
{
    @real@ seen = state->controlled_variable;
    if (state->law.has_observer && state->law.observer.predicts) {
        seen = seen + state->law.observer.model_gain * line_area(state);
    }
    return seen;
}

/* A new sample came, so long [s] after the one before: the slope moves. */
static void pid_measure(@name@_state *state, @real@ seen, @real@ elapsed)
{
    const @name@_pid *const pid = &state->law.pid;
    if (state->pid.sampled) {
        const @real@ tf = pid->has_derivative && pid->has_derivative_filter ? pid->filter_time : 0;
        const @real@ rise = pid->derivative_setpoint_weight * (state->setpoint - state->pid.sample_setpoint)
            - (seen - state->pid.sample_controlled_variable);
        state->pid.slope = (tf * state->pid.slope + rise) / (tf + elapsed);
    }
    state->pid.sampled = true;
    state->pid.sample_setpoint = state->setpoint;
    state->pid.sample_controlled_variable = seen;
}

/* The integral moves on by h [s]; the shortfall is the output applied in that time less the one wanted. */
static void pid_integrate(@name@_state *state, @real@ shortfall, @real@ h)
{
    const @name@_pid *const pid = &state->law.pid;
    if (state->pid.sampled && pid->has_integral) {
        const @real@ kc = pid->proportional_gain;
        const @real@ ti = pid->integral_time;
        const @real@ tt = pid->has_tracking_time ? pid->tracking_time : ti;
        const @real@ error = state->setpoint - state->pid.sample_controlled_variable;
        sum_add(&state->pid.integral, kc * h / ti * error + shortfall * h / (tt + h));
    }
}

/* The bias goes back to its set value for h [s]. */
static void pid_bleed(@name@_state *state, @real@ h)
{
    const @real@ step = state->pid.bleed_rate * h;
    if ((step > 0 && step < state->pid.bias_offset) || (step < 0 && step > state->pid.bias_offset)) {
        state->pid.bias_offset = state->pid.bias_offset - step;
    } else if (step != 0) {
        state->pid.bias_offset = 0;
        state->pid.bleed_rate = 0;
    }
}

/* Proportional and derivative term together. */
static @real@ pid_proportional_derivative(const @name@_state *state)
{
    const @name@_pid *const pid = &state->law.pid;
    if (!state->pid.sampled) {
        return 0;
    }
    const @real@ kc = pid->proportional_gain;
    const @real@ td = pid->has_derivative ? pid->derivative_time : 0;
    return kc * (pid->setpoint_weight * state->setpoint - state->pid.sample_controlled_variable)
        + kc * td * state->pid.slope;
}

/* Takes up this offset in the bias, to bleed from now on. */
static void pid_set_bias_offset(@name@_state *state, @real@ offset)
{
    const @name@_pid *const pid = &state->law.pid;
    state->pid.bias_offset = offset;
    state->pid.bleed_rate = pid->has_bleed_time ? offset / pid->bleed_time : 0;
}

/* What is added to the output beside the terms and the observer's model: feed-forward and bias. */
static @real@ assistance(const @name@_state *state)
{
    return state->feed_forward + (state->law.pid.bias + state->pid.bias_offset);
}

/* Makes `target` the wanted output: the integral gives way; where there is none, the load estimate; where there is
   no observer, the bias. */
static void seat(@name@_state *state, @real@ target)
{
    const @real@ terms = pid_proportional_derivative(state);
    pid_set_bias_offset(state, 0);
    state->unassisted = terms;
    if (state->law.pid.has_integral) {
        const @real@ integral = target - assistance(state) + state->observer.load_estimate - terms;
        state->pid.integral = sum_of(integral);
        state->unassisted = terms + integral;
    } else if (state->law.has_observer) {
        observer_seat(state, terms + assistance(state) - target);
    } else {
        pid_set_bias_offset(state, target - (terms + assistance(state)));
    }
    state->wanted = target;
}

