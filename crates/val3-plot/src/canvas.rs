//! Shapes and texts in an SVG picture. Coordinates are pixels from the upper left corner.

use std::fmt::Write as _;

/// Width of every picture in pixels.
pub(crate) const WIDTH: f64 = 1600.0;

const STYLE: &str = "svg{font-family:'DejaVu Sans',Verdana,sans-serif;background:#fff}\
text{fill:#222;font-size:12px}.title{font-size:20px;font-weight:bold}.small{font-size:12px;fill:#555}\
.tick{font-size:10px;fill:#777}.label{font-size:11px;paint-order:stroke;stroke:#fff;stroke-width:3px}.note{font-size:10px;fill:#8a5a00;paint-order:stroke;stroke:#fff;stroke-width:3px}.centre{text-anchor:middle}.right{text-anchor:end}\
line.deviation{stroke:#c00000;stroke-width:2}text.deviation{fill:#c00000;font-weight:bold}\
path,line{fill:none}.grid{stroke:#e6e6e6;stroke-width:1}.frame{stroke:#bbb;fill:none}\
.limit{stroke:#d55e00;stroke-width:1;stroke-dasharray:6 4}.limit-label{font-size:10px;fill:#b34a00;paint-order:stroke;stroke:#fff;stroke-width:3px}\
.beyond{fill:#d55e00;fill-opacity:.08}.leader{stroke:#999;stroke-width:.7}\
.start{stroke:#c8c8c8;stroke-width:1;stroke-dasharray:2 3}";

/// A drawing that is extended shape by shape.
#[derive(Default)]
pub(crate) struct Canvas {
    out: String,
}

impl Canvas {
    /// Returns the SVG file with this height in pixels.
    pub(crate) fn finish(self, height: f64, title: &str, description: &str) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height:.0}\" viewBox=\"0 0 {WIDTH} \
             {height:.0}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n<style>{STYLE}</style>\n<rect width=\"100%\" \
             height=\"100%\" fill=\"#fff\"/>\n{}</svg>\n",
            escaped(title),
            escaped(description),
            self.out
        )
    }

    fn put(&mut self, shape: &str) {
        self.out.push_str(shape);
        self.out.push('\n');
    }

    /// Draws a text whose base line begins at the coordinates; the class may contain another anchor.
    pub(crate) fn text(&mut self, [x, y]: [f64; 2], class: &str, text: &str) {
        self.put(&format!("<text x=\"{x:.1}\" y=\"{y:.1}\" class=\"{class}\">{}</text>", escaped(text)));
    }

    /// Draws a text with an explanation, which viewers show as a tooltip.
    pub(crate) fn explained(&mut self, [x, y]: [f64; 2], class: &str, text: &str, explanation: &str) {
        let (text, explanation) = (escaped(text), escaped(explanation));
        self.put(&format!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" class=\"{class}\">{text}<title>{explanation}</title></text>"
        ));
    }

    /// Draws a text that is rotated to be read upwards.
    pub(crate) fn upright(&mut self, [x, y]: [f64; 2], class: &str, text: &str) {
        let text = escaped(text);
        self.put(&format!("<text transform=\"translate({x:.1} {y:.1}) rotate(-90)\" class=\"{class}\">{text}</text>"));
    }

    /// Draws a line with a style.
    pub(crate) fn line(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], style: &str) {
        let line = format!("<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" style=\"{style}\"/>");
        self.put(&line);
    }

    /// Draws a line with a class.
    pub(crate) fn rule(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], class: &str) {
        let line = format!("<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" class=\"{class}\"/>");
        self.put(&line);
    }

    /// Draws a frame.
    pub(crate) fn frame(&mut self, corner: [f64; 2], size: [f64; 2]) {
        self.area(corner, size, "frame");
    }

    /// Draws a rectangle with a class.
    pub(crate) fn area(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2], class: &str) {
        let area =
            format!("<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" class=\"{class}\"/>");
        self.put(&area);
    }

    /// Draws a coloured rectangle with an explanation, which viewers show as a tooltip.
    pub(crate) fn explained_area(
        &mut self,
        [x, y]: [f64; 2],
        [width, height]: [f64; 2],
        colour: &str,
        explanation: &str,
    ) {
        let explanation = escaped(explanation);
        self.put(&format!(
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" \
             fill=\"{colour}\"><title>{explanation}</title></rect>"
        ));
    }

    /// Draws a circle with a style.
    pub(crate) fn circle(&mut self, [x, y]: [f64; 2], radius: f64, style: &str) {
        self.put(&format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\" style=\"{style}\"/>"));
    }

    /// Draws a polyline with a style.
    pub(crate) fn path(&mut self, points: &[[f64; 2]], style: &str) {
        let mut data = String::new();
        for (index, [x, y]) in points.iter().enumerate() {
            // Writing to a string cannot fail.
            let _ = write!(data, "{}{x:.1} {y:.1}", if index == 0 { "M" } else { "L" });
        }
        if points.len() > 1 {
            self.put(&format!("<path d=\"{data}\" style=\"{style}\"/>"));
        }
    }
}

fn escaped(text: &str) -> String {
    let allowed = text.chars().filter(|letter| !letter.is_control());
    allowed.collect::<String>().replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
