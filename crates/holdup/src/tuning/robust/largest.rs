//! The largest family that keeps a sensitivity peak.

use super::touching::Boxes;
use crate::analysis::frequency::FrequencyError;
use crate::analysis::frequency::family::{Family, Goal, worst_case};
use crate::model::{Controller, Process};
use crate::tuning::line::boundary;

/// Relative width at which the bisection ends.
const FINEST: f64 = 1e-6;
/// How far below the size that touches the peak it is proven to be kept, and above it to be exceeded, relative.
const APART: f64 = 1e-7;
/// Sizes beyond this are not looked for: the family is then said to be unlimited.
const GREATEST: f64 = 1e3;
/// A sensitivity peak so many times that allowed says no more than that it is exceeded.
const FAR: f64 = 3.0;
/// A family whose least factor is below this is limited by zero.
const NEAR_ZERO: f64 = 1e-3;

/// The largest family of a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Largest {
    /// Factor on the distance of every factor from 1 \[–\], proven to be allowed; within 1e-6 of one that is not.
    pub size: f64,
    /// The family of that size.
    pub family: Family,
    /// Whether its least gain or dead time is nearly 0 (a thousandth of the nominal), so that not the peak limits it.
    pub limited_by_zero: bool,
}

/// The largest multiple of a family whose every member is proven to keep this sensitivity peak; `None` where even the
/// nominal loop does not.
///
/// ```
/// use holdup::analysis::frequency::family::Family;
/// use holdup::model::{Controller, Process, Seconds};
/// use holdup::tuning::robust::largest_family;
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let p = Controller::proportional(0.3)?;
/// let shape = Family::ranges([0.9, 1.1], [0.9, 1.1])?;
/// let largest = largest_family(&process, &p, &shape, 2.0)?.unwrap();
/// assert!(largest.size > 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FrequencyError`] if the numbers of the loop are out of the reach of double precision.
pub fn largest_family(
    process: &Process,
    controller: &Controller,
    shape: &Family,
    sensitivity_peak: f64,
) -> Result<Option<Largest>, FrequencyError> {
    let keeps = |family: &Family| {
        worst_case(process, controller, family, Goal::AtMost(sensitivity_peak)).map(|found| found.stable)
    };
    let allowed = |size: f64| shape.scaled(size).map_or(Ok(false), |family| keeps(&family));
    if !allowed(0.0)? {
        return Ok(None);
    }
    let boxes = Boxes::new(process, shape, sensitivity_peak);
    let touching = boxes.map(|boxes| boxes.touching(controller, most(shape))).transpose()?;
    let size = match touching.map(|touching| touching.size) {
        // A little less is proven, and a little more is proven to be too much.
        Some(size)
            if allowed(size * (1.0 - APART))? && (size >= GREATEST || !allowed(size * (1.0 + APART))?) =>
        {
            size * (1.0 - APART)
        }
        _ => {
            let size = searched(process, controller, shape, sensitivity_peak);
            if !allowed(size)? {
                return Ok(None);
            }
            size
        }
    };
    let Ok(family) = shape.scaled(size) else { return Ok(None) };
    let limited_by_zero = family.gain()[0].min(family.dead_time()[0]) < NEAR_ZERO;
    Ok(Some(Largest { size, family, limited_by_zero }))
}

/// The size of the largest family, proven. `None` where not even the nominal loop keeps the peak.
pub(crate) fn proven_size(
    process: &Process,
    controller: &Controller,
    shape: &Family,
    sensitivity_peak: f64,
) -> Option<f64> {
    Some(largest_family(process, controller, shape, sensitivity_peak).ok()??.size)
}

/// The greatest size that is looked for, at which a factor becomes 0 at the latest.
pub(crate) fn most(shape: &Family) -> f64 {
    let least = shape.gain()[0].min(shape.dead_time()[0]);
    if least < 1.0 { GREATEST.min(1.0 / (1.0 - least)) } else { GREATEST }
}

/// The size found by worst cases alone, each proven.
fn searched(process: &Process, controller: &Controller, shape: &Family, sensitivity_peak: f64) -> f64 {
    // By how much the worst member keeps the peak; sizes that are no family, or far too large, are outside.
    let slack = |size: f64| -> f64 {
        let peak = shape.scaled(size).ok().and_then(|family| {
            let at_most = Goal::AtMost(FAR * sensitivity_peak);
            let near = worst_case(process, controller, &family, at_most).is_ok_and(|found| found.stable);
            let worst = || worst_case(process, controller, &family, Goal::Worst).ok()?.sensitivity_peak;
            near.then(worst).flatten()
        });
        peak.map_or(f64::NEG_INFINITY, |peak| sensitivity_peak / peak - 1.0)
    };
    // First a size that is too large, doubling; then the limit between it and the last that is allowed.
    let (mut inside, mut size) = ((0.0, slack(0.0)), 1.0);
    let outside = loop {
        let here = (size, slack(size));
        if here.1 < 0.0 || size > GREATEST {
            break here;
        }
        (inside, size) = (here, 2.0 * size);
    };
    if outside.1 < 0.0 {
        boundary(inside, outside, (FINEST, 0.1 * FINEST), &mut |size| slack(size))
    } else {
        inside.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::frequency::margins;
    use crate::model::{ClosedLoop, Seconds};

    #[test]
    fn the_gain_range_of_proportional_control_ends_where_its_peak_is_reached() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let p = Controller::proportional(0.3).unwrap();
        let shape = Family::ranges([1.0, 1.1], [1.0, 1.0]).unwrap();
        let largest = largest_family(&process, &p, &shape, 2.0).unwrap().unwrap();
        let factor = largest.family.gain()[1];
        let peak = |factor: f64| {
            let member = process.perturbed(factor, 1.0).unwrap();
            margins(&ClosedLoop::new(&member, &p)).unwrap().sensitivity_peak.unwrap()
        };
        // The bisection ends within 1e-6 of the size, some 10, of which the factor moves by a tenth.
        assert!(peak(factor) <= 2.0 && peak(factor + 5e-6) > 2.0, "{largest:?}");
        assert!(!largest.limited_by_zero);
    }

    #[test]
    fn a_nominal_loop_above_the_limit_has_no_family() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let p = Controller::proportional(0.9).unwrap();
        let shape = Family::ranges([0.9, 1.1], [0.9, 1.1]).unwrap();
        assert_eq!(largest_family(&process, &p, &shape, 1.5).unwrap(), None);
    }

    #[test]
    fn a_family_may_end_at_zero() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let p = Controller::proportional(0.3).unwrap();
        let shape = Family::ranges([0.9, 1.0], [1.0, 1.0]).unwrap();
        let largest = largest_family(&process, &p, &shape, 2.0).unwrap().unwrap();
        assert!(largest.limited_by_zero && (largest.size - 10.0).abs() < 2e-5, "{largest:?}");
    }
}
