//! The manipulated variable between its samples, and its exact integrals.

use super::kind::Hold;

/// The manipulated variable less its mean, as a function of time, with its first and second integral from the first
/// sample on. Before the first sample it stands at its first value, after the last at its last.
#[derive(Debug, Clone)]
pub(crate) struct Input<'r> {
    time: &'r [f64],
    value: Vec<f64>,
    slope: Option<Vec<f64>>,
    first: Vec<f64>,
    second: Vec<f64>,
}

/// What a process makes of its input before gain and dead time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    /// 1/s.
    Integral,
    /// 1/(s(Ts + 1)).
    LaggedIntegral(f64),
    /// 1/s².
    DoubleIntegral,
    /// 1/(Ts + 1).
    Lag(f64),
    /// 1: the input itself.
    Value,
    /// s/(Ts + 1).
    LagRate(f64),
}

impl Shape {
    /// The shape of the derivative with respect to time.
    pub(crate) fn rate(self) -> Self {
        match self {
            Self::Integral | Self::Value => Self::Value,
            Self::LaggedIntegral(lag) => Self::Lag(lag),
            Self::DoubleIntegral => Self::Integral,
            Self::Lag(lag) | Self::LagRate(lag) => Self::LagRate(lag),
        }
    }
}

impl<'r> Input<'r> {
    /// The input of these samples. The mean is taken off: a constant input gives a column that initial value and
    /// constant load span, and without it the integrals stay small.
    pub(crate) fn new(time: &'r [f64], samples: &[f64], hold: Hold) -> Self {
        let rows = time.len();
        let span = time[rows - 1] - time[0];
        let area = |k: usize| samples[k] * (time[k + 1] - time[k]);
        let mean = (0..rows - 1).map(area).sum::<f64>() / span;
        let value: Vec<f64> = samples.iter().map(|sample| sample - mean).collect();
        let slope = (hold == Hold::Linear).then(|| {
            let between = |k: usize| (value[k + 1] - value[k]) / (time[k + 1] - time[k]);
            (0..rows).map(|k| if k + 1 < rows { between(k) } else { 0.0 }).collect::<Vec<f64>>()
        });
        let (mut first, mut second) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
        let (mut once, mut twice) = (0.0, 0.0);
        for k in 0..rows {
            first.push(once);
            second.push(twice);
            if k + 1 < rows {
                let step = time[k + 1] - time[k];
                let bend = slope.as_ref().map_or(0.0, |slope| slope[k]);
                twice += step * (once + step * (value[k] / 2.0 + step * bend / 6.0));
                once += step * (value[k] + step * bend / 2.0);
            }
        }
        Self { time, value, slope, first, second }
    }

    /// The shape of the input at the times less `delay`; the times must not decrease.
    pub(crate) fn column(&self, shape: Shape, delay: f64, times: &[f64]) -> Vec<f64> {
        let lagged = match shape {
            Shape::LaggedIntegral(lag) | Shape::Lag(lag) | Shape::LagRate(lag) => self.lagged(lag),
            _ => Vec::new(),
        };
        let mut place = 0;
        times.iter().map(|time| self.at(shape, &lagged, time - delay, &mut place)).collect()
    }

    /// The lagged input at the samples, at rest on the first value before them.
    fn lagged(&self, lag: f64) -> Vec<f64> {
        let mut state = self.value[0];
        let mut states = Vec::with_capacity(self.value.len());
        for k in 0..self.value.len() {
            states.push(state);
            if k + 1 < self.value.len() {
                state = self.lag_after(k, state, self.time[k + 1] - self.time[k], lag);
            }
        }
        states
    }

    /// The lagged input so long after sample `k`, from its state there.
    fn lag_after(&self, k: usize, state: f64, after: f64, lag: f64) -> f64 {
        let bend = self.slope.as_ref().map_or(0.0, |slope| slope[k]);
        let quasi = self.value[k] - bend * lag;
        quasi + bend * after + (state - quasi) * (-after / lag).exp()
    }

    fn at(&self, shape: Shape, lagged: &[f64], time: f64, place: &mut usize) -> f64 {
        let after = time - self.time[0];
        if after <= 0.0 {
            let value = self.value[0];
            return match shape {
                Shape::Integral | Shape::LaggedIntegral(_) => value * after,
                Shape::DoubleIntegral => value * after * after / 2.0,
                Shape::Lag(_) | Shape::Value => value,
                Shape::LagRate(_) => 0.0,
            };
        }
        while *place + 1 < self.time.len() && self.time[*place + 1] <= time {
            *place += 1;
        }
        let k = *place;
        let after = time - self.time[k];
        let bend = self.slope.as_ref().map_or(0.0, |slope| slope[k]);
        let value = self.value[k];
        let once = || self.first[k] + after * (value + after * bend / 2.0);
        match shape {
            Shape::Value => value + bend * after,
            Shape::Integral => once(),
            Shape::DoubleIntegral => {
                self.second[k] + after * (self.first[k] + after * (value / 2.0 + after * bend / 6.0))
            }
            Shape::Lag(lag) => self.lag_after(k, lagged[k], after, lag),
            Shape::LaggedIntegral(lag) => {
                once() - lag * (self.lag_after(k, lagged[k], after, lag) - self.value[0])
            }
            Shape::LagRate(lag) => (value + bend * after - self.lag_after(k, lagged[k], after, lag)) / lag,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIME: [f64; 5] = [0.0, 1.0, 1.5, 4.0, 5.0];
    const VALUE: [f64; 5] = [1.0, 3.0, -2.0, 0.5, 0.0];

    /// Each shape is the derivative of the one that it is the rate of, by central differences; the step of 1e-4 leaves
    /// an error of 1e-8 times a third derivative of order 1.
    #[test]
    fn every_shape_is_the_integral_of_its_rate() {
        for hold in [Hold::Constant, Hold::Linear] {
            let input = Input::new(&TIME, &VALUE, hold);
            for shape in [Shape::Integral, Shape::LaggedIntegral(0.7), Shape::DoubleIntegral, Shape::Lag(0.7)]
            {
                for time in [-0.5, 0.4, 1.2, 2.9, 4.7, 6.0] {
                    let near = input.column(shape, 0.3, &[time - 1e-4, time + 1e-4]);
                    let rate = input.column(shape.rate(), 0.3, &[time])[0];
                    assert!(((near[1] - near[0]) / 2e-4 - rate).abs() < 1e-6, "{shape:?} at {time}");
                }
            }
        }
    }

    #[test]
    fn a_lag_is_the_input_less_the_lag_times_its_rate() {
        let input = Input::new(&TIME, &VALUE, Hold::Constant);
        for time in [0.2, 1.7, 4.4] {
            let [value, lag, rate] = [Shape::Value, Shape::Lag(0.9), Shape::LagRate(0.9)]
                .map(|s| input.column(s, 0.0, &[time])[0]);
            assert!((value - lag - 0.9 * rate).abs() < 1e-14);
        }
    }
}
