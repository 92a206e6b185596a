//! `val3 eval`: evaluates expressions and executes statements, which share their variables.

mod prompt;

use std::io::{self, IsTerminal};
use std::ops::ControlFlow;
use std::process::ExitCode;
use std::rc::Rc;

use clap::{CommandFactory as _, ValueEnum};
use val3_session::evaluate::{next_text, texts};
use val3_session::{CellChoice, Delay, EvaluationOutput, Evaluator, Listener};

use crate::args::{Args, EvalArgs, InputArgs};
use crate::color::Color;
use crate::output::{OutputContent, to_reader, to_stderr};
use crate::paths::current_folder;
use crate::sockets::{AnnouncementReader, Announcements, note_grants};
use crate::standard_input;
use crate::user_error::UserError;
use crate::wall_clock::duration;

/// Runs the command. The exit code states whether every text could be evaluated.
pub(crate) fn run(args: &EvalArgs, color: Color) -> Result<ExitCode, UserError> {
    if let Some(option) = args.texts.iter().find(|text| is_option(text)) {
        return Err(
            UserError::new(format!("`{option}` must precede the texts")).with_help("write options before the texts")
        );
    }
    let current = current_folder()?;
    let application = args.app.as_ref().map(|path| current.join(path));
    let mut settings = args.controller.settings(Rc::new(Announcements::new(AnnouncementReader::Terminal)));
    // Expressions need no surroundings.
    settings.cell.get_or_insert(CellChoice::Without);
    let evaluator = Evaluator::open(application.as_deref(), &current, &args.local, &settings)?;
    if application.is_some() {
        note_grants(&evaluator.grants(&settings)?);
    }
    if args.texts.is_empty() && args.input.input.is_none() && io::stdin().is_terminal() {
        return prompt::run(evaluator, color);
    }
    let mut progress = EvalState { evaluator, color, sound: true };
    if args.texts.is_empty() {
        progress.read_lines(&args.input)?;
    } else {
        progress.evaluate_all(texts(&args.texts.join("\n")))?;
    }
    Ok(if progress.sound { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Evaluation of several texts in order.
struct EvalState {
    evaluator: Evaluator,
    color: Color,
    /// Whether every text so far could be evaluated.
    sound: bool,
}

impl EvalState {
    /// Evaluates texts until one of them ends the session. Returns whether the session continues.
    fn evaluate_all(&mut self, texts: impl IntoIterator<Item = String>) -> Result<bool, UserError> {
        for text in texts {
            match evaluate(&mut self.evaluator, &text, self.color)? {
                TextOutcome::Sound => {}
                TextOutcome::Faulty => self.sound = false,
                TextOutcome::Unread | TextOutcome::Exit => return Ok(false),
            }
        }
        Ok(true)
    }

    /// Evaluates the input, each text as soon as it is complete.
    fn read_lines(&mut self, input: &InputArgs) -> Result<(), UserError> {
        let mut open = String::new();
        for line in standard_input::lines(input)? {
            let line = line.map_err(|error| UserError::new(format!("cannot read the standard input: {error}")))?;
            if !self.evaluate_all(next_text(&mut open, &line))? {
                return Ok(());
            }
        }
        self.evaluate_all(texts(&open)).map(drop)
    }
}

/// Whether the text is an option. Texts may begin with a hyphen (`-nA`), so clap reads an option after a text as a
/// text.
fn is_option(text: &str) -> bool {
    let Some(name) = text.strip_prefix("--").and_then(|text| text.split('=').next()) else { return false };
    let mut command = Args::command();
    command.build();
    let known = command.find_subcommand("eval").map(clap::Command::get_arguments);
    known.is_some_and(|mut known| known.any(|option| option.get_long() == Some(name)))
}

/// Outcome of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum TextOutcome {
    /// The text was evaluated.
    Sound,
    /// The text has a fault, or ended with an error.
    Faulty,
    /// The reader has closed the output.
    Unread,
    /// The text ends the session.
    Exit,
}

/// A word that is a session command instead of a text to evaluate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum SessionCommand {
    Exit,
    Quit,
    Help,
}

/// Output of `help`.
const HELP: &str = "\
num nA, num nA=2, point pA[3]   declare variables
nA*2                            print the value of an expression
nA=nA+1                         execute statements; blocks may have several lines
exit, quit                      leave; at a terminal Ctrl-D does the same
The program `val3 explain NAME` shows the page of an instruction.";

/// Executes a session command, unless a variable has its name.
fn command(evaluator: &Evaluator, text: &str, color: Color) -> Result<Option<TextOutcome>, UserError> {
    let word = text.trim();
    if evaluator.has_variable(word) {
        return Ok(None);
    }
    Ok(match SessionCommand::from_str(word, false) {
        Ok(SessionCommand::Exit | SessionCommand::Quit) => Some(TextOutcome::Exit),
        Ok(SessionCommand::Help) => {
            let is_read = to_reader(OutputContent::Words, color, |out| writeln!(out, "{HELP}"))?;
            Some(if is_read { TextOutcome::Sound } else { TextOutcome::Unread })
        }
        Err(_) => None,
    })
}

/// Evaluates one text and shows its results as they arrive.
fn evaluate(evaluator: &mut Evaluator, text: &str, color: Color) -> Result<TextOutcome, UserError> {
    if let Some(status) = command(evaluator, text, color)? {
        return Ok(status);
    }
    let mut display = Display { text, color, shown: Ok(TextOutcome::Sound) };
    evaluator.evaluate(text, &mut display);
    display.shown
}

/// Shows results at the terminal.
struct Display<'t> {
    text: &'t str,
    color: Color,
    /// Outcome so far, or a write error.
    shown: Result<TextOutcome, UserError>,
}

impl Listener for Display<'_> {
    fn answer(&mut self, answer: &EvaluationOutput) -> ControlFlow<()> {
        self.shown = match show(answer, self.text, self.color) {
            Ok(true) if answer.is_sound() && self.shown == Ok(TextOutcome::Sound) => return ControlFlow::Continue(()),
            Ok(true) => Ok(TextOutcome::Faulty),
            Ok(false) => Ok(TextOutcome::Unread),
            Err(error) => Err(error),
        };
        match self.shown {
            Ok(TextOutcome::Faulty) => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        }
    }

    fn wait(&mut self, delay: Delay) {
        std::thread::sleep(duration(delay));
    }
}

/// Writes a result to the standard output and the location of a fault to the standard error output. Returns whether the
/// output is still read.
fn show(answer: &EvaluationOutput, text: &str, color: Color) -> Result<bool, UserError> {
    let is_read = to_reader(OutputContent::Data, color, |out| writeln!(out, "{answer}"))?;
    if let Some(excerpt) = answer.fault().and_then(|fault| fault.excerpt(text)) {
        to_stderr(|out| writeln!(out, "{excerpt}"));
    }
    Ok(is_read)
}
