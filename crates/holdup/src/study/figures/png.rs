//! A figure as PNG, with the font that is compiled in: machines without fonts draw it too.
use super::figure::Figure;
use super::scene::{self, Anchor, Ink, Shape, Text};
use super::svg::{FRAME, GRID, PAPER, TEXT};
use tiny_skia::{Color, FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// `DejaVu` Sans, cut down to Latin, Greek, Cyrillic and mathematical signs by fonttools 4:
/// `pyftsubset DejaVuSans.ttf --unicodes=U+20-7E,U+A0-17F,U+300-30C,U+370-3FF,U+400-45F,U+2010-2027,U+2030-203A,`
/// `U+2044,U+2070-209C,U+20AC,U+2103,U+2126,U+2190-2195,U+21D2,U+2200-2265,U+25A0-25CF,U+FFFD`
/// `--layout-features= --no-hinting --notdef-outline`. Its licence lies beside it.
const FONT: &[u8] = include_bytes!("assets/DejaVuSans-subset.ttf");

/// Why no picture came out.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PngError {
    /// The picture would be empty or too large.
    #[error("scale {scale} is not allowed: it must be at least 0.1 and at most 10")]
    Scale {
        /// Pixels for each unit of the figure.
        scale: f32,
    },
    /// The picture could not be written as PNG.
    #[error("the picture cannot be written as PNG: {reason}")]
    Encoding {
        /// What the encoder says.
        reason: String,
    },
}

/// Draws the figure on white, 800·`scale` pixels wide; 2 suits screens and print.
///
/// A character that the font lacks is drawn as a box.
///
/// # Errors
/// [`PngError::Scale`] unless `scale` is between 0.1 and 10; [`PngError::Encoding`] when the encoder fails.
///
/// # Panics
/// Never: the font that is compiled in can be read, which a test ensures.
///
/// # Examples
/// ```
/// use holdup::study::figures::{Axis, Figure, Panel, png};
///
/// let panel = Panel::new(Axis::linear("time [s]"), Axis::linear("level [m]"));
/// let png = png::bytes(&Figure::new("A tank", vec![panel])?, 2.0)?;
/// assert!(png.starts_with(b"\x89PNG"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn bytes(figure: &Figure, scale: f32) -> Result<Vec<u8>, PngError> {
    let scene = scene::lay_out(figure, true);
    if !(0.1..=10.0).contains(&scale) {
        return Err(PngError::Scale { scale });
    }
    let pixels = |length: f64| whole(length * f64::from(scale));
    let pixmap = Pixmap::new(pixels(scene.width), pixels(scene.height)).ok_or(PngError::Scale { scale })?;
    let face = Face::parse(FONT, 0).expect("the font that is compiled in is one");
    let mut painter = Painter { pixmap, face, transform: Transform::from_scale(scale, scale) };
    painter.pixmap.fill(colour(PAPER));
    for shape in &scene.shapes {
        painter.paint(shape);
    }
    painter.pixmap.encode_png().map_err(|error| PngError::Encoding { reason: error.to_string() })
}

struct Painter {
    pixmap: Pixmap,
    face: Face<'static>,
    transform: Transform,
}

impl Painter {
    fn paint(&mut self, shape: &Shape) {
        match shape {
            Shape::Stroke { points, ink, width, dash } => {
                let Some(path) = polyline(points) else { return };
                let dash = StrokeDash::new(dash.iter().map(|d| narrow(*d)).collect(), 0.0);
                let width = narrow(*width);
                self.stroke(
                    &path,
                    &Stroke { width, dash, line_join: LineJoin::Round, ..Stroke::default() },
                    rgb(*ink),
                );
            }
            Shape::Disc { centre, radius, ink } => {
                if let Some(path) =
                    PathBuilder::from_circle(narrow(centre.0), narrow(centre.1), narrow(*radius))
                {
                    self.fill(&path, rgb(*ink));
                }
            }
            Shape::Text(text) => self.text(text),
        }
    }

    fn text(&mut self, text: &Text) {
        let Some(path) = outline(&self.face, text) else { return };
        if text.lifted {
            let border = Stroke { width: 4.0, line_join: LineJoin::Round, ..Stroke::default() };
            self.stroke(&path, &border, PAPER);
        }
        if text.bold {
            // The font has one weight; a thin border of the same colour makes it heavier.
            self.stroke(&path, &Stroke { width: 0.6, ..Stroke::default() }, TEXT);
        }
        self.fill(&path, TEXT);
    }

    fn stroke(&mut self, path: &Path, stroke: &Stroke, rgb: [u8; 3]) {
        self.pixmap.stroke_path(path, &paint(rgb), stroke, self.transform, None);
    }

    fn fill(&mut self, path: &Path, rgb: [u8; 3]) {
        self.pixmap.fill_path(path, &paint(rgb), FillRule::Winding, self.transform, None);
    }
}

fn paint(rgb: [u8; 3]) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(colour(rgb));
    paint
}

