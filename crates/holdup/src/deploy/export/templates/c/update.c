/* Takes another law, its load estimate where the old one's was. The wanted output is the caller's to seat. */
static void adopt(@name@_state *state, const @name@_law *law)
{
    const bool had_observer = state->law.has_observer;
    const bool other_observer = !same_observer(&state->law, law);
    state->law = *law;
    if (!law->has_observer) {
        const @name@_observer_state none = {{0, 0}, 0, 0, 0};
        state->observer = none;
    } else if (!had_observer) {
        state->dead_time = law->observer.dead_time;
        line_fill(state, state->unassisted);
        observer_start(state, state->controlled_variable, 0);
    } else if (other_observer) {
        line_set_dead_time(state, law->observer.dead_time);
        observer_seat(state, state->observer.load_estimate);
    }
    if (!law->pid.has_integral) {
        state->pid.integral = sum_of(0);
    }
    if (state->pid.sampled) {
        state->pid.sample_controlled_variable = pid_seen(state);
    }
}

/* A controller that is switched on at this manipulated variable: its first automatic output is that one, whatever the
   measurement. False, and the state is not to be used, where the output is not finite, the settings have a fault or
   the delay line is too short for them. */
bool @name@_switch_on(
    @name@_state *state, const @name@_settings *settings, @real@ manipulated_variable)
{
    static const @name@_state new_state;
    @name@_limited limited = @NAME@_FREE;
    if (!is_finite(manipulated_variable) || @name@_fault(settings) || !line_is_long_enough(&settings->law)) {
        return false;
    }
    *state = new_state;
    state->law = settings->law;
    state->limits = settings->limits;
    state->watch = settings->watch;
    state->manipulated_variable = limits_within(&state->limits, manipulated_variable, &limited);
    state->wanted = state->manipulated_variable;
    if (state->law.has_observer) {
        state->dead_time = state->law.observer.dead_time;
        line_fill(state, 0);
        /* Until a measurement tells more, the load is taken to be the one that this output balances. */
        state->observer.load_estimate = state->law.pid.bias - state->manipulated_variable;
    }
    return true;
}

/* A controller that has long been in automatic at this setpoint, controlled and manipulated variable: it answers the
   next change of any of them at once. False as above. */
bool @name@_at_rest(
    @name@_state *state, const @name@_settings *settings, @real@ setpoint, @real@ controlled_variable,
    @real@ manipulated_variable)
{
    if (!is_finite(setpoint) || !is_finite(controlled_variable)
        || !@name@_switch_on(state, settings, manipulated_variable)) {
        return false;
    }
    state->setpoint = setpoint;
    state->controlled_variable = controlled_variable;
    state->pid.sampled = true;
    state->pid.sample_setpoint = setpoint;
    state->pid.sample_controlled_variable = pid_seen(state);
    if (state->law.has_observer) {
        /* At rest it is the load estimate that holds the output, not the integral. */
        observer_start(state, controlled_variable, state->observer.load_estimate);
    }
    seat(state, state->manipulated_variable);
    /* A prediction at rest has nothing under way. */
    if (!(state->law.has_observer && state->law.observer.predicts)) {
        line_fill(state, state->unassisted);
    }
    state->follows = true;
    state->automatic = true;
    return true;
}

/* A new measurement in automatic, no feed-forward, the returned output applied. */
@name@_input @name@_automatic(@real@ sample_period, @real@ setpoint, @real@ controlled_variable)
{
    const @name@_input input = {
        sample_period, setpoint, true, controlled_variable, 0, false, 0, @NAME@_AUTOMATIC, 0};
    return input;
}

static @name@_output answer(const @name@_state *state, @name@_limited limited, @name@_status status)
{
    const @name@_output output = {
        state->manipulated_variable, state->wanted, limited,
        state->law.has_observer ? state->observer.load_estimate : 0, status};
    return output;
}

/* The output that the operator asks for: the last one where none is asked for. */
static @real@ operator_output(const @name@_state *state, const @name@_input *input)
{
    return input->mode == @NAME@_MANUAL && is_finite(input->manual_output) ? input->manual_output
                                                                           : state->manipulated_variable;
}

/* Takes setpoint and feed-forward where they are good, and says whether all inputs but the measurement are. */
static @name@_status take(@name@_state *state, const @name@_input *input)
{
    bool good = true;
    if (is_finite(input->setpoint)) {
        state->setpoint = input->setpoint;
    } else {
        good = false;
    }
    if (is_finite(input->feed_forward)) {
        state->feed_forward = input->feed_forward;
    } else {
        good = false;
    }
    if (input->applied_known && !is_finite(input->applied)) {
        good = false;
    }
    if (input->mode == @NAME@_MANUAL && !is_finite(input->manual_output)) {
        good = false;
    }
    return good ? @NAME@_GOOD : @NAME@_INPUT_REJECTED;
}

/* The update without a measurement to go by: the law stands still, and starts again without bump. */
static @name@_output without_measurement(
    @name@_state *state, const @name@_input *input, @name@_status status)
{
    @real@ target = operator_output(state, input);
    @name@_limited limited = @NAME@_FREE;
    state->follows = false;
    if (state->watch.has_failure && state->age.value > state->watch.failure_time) {
        status = @NAME@_MEASUREMENT_FAILED;
        if (input->mode == @NAME@_AUTOMATIC) {
            target = state->watch.safe_output;
        }
    }
    state->manipulated_variable =
        limits_apply(&state->limits, target, state->manipulated_variable, input->sample_period, &limited);
    return answer(state, limited, status);
}

