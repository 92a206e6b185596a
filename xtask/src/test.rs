//! `test`: every check and every test of the project, in one command.

mod failures;
mod tools;

use std::io::{BufRead as _, BufReader};
use std::num::NonZero;
use std::process::{Command, Stdio};
use std::time::Instant;

use anyhow::Context;
use clap::builder::PossibleValuesParser;

use crate::project;
use failures::Failures;
use tools::Tools;

/// Options of `test`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Only these steps; all of them if none is named
    #[arg(value_name = "STEP", value_parser = PossibleValuesParser::new(STEPS.iter().map(|step| step.name)))]
    steps: Vec<String>,
    /// All steps but these, for machines that cannot have their tools
    #[arg(
        long,
        value_name = "STEP",
        num_args = 1..,
        value_delimiter = ',',
        conflicts_with = "steps",
        value_parser = PossibleValuesParser::new(STEPS.iter().map(|step| step.name)),
    )]
    without: Vec<String>,
}

/// A check. Every step runs, also after a step that failed.
struct Step {
    name: &'static str,
    run: StepCommand,
}

enum StepCommand {
    Cargo(&'static [&'static str]),
    /// A script of the project and its arguments.
    Script(&'static str, &'static [&'static str]),
}

/// The step that tests editors.
const EDITORS: &str = "editors";

const STEPS: &[Step] = &[
    Step { name: "format", run: StepCommand::Cargo(&["xtask", "fmt", "--check"]) },
    Step { name: "tidy", run: StepCommand::Cargo(&["xtask", "tidy"]) },
    Step {
        name: "clippy",
        run: StepCommand::Cargo(&[
            "clippy",
            "--workspace",
            "--all-targets",
            "--locked",
            "--quiet",
            "--",
            "--deny",
            "warnings",
        ]),
    },
    Step {
        name: "documentation",
        // The targets are those that cargo documents by default. `--examples` selects none, but gives the dependencies the
        // features of development dependencies, as clippy does, so that cargo does not check them again.
        run: StepCommand::Cargo(&[
            "doc",
            "--workspace",
            "--lib",
            "--bin",
            "val3",
            "--examples",
            "--no-deps",
            "--document-private-items",
            "--locked",
            "--quiet",
        ]),
    },
    Step {
        name: "dependencies",
        run: StepCommand::Script(
            "tests/tools/run",
            &["cargo-deny", "--locked", "check", "bans", "licenses", "sources"],
        ),
    },
    Step { name: "workflows", run: StepCommand::Script("tests/tools/workflows", &[]) },
    Step { name: "hooks", run: StepCommand::Script("tests/tools/hooks", &[]) },
    Step { name: "reports", run: StepCommand::Script("tests/tools/reports", &[]) },
    Step { name: "tests", run: StepCommand::Cargo(&["test", "--workspace", "--locked", "--no-fail-fast"]) },
    Step { name: "coverage", run: StepCommand::Script("tests/tools/coverage", &[]) },
    Step { name: "python", run: StepCommand::Script("tests/python/run", &[]) },
    Step { name: EDITORS, run: StepCommand::Script("tests/editors/run", &[]) },
];

/// Numbers of passed and failed checks and tests.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
struct Tally {
    passed: usize,
    failed: usize,
}

/// Runs the steps and prints the number of checks and tests as the last line. The exit code is 1 if one failed.
///
/// # Errors
/// The machine has no tools for a step, or a step cannot be started.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    let mut total = Tally::default();
    let mut failed = Vec::new();
    let mut failures = Failures::default();
    let steps: Vec<&Step> = STEPS.iter().filter(|step| arguments.wants(step.name)).collect();
    let names: Vec<&str> = steps.iter().map(|step| step.name).collect();
    let begin = Instant::now();
    let mut tools = Tools::prepare(&names)?;
    for step in steps {
        println!("==> {}, after {} s", step.name, begin.elapsed().as_secs());
        let tally = match run_step(step, &mut tools, &mut failures) {
            Ok(tally) => tally,
            Err(error) => {
                println!("error: {error:#}");
                Tally { passed: 0, failed: 1 }
            }
        };
        total.passed += tally.passed;
        total.failed += tally.failed;
        failed.extend((tally.failed > 0).then_some(step.name));
    }
    tools.close()?;
    failures.print();
    if !failed.is_empty() {
        println!("failed: {}", failed.join(", "));
    }
    if !arguments.without.is_empty() {
        println!("left out: {}", arguments.without.join(", "));
    }
    println!("took {} s", begin.elapsed().as_secs());
    println!("{} passed, {} failed", total.passed, total.failed);
    if failed.is_empty() { Ok(()) } else { std::process::exit(1) }
}

