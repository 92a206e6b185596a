//! Changes as a unified diff for `patch -p1` and `git apply`.

use std::io;

use codespan_reporting::term::termcolor::{Color, ColorSpec, WriteColor};
use similar::TextDiff;
use val3_check::fix::FixedFile;

use crate::paths::Paths;

/// Writes a diff for each file.
pub(crate) fn write(files: &[FixedFile], paths: &Paths, out: &mut dyn WriteColor) -> io::Result<()> {
    files.iter().try_for_each(|file| write_diff(&paths.shown(&file.path), &file.before, &file.after, out))
}

/// Writes one file's diff.
pub(crate) fn write_diff(path: &str, before: &str, after: &str, out: &mut dyn WriteColor) -> io::Result<()> {
    let diff = TextDiff::from_lines(before, after);
    let text = diff.unified_diff().header(&format!("a/{path}"), &format!("b/{path}")).to_string();
    for line in text.split_inclusive('\n') {
        out.set_color(&color(line))?;
        // A line of the file may end with a carriage return: colours are reset before it.
        let content = line.trim_end_matches(['\r', '\n']);
        out.write_all(content.as_bytes())?;
        out.reset()?;
        out.write_all(line.get(content.len()..).unwrap_or("").as_bytes())?;
    }
    Ok(())
}

fn color(line: &str) -> ColorSpec {
    let mut spec = ColorSpec::new();
    match line.as_bytes() {
        [b'-', b'-', b'-', ..] | [b'+', b'+', b'+', ..] => spec.set_bold(true),
        [b'-', ..] => spec.set_fg(Some(Color::Red)),
        [b'+', ..] => spec.set_fg(Some(Color::Green)),
        [b'@', ..] => spec.set_fg(Some(Color::Cyan)),
        _ => &mut spec,
    };
    spec
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::NoColor;

    use super::*;

    #[test]
    fn changed_lines_are_shown_with_their_context() {
        let before = "begin\r\n  IF a\r\n  endIf\r\nend";
        let mut out = NoColor::new(Vec::new());
        write_diff("app/a.pgx", before, &before.replace("IF", "if"), &mut out).unwrap();
        let text = String::from_utf8(out.into_inner()).unwrap().replace('\r', "␍");
        insta::assert_snapshot!(text);
    }
}
