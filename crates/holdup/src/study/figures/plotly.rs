//! A figure as the data and layout of plotly.js.
//!
//! Colours of text, grid and background are left to the page, which knows whether it is light or dark.
use super::figure::{Axis, Figure, Panel, Scale};
use super::palette::{NEUTRAL, css};
use super::scene::panels_height;
use super::series::{Line, Mark, Reference, Series, around};
use super::text::escape;
use super::view::{Span, View, views};
use serde_json::{Map, Value, json};

/// Writes the figure as `{"data": […], "layout": {…}}` for `Plotly.newPlot`, without its title: plotly.js does not
/// break lines, a heading does.
///
/// Values are rounded to nine digits, which no picture shows, to keep pages small.
///
/// # Examples
/// ```
/// use holdup::study::figures::{Axis, Figure, Panel, Series, plotly};
///
/// let level = Series::new("level", vec![0.0, 6.0, 30.0], vec![0.0, f64::NAN, 1.0])?;
/// let panel = Panel::new(Axis::linear("time [s]"), Axis::linear("level [m]")).with_series(level);
/// let figure = plotly::value(&Figure::new("A tank", vec![panel])?);
/// assert_eq!(figure["data"][0]["name"], "level");
/// assert!(figure["data"][0]["y"][1].is_null());
/// # Ok::<(), holdup::study::figures::FigureError>(())
/// ```
#[must_use]
pub fn value(figure: &Figure) -> Value {
    let mut named: Vec<&str> = Vec::new();
    let mut data = Vec::new();
    for (index, panel) in figure.panels().iter().enumerate() {
        data.extend(panel.references().iter().filter_map(|reference| circle(reference, index)));
        for series in panel.series() {
            let first = !series.name().is_empty() && !named.contains(&series.name());
            named.push(series.name());
            data.push(trace(figure, series, index, first, &hover(panel)));
        }
    }
    json!({ "data": data, "layout": layout(figure) })
}

fn axis_name(letter: char, index: usize) -> String {
    if index == 0 { letter.to_string() } else { format!("{letter}{}", index + 1) }
}

/// What is shown beside the pointer: the name and the value with its unit, of a plane both coordinates.
fn hover(panel: &Panel) -> String {
    let unit = panel.y().label().rsplit_once('[').and_then(|(_, unit)| unit.split_once(']'));
    // A unit that looks like a template would be filled in.
    let unit = unit.map_or("", |(unit, _)| unit);
    let unit = if ["–", "-"].contains(&unit) { String::new() } else { escape(unit).replace("%{", "% {") };
    let value = if panel.is_equal_aspect() { "(%{x:.5~g}, %{y:.5~g})" } else { "%{y:.5~g}" };
    format!("%{{fullData.name}}: {value} {unit}<extra></extra>")
}

fn trace(figure: &Figure, series: &Series, panel: usize, first: bool, hover: &str) -> Value {
    let (x, y): (Vec<Value>, Vec<Value>) = series
        .points()
        .map(|point| point.map_or((Value::Null, Value::Null), |(x, y)| (rounded(x), rounded(y))))
        .unzip();
    let look = figure.look(series);
    let mode = match (look.line, series.mark()) {
        (Line::None, _) => "markers",
        (_, Some(_)) => "lines+markers",
        (_, None) => "lines",
    };
    let shape = if series.is_held() { "hv" } else { "linear" };
    let symbol = match series.mark() {
        Some(Mark::Cross) => "x-thin",
        _ => "circle",
    };
    let colour = css(look.rgb);
    let mut trace = json!({
        "type": "scatter", "mode": mode, "name": escape(series.name()), "legendgroup": escape(series.name()),
        "showlegend": first, "x": x, "y": y, "xaxis": "x", "yaxis": axis_name('y', panel), "connectgaps": false,
        "hovertemplate": hover,
        "line": { "color": colour, "width": series.width(), "dash": dash(look.line), "shape": shape },
        "marker": { "color": colour, "size": 8, "symbol": symbol, "line": { "color": colour, "width": 2 } },
    });
    if !series.labels().is_empty() {
        trace["text"] = series.labels().iter().map(|label| json!(escape(label))).collect();
        trace["hovertemplate"] = json!("%{text}<extra></extra>");
    }
    trace
}

