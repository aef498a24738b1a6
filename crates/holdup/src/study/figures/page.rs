//! A report as one HTML file that needs nothing else: no server, no network, no second file.
use super::figure::Figure;
use super::text::{clean, escape};
use super::{plotly, svg};
use std::fmt::Write;

const STYLE: &str = include_str!("assets/page.css");
const SCRIPT: &str = include_str!("assets/page.js");

/// The browser itself refuses whatever would be loaded from elsewhere.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
    img-src data: blob:";

/// A table row does not fit its heading.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("row {row} of table \"{table}\" has {cells} cells where the heading has {columns}")]
pub struct RowLength {
    table: String,
    row: usize,
    cells: usize,
    columns: usize,
}

/// How the cells of a column stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// Words, left aligned.
    Words,
    /// Numbers, right aligned with digits of equal width.
    Numbers,
}

/// A table; the first cell of each row names the row and stays in sight where the table is scrolled.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    caption: String,
    columns: Vec<(String, Column)>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table of text that is already rounded for reading.
    ///
    /// # Errors
    /// [`RowLength`] for the first row that has not one cell for each column.
    pub fn new(
        caption: impl Into<String>,
        columns: Vec<(String, Column)>,
        rows: Vec<Vec<String>>,
    ) -> Result<Self, RowLength> {
        let caption = caption.into();
        match rows.iter().position(|row| row.len() != columns.len()) {
            Some(row) => Err(RowLength {
                table: caption,
                row: row + 1,
                cells: rows[row].len(),
                columns: columns.len(),
            }),
            None => Ok(Self { caption, columns, rows }),
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Block {
    Paragraph(String),
    List(Vec<String>),
    Code(String),
    Table(Table),
    Figure(Box<Figure>),
}

/// A heading and what stands under it, in the order of adding. All text is text: markup in it is shown, not obeyed.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    heading: String,
    blocks: Vec<Block>,
}

impl Section {
    /// An empty section.
    #[must_use]
    pub fn new(heading: impl Into<String>) -> Self {
        Self { heading: heading.into(), blocks: Vec::new() }
    }

    fn with(mut self, block: Block) -> Self {
        self.blocks.push(block);
        self
    }

    /// The section with one more paragraph.
    #[must_use]
    pub fn with_paragraph(self, text: impl Into<String>) -> Self {
        self.with(Block::Paragraph(text.into()))
    }

    /// The section with a list of points.
    #[must_use]
    pub fn with_list(self, points: Vec<String>) -> Self {
        self.with(Block::List(points))
    }

    /// The section with text whose line breaks and spaces stand as they are, such as a command or a file.
    #[must_use]
    pub fn with_code(self, text: impl Into<String>) -> Self {
        self.with(Block::Code(text.into()))
    }

    /// The section with a table.
    #[must_use]
    pub fn with_table(self, table: Table) -> Self {
        self.with(Block::Table(table))
    }

    /// The section with a figure.
    #[must_use]
    pub fn with_figure(self, figure: Figure) -> Self {
        self.with(Block::Figure(Box::new(figure)))
    }
}

/// A report: title, introduction, sections.
///
/// # Examples
/// ```
/// use holdup::study::figures::page::{Page, Section};
///
/// let findings = Section::new("Findings").with_paragraph("IAE < 5 is impossible.");
/// let html = Page::new("A tank level").with_section(findings).html();
/// assert!(html.contains("<p>IAE &lt; 5 is impossible.</p>"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    title: String,
    introduction: Option<String>,
    sections: Vec<Section>,
}

