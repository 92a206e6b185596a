//! `val3 test`: the tests of applications, each on a controller of its own in virtual time.

mod discovery;
mod github;
mod human;
mod init;
mod json;
mod junit;
mod order;
mod tap;
mod tested;
mod workers;

use std::iter;
use std::process::ExitCode;

use crate::args::{TestArgs, TestFormat};
use crate::color::Color;
use crate::output::to_stdout;
use crate::paths::{Paths, current_folder};
use crate::user_error::UserError;
use discovery::{TestFile, chosen, suites};
pub(crate) use order::Shard;

/// Runs the command.
pub(crate) fn run(args: &TestArgs, color: Color) -> Result<ExitCode, UserError> {
    if args.init {
        return init::run(&args.paths);
    }
    let current = current_folder()?;
    let suites = suites(args, &current)?;
    let tests = chosen(args, &suites);
    if args.list {
        return to_stdout(color, |out| tests.iter().try_for_each(|test| writeln!(out, "{}", test.case.name())))
            .map(|()| ExitCode::SUCCESS);
    }
    let repeated: Vec<TestFile<'_>> =
        tests.iter().flat_map(|test| iter::repeat_n(*test, args.repeat as usize)).collect();
    let tested = workers::executed(args, &repeated)?;
    let paths = Paths::new(&args.paths, &current);
    to_stdout(color, |out| match args.format {
        TestFormat::Human => human::write(&tested, &paths, out),
        TestFormat::Json => json::write(&tested, &paths, out),
        TestFormat::Junit => junit::write(&tested, &paths, out),
        TestFormat::Tap => tap::write(&tested, &paths, out),
        TestFormat::Github => github::write(&tested, &paths, out),
    })?;
    Ok(if tested.iter().all(|test| test.result.failure.is_none()) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