/// A circle is drawn as a curve: a shape would not be in the legend.
fn circle(reference: &Reference, panel: usize) -> Option<Value> {
    let Reference::Circle { centre, radius, label } = reference else { return None };
    let (x, y): (Vec<Value>, Vec<Value>) =
        around(*centre, *radius).into_iter().map(|(x, y)| (rounded(x), rounded(y))).unzip();
    Some(json!({
        "type": "scatter", "mode": "lines", "name": escape(label), "showlegend": !label.is_empty(),
        "legendrank": 2000, "hoverinfo": "skip", "x": x, "y": y, "xaxis": "x", "yaxis": axis_name('y', panel),
        "line": { "color": css(NEUTRAL.rgb), "width": 1.3, "dash": "5px,4px" },
    }))
}

fn dash(line: Line) -> &'static str {
    match line {
        Line::Automatic | Line::None | Line::Solid => "solid",
        Line::Dashed => "8px,5px",
        Line::Dotted => "2px,4px",
        Line::DashDotted => "9px,4px,2px,4px",
        Line::LongDashed => "16px,5px",
    }
}

fn layout(figure: &Figure) -> Value {
    let panels = figure.panels();
    let height = panels_height(figure);
    let views = views(figure, height, 700.0);
    let count = panels.len();
    let mut layout = Map::new();
    let labelled = |panel: &Panel| panel.series().iter().any(|series| !series.labels().is_empty());
    let plane = panels.iter().any(|panel| panel.is_equal_aspect() || labelled(panel));
    layout.insert("height".into(), json!(height + 120.0));
    layout.insert("margin".into(), json!({ "l": 70, "r": 16, "t": 32, "b": 50 }));
    layout.insert("hovermode".into(), json!(if plane { "closest" } else { "x unified" }));
    layout.insert("hoversubplots".into(), json!("axis"));
    layout.insert("hoverlabel".into(), json!({ "namelength": -1 }));
    // The legend stands below the axis label, in pixels: fractions would move with the height.
    let below = -52.0 / height;
    layout.insert(
        "legend".into(),
        json!({ "orientation": "h", "x": 0, "xanchor": "left", "y": below, "yanchor": "top" }),
    );
    if let (Some(lowest), Some(view)) = (panels.last(), views.last()) {
        let mut x = axis(lowest.x(), view.x, 9.0);
        if count > 1 {
            x["mirror"] = json!("all");
        }
        x["anchor"] = json!(axis_name('y', count - 1));
        layout.insert("xaxis".into(), x);
    }
    for (index, (panel, view)) in panels.iter().zip(&views).enumerate() {
        let mut y = axis(panel.y(), view.y, if count > 1 { 5.0 } else { 9.0 });
        y["anchor"] = json!("x");
        let share = |from_top: usize| 1.0 - float(from_top) / float(count);
        let gap = if index + 1 < count { 0.06 } else { 0.0 };
        y["domain"] = json!([share(index + 1) + gap / float(count), share(index)]);
        if panel.is_equal_aspect() {
            y["scaleanchor"] = json!("x");
        }
        layout.insert(if index == 0 { "yaxis".into() } else { format!("yaxis{}", index + 1) }, y);
    }
    let shapes = panels.iter().zip(&views).enumerate();
    let shapes: Vec<Value> =
        shapes.flat_map(|(index, (panel, view))| shapes_of(panel, *view, index)).collect();
    layout.insert("shapes".into(), Value::Array(shapes));
    Value::Object(layout)
}

fn float(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}

