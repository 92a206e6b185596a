//! Coverage of the tested programs: a table, report files, and the minimum share.

use std::fs;

use camino::Utf8Path;
use val3_analysis::items::program::code;
use val3_coverage::{Coverage, Share, cobertura, json, lcov, pages, table};
use val3_files::FileClass;
use val3_syntax::{decode_entities, encoding, parse};

use crate::args::{CoverageArgs, CoverageFormat, ReportOutput, TestArgs, TestFormat};
use crate::color::Color;
use crate::output::file_kind::OutputFileKind;
use crate::output::{to_file, to_stderr, to_stdout};
use crate::paths::Paths;
use crate::printable::one_line;
use crate::user_error::UserError;

/// Start of code that is not escaped.
const CDATA: &str = "<![CDATA[";

/// Writes the reports. Returns whether enough lines were executed.
///
/// # Errors
/// A report cannot be written.
pub(super) fn report(args: &TestArgs, counted: Coverage, paths: &Paths, color: Color) -> Result<bool, UserError> {
    if !args.coverage.is_wanted() {
        return Ok(true);
    }
    let coverage =
        counted.shown(|file| shown(file, paths), |file| one_line(&paths.in_repository(file.into())).into_owned());
    if args.format == TestFormat::Human {
        to_stdout(color, |out| table(&coverage, out))?;
    } else {
        to_stderr(|out| table(&coverage, out));
    }
    args.coverage.coverage_output.iter().try_for_each(|output| write(&coverage, output, paths))?;
    let shortfall = shortfall(&args.coverage, coverage.line_share());
    if let Some(message) = &shortfall {
        to_stderr(|out| writeln!(out, "error: {message}"));
    }
    Ok(shortfall.is_none())
}

/// Path by which services identify a file, and its code lines. `None` for a library that only a test has written.
fn shown(file: &str, paths: &Paths) -> Option<(String, Vec<(u32, String)>)> {
    let bytes = val3_files::read(file.into(), FileClass::Program).ok()?;
    Some((one_line(&paths.in_repository(file.into())).into_owned(), source(&encoding::decode(bytes).text)))
}

/// Code lines of a program with their line numbers in the file.
fn source(text: &str) -> Vec<(u32, String)> {
    let parse = parse(text);
    let range = code(parse.view()).map(|code| usize::from(code.range().start())..usize::from(code.range().end()));
    let Some((start, code)) = range.and_then(|range| Some((range.start, text.get(range)?))) else { return Vec::new() };
    let first = text.bytes().take(start).filter(|byte| *byte == b'\n').count();
    let first = u32::try_from(first).unwrap_or(u32::MAX).saturating_add(1);
    let is_cdata = code.starts_with(CDATA);
    let lines = (first..).zip(code.lines()).map(|(number, line)| (number, code_line(line, is_cdata)));
    let lines: Vec<(u32, String)> = lines.collect();
    let is_blank = |(_, text): &(u32, String)| text.trim().is_empty();
    let end = lines.iter().rposition(|line| !is_blank(line)).map_or(0, |last| last + 1);
    lines.into_iter().take(end).skip_while(is_blank).collect()
}

/// VAL 3 code in a line of the file, without the mark-up of XML.
fn code_line(line: &str, is_cdata: bool) -> String {
    match is_cdata {
        true => line.trim_start_matches(CDATA).trim_end_matches("]]>").to_owned(),
        false => decode_entities(line).into_owned(),
    }
}

fn write(coverage: &Coverage, output: &ReportOutput<CoverageFormat>, paths: &Paths) -> Result<(), UserError> {
    let path = &output.path;
    match output.format {
        CoverageFormat::Lcov => to_file(path, OutputFileKind::Text, |out| lcov(coverage, out)),
        CoverageFormat::Cobertura => {
            to_file(path, OutputFileKind::XmlReport, |out| cobertura(coverage, &paths.source_root(), out))
        }
        CoverageFormat::Json => to_file(path, OutputFileKind::Json, |out| json(coverage, out)),
        CoverageFormat::Html => write_pages(coverage, path),
    }
}

fn write_pages(coverage: &Coverage, folder: &Utf8Path) -> Result<(), UserError> {
    fs::create_dir_all(folder)
        .map_err(|error| UserError::new(format!("cannot create the folder `{folder}`: {error}")))?;
    pages(coverage).iter().try_for_each(|page| {
        to_file(&folder.join(&page.name), OutputFileKind::Html, |out| write!(out, "{}", page.text))
    })
}

/// Error message if too few lines were executed.
fn shortfall(args: &CoverageArgs, lines: Share) -> Option<String> {
    let wanted = args.fail_under?;
    if lines.total == 0 {
        return Some(
            "no line was counted: the tests have loaded no application or library other than tests".to_owned(),
        );
    }
    let Share { hit, total } = lines;
    (lines.percent() < wanted)
        .then(|| format!("{lines} of the lines were executed ({hit} of {total}), fewer than {wanted} %"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_has_the_lines_of_its_file() {
        let lines =
            |text: &str| source(text).into_iter().map(|(line, text)| format!("{line}:{text}")).collect::<Vec<_>>();
        let new = "<?xml version=\"1.0\"?>\n<Programs>\n<Program name=\"p\">\n<Code><![CDATA[\nbegin\n  n=1 //a&lt;\n\nend\n]]></Code>\n</Program></Programs>";
        assert_eq!(lines(new), ["5:begin", "6:  n=1 //a&lt;", "7:", "8:end"]);
        let old = "<programList><program name=\"p\">\r\n<source><code>begin\r\n  if n&lt;1\r\n  endIf\r\nend</code></source></program></programList>";
        assert_eq!(lines(old), ["2:begin", "3:  if n<1", "4:  endIf", "5:end"]);
        assert!(source("no XML").is_empty());
    }
}