impl Page {
    /// A page without content.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), introduction: None, sections: Vec::new() }
    }

    /// The page with a sentence or two under its title.
    #[must_use]
    pub fn with_introduction(self, text: impl Into<String>) -> Self {
        Self { introduction: Some(text.into()), ..self }
    }

    /// The page with one more section.
    #[must_use]
    pub fn with_section(mut self, section: Section) -> Self {
        self.sections.push(section);
        self
    }

    /// Writes the page. The same page gives the same bytes.
    #[must_use]
    pub fn html(&self) -> String {
        let title = safe(&self.title);
        let mut html = format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n\
             <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<div class=\"sheet\">\n\
             <header><h1>{title}</h1>"
        );
        if let Some(introduction) = &self.introduction {
            push(&mut html, "<p>", introduction, "</p>");
        }
        html.push_str("</header>\n<div class=\"columns\">\n<nav aria-label=\"Sections\">\n");
        for (number, section) in (1..).zip(&self.sections) {
            push(&mut html, &format!("<a href=\"#section-{number}\">"), &section.heading, "</a>\n");
        }
        html.push_str("</nav>\n<main>\n");
        for (number, section) in (1..).zip(&self.sections) {
            push(&mut html, &format!("<section id=\"section-{number}\">\n<h2>"), &section.heading, "</h2>\n");
            for block in &section.blocks {
                push_block(&mut html, block);
            }
            html.push_str("</section>\n");
        }
        html.push_str("</main>\n</div>\n<footer>Computed by holdup ");
        html.push_str(env!("CARGO_PKG_VERSION"));
        html.push_str(".</footer>\n</div>\n");
        if self.has_figure() {
            // Writing to a string cannot fail.
            let _ = write!(html, "<script>{}</script>\n<script>\n{SCRIPT}</script>\n", plotly_source());
        }
        html.push_str("</body>\n</html>\n");
        html
    }

    fn has_figure(&self) -> bool {
        self.sections
            .iter()
            .flat_map(|section| &section.blocks)
            .any(|block| matches!(block, Block::Figure(_)))
    }
}

fn safe(text: &str) -> String {
    escape(&clean(text))
}

fn push(html: &mut String, before: &str, text: &str, after: &str) {
    html.push_str(before);
    html.push_str(&safe(text));
    html.push_str(after);
}

fn push_block(html: &mut String, block: &Block) {
    match block {
        Block::Paragraph(text) => push(html, "<p>", text, "</p>\n"),
        Block::List(points) => {
            html.push_str("<ul>\n");
            for point in points {
                push(html, "<li>", point, "</li>\n");
            }
            html.push_str("</ul>\n");
        }
        Block::Code(text) => {
            html.push_str("<pre>");
            for line in text.lines() {
                push(html, "", line, "\n");
            }
            html.push_str("</pre>\n");
        }
        Block::Table(table) => push_table(html, table),
        Block::Figure(figure) => push_figure(html, figure),
    }
}

