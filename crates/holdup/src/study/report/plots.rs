//! The figures of a report, from loops and scenarios.

use super::ReportError;
use crate::analysis::frequency::{FrequencyPoint, LoopTransfer};
use crate::analysis::response::{Scenario, Trajectory, plot_times, trajectory};
use crate::model::ClosedLoop;
use crate::study::figures::{Axis, Figure, Line, Mark, Panel, Reference, Series, Tone};

/// Points of a drawn response; the breakpoints come on top.
pub(super) const POINTS: usize = 900;

/// A loop with the name it has in the legend.
#[derive(Debug, Clone)]
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// The loop.
    pub closed_loop: ClosedLoop,
}

/// Controlled and manipulated variable over time, setpoint included.
///
/// # Errors
/// [`ReportError`] if a loop cannot be simulated or a value cannot be drawn.
pub fn response(title: &str, scenario: &Scenario, curves: &[Curve]) -> Result<Figure, ReportError> {
    response_with(title, scenario, curves, Vec::new())
}

/// The same with other runs of the scenario, by name.
///
/// # Errors
/// As [`response`].
pub fn response_with(
    title: &str,
    scenario: &Scenario,
    curves: &[Curve],
    others: Vec<(String, Trajectory)>,
) -> Result<Figure, ReportError> {
    let mut runs = runs(scenario, curves)?;
    runs.extend(others);
    let mut y = Panel::new(Axis::linear("time [s]"), Axis::linear("controlled variable y"));
    let mut inputs = Vec::new();
    if let Some((_, first)) = runs.first() {
        let setpoint = Series::new("setpoint r", first.time.clone(), first.setpoint.clone())?;
        y = y.with_series(setpoint.with_tone(Tone::Neutral).with_line(Line::Dashed).with_width(1.5)?);
    }
    for (index, (name, run)) in runs.iter().enumerate() {
        let series = Series::new(name, run.time.clone(), run.controlled_variable.clone())?;
        y = y.with_series(series.with_tone(Tone::Slot(index)));
        let series = Series::new(name, run.time.clone(), run.manipulated_variable.clone())?;
        inputs.push((series.with_tone(Tone::Slot(index)), run.manipulated_variable.as_slice()));
    }
    let values: Vec<&[f64]> = inputs.iter().map(|(_, values)| *values).collect();
    let mut u = Panel::new(Axis::linear("time [s]"), input_axis(&values)?);
    for (series, _) in inputs {
        u = u.with_series(series);
    }
    for (time, _) in scenario.load_moves() {
        if time > 0.0 {
            y = y.with_reference(Reference::vertical(time, "load step")?);
        }
    }
    Ok(Figure::new(title, vec![y, u])?)
}

/// The load and what each observer makes of it; `None` where no loop has an observer.
///
/// # Errors
/// As [`response`].
pub fn load_estimate(
    title: &str,
    scenario: &Scenario,
    curves: &[Curve],
) -> Result<Option<Figure>, ReportError> {
    let mut panel = Panel::new(Axis::linear("time [s]"), Axis::linear("load D at the process input"));
    let mut drawn = false;
    for (index, (name, run)) in runs(scenario, curves)?.into_iter().enumerate() {
        let Some(estimate) = run.load_estimate else { continue };
        if !drawn {
            let load = Series::new("load D", run.time.clone(), run.load)?;
            panel = panel.with_series(load.with_tone(Tone::Neutral).with_line(Line::Dashed));
            drawn = true;
        }
        let series = Series::new(format!("estimate D̂, {name}"), run.time, estimate)?;
        panel = panel.with_series(series.with_tone(Tone::Slot(index)));
    }
    Ok(if drawn { Some(Figure::new(title, vec![panel])?) } else { None })
}

/// Nyquist plot of loops broken at the process input, with the circle that a sensitivity peak of `peak` touches.
///
/// # Errors
/// [`ReportError`] if a loop's transfer function is out of reach.
pub fn nyquist(title: &str, curves: &[Curve], peak: f64) -> Result<Figure, ReportError> {
    let mut panel = Panel::new(
        Axis::linear("Re L(jω) [–]").with_range(-2.6, 1.0)?,
        Axis::linear("Im L(jω) [–]").with_range(-2.2, 1.0)?,
    )
    .with_equal_aspect()
    .with_reference(Reference::circle((-1.0, 0.0), 1.0 / peak, format!("M_s = {peak:.2}"))?);
    for (index, curve) in curves.iter().enumerate() {
        let points = loop_points(&curve.closed_loop)?;
        let (re, im) = points.iter().map(|p| (p.value.re, p.value.im)).unzip();
        panel = panel.with_series(Series::new(&curve.name, re, im)?.with_tone(Tone::Slot(index)));
    }
    let critical = Series::new("critical point −1", vec![-1.0], vec![0.0])?;
    panel = panel.with_series(critical.as_marks(Mark::Cross).with_tone(Tone::Neutral));
    Ok(Figure::new(title, vec![panel])?)
}