/*
 * One update: takes the measurement, returns the manipulated variable.
 *
 * In this order: the observer's model runs on to now; the measurement is judged; the terms move; the wanted output
 * is their sum; the output is what the limits leave of it. The integral and the model learn what was applied at the
 * next update.
 */
@name@_output @name@_update(
    @name@_state *state, const @name@_settings *settings, const @name@_input *input)
{
    const @real@ h = input->sample_period;
    const bool settings_are_good = !@name@_fault(settings);
    @name@_limited limited = @NAME@_FREE;
    if (settings_are_good) {
        /* Limits and watch hold at once, the law from the next good sample on. */
        state->limits = settings->limits;
        state->watch = settings->watch;
    }
    if (!is_positive(h)) {
        state->manipulated_variable = limits_within(&state->limits, state->manipulated_variable, &limited);
        return answer(state, @NAME@_FREE, @NAME@_SAMPLE_PERIOD_REJECTED);
    }

    /* The time since the last update, with what was applied in it: while nothing limited, the model is driven by what
       the PID terms asked for, otherwise by what was applied and the load estimate, which leaves out what feed-forward
       and bias balance. */
    const @real@ applied =
        input->applied_known && is_finite(input->applied) ? input->applied : state->manipulated_variable;
    const @real@ shortfall = applied - state->wanted;
    if (state->law.has_observer) {
        @real@ drive = state->unassisted;
        if (shortfall != 0) {
            drive = applied + (state->observer.load_estimate - assistance(state));
        }
        if (!is_finite(drive)) {
            drive = applied;
        }
        observer_advance(state, drive, h);
    }
    @name@_status status = take(state, input);
    if (!settings_are_good) {
        status = @NAME@_SETTINGS_REJECTED;
    }

    /* The measurement. */
    const @name@_watch *const watch = &state->watch;
    const @name@_sum age = state->age;
    sum_add(&state->age, h);
    if (!is_finite(state->age.value)) {
        state->age = age;
    }
    const @real@ elapsed = state->age.value;
    const bool late = watch->has_stale_time && (elapsed > watch->stale_time || h > watch->stale_time);
    const @real@ measured = input->controlled_variable;
    const bool fresh = input->measured && is_finite(measured)
        && (!watch->has_range || (watch->range_low <= measured && measured <= watch->range_high));
    if (input->measured && !fresh) {
        return without_measurement(state, input, @NAME@_MEASUREMENT_REJECTED);
    }
    if (!input->measured && (late || !state->follows)) {
        return without_measurement(state, input, @NAME@_MEASUREMENT_STALE);
    }
    const bool start = !state->follows || (late && fresh);
    const bool by_law = input->mode == @NAME@_AUTOMATIC && state->automatic && !start;
    const @name@_pid_state pid_before = state->pid;
    const @name@_observer_state observer_before = state->observer;
    const @real@ controlled_variable_before = state->controlled_variable;
    const @real@ unassisted_before = state->unassisted;
    const @real@ wanted_before = state->wanted;

    /* The terms. */
    if (fresh) {
        state->controlled_variable = measured;
        if (state->law.has_observer) {
            if (start) {
                observer_start(state, measured, state->observer.load_estimate);
            } else {
                observer_measure(state, measured, elapsed);
            }
        }
        if (!by_law) {
            /* The setpoint moved while the law was not in charge: that gives no derivative action later. */
            state->pid.sample_setpoint = state->setpoint;
        }
        pid_measure(state, pid_seen(state), elapsed);
    }
    pid_integrate(state, shortfall, h);
    pid_bleed(state, h);

    /* The wanted output; by whom it is computed decides what gives way. */
    const @real@ bumpless = limits_apply(
        &state->limits, operator_output(state, input), state->manipulated_variable, h, &limited);
    if (by_law) {
        state->unassisted = pid_proportional_derivative(state) + state->pid.integral.value;
        state->wanted = state->unassisted + (assistance(state) - state->observer.load_estimate);
    }
    const @real@ target = by_law ? state->wanted : bumpless;
    bool gives_way = !by_law;
    if (settings_are_good
        && !(same_pid(&state->law.pid, &settings->law.pid) && same_observer(&state->law, &settings->law))) {
        if (line_is_long_enough(&settings->law)) {
            adopt(state, &settings->law);
            gives_way = true;
        } else {
            status = @NAME@_SETTINGS_REJECTED;
        }
    }
    if (gives_way) {
        seat(state, target);
    }
    if (!(is_finite(state->wanted) && is_finite(state->unassisted))) {
        state->pid = pid_before;
        state->observer = observer_before;
        state->controlled_variable = controlled_variable_before;
        state->unassisted = unassisted_before;
        state->wanted = wanted_before;
        return without_measurement(state, input, @NAME@_MEASUREMENT_REJECTED);
    }

    /* The output. */
    state->manipulated_variable = by_law
        ? limits_apply(&state->limits, state->wanted, state->manipulated_variable, h, &limited)
        : bumpless;
    if (fresh) {
        state->age = sum_of(0);
    }
    state->follows = true;
    state->automatic = input->mode == @NAME@_AUTOMATIC;
    return answer(state, limited, status);
}

#endif
