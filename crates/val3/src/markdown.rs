//! Renders Markdown pages for a terminal: bold headings, indented code, filled text.

use std::io;

use codespan_reporting::term::termcolor::{Color, ColorSpec, WriteColor};

const CODE_INDENT: &str = "    ";
/// Maximum number of characters in a line of text.
const WIDTH: usize = 80;

/// Writes `page`. Colours mark headings and code; the text is also complete without colours.
pub(crate) fn render(page: &str, out: &mut dyn WriteColor) -> io::Result<()> {
    let mut renderer = Renderer { out, paragraph: String::new(), in_code: false };
    page.lines().try_for_each(|line| renderer.line(line))?;
    renderer.end_paragraph()
}

struct Renderer<'a> {
    out: &'a mut dyn WriteColor,
    /// Joined lines of the current paragraph or list item.
    paragraph: String,
    in_code: bool,
}

impl Renderer<'_> {
    fn line(&mut self, line: &str) -> io::Result<()> {
        if line.trim_start().starts_with("```") {
            self.in_code = !self.in_code;
            self.end_paragraph()
        } else if self.in_code {
            self.code(line)
        } else if let Some(title) = heading(line) {
            self.end_paragraph()?;
            styled(&heading_style(), title, self.out)?;
            writeln!(self.out)
        } else {
            self.text(line)
        }
    }

    fn code(&mut self, line: &str) -> io::Result<()> {
        if !line.is_empty() {
            styled(&code_style(), &format!("{CODE_INDENT}{line}"), self.out)?;
        }
        writeln!(self.out)
    }

    fn text(&mut self, line: &str) -> io::Result<()> {
        let line = line.trim();
        if line.is_empty() || line.starts_with(['|', '-', '*']) {
            self.end_paragraph()?;
        }
        if line.is_empty() {
            return writeln!(self.out);
        }
        if !self.paragraph.is_empty() {
            self.paragraph.push(' ');
        }
        self.paragraph.push_str(line);
        Ok(())
    }

    fn end_paragraph(&mut self) -> io::Result<()> {
        let paragraph = std::mem::take(&mut self.paragraph);
        if paragraph.starts_with('|') {
            return writeln!(self.out, "{paragraph}");
        }
        for line in filled(&paragraph) {
            inline(&line, self.out)?;
            writeln!(self.out)?;
        }
        Ok(())
    }
}

fn heading(line: &str) -> Option<&str> {
    line.starts_with('#').then(|| line.trim_start_matches('#').strip_prefix(' ')).flatten()
}

/// Breaks a paragraph into lines. In a list item, they are aligned with its text.
fn filled(paragraph: &str) -> Vec<String> {
    let indent = if paragraph.starts_with("- ") { "  " } else { "" };
    let mut lines: Vec<String> = Vec::new();
    for word in words(paragraph) {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= WIDTH => {
                line.push(' ');
                line.push_str(word);
            }
            Some(_) => lines.push(format!("{indent}{word}")),
            None => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Splits the text at blanks outside of `code`.
fn words(text: &str) -> impl Iterator<Item = &str> {
    let mut in_code = false;
    text.split(move |letter| {
        in_code ^= letter == '`';
        letter == ' ' && !in_code
    })
    .filter(|word| !word.is_empty())
}

/// Writes a line with `code`. Without colours, the backticks remain.
fn inline(line: &str, out: &mut dyn WriteColor) -> io::Result<()> {
    let mut is_code = false;
    for part in line.split_inclusive('`') {
        let text = part.strip_suffix('`').unwrap_or(part);
        match is_code {
            true if out.supports_color() => styled(&code_style(), text, out)?,
            true => write!(out, "`{part}")?,
            false => write!(out, "{text}")?,
        }
        is_code = !is_code;
    }
    Ok(())
}

/// Writes `text` in a style and resets the style.
pub(crate) fn styled(style: &ColorSpec, text: &str, out: &mut dyn WriteColor) -> io::Result<()> {
    out.set_color(style)?;
    write!(out, "{text}")?;
    out.reset()
}

/// Style of headings.
pub(crate) fn heading_style() -> ColorSpec {
    let mut style = ColorSpec::new();
    style.set_bold(true);
    style
}

/// Style of code and of text to type.
pub(crate) fn code_style() -> ColorSpec {
    let mut style = ColorSpec::new();
    style.set_fg(Some(Color::Cyan));
    style
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::{Ansi, NoColor};

    use super::*;

    const PAGE: &str =
        "Moves to `pPick` and `x` on.\n\n## Example\n```val3\nmovej(a,b,c)\n\n  close(t)\n```\nEnd # 1.\n";

    #[test]
    fn pages_are_printed_without_colours() {
        let mut out = NoColor::new(Vec::new());
        render(PAGE, &mut out).unwrap();
        let text = String::from_utf8(out.into_inner()).unwrap();
        let expected = "Moves to `pPick` and `x` on.\n\nExample\n    movej(a,b,c)\n\n      close(t)\nEnd # 1.\n";
        assert_eq!(text, expected);
    }

    #[test]
    fn paragraphs_and_list_items_are_filled() {
        let code = format!("`{} b`", "a".repeat(74));
        let text = format!("One\ntwo.\n- item\n  {code}\n- next");
        assert_eq!(filled("").len(), 0);
        let mut out = NoColor::new(Vec::new());
        render(&text, &mut out).unwrap();
        let expected = format!("One two.\n- item\n  {code}\n- next\n");
        assert_eq!(String::from_utf8(out.into_inner()).unwrap(), expected);
    }

    #[test]
    fn pages_are_printed_with_colours() {
        let mut out = Ansi::new(Vec::new());
        render(PAGE, &mut out).unwrap();
        let text = String::from_utf8(out.into_inner()).unwrap();
        assert!(text.contains("\u{1b}[1mExample\u{1b}[0m"), "{text:?}");
        assert!(!text.contains('`'), "{text:?}");
    }
}
