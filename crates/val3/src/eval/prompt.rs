//! `val3 eval` at a terminal, with history and completion.

use std::cell::RefCell;
use std::process::ExitCode;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use rustyline::completion::{Completer, Pair};
use rustyline::error::ReadlineError;
use rustyline::history::DefaultHistory;
use rustyline::validate::{ValidationContext, ValidationResult, Validator};
use rustyline::{CompletionType, Config, Context, Editor, Helper, Highlighter, Hinter};
use val3_session::Evaluator;
use val3_session::evaluate::{has_open_block, texts};

use super::{TextOutcome, evaluate};
use crate::color::Color;
use crate::user_error::UserError;

/// Reads texts and evaluates them until the end of the input.
pub(crate) fn run(evaluator: Evaluator, color: Color) -> Result<ExitCode, UserError> {
    let flag = evaluator.interrupt();
    let evaluator = Rc::new(RefCell::new(evaluator));
    let config = Config::builder().completion_type(CompletionType::List).build();
    let mut editor: Editor<PromptCompleter, DefaultHistory> =
        Editor::with_config(config).map_err(|error| no_terminal(&error))?;
    editor.set_helper(Some(PromptCompleter { evaluator: Rc::clone(&evaluator) }));
    // Registered after the line editor, whose own handler would replace this handler.
    catch_interrupt(&flag)?;
    loop {
        match editor.readline("> ") {
            Ok(text) if text.trim().is_empty() => {}
            Ok(text) => {
                editor.add_history_entry(&text).map_err(|error| no_terminal(&error))?;
                // A pasted text may contain several texts.
                for text in texts(&text) {
                    if evaluate(&mut evaluator.borrow_mut(), &text, color)? == TextOutcome::Exit {
                        return Ok(ExitCode::SUCCESS);
                    }
                }
            }
            Err(ReadlineError::Interrupted) => {}
            Err(ReadlineError::Eof) => return Ok(ExitCode::SUCCESS),
            Err(error) => return Err(no_terminal(&error)),
        }
    }
}

fn no_terminal(error: &ReadlineError) -> UserError {
    UserError::new(format!("cannot read from the terminal: {error}")).with_help("pass the texts as arguments")
}

/// Completes names at the cursor, and continues an open block on the next line.
#[derive(Helper, Highlighter, Hinter)]
struct PromptCompleter {
    evaluator: Rc<RefCell<Evaluator>>,
}

impl Completer for PromptCompleter {
    type Candidate = Pair;

    fn complete(&self, line: &str, at: usize, _: &Context<'_>) -> rustyline::Result<(usize, Vec<Pair>)> {
        let found = self.evaluator.borrow_mut().completions(line, at);
        let start = found.first().map_or(at, |(start, _)| *start);
        let typed = line.get(start..at).unwrap_or_default();
        // A terminal shows no list for choosing a similar name, so only names with the typed prefix remain.
        let mut names: Vec<String> = found.into_iter().map(|(_, name)| name).collect();
        names.retain(|name| name.len() > typed.len() && name.starts_with(typed) && !name.contains(char::is_control));
        names.sort_unstable();
        names.dedup();
        Ok((start, names.into_iter().map(|name| Pair { display: name.clone(), replacement: name }).collect()))
    }
}

impl Validator for PromptCompleter {
    fn validate(&self, context: &mut ValidationContext<'_>) -> rustyline::Result<ValidationResult> {
        let text = context.input();
        // An empty line ends an open block.
        let continues = !text.ends_with('\n') && has_open_block(text);
        Ok(if continues { ValidationResult::Incomplete } else { ValidationResult::Valid(None) })
    }
}

/// Makes Ctrl-C set `flag` and have no other effect, so that it ends an evaluation and not the session.
///
/// # Errors
/// The signal handler cannot be installed.
#[cfg(unix)]
fn catch_interrupt(flag: &Arc<AtomicBool>) -> Result<(), UserError> {
    let caught = signal_hook::flag::register(signal_hook::consts::SIGINT, Arc::clone(flag));
    caught.map(drop).map_err(|error| UserError::new(format!("cannot catch Ctrl-C: {error}")))
}

/// Does nothing: Ctrl-C keeps its default effect.
#[cfg(not(unix))]
fn catch_interrupt(_: &Arc<AtomicBool>) -> Result<(), UserError> {
    Ok(())
}
