//! `val3 eval`: values of expressions, and what statements do, in one scope.

mod answer;
mod declaration;
mod execution;
mod interrupt;
mod locals;
mod prompt;
mod scope;
mod sources;

use std::io::{self, IsTerminal};
use std::process::ExitCode;

use clap::{CommandFactory as _, ValueEnum};

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
    let scope = Scope::open(args)?;
    if args.texts.is_empty() && io::stdin().is_terminal() {
        return prompt::run(scope, color);
    }
    let mut progress = Progress { scope, color, sound: true };
    if args.texts.is_empty() {
        progress.read_stdin()?;
    } else {
        progress.evaluate_all(args.texts.iter().flat_map(|text| sources::texts(text)))?;
    }
    Ok(if progress.sound { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Texts that are evaluated one after the other.
struct Progress {
    scope: Scope,
    color: Color,
    /// Every text could be evaluated so far.
    sound: bool,
}

impl Progress {
    /// Evaluates texts until one of them ends the session. The answer is whether the session continues.
    fn evaluate_all(&mut self, texts: impl IntoIterator<Item = String>) -> Result<bool, UserError> {
        for text in texts {
            match evaluate(&mut self.scope, &text, self.color)? {
                Outcome::Sound => {}
                Outcome::Faulty => self.sound = false,
                Outcome::Unread | Outcome::Exit => return Ok(false),
            }
        }
        Ok(true)
    }

    /// Evaluates each text of the standard input as soon as it is complete.
    fn read_stdin(&mut self) -> Result<(), UserError> {
        let mut open = String::new();
        for line in io::stdin().lines() {
            let line = line.map_err(|error| UserError::new(format!("cannot read the standard input: {error}")))?;
            if !self.evaluate_all(sources::next_text(&mut open, &line))? {
                return Ok(());
            }
        }
        self.evaluate_all(sources::texts(&open)).map(drop)
    }
}

/// Texts may begin with a hyphen (`-nA`), so that an option behind one would be taken for a text.
fn is_option(text: &str) -> bool {
    let Some(name) = text.strip_prefix("--").and_then(|text| text.split('=').next()) else { return false };
    let mut command = Args::command();
    command.build();
    let known = command.find_subcommand("eval").map(clap::Command::get_arguments);
    known.is_some_and(|mut known| known.any(|option| option.get_long() == Some(name)))
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
    /// It ends the session.
    Exit,
}

/// A word that is a command of the session and no text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Command {
    Exit,
    Quit,
    Help,
}

/// What can be written.
const HELP: &str = "\
num nA, num nA=2, point pA[3]   declare variables
nA*2                            print the value of an expression
nA=nA+1                         execute statements; blocks may have several lines
exit, quit                      leave; at a terminal Ctrl-D does the same
The program `val3 explain NAME` shows the page of an instruction.";

/// Obeys a word that is a command of the session, unless a variable has this name.
fn command(scope: &Scope, text: &str, color: Color) -> Result<Option<Outcome>, UserError> {
    let word = text.trim();
    if scope.has_variable(word) {
        return Ok(None);
    }
    Ok(match Command::from_str(word, false) {
        Ok(Command::Exit | Command::Quit) => Some(Outcome::Exit),
        Ok(Command::Help) => {
            let is_read = to_reader(color, |out| writeln!(out, "{HELP}"))?;
            Some(if is_read { Outcome::Sound } else { Outcome::Unread })
        }
        Err(_) => None,
    })
}

/// Evaluates one text and shows what comes of it, as it comes.
fn evaluate(scope: &mut Scope, text: &str, color: Color) -> Result<Outcome, UserError> {
    if let Some(outcome) = command(scope, text, color)? {
        return Ok(outcome);
    }
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
