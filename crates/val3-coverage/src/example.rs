//! A small report for the tests of the formats.

use std::io::{self, Write};

use crate::coverage::Coverage;
use crate::program::{Branch, ProgramCoverage, Side};

/// Returns an application with two programs, and a library whose code was not executed.
pub(crate) fn example() -> Coverage {
    let mut coverage = Coverage::default();
    coverage.add("usrapp/pal/start.pgx".to_owned(), start());
    let lines = [(4, 2)].into();
    coverage.add("usrapp/pal/stop.pgx".to_owned(), ProgramCoverage { lines, ..named("pal", "stop", &[]) });
    let lines = [(5, 0), (6, 0)].into();
    let feed = ProgramCoverage { lines, ..named("feeder", "feed", &[(5, "n=1"), (6, "m=2")]) };
    coverage.add("usrapp/feeder/feed.pgx".to_owned(), feed);
    coverage
}

fn start() -> ProgramCoverage {
    let source = [
        (9, "begin"),
        (10, "  if a<b & \"c\""),
        (11, "    x=1"),
        (12, "  endIf"),
        (13, "  switch n"),
        (14, "    case \"a\""),
    ];
    let side = |(name, hits): (&str, u64)| Side { name: name.to_owned(), hits };
    let sides = |sides: &[(&str, u64)]| sides.iter().copied().map(side).collect();
    ProgramCoverage {
        lines: [(10, 3), (11, 3), (13, 7), (15, 0), (16, 0), (19, 1), (20, 0)].into(),
        branches: vec![
            Branch { line: 10, sides: sides(&[("true", 3), ("false", 0)]) },
            Branch { line: 13, sides: sides(&[("case \"a\"", 0), ("no case", 7)]) },
            Branch { line: 15, sides: sides(&[("true", 0), ("false", 0)]) },
            Branch { line: 19, sides: sides(&[("true", 1), ("false", 1)]) },
        ],
        ..named("pal", "start", &source)
    }
}

fn named(project: &str, program: &str, source: &[(u32, &str)]) -> ProgramCoverage {
    let source = source.iter().map(|(line, text)| (*line, (*text).to_owned())).collect();
    ProgramCoverage { project: project.to_owned(), program: program.to_owned(), source, ..ProgramCoverage::default() }
}

/// Returns the output of a format.
pub(crate) fn text(write: impl Fn(&mut dyn Write) -> io::Result<()>) -> String {
    let mut out = Vec::new();
    write(&mut out).unwrap();
    String::from_utf8(out).unwrap()
}