impl Arguments {
    fn wants(&self, step: &str) -> bool {
        let is_named = self.steps.is_empty() || self.steps.iter().any(|name| name == step);
        is_named && !self.without.iter().any(|name| name == step)
    }
}

/// Runs a step. It counts as the tests that it reports, or as one check if it reports none.
fn run_step(step: &Step, tools: &mut Tools, failures: &mut Failures) -> anyhow::Result<Tally> {
    let mut command = match step.run {
        StepCommand::Cargo(arguments) => {
            tools.advance()?;
            project::cargo(arguments)
        }
        StepCommand::Script(path, arguments) => {
            let mut script = Command::new(project::root().join(path));
            script.args(arguments).env("PATH", tools.path()?);
            script
        }
    };
    command.env("RUSTDOCFLAGS", "--deny warnings").env("RUST_TEST_THREADS", test_threads().to_string());
    let mut child =
        command.stdout(Stdio::piped()).spawn().with_context(|| format!("cannot start the step {}", step.name))?;
    let mut tally = Tally::default();
    if let Some(output) = child.stdout.take() {
        for line in BufReader::new(output).lines() {
            let line = line?;
            println!("{line}");
            count(&line, &mut tally);
            failures.read(step.name, &line);
        }
    }
    if child.wait()?.success() {
        tally.passed = tally.passed.max(1);
    } else {
        tally.failed = tally.failed.max(1);
    }
    Ok(tally)
}

/// Number of tests that run at the same time: two for each core, because many tests wait for a process or a connection.
fn test_threads() -> usize {
    2 * std::thread::available_parallelism().map_or(1, NonZero::get)
}

/// Adds the numbers in `test result: ok. 12 passed; 0 failed; …`.
fn count(line: &str, tally: &mut Tally) {
    let Some(result) = line.strip_prefix("test result: ") else { return };
    tally.passed += number_before(" passed", result).unwrap_or(0);
    tally.failed += number_before(" failed", result).unwrap_or(0);
}

fn number_before(word: &str, result: &str) -> Option<usize> {
    let before = result.split(word).next()?;
    before.split_whitespace().last()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_steps_run_alone() {
        let only = Arguments { steps: vec!["tidy".to_owned()], without: Vec::new() };
        let names: Vec<_> = STEPS.iter().filter(|step| only.wants(step.name)).map(|step| step.name).collect();
        assert_eq!(names, ["tidy"]);
        let all = Arguments { steps: Vec::new(), without: Vec::new() };
        assert!(STEPS.iter().all(|step| all.wants(step.name)));
    }

    #[test]
    fn steps_are_left_out_by_name() {
        let some = Arguments { steps: Vec::new(), without: vec![EDITORS.to_owned(), "coverage".to_owned()] };
        let left_out: Vec<_> = STEPS.iter().filter(|step| !some.wants(step.name)).map(|step| step.name).collect();
        assert_eq!(left_out, ["coverage", EDITORS]);
    }

    #[test]
    fn counts_are_added() {
        let mut tally = Tally::default();
        count("test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured", &mut tally);
        count("test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured", &mut tally);
        count("a line of another kind: 7 passed", &mut tally);
        assert_eq!(tally, Tally { passed: 15, failed: 2 });
    }
}
