//! `val3 eval`: values of expressions, and what statements do, in one scope.

mod locals;
mod prompt;
mod scope;
mod sources;

use std::io::{self, IsTerminal};
use std::process::ExitCode;

use crate::args::{Color, EvalArgs};
use crate::output::to_stdout;
use crate::user_error::UserError;
use scope::{Answer, Scope};

/// Runs the command; the exit code says whether every text could be evaluated.
pub(crate) fn run(args: &EvalArgs, color: Color) -> Result<ExitCode, UserError> {
    if let Some(option) = args.texts.iter().find(|text| is_option(text)) {
        return Err(
            UserError::new(format!("`{option}` stands behind a text")).with_help("write options before the texts")
        );
    }
    let mut scope = Scope::open(args)?;
    if args.texts.is_empty() && io::stdin().is_terminal() {
        return prompt::run(&mut scope, color);
    }
    let piped = if args.texts.is_empty() { lines_of_stdin()? } else { Vec::new() };
    let mut sound = true;
    for text in args.texts.iter().chain(&piped) {
        sound &= evaluate(&mut scope, text, color)?;
    }
    Ok(if sound { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Texts may begin with a hyphen (`-nA`), so that an option behind one would be taken for a text.
fn is_option(text: &str) -> bool {
    ["--local", "--app", "--arm"].contains(&text.split('=').next().unwrap_or_default())
}

fn lines_of_stdin() -> Result<Vec<String>, UserError> {
    let lines: Result<Vec<String>, _> = io::stdin().lines().collect();
    let lines = lines.map_err(|error| UserError::new(format!("cannot read the standard input: {error}")))?;
    Ok(lines.into_iter().filter(|line| !line.trim().is_empty()).collect())
}

/// Evaluates one text and shows what comes of it; whether nothing was wrong.
fn evaluate(scope: &mut Scope, text: &str, color: Color) -> Result<bool, UserError> {
    let answer = scope.evaluate(text);
    let sound = answer.iter().all(Answer::is_sound);
    to_stdout(color, |out| answer.iter().try_for_each(|answer| writeln!(out, "{answer}")))?;
    Ok(sound)
}
