//! `val3 eval` at a terminal: lines with history and completion.

use std::process::ExitCode;

use rustyline::completion::{Completer, Pair};
use rustyline::error::ReadlineError;
use rustyline::history::DefaultHistory;
use rustyline::{Context, Editor, Helper, Highlighter, Hinter, Validator};
use val3_lang::instructions;

use super::evaluate;
use super::scope::Scope;
use crate::args::Color;
use crate::user_error::UserError;

/// Reads texts and evaluates them until the end of the input.
pub(crate) fn run(scope: &mut Scope, color: Color) -> Result<ExitCode, UserError> {
    let mut editor: Editor<Names, DefaultHistory> = Editor::new().map_err(|error| no_terminal(&error))?;
    editor.set_helper(Some(Names));
    loop {
        match editor.readline("> ") {
            Ok(text) if text.trim().is_empty() => {}
            Ok(text) => {
                editor.add_history_entry(&text).map_err(|error| no_terminal(&error))?;
                evaluate(scope, &text, color)?;
            }
            Err(ReadlineError::Interrupted) => {}
            Err(ReadlineError::Eof) => return Ok(ExitCode::SUCCESS),
            Err(error) => return Err(no_terminal(&error)),
        }
    }
}

fn no_terminal(error: &ReadlineError) -> UserError {
    UserError::new(format!("cannot read from the terminal: {error}")).with_help("give the texts as arguments")
}

/// Completes the names of instructions.
#[derive(Helper, Highlighter, Hinter, Validator)]
struct Names;

impl Completer for Names {
    type Candidate = Pair;

    fn complete(&self, line: &str, at: usize, _: &Context<'_>) -> rustyline::Result<(usize, Vec<Pair>)> {
        let before = line.get(..at).unwrap_or_default();
        let is_part = |character: char| character.is_ascii_alphanumeric() || character == '_' || character == '$';
        let start = before.rfind(|character| !is_part(character)).map_or(0, |before| before + 1);
        let typed = before.get(start..).unwrap_or_default();
        let names = instructions::all().iter().map(|instruction| instruction.name);
        let found = names.filter(|name| !typed.is_empty() && name.starts_with(typed));
        Ok((start, found.map(|name| Pair { display: name.to_owned(), replacement: name.to_owned() }).collect()))
    }
}