fn push_table(html: &mut String, table: &Table) {
    push(
        html,
        "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"",
        &table.caption,
        "\">\n<table>\n",
    );
    if !table.caption.is_empty() {
        push(html, "<caption>", &table.caption, "</caption>\n");
    }
    html.push_str("<thead><tr>");
    for (heading, column) in &table.columns {
        push(html, &format!("<th scope=\"col\"{}>", class(*column)), heading, "</th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in &table.rows {
        html.push_str("<tr>");
        for (index, (cell, (_, column))) in row.iter().zip(&table.columns).enumerate() {
            let class = class(*column);
            if index == 0 {
                push(html, &format!("<th scope=\"row\"{class}>"), cell, "</th>");
            } else {
                push(html, &format!("<td{class}>"), cell, "</td>");
            }
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table>\n</div>\n");
}

fn class(column: Column) -> &'static str {
    match column {
        Column::Words => "",
        Column::Numbers => " class=\"number\"",
    }
}

fn push_figure(html: &mut String, figure: &Figure) {
    push(html, "<figure>\n<figcaption>", figure.title(), "</figcaption>\n<div class=\"still\">\n");
    html.push_str(&svg::element(figure));
    html.push_str("</div>\n<div class=\"plot\"></div>\n<script type=\"application/json\">");
    // Inside a script element only "<" can end the element; JSON may write it as an escape.
    html.push_str(&plotly::value(figure).to_string().replace('<', "\\u003c"));
    html.push_str("</script>\n</figure>\n");
}

/// The source of plotly.js, for one script element. It is © Plotly, Inc., under the MIT licence, which its first
/// lines say.
///
/// # Panics
/// Never with the version of the crate `plotly` this was built with, which a test ensures.
#[must_use]
pub fn plotly_source() -> String {
    // The crate gives two script elements, plotly.js and MathJax; formulas need no typesetter here.
    let elements = ::plotly::Plot::offline_js_sources();
    let source = elements
        .split("</script>")
        .filter_map(|element| element.split_once('>').map(|(_, source)| source))
        .find(|source| source.trim_start().starts_with("/**\n* plotly.js v"));
    source.expect("the crate plotly brings plotly.js").to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::figures::{Axis, Panel, Reference, Series};

    const EVIL: &str = "</script><script>alert(1)</script><img src=x onerror=\"alert(2)\">";

    fn figure(name: &str) -> Figure {
        let series = Series::new(name, vec![0.0, 1.0], vec![0.0, 1.0]).unwrap();
        let panel = Panel::new(Axis::linear(name), Axis::linear(name)).with_series(series);
        Figure::new(name, vec![panel.with_reference(Reference::vertical(0.5, name).unwrap())]).unwrap()
    }

    fn page(name: &str) -> String {
        let columns = vec![(name.to_owned(), Column::Words), ("IAE".to_owned(), Column::Numbers)];
        let table = Table::new(name, columns, vec![vec![name.to_owned(), "1.5".to_owned()]]).unwrap();
        let section = Section::new(name)
            .with_paragraph(name)
            .with_list(vec![name.to_owned()])
            .with_code(name)
            .with_table(table)
            .with_figure(figure(name))
            .with_figure(figure("second"));
        Page::new(name).with_introduction(name).with_section(section).html()
    }

    fn without_plotly(html: &str) -> String {
        html.replace(&plotly_source(), "")
    }

    #[test]
    fn plotly_is_embedded_exactly_once_and_mathjax_not_at_all() {
        let html = page("a");
        assert_eq!(html.matches("* plotly.js v").count(), 1);
        assert!(!html.contains("MathJax-src") && html.len() < 4_800_000);
        assert!(!plotly_source().contains("</script"));
        assert!(
            !Page::new("a").with_section(Section::new("b").with_paragraph("c")).html().contains("plotly")
        );
    }

    #[test]
    fn markup_in_any_text_is_shown_and_not_obeyed() {
        let (evil, plain) = (without_plotly(&page(EVIL)), without_plotly(&page("plain")));
        for tag in ["<script", "</script", "<img", "<td", "<p>", "<svg"] {
            assert_eq!(evil.matches(tag).count(), plain.matches(tag).count(), "{tag}");
        }
        assert!(evil.contains("&lt;script&gt;alert(1)"));
    }

    #[test]
    fn nothing_is_loaded_from_elsewhere() {
        let html = without_plotly(&page("a"));
        for loaded in ["http:", "https:", "src=", "@import", "url(", "href=\"//"] {
            assert!(!html.contains(loaded), "{loaded}");
        }
        let links = html.matches("href=\"").count();
        assert_eq!(links, html.matches("href=\"#section-").count() + html.matches("href=\"data:,\"").count());
        assert!(html.contains("default-src 'none'"));
    }

    #[test]
    fn numbers_are_marked_and_rows_that_do_not_fit_are_an_error() {
        assert!(page("a").contains("<td class=\"number\">1.5</td>"));
        let columns = vec![("controller".to_owned(), Column::Words)];
        let error = Table::new("margins", columns, vec![vec!["SIMC".to_owned()], vec![]]).unwrap_err();
        assert_eq!(error.to_string(), "row 2 of table \"margins\" has 0 cells where the heading has 1");
    }
}
