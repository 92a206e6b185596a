//! Writes the report to the standard output.

use std::io;

use codespan_reporting::term::termcolor::{Color as Paint, ColorSpec, WriteColor};
use val3_diff::format::human::{self, StyledLine, TextStyle};
use val3_diff::format::{html, json, markdown};
use val3_diff::model::Comparison;

use crate::args::{DiffArgs, DiffFormat};
use crate::color::Color;
use crate::output::{OutputContent, to_stdout, to_stdout_as};
use crate::printable::one_line;
use crate::user_error::UserError;

/// Writes the report.
pub(super) fn write(comparison: &Comparison, args: &DiffArgs, color: Color) -> Result<(), UserError> {
    let detail = args.detail();
    let text = match args.format {
        DiffFormat::Human => {
            let lines = human::lines(comparison, detail);
            return to_stdout(color, |out| lines.iter().try_for_each(|line| write_line(line, out)));
        }
        DiffFormat::Json => json::write(comparison, detail)
            .map_err(|error| UserError::new(format!("cannot write the differences as JSON: {error}")))?,
        DiffFormat::Markdown => markdown::write(comparison, detail),
        DiffFormat::Html => html::write(comparison, detail),
    };
    let content = if args.format == DiffFormat::Json { OutputContent::Json } else { OutputContent::Words };
    to_stdout_as(content, Color::Never, |out| out.write_all(text.as_bytes()))
}

fn write_line(line: &StyledLine, out: &mut dyn WriteColor) -> io::Result<()> {
    for (style, text) in line {
        let is_plain = *style == TextStyle::Plain;
        if !is_plain {
            out.set_color(&spec(*style))?;
        }
        out.write_all(one_line(text).as_bytes())?;
        if !is_plain {
            out.reset()?;
        }
    }
    writeln!(out)
}

fn spec(style: TextStyle) -> ColorSpec {
    let mut spec = ColorSpec::new();
    match style {
        TextStyle::Plain => {}
        TextStyle::Heading | TextStyle::Name => _ = spec.set_bold(true),
        TextStyle::Dim => _ = spec.set_dimmed(true),
        TextStyle::Added => _ = spec.set_fg(Some(Paint::Green)),
        TextStyle::Removed => _ = spec.set_fg(Some(Paint::Red)),
        TextStyle::Changed => _ = spec.set_fg(Some(Paint::Cyan)),
        TextStyle::Warning => _ = spec.set_fg(Some(Paint::Yellow)).set_bold(true),
    }
    spec
}
