//! Table for terminals.

use std::io::{self, Write};

use crate::coverage::Coverage;
use crate::program::ProgramCoverage;
use crate::share::Share;

/// A row: name, lines, branches, and missing lines.
type CoverageRow = (String, Share, Share, String);

/// Writes a row for each application or library and for each program, and a row with the sums.
///
/// # Errors
/// If writing to `out` fails.
pub fn write(coverage: &Coverage, out: &mut dyn Write) -> io::Result<()> {
    let rows = rows(coverage);
    let width = rows.iter().map(|(name, ..)| name.chars().count()).max().unwrap_or(0);
    writeln!(out, "{:width$}  {:>16}  {:>16}  missing lines", "coverage", "lines", "branches")?;
    for (name, lines, branches, missing) in rows {
        let row = format!("{name:width$}  {}  {}  {missing}", cell(lines), cell(branches));
        writeln!(out, "{}", row.trim_end())?;
    }
    Ok(())
}

fn rows(coverage: &Coverage) -> Vec<CoverageRow> {
    let mut rows = Vec::new();
    for project in coverage.projects() {
        rows.push((project.name.clone(), project.line_share(), project.branch_share(), String::new()));
        rows.extend(project.programs.iter().map(|(_, program)| of(program)));
    }
    rows.push(("total".to_owned(), coverage.line_share(), coverage.branch_share(), String::new()));
    rows
}

fn of(program: &ProgramCoverage) -> CoverageRow {
    let name = format!("  {}", program.program);
    (name, program.line_share(), program.branch_share(), ranges(program))
}

/// Formats ranges: `3-5, 9`.
fn ranges(program: &ProgramCoverage) -> String {
    let range = |(first, last): (u32, u32)| if first == last { first.to_string() } else { format!("{first}-{last}") };
    program.missing_lines().into_iter().map(range).collect::<Vec<_>>().join(", ")
}

/// Formats a cell: ` 66.6 %      2/3`.
fn cell(share: Share) -> String {
    let count = format!("{}/{}", share.hit, share.total);
    let percent = if share.total == 0 { String::new() } else { share.to_string() };
    format!("{percent:>7} {:>8}", if share.total == 0 { "-".to_owned() } else { count })
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::example::{example, text};

    #[test]
    fn programs_follow_their_application() {
        expect![[r#"
            coverage             lines          branches  missing lines
            feeder     0.0 %      0/2                 -
              feed     0.0 %      0/2                 -  5-6
            pal       62.5 %      5/8   50.0 %      4/8
              start   57.1 %      4/7   50.0 %      4/8  15-16, 20
              stop   100.0 %      1/1                 -
            total     50.0 %     5/10   50.0 %      4/8
        "#]]
        .assert_eq(&text(|out| super::write(&example(), out)));
    }
}
