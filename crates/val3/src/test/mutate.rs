//! `--mutate`: seeds mistakes into the tested programs and their data, and reports the mistakes that no test finds.
//!
//! A mistake exists only in memory. It is tried with the tests that execute its line, or a line that names its
//! variable.

mod code_sites;
mod data_sites;
mod executor;
mod mutant;
mod original;
mod report;
mod site;
mod trial;
mod used_names;

use std::process::ExitCode;

use super::discovery::TestFile;
use super::refused::RefusedTests;
use super::results::{EarlyEnd, Results};
use super::workers::Surroundings;
use super::{exit_code, human, json};
use crate::args::{TestArgs, TestFormat};
use crate::color::Color;
use crate::output::{to_stderr, to_stdout_as};
use crate::paths::Paths;
use crate::user_error::{EXIT_USAGE, UserError};
use executor::{Conditions, SEED};
use mutant::mutants;
use original::originals;
use report::MutationReport;
use trial::Verdict;

/// Trial of mistakes, with the output of its report.
pub(super) struct MutationRun<'a> {
    pub(super) args: &'a TestArgs,
    pub(super) surroundings: &'a Surroundings<'a>,
    pub(super) paths: &'a Paths,
    pub(super) color: Color,
}

/// Executes the tests, tries the number of mistakes in the arguments, and reports the surviving mistakes.
///
/// # Errors
/// The report does not support the format, an application can no longer be read, or the report cannot be written.
pub(super) fn run(
    mutation_run: &MutationRun<'_>,
    tests: &[TestFile<'_>],
    refused: Vec<RefusedTests>,
) -> Result<ExitCode, UserError> {
    let MutationRun { args, surroundings, paths, color } = *mutation_run;
    if !matches!(args.format, TestFormat::Human | TestFormat::Json) {
        return Err(UserError::new("the mistakes of --mutate can be reported in the formats `human` and `json` alone")
            .with_help("val3 test --mutate --format json"));
    }
    let flag = surroundings.signals.flag();
    let conditions = Conditions { args, surroundings, is_interrupted: &flag };
    let (originals, mut results) = originals(conditions, tests);
    results.tested.extend(refused.into_iter().map(RefusedTests::into_tested));
    if results.early_end.is_some() || results.failed() > 0 {
        return unmutated(mutation_run, &results);
    }
    let mutants = mutants(&originals)?;
    if mutants.all.is_empty() {
        return Err(UserError::new("the tests execute no line of a tested program in which a mistake can be made")
            .with_help("`val3 test --coverage` shows the lines that tests execute"));
    }
    let trials = trial::all(conditions, &originals, &mutants.all)?;
    let seed = args.seed.unwrap_or(SEED);
    let report = MutationReport { originals: &originals, trials: &trials, unused: &mutants.unused, paths, seed };
    to_stdout_as(args.format.content(), color, |out| match args.format {
        TestFormat::Json => report.json(out),
        _ => report.human(out),
    })?;
    let code = surroundings.signals.exit_code().unwrap_or_else(|| code(trials.iter().map(|trial| &trial.verdict)));
    if code == EXIT_USAGE {
        to_stderr(|out| {
            writeln!(out, "error: none of the mistakes could be executed, so the tests have proved nothing")
        });
    }
    Ok(ExitCode::from(code))
}

/// Exit code: 0 if the tests have found all executable mistakes, 1 if a mistake survives, 2 if no mistake could be
/// executed.
fn code<'v>(verdicts: impl Iterator<Item = &'v Verdict>) -> u8 {
    let (mut found, mut survived) = (false, false);
    for verdict in verdicts {
        found |= matches!(verdict, Verdict::Found(_));
        survived |= matches!(verdict, Verdict::Survived(_));
    }
    match (found, survived) {
        (_, true) => 1,
        (true, false) => 0,
        (false, false) => EXIT_USAGE,
    }
}

/// Reports tests that fail without a mistake, or an interruption by a signal.
fn unmutated(mutation_run: &MutationRun<'_>, results: &Results) -> Result<ExitCode, UserError> {
    let MutationRun { args, paths, color, .. } = *mutation_run;
    to_stdout_as(args.format.content(), color, |out| match args.format {
        TestFormat::Json => json::write(results, paths, out),
        _ => human::write(results, true, paths, out),
    })?;
    if !matches!(results.early_end, Some(EarlyEnd::Signal(_))) {
        to_stderr(|out| writeln!(out, "error: no mistake was seeded, because the tests must pass without one"));
    }
    Ok(exit_code(results, true))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mistakes_that_are_not_executed_prove_nothing() {
        let (found, survived, refused) = (Verdict::Found(0), Verdict::Survived(None), Verdict::NotCompiled);
        assert_eq!(code([&found, &refused].into_iter()), 0);
        assert_eq!(code([&found, &survived].into_iter()), 1);
        assert_eq!(code([&refused, &refused].into_iter()), EXIT_USAGE);
        assert_eq!(code(std::iter::empty()), EXIT_USAGE);
    }
}