/// Bode plot of loops broken at the process input.
///
/// # Errors
/// As [`nyquist`].
pub fn bode(title: &str, curves: &[Curve]) -> Result<Figure, ReportError> {
    let x = || Axis::logarithmic("frequency ω [rad/s]");
    let mut gain = Panel::new(x(), Axis::logarithmic("gain |L(jω)| [–]"))
        .with_reference(Reference::horizontal(1.0, "gain 1")?);
    let mut phase =
        Panel::new(x(), Axis::linear("phase of L(jω) [°]").with_range(-540.0, 0.0)?.with_tick_step(90.0)?)
            .with_reference(Reference::horizontal(-180.0, "−180°")?);
    for (index, curve) in curves.iter().enumerate() {
        let points = loop_points(&curve.closed_loop)?;
        let frequency: Vec<f64> = points.iter().map(|p| p.omega).collect();
        let magnitude = points.iter().map(|p| p.value.norm()).collect();
        let gain_series = Series::new(&curve.name, frequency.clone(), magnitude)?;
        gain = gain.with_series(gain_series.with_tone(Tone::Slot(index)));
        let phase_series = Series::new(&curve.name, frequency, unwrapped(&points))?;
        phase = phase.with_series(phase_series.with_tone(Tone::Slot(index)));
    }
    Ok(Figure::new(title, vec![gain, phase])?)
}

/// L(jω) from far below the crossovers to far above.
fn loop_points(closed_loop: &ClosedLoop) -> Result<Vec<FrequencyPoint>, ReportError> {
    let dead_time = closed_loop.channels().iter().map(|c| c.delay).fold(0.0, f64::max);
    Ok(LoopTransfer::new(closed_loop)?.curve(0.005 / dead_time, 12.0 / dead_time, 2e-3))
}

/// The phase [deg] along the points without jumps of 360°, starting between −360° and 0°.
fn unwrapped(points: &[FrequencyPoint]) -> Vec<f64> {
    let mut turns = 0.0;
    let mut last: Option<f64> = None;
    points
        .iter()
        .map(|p| {
            let raw = p.value.arg().to_degrees();
            match last {
                None if raw > 0.0 => turns = -360.0,
                Some(before) if raw - before > 180.0 => turns -= 360.0,
                Some(before) if raw - before < -180.0 => turns += 360.0,
                _ => {}
            }
            last = Some(raw);
            raw + turns
        })
        .collect()
}

fn runs(scenario: &Scenario, curves: &[Curve]) -> Result<Vec<(String, Trajectory)>, ReportError> {
    curves
        .iter()
        .map(|curve| {
            let times = plot_times(&curve.closed_loop, scenario, POINTS);
            Ok((curve.name.clone(), trajectory(&curve.closed_loop, scenario, &times)?))
        })
        .collect()
}

/// Axis of the manipulated variable. A filtered derivative kicks for a few hundredths of a second, hundreds of
/// times the rest: then the axis shows the rest and says that peaks are cut.
fn input_axis(curves: &[&[f64]]) -> Result<Axis, ReportError> {
    let mut values: Vec<f64> =
        curves.iter().flat_map(|c| c.iter().copied()).filter(|v| v.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    let label = "manipulated variable u";
    let (Some(&lowest), Some(&highest)) = (values.first(), values.last()) else {
        return Ok(Axis::linear(label));
    };
    let (low, high) = (values[values.len() / 50], values[values.len() - 1 - values.len() / 50]);
    let span = high - low;
    if span <= 0.0 || highest - lowest <= 4.0 * span {
        return Ok(Axis::linear(label));
    }
    let (low, high) = (lowest.max(low - 0.6 * span), highest.min(high + 0.6 * span));
    Ok(Axis::linear("manipulated variable u (peaks cut)").with_range(low, high)?)
}
