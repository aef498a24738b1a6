/* Settings: whether they are the same, and whether a controller can run with them. */

/* Same value, or both absent. */
static bool same(bool has, @real@ value, bool other_has, @real@ other)
{
    return has == other_has && (!has || value == other);
}

static bool same_pid(const @name@_pid *one, const @name@_pid *other)
{
    const bool derivatives = one->has_derivative && other->has_derivative;
    return same(true, one->proportional_gain, true, other->proportional_gain)
        && same(true, one->setpoint_weight, true, other->setpoint_weight)
        && same(true, one->derivative_setpoint_weight, true, other->derivative_setpoint_weight)
        && same(one->has_integral, one->integral_time, other->has_integral, other->integral_time)
        && same(one->has_tracking_time, one->tracking_time, other->has_tracking_time, other->tracking_time)
        && same(one->has_derivative, one->derivative_time, other->has_derivative, other->derivative_time)
        && (!derivatives
            || same(one->has_derivative_filter, one->filter_time,
                    other->has_derivative_filter, other->filter_time))
        && same(true, one->bias, true, other->bias)
        && same(one->has_bleed_time, one->bleed_time, other->has_bleed_time, other->bleed_time);
}

static bool same_observer(const @name@_law *one, const @name@_law *other)
{
    const @name@_observer *const o = &one->observer;
    const @name@_observer *const p = &other->observer;
    if (!one->has_observer || !other->has_observer) {
        return one->has_observer == other->has_observer;
    }
    return same(true, o->observer_gain, true, p->observer_gain)
        && same(true, o->model_gain, true, p->model_gain)
        && same(true, o->dead_time, true, p->dead_time)
        && same(true, o->sample_period, true, p->sample_period)
        && o->predicts == p->predicts
        && same(o->has_lead, o->lead_time, p->has_lead, p->lead_time)
        && same(o->has_lead, o->lead_filter_time, p->has_lead, p->lead_filter_time);
}

static @real@ limits_within(const @name@_limits *limits, @real@ wanted, @name@_limited *limited)
{
    if (limits->has_high && wanted > limits->high) {
        *limited = @NAME@_AT_HIGH;
        return limits->high;
    }
    if (limits->has_low && wanted < limits->low) {
        *limited = @NAME@_AT_LOW;
        return limits->low;
    }
    return wanted;
}

/* The output nearest to the wanted one that may follow the last one after h [s]. Where a new output limit is beyond
   the rate's reach, the output limit wins. */
static @real@ limits_apply(
    const @name@_limits *limits, @real@ wanted, @real@ last, @real@ h, @name@_limited *limited)
{
    @real@ reachable = wanted;
    *limited = @NAME@_FREE;
    if (limits->has_rate) {
        const @real@ step = limits->rate * h;
        if (wanted > last + step) {
            reachable = last + step;
            *limited = @NAME@_AT_RATE;
        } else if (wanted < last - step) {
            reachable = last - step;
            *limited = @NAME@_AT_RATE;
        }
    }
    return limits_within(limits, reachable, limited);
}

/* The name of the first setting that no controller can run with; NULL where all are good. */
const char *@name@_fault(const @name@_settings *settings)
{
    const @name@_pid *const pid = &settings->law.pid;
    const @name@_observer *const observer = &settings->law.observer;
    const @name@_limits *const limits = &settings->limits;
    const @name@_watch *const watch = &settings->watch;
    @name@_limited limited = @NAME@_FREE;
    if (!is_finite(pid->proportional_gain) || pid->proportional_gain == 0) {
        return "proportional_gain";
    }
    if (!is_finite(pid->setpoint_weight)) {
        return "setpoint_weight";
    }
    if (!is_finite(pid->derivative_setpoint_weight)) {
        return "derivative_setpoint_weight";
    }
    if (pid->has_integral && !is_positive(pid->integral_time)) {
        return "integral_time";
    }
    if (pid->has_tracking_time && !(is_finite(pid->tracking_time) && pid->tracking_time >= 0)) {
        return "tracking_time";
    }
    if (pid->has_derivative && !(is_finite(pid->derivative_time) && pid->derivative_time >= 0)) {
        return "derivative_time";
    }
    if (pid->has_derivative && pid->has_derivative_filter && !is_positive(pid->filter_time)) {
        return "filter_time";
    }
    if (!is_finite(pid->bias)) {
        return "bias";
    }
    if (pid->has_bleed_time && !is_positive(pid->bleed_time)) {
        return "bleed_time";
    }
    if (settings->law.has_observer) {
        const @real@ model_gain = observer->model_gain;
        if (!is_finite(model_gain) || model_gain == 0) {
            return "model_gain";
        }
        if (!is_finite(observer->observer_gain) || observer->observer_gain == 0
            || (observer->observer_gain > 0) != (model_gain > 0)) {
            return "observer_gain";
        }
        if ((pid->proportional_gain > 0) != (model_gain > 0)) {
            return "proportional_gain";
        }
        if (!is_positive(observer->dead_time)) {
            return "dead_time";
        }
        if (!is_positive(observer->sample_period)) {
            return "sample_period";
        }
        if (observer->has_lead && !(is_finite(observer->lead_time) && observer->lead_time >= 0)) {
            return "lead_time";
        }
        if (observer->has_lead && !is_positive(observer->lead_filter_time)) {
            return "lead_filter_time";
        }
    }
    if (limits->has_low && !is_finite(limits->low)) {
        return "low";
    }
    if (limits->has_high && !is_finite(limits->high)) {
        return "high";
    }
    if (limits->has_low && limits->has_high && !(limits->low < limits->high)) {
        return "low";
    }
    if (limits->has_rate && !is_positive(limits->rate)) {
        return "rate";
    }
    if (watch->has_range
        && !(is_finite(watch->range_low) && is_finite(watch->range_high) && watch->range_low < watch->range_high)) {
        return "range_low";
    }
    if (watch->has_stale_time && !is_positive(watch->stale_time)) {
        return "stale_time";
    }
    if (watch->has_failure) {
        if (!is_positive(watch->failure_time)
            || (watch->has_stale_time && watch->failure_time < watch->stale_time)) {
            return "failure_time";
        }
        (void)limits_within(limits, watch->safe_output, &limited);
        if (!is_finite(watch->safe_output) || limited != @NAME@_FREE) {
            return "safe_output";
        }
    }
    return 0;
}

