//! Speed of applications in comparison with the same algorithms in Lua and CPython: `cargo xtask metrics --run`.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, ensure};
use camino::Utf8Path;

use crate::project;

/// Applications in `benches/programs`. All except the last one, which waits for an hour, exist in Lua and Python too.
pub const PROGRAMS: [&str; 9] =
    ["sieve", "loops", "arrays", "fibonacci", "functions", "texts", "transformations", "tasks", "waiting"];

/// Number of runs. Only the fastest run counts, because the slower runs were disturbed.
const RUNS: usize = 3;

/// Prints the seconds per program, from the start of the process to the end.
///
/// # Errors
/// A program fails, or two versions of a program do not print the same.
pub(super) fn measure() -> anyhow::Result<()> {
    println!("{:16} {:>8} {:>8} {:>8} {:>8} {:>8}", "seconds", "val3", "lua", "python", "x lua", "x python");
    PROGRAMS.iter().try_for_each(|name| row(name))
}

fn row(name: &str) -> anyhow::Result<()> {
    let folder = project::root().join("benches/programs").join(name);
    let (expected, val3) = fastest(&[project::binary(project::DIST)?.as_str(), "run", folder.as_str()])?;
    print!("{name:16} {:8.3}", val3.as_secs_f64());
    let mut factors = String::new();
    for (interpreter, ending) in [("lua5.4", "lua"), ("python3", "py")] {
        let program = folder.join(name).with_extension(ending);
        if !program.exists() {
            continue;
        }
        let (printed, time) = fastest(&[interpreter, program.as_str()])?;
        ensure!(expected.ends_with(&printed), "{program} prints {printed}, val3 {expected}");
        print!(" {:8.3}", time.as_secs_f64());
        factors += &format!(" {:8.1}", time.as_secs_f64() / val3.as_secs_f64());
    }
    println!("{factors}");
    Ok(())
}

/// Returns the output of a command, and its shortest duration.
fn fastest(command: &[&str]) -> anyhow::Result<(String, Duration)> {
    let runs = (0..RUNS).map(|_| run(command)).collect::<anyhow::Result<Vec<_>>>()?;
    runs.into_iter().min_by_key(|(_, time)| *time).context("no run")
}

fn run(command: &[&str]) -> anyhow::Result<(String, Duration)> {
    let (program, arguments) = command.split_first().context("no command")?;
    let started = Instant::now();
    let output = Command::new(program).args(arguments).stderr(Stdio::inherit()).output();
    let time = started.elapsed();
    let output = output.with_context(|| format!("cannot start {}", Utf8Path::new(program)))?;
    ensure!(output.status.success(), "{} ended with {}", command.join(" "), output.status);
    Ok((String::from_utf8(output.stdout)?, time))
}
