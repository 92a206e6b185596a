//! LCOV, the text format of `genhtml` and most services.

use std::io::{self, Write};

use crate::coverage::Coverage;
use crate::program::ProgramCoverage;

/// Writes a record for each file, with the program as its function.
///
/// # Errors
/// If writing to `out` fails.
pub fn write(coverage: &Coverage, out: &mut dyn Write) -> io::Result<()> {
    coverage.programs().try_for_each(|(file, program)| record(file, program, out))
}

fn record(file: &str, program: &ProgramCoverage, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "TN:\nSF:{file}")?;
    if let Some((line, hits)) = program.lines.first_key_value() {
        let name = &program.program;
        writeln!(out, "FN:{line},{name}\nFNDA:{hits},{name}\nFNF:1\nFNH:{}", u8::from(*hits > 0))?;
    }
    branches(program, out)?;
    for (line, hits) in &program.lines {
        writeln!(out, "DA:{line},{hits}")?;
    }
    let share = program.line_share();
    writeln!(out, "LF:{}\nLH:{}\nend_of_record", share.total, share.hit)
}

fn branches(program: &ProgramCoverage, out: &mut dyn Write) -> io::Result<()> {
    for (block, branch) in program.branches.iter().enumerate() {
        let is_reached = program.lines.get(&branch.line).is_some_and(|hits| *hits > 0);
        for (number, side) in branch.sides.iter().enumerate() {
            let taken = if is_reached { side.hits.to_string() } else { "-".to_owned() };
            writeln!(out, "BRDA:{},{block},{number},{taken}", branch.line)?;
        }
    }
    let share = program.branch_share();
    if share.total == 0 { Ok(()) } else { writeln!(out, "BRF:{}\nBRH:{}", share.total, share.hit) }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::example::{example, text};

    #[test]
    fn a_file_is_a_record() {
        expect![[r#"
            TN:
            SF:usrapp/feeder/feed.pgx
            FN:5,feed
            FNDA:0,feed
            FNF:1
            FNH:0
            DA:5,0
            DA:6,0
            LF:2
            LH:0
            end_of_record
            TN:
            SF:usrapp/pal/start.pgx
            FN:10,start
            FNDA:3,start
            FNF:1
            FNH:1
            BRDA:10,0,0,3
            BRDA:10,0,1,0
            BRDA:13,1,0,0
            BRDA:13,1,1,7
            BRDA:15,2,0,-
            BRDA:15,2,1,-
            BRDA:19,3,0,1
            BRDA:19,3,1,1
            BRF:8
            BRH:4
            DA:10,3
            DA:11,3
            DA:13,7
            DA:15,0
            DA:16,0
            DA:19,1
            DA:20,0
            LF:7
            LH:4
            end_of_record
            TN:
            SF:usrapp/pal/stop.pgx
            FN:4,stop
            FNDA:2,stop
            FNF:1
            FNH:1
            DA:4,2
            LF:1
            LH:1
            end_of_record
        "#]]
        .assert_eq(&text(|out| super::write(&example(), out)));
    }
}