fn colour([r, g, b]: [u8; 3]) -> Color {
    Color::from_rgba8(r, g, b, 255)
}

fn rgb(ink: Ink) -> [u8; 3] {
    match ink {
        Ink::Grid => GRID,
        Ink::Frame => FRAME,
        Ink::Curve(rgb) => rgb,
    }
}

fn polyline(points: &[(f64, f64)]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (index, (x, y)) in points.iter().enumerate() {
        if index == 0 {
            path.move_to(narrow(*x), narrow(*y));
        } else {
            path.line_to(narrow(*x), narrow(*y));
        }
    }
    path.finish()
}

/// The outlines of all glyphs of the text at its place.
fn outline(face: &Face<'_>, text: &Text) -> Option<Path> {
    let glyph = |c: char| face.glyph_index(c).unwrap_or(GlyphId(0));
    let advance = |c: char| f32::from(face.glyph_hor_advance(glyph(c)).unwrap_or(0));
    let scale = narrow(text.size) / f32::from(face.units_per_em());
    let width: f32 = text.words.chars().map(advance).sum();
    let mut pen = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * width,
        Anchor::End => -width,
    };
    let mut outline = Outline { path: PathBuilder::new(), x: 0.0, y: 0.0 };
    let mut base: Option<(f32, f32)> = None;
    for c in text.words.chars() {
        (outline.x, outline.y) = (pen, 0.0);
        match (('\u{300}'..='\u{30c}').contains(&c), base, face.glyph_bounding_box(glyph(c))) {
            (true, Some((middle, top)), Some(mark)) => {
                // An accent stands over the middle of its letter, as that of D̂ must.
                outline.x = middle - 0.5 * f32::from(mark.x_min + mark.x_max);
                outline.y = (top + ACCENT_GAP - f32::from(mark.y_min)).max(0.0);
            }
            (_, _, size) => {
                base =
                    size.map(|size| (pen + 0.5 * f32::from(size.x_min + size.x_max), f32::from(size.y_max)));
            }
        }
        face.outline_glyph(glyph(c), &mut outline);
        pen += advance(c);
    }
    let turned = if text.upright { Transform::from_rotate(-90.0) } else { Transform::identity() };
    // Fonts count upwards, pictures downwards.
    let place = turned.pre_scale(scale, -scale).post_translate(narrow(text.at.0), narrow(text.at.1));
    outline.path.finish()?.transform(place)
}

/// Height of the gap between a letter and its accent, in the font's units.
const ACCENT_GAP: f32 = 110.0;

/// A path in the font's units, and where the glyph that is added to it stands.
struct Outline {
    path: PathBuilder,
    x: f32,
    y: f32,
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.move_to(self.x + x, self.y + y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.path.line_to(self.x + x, self.y + y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.path.quad_to(self.x + x1, self.y + y1, self.x + x, self.y + y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (dx, dy) = (self.x, self.y);
        self.path.cubic_to(dx + x1, dy + y1, dx + x2, dy + y2, dx + x, dy + y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

#[expect(clippy::cast_possible_truncation, reason = "pixels need no more than single precision")]
fn narrow(value: f64) -> f32 {
    value as f32
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of pixels, at most 80 000"
)]
fn whole(value: f64) -> u32 {
    value.ceil() as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::figures::{Axis, Panel, Series};

    fn figure(x: Vec<f64>, y: Vec<f64>) -> Figure {
        let panel = Panel::new(Axis::linear("ω [rad/s]"), Axis::linear("水 [m]"));
        let panel = panel.with_series(Series::new("level", x, y).unwrap());
        Figure::new("A tank", vec![panel]).unwrap()
    }

    #[test]
    fn the_picture_has_the_size_asked_for_and_shows_the_curve() {
        let png = bytes(&figure(vec![0.0, 1.0], vec![0.0, 1.0]), 1.5).unwrap();
        let picture = Pixmap::decode_png(&png).unwrap();
        assert_eq!(picture.width(), 1200);
        let blue = |pixel: &&tiny_skia::PremultipliedColorU8| {
            (pixel.red(), pixel.green(), pixel.blue()) == (0x00, 0x72, 0xb2)
        };
        assert!(picture.pixels().iter().filter(blue).count() > 1000);
    }

    #[test]
    fn figures_without_data_and_with_extreme_data_are_drawn() {
        assert!(bytes(&figure(vec![], vec![]), 1.0).is_ok());
        assert!(bytes(&figure(vec![-1e300, 1e300], vec![f64::NAN, 1e300]), 1.0).is_ok());
        assert!(bytes(&figure(vec![-1e300, 1e300], vec![1e300, -1e300]), 1.0).is_ok());
    }

    #[test]
    fn a_scale_out_of_its_range_is_an_error() {
        for scale in [0.0, -1.0, f32::NAN, 11.0] {
            assert!(matches!(bytes(&figure(vec![], vec![]), scale), Err(PngError::Scale { .. })));
        }
    }
}
