//! A figure as SVG.
use super::figure::Figure;
use super::palette::css;
use super::scene::{self, Anchor, Ink, Scene, Shape, Text};
use super::text::escape;
use std::fmt::Write;

/// Colours of the paper when no style sheet says otherwise.
pub(super) const PAPER: [u8; 3] = [0xff, 0xff, 0xff];
pub(super) const TEXT: [u8; 3] = [0x1f, 0x23, 0x28];
pub(super) const GRID: [u8; 3] = [0xe4, 0xe7, 0xeb];
pub(super) const FRAME: [u8; 3] = [0x8c, 0x95, 0x9f];

/// Viewers that know the reader's preference show the figure dark. Attributes give way to style sheets, so that
/// programs without style sheets show it light.
const DARK: &str = "<style>@media (prefers-color-scheme: dark) { .figure-paper { fill: #15181c } \
    .figure-text { fill: #e6e8eb } .figure-lifted { stroke: #15181c } .figure-grid { stroke: #2c3138 } \
    .figure-frame { stroke: #7d8590 } }</style>";

/// Writes the figure as an SVG file: white, or dark for readers who prefer dark.
///
/// # Examples
/// ```
/// use holdup::study::figures::{Axis, Figure, Panel, Series, svg};
///
/// let level = Series::new("level", vec![0.0, 6.0, 30.0], vec![0.0, 0.0, 1.0])?;
/// let panel = Panel::new(Axis::linear("time [s]"), Axis::linear("level [m]")).with_series(level);
/// let figure = Figure::new("A tank", vec![panel])?;
/// assert!(svg::document(&figure).starts_with("<svg xmlns="));
/// # Ok::<(), holdup::study::figures::FigureError>(())
/// ```
#[must_use]
pub fn document(figure: &Figure) -> String {
    let scene = scene::lay_out(figure, true);
    let (width, height) = (short(scene.width), short(scene.height));
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" {FONT}>\n<title>{}</title>\n{DARK}\n\
         <rect class=\"figure-paper\" width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n",
        escape(figure.title()),
        css(PAPER)
    );
    paint(&mut svg, &scene);
    svg.push_str("</svg>\n");
    svg
}

/// Writes the figure without its title as an element to put into an HTML page, whose style sheet colours the
/// classes `figure-text`, `figure-lifted`, `figure-grid` and `figure-frame`.
#[must_use]
pub fn element(figure: &Figure) -> String {
    let scene = scene::lay_out(figure, false);
    let (width, height) = (short(scene.width), short(scene.height));
    let mut svg = format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\" {FONT}>\n",
        escape(figure.title())
    );
    paint(&mut svg, &scene);
    svg.push_str("</svg>\n");
    svg
}

const FONT: &str = "font-family=\"'DejaVu Sans', Verdana, system-ui, sans-serif\"";

fn paint(svg: &mut String, scene: &Scene) {
    for shape in &scene.shapes {
        // Writing to a string cannot fail.
        let _ = match shape {
            Shape::Stroke { points, ink, width, dash } => {
                let line: Vec<String> =
                    points.iter().map(|(x, y)| format!("{},{}", short(*x), short(*y))).collect();
                let dash: Vec<String> = dash.iter().map(|d| short(*d)).collect();
                let dash = if dash.is_empty() {
                    String::new()
                } else {
                    format!(" stroke-dasharray=\"{}\"", dash.join(" "))
                };
                let (line, ink, width) = (line.join(" "), ink_as(*ink, "stroke"), short(*width));
                let join = "stroke-linejoin=\"round\"";
                writeln!(
                    svg,
                    "<polyline points=\"{line}\" fill=\"none\" {ink} stroke-width=\"{width}\" {join}{dash}/>"
                )
            }
            Shape::Disc { centre, radius, ink } => {
                let (x, y, r) = (short(centre.0), short(centre.1), short(*radius));
                writeln!(svg, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" {}/>", ink_as(*ink, "fill"))
            }
            Shape::Text(text) => writeln!(svg, "{}", text_element(text)),
        };
    }
}

fn text_element(text: &Text) -> String {
    let (x, y, size) = (short(text.at.0), short(text.at.1), short(text.size));
    let anchor = match text.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let bold = if text.bold { " font-weight=\"bold\"" } else { "" };
    let turned = if text.upright { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
    let (class, border) = if text.lifted {
        let border = format!(" stroke=\"{}\" stroke-width=\"4\" paint-order=\"stroke\"", css(PAPER));
        ("figure-text figure-lifted", border)
    } else {
        ("figure-text", String::new())
    };
    let (fill, words) = (css(TEXT), escape(&text.words));
    format!(
        "<text class=\"{class}\" x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{fill}\"{bold}{turned}{border}>{words}</text>"
    )
}

/// The attributes that paint with the ink.
fn ink_as(ink: Ink, property: &str) -> String {
    match ink {
        Ink::Grid => format!("class=\"figure-grid\" {property}=\"{}\"", css(GRID)),
        Ink::Frame => format!("class=\"figure-frame\" {property}=\"{}\"", css(FRAME)),
        Ink::Curve(rgb) => format!("{property}=\"{}\"", css(rgb)),
    }
}

/// The number to a hundredth of a pixel.
fn short(value: f64) -> String {
    let rounded = (value * 100.0).round() / 100.0;
    // Adding zero turns −0 into 0.
    (rounded + 0.0).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::figures::{Axis, Mark, Panel, Reference, Series};

    fn figure(name: &str) -> Figure {
        let nan = f64::NAN;
        let series = Series::new(name, vec![1.0, 2.0, 3.0, 4.0, 5.0], vec![1.0, 2.0, nan, 3.0, 1.0]).unwrap();
        let panel = Panel::new(Axis::logarithmic(name), Axis::linear(name))
            .with_reference(Reference::horizontal(1.5, name).unwrap())
            .with_reference(Reference::circle((2.0, 2.0), 0.5, name).unwrap())
            .with_series(series.clone())
            .with_series(series.as_marks(Mark::Cross));
        Figure::new(name, vec![panel]).unwrap()
    }

    #[test]
    fn any_text_gives_well_formed_xml() {
        for name in ["level", "<script>alert(1)</script>", "a & b \" ' ]]> \u{0}\u{1b}\u{ffff} −", ""] {
            let svg = document(&figure(name));
            let xml = roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{error}: {svg}"));
            assert!(xml.descendants().all(|node| !node.has_tag_name("script")));
        }
    }

    #[test]
    fn a_gap_parts_the_line() {
        let svg = document(&figure("level"));
        assert_eq!(
            svg.matches("stroke=\"#0072b2\" stroke-width=\"2\" stroke-linejoin=\"round\"/>").count(),
            3 + 8
        );
    }

    #[test]
    fn nothing_is_loaded_and_no_coordinate_is_missing() {
        let svg = document(&figure("level"));
        assert!(!svg.contains("href") && !svg.contains("url("));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn many_points_make_a_small_file() {
        let x: Vec<f64> = (0..20_001).map(f64::from).collect();
        let y = x.iter().map(|t| (t / 3000.0).sin()).collect();
        let panel =
            Panel::new(Axis::linear("t"), Axis::linear("y")).with_series(Series::new("a", x, y).unwrap());
        assert!(document(&Figure::new("a", vec![panel]).unwrap()).len() < 20_000);
    }
}
