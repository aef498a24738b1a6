//! Draws one figure of each kind into a folder (SVG, PNG, a page) and on the terminal:
//! `cargo run -p holdup --features report --example figures -- /tmp/figures`
use holdup::study::figures::page::{Column, Page, Section, Table};
use holdup::study::figures::{Axis, Figure, FigureError, Line, Mark, Panel, Reference, Series, Tone};
use holdup::study::figures::{png, svg, terminal};
use holdup::study::output::write_atomically;
use std::error::Error;
use std::f64::consts::PI;
use std::path::PathBuf;

const DEAD_TIME: f64 = 6.0;
const GAIN: f64 = 0.0506;
const CONTROLLERS: [(&str, f64, f64); 4] = [
    ("Proposed PD", 1.53, 1.03),
    ("Wang–Cluett, ζ = 1", 1.20, 0.50),
    ("Sree–Chidambaram", 1.85, 1.60),
    ("Ali–Majhi", 1.0, 0.2),
];

/// A rough march in small steps: the curves only have to look like responses.
fn response(kc: f64, td: f64, load_at: f64, horizon: f64) -> (Vec<f64>, Vec<f64>) {
    let (h, delay) = (0.05, 120_usize);
    let (mut y, mut last, mut pending) = (0.0, 0.0, vec![0.0; delay]);
    let (mut times, mut levels) = (Vec::new(), Vec::new());
    for (k, step) in (0_u32..).take_while(|k| f64::from(*k) * h <= horizon).enumerate() {
        let t = f64::from(step) * h;
        let u = kc * (1.0 - y) - kc * td * (y - last) / h + if t >= load_at { 0.4 } else { 0.0 };
        last = y;
        y += h * GAIN * pending[k % delay];
        pending[k % delay] = u;
        times.push(t);
        levels.push(last);
    }
    (times, levels)
}

fn tracking() -> Result<Figure, FigureError> {
    let mut panel = Panel::new(Axis::linear("time [s]"), Axis::linear("controlled variable y [m]"))
        .with_reference(Reference::vertical(150.0, "load step")?);
    let setpoint = Series::new("setpoint", vec![0.0, 300.0], vec![1.0, 1.0])?;
    panel = panel.with_series(setpoint.with_tone(Tone::Neutral).with_width(1.5)?);
    for (name, kc, td) in CONTROLLERS {
        let (t, y) = response(kc, td, 150.0, 300.0);
        panel = panel.with_series(Series::new(name, t, y)?);
    }
    Figure::new("Setpoint step at 0 s, load step at 150 s", vec![panel])
}

fn loop_gain(kc: f64, td: f64, w: f64) -> (f64, f64) {
    let magnitude = GAIN * kc * (1.0 + (td * w).powi(2)).sqrt() / w;
    (magnitude, (td * w).atan() - PI / 2.0 - DEAD_TIME * w)
}

fn frequencies() -> impl Iterator<Item = f64> {
    (0..=1500).map(|k| 10_f64.powf(-3.0 + f64::from(k) / 500.0))
}

fn nyquist() -> Result<Figure, FigureError> {
    let mut panel = Panel::new(
        Axis::linear("Re L(jω) [–]").with_range(-2.5, 1.0)?,
        Axis::linear("Im L(jω) [–]").with_range(-2.0, 1.0)?,
    )
    .with_equal_aspect()
    .with_reference(Reference::circle((-1.0, 0.0), 0.5, "sensitivity peak Mₛ = 2")?);
    for (name, kc, td) in CONTROLLERS {
        let points = frequencies().map(|w| loop_gain(kc, td, w)).map(|(m, p)| (m * p.cos(), m * p.sin()));
        let (re, im) = points.unzip();
        panel = panel.with_series(Series::new(name, re, im)?);
    }
    let critical = Series::new("critical point −1", vec![-1.0], vec![0.0])?;
    panel = panel.with_series(critical.as_marks(Mark::Cross).with_tone(Tone::Neutral));
    Figure::new("Nyquist plot of the loop broken at the process input", vec![panel])
}