fn axis(axis: &Axis, span: Span, most_ticks: f64) -> Value {
    let mut value = json!({
        "title": { "text": escape(axis.label()), "standoff": 10 }, "range": span.ends().map(rounded), "automargin": true,
        "hoverformat": ".6~g", "zeroline": false, "showline": true, "mirror": true, "ticks": "outside",
    });
    if axis.scale() == Scale::Logarithmic {
        value["type"] = json!("log");
        value["dtick"] = json!(1);
        let decades = span.ends()[1] - span.ends()[0];
        if decades < 2.0 {
            value["dtick"] = json!("D2");
        } else if decades > 10.0 {
            value["dtick"] = json!((decades / 8.0).ceil());
        }
    } else if let Some(step) = axis.tick_step() {
        // Many turns of phase would crowd the axis.
        let span = span.ends()[1] - span.ends()[0];
        value["dtick"] = json!(step * (span / step / most_ticks).max(1.0).log2().ceil().exp2());
    }
    value
}

/// The straight lines that curves are compared with.
fn shapes_of(panel: &Panel, view: View, index: usize) -> Vec<Value> {
    let line = json!({ "color": css(NEUTRAL.rgb), "width": 1.3, "dash": "5px,4px" });
    let inside = |place: Option<f64>| place.is_some_and(|place| (0.0..=1.0).contains(&place));
    let y = axis_name('y', index);
    let drawn = |reference: &Reference| match reference {
        Reference::Horizontal { at, label } if inside(view.y.place(*at)) => Some(json!({
            "type": "line", "layer": "below", "line": line, "xref": "x domain", "x0": 0, "x1": 1, "yref": y,
            "y0": at, "y1": at, "label": { "text": escape(label), "textposition": "end", "xanchor": "right", "yanchor": "bottom", "padding": 5 },
        })),
        Reference::Vertical { at, label } if inside(view.x.place(*at)) => Some(json!({
            "type": "line", "layer": "below", "line": line, "xref": "x", "x0": at, "x1": at,
            "yref": format!("{y} domain"), "y0": 0, "y1": 1,
            "label": {
                "text": escape(label), "textposition": "end", "textangle": 0, "yanchor": "top", "padding": 5,
                "xanchor": if view.x.place(*at).is_some_and(|place| place > 0.75) { "right" } else { "left" },
            },
        })),
        _ => None,
    };
    panel.references().iter().filter_map(drawn).collect()
}

fn rounded(value: f64) -> Value {
    // A number that was finite is a number again.
    format!("{value:.8e}").parse::<f64>().map_or(Value::Null, |value| json!(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(name: &str) -> Panel {
        let series = Series::new(name, vec![1.0, 2.0, f64::INFINITY], vec![1.0, f64::NAN, 3.0]).unwrap();
        Panel::new(Axis::logarithmic("frequency [rad/s]"), Axis::linear("phase [°]")).with_series(series)
    }

    #[test]
    fn gaps_are_null() {
        let value = value(&Figure::new("a", vec![panel("a")]).unwrap());
        assert_eq!(value["data"][0]["x"], json!([1.0, null, null]));
        assert_eq!(value["data"][0]["y"], json!([1.0, null, null]));
    }

    #[test]
    fn stacked_panels_share_the_x_axis_and_one_entry_of_the_legend() {
        let value = value(&Figure::new("a", vec![panel("a"), panel("a")]).unwrap());
        assert_eq!(value["data"][0]["showlegend"], json!(true));
        assert_eq!(value["data"][1]["showlegend"], json!(false));
        assert_eq!(value["data"][1]["xaxis"], json!("x"));
        assert_eq!(value["data"][1]["yaxis"], json!("y2"));
        assert_eq!(value["layout"]["xaxis"]["anchor"], json!("y2"));
        assert_eq!(value["layout"]["xaxis"]["type"], json!("log"));
        assert!(value["layout"].get("xaxis2").is_none());
    }

    #[test]
    fn markup_in_names_is_not_markup_for_plotly() {
        let value = value(&Figure::new("a", vec![panel("<a href='https://example.com'>x</a>")]).unwrap());
        assert!(!value.to_string().contains("<a"));
    }
}
