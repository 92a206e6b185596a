//! `val3 eval`: values of expressions, and what statements do, in one scope.

mod answer;
mod execution;
mod interrupt;
mod locals;
mod prompt;
mod scope;
mod sources;

use std::io::{self, IsTerminal};
use std::process::ExitCode;

use clap::CommandFactory as _;

use crate::args::{Args, Color, EvalArgs};
use crate::output::{to_reader, to_stderr};
use crate::user_error::UserError;
use answer::Answer;
use scope::Scope;

/// Runs the command; the exit code says whether every text could be evaluated.
pub(crate) fn run(args: &EvalArgs, color: Color) -> Result<ExitCode, UserError> {
    if let Some(option) = args.texts.iter().find(|text| is_option(text)) {
        return Err(
            UserError::new(format!("`{option}` stands behind a text")).with_help("write options before the texts")
        );
    }
    let mut scope = Scope::open(args)?;
    if args.texts.is_empty() && io::stdin().is_terminal() {
        return prompt::run(scope, color);
    }
    let piped = if args.texts.is_empty() { lines_of_stdin()? } else { Vec::new() };
    let mut sound = true;
    for text in args.texts.iter().chain(&piped) {
        match evaluate(&mut scope, text, color)? {
            Outcome::Sound => {}
            Outcome::Faulty => sound = false,
            Outcome::Unread => break,
        }
    }
    Ok(if sound { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Texts may begin with a hyphen (`-nA`), so that an option behind one would be taken for a text.
fn is_option(text: &str) -> bool {
    let Some(name) = text.strip_prefix("--").and_then(|text| text.split('=').next()) else { return false };
    let mut command = Args::command();
    command.build();
    let known = command.find_subcommand("eval").map(clap::Command::get_arguments);
    known.is_some_and(|mut known| known.any(|option| option.get_long() == Some(name)))
}

fn lines_of_stdin() -> Result<Vec<String>, UserError> {
    let lines: Result<Vec<String>, _> = io::stdin().lines().collect();
    let lines = lines.map_err(|error| UserError::new(format!("cannot read the standard input: {error}")))?;
    Ok(lines.into_iter().filter(|line| !line.trim().is_empty()).collect())
}

/// What has come of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    /// It was evaluated.
    Sound,
    /// Something was wrong.
    Faulty,
    /// Nobody reads it.
    Unread,
}

/// Evaluates one text and shows what comes of it, as it comes.
fn evaluate(scope: &mut Scope, text: &str, color: Color) -> Result<Outcome, UserError> {
    let mut outcome = Outcome::Sound;
    let interrupt = scope.interrupt().clone();
    scope.evaluate(text, &mut |answer| {
        if outcome == Outcome::Sound && !answer.is_sound() {
            outcome = Outcome::Faulty;
        }
        if outcome != Outcome::Unread && !show(answer, text, color)? {
            outcome = Outcome::Unread;
            interrupt.ask();
        }
        Ok(())
    })?;
    Ok(outcome)
}

/// Shows a line on the standard output, and where a fault is on the standard error output. Whether somebody reads it.
fn show(answer: &Answer, text: &str, color: Color) -> Result<bool, UserError> {
    let is_read = to_reader(color, |out| writeln!(out, "{answer}"))?;
    if let Some(excerpt) = answer.fault().and_then(|fault| fault.excerpt(text)) {
        to_stderr(|out| writeln!(out, "{excerpt}"));
    }
    Ok(is_read)
}