fn bode() -> Result<Figure, FigureError> {
    let w: Vec<f64> = frequencies().take_while(|w| *w <= 1.0).collect();
    let x = || Axis::logarithmic("frequency ω [rad/s]");
    let mut gain = Panel::new(x(), Axis::logarithmic("gain |L(jω)| [–]"))
        .with_reference(Reference::horizontal(1.0, "gain 1")?);
    let mut phase = Panel::new(x(), Axis::linear("phase of L(jω) [°]").with_tick_step(45.0)?)
        .with_reference(Reference::horizontal(-180.0, "−180°")?);
    for (name, kc, td) in CONTROLLERS {
        let (m, p) = w.iter().map(|w| loop_gain(kc, td, *w)).map(|(m, p)| (m, p.to_degrees())).unzip();
        gain = gain.with_series(Series::new(name, w.clone(), m)?);
        phase = phase.with_series(Series::new(name, w.clone(), p)?);
    }
    Figure::new("Bode plot of the loop broken at the process input", vec![gain, phase])
}

fn load() -> Result<Figure, FigureError> {
    let t: Vec<f64> = (0..=600).map(|k| f64::from(k) * 0.5).collect();
    let estimate = t.iter().map(|t| if *t < 106.0 { 0.0 } else { 1.0 - (-(t - 106.0) / 12.0).exp() });
    let estimate = Series::new("estimate D̂", t.clone(), estimate.collect())?;
    let truth = Series::new("load D", vec![0.0, 100.0, 300.0], vec![0.0, 1.0, 1.0])?;
    let panel = Panel::new(Axis::linear("time [s]"), Axis::linear("load at the process input [%]"))
        .with_series(truth.held().with_tone(Tone::Neutral).with_line(Line::Dashed))
        .with_series(estimate);
    Figure::new("A load and its estimate", vec![panel])
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "/tmp/figures".into()));
    std::fs::create_dir_all(&folder)?;
    let figures = [("tracking", tracking()?), ("nyquist", nyquist()?), ("bode", bode()?), ("load", load()?)];
    let columns = ["controller", "Kc [–]", "Td [s]", "IAE [m·s]", "% of the best possible", "remark"];
    let kinds = columns.map(|name| (name.to_owned(), Column::Numbers));
    let kinds = kinds.into_iter().map(|(name, kind)| match name.as_str() {
        "controller" | "remark" => (name, Column::Words),
        _ => (name, kind),
    });
    let rows = CONTROLLERS.map(|(name, kc, td)| {
        let remark = "The specification on the phase is not met because the sign of Td was dropped.";
        vec![
            name.into(),
            format!("{kc:.4}"),
            format!("{td:.4}"),
            format!("{:.2}", 20.0 / kc),
            "41.3".into(),
            remark.into(),
        ]
    });
    let table = Table::new("Setpoint step", kinds.collect(), rows.to_vec())?;
    let mut page = Page::new("A tank level: four controllers <script>alert(1)</script>")
        .with_introduction("Process gain 0.0506 m/(s·m³/s), dead time 6 s.")
        .with_section(
            Section::new("Findings")
                .with_paragraph(
                    "The proposed controller has the smallest IAE of the four. Nothing here is approximate.",
                )
                .with_list(vec!["Two cells are impossible.".into(), "Five cells are not reproduced.".into()])
                .with_code("holdup compare studies/kadam-2017.toml --report kadam-2017.html")
                .with_table(table),
        );
    let mut section = Section::new("Responses and loop gains");
    for (name, figure) in figures {
        println!("{}", terminal::chart(&figure, 80, false));
        write_atomically(&folder.join(format!("{name}.svg")), svg::document(&figure).as_bytes())?;
        write_atomically(&folder.join(format!("{name}.png")), &png::bytes(&figure, 2.0)?)?;
        section = section.with_figure(figure);
    }
    page = page.with_section(section);
    write_atomically(&folder.join("page.html"), page.html().as_bytes())?;
    Ok(())
}
