//! Collects the result of a run from its events.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::io::Write as _;

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::OutputFile;
use val3_lang::runtime_errors;
use val3_machine::controller::{Controller, RunStatus, TaskPosition};
use val3_machine::event::{EndReason, Event, EventKind, shown_seconds};
use val3_machine::missing_instruction;
use val3_machine::screen::Pendant;

use super::document::{
    CodeLine, ErrorEntry, IoEntry, LineMoves, MovesEntry, ProgramMoves, ResultDocument, ResultReason, TaskEntry,
    WaitEntry,
};
use super::listed::Listed;
use super::next_step::next_step;
use super::text;
use crate::args::{RunArgs, SummaryFormat};
use crate::color::Color;
use crate::output::file_kind::OutputFileKind;
use crate::output::{OutputContent, file, to_stdout_as};
use crate::run::console::Console;
use crate::run::encounters::Encounter;
use crate::run::end::End;
use crate::run::failures::ImpossiblePath;
use crate::run::missing::code;
use crate::run::motion::{TimesReport, TimesRow};
use crate::run::output_errors::OutputErrors;
use crate::user_error::UserError;

/// Maximum length of each list in a summary.
const SUMMARY_ITEMS: usize = 20;

/// Activities of a task that do not count as waits.
const NO_WAITS: [&str; 3] = ["computing", "suspended", "error"];

/// A line of a program with its instruction.
type MoveLine = (String, u32, &'static str);

/// Collects the result of a run.
pub(crate) struct ResultRecorder {
    file: Option<(OutputFile, Utf8PathBuf)>,
    summary: Option<SummaryFormat>,
    errors: Listed<ErrorEntry>,
    notes: Listed<String>,
    prints: Listed<String>,
    log: Listed<String>,
    io: Listed<IoEntry>,
    /// Number of started moves.
    moves: BTreeMap<MoveLine, usize>,
}

/// The end of a run.
pub(crate) struct RunEnd<'r> {
    pub(crate) end: End,
    /// Exit code of the command.
    pub(crate) code: u8,
    pub(crate) controller: &'r Controller,
    pub(crate) console: &'r Console,
    pub(crate) times: &'r TimesReport,
}

impl ResultRecorder {
    /// Opens the outputs of `--summary` and `--result`; `None` without them.
    pub(crate) fn open(args: &RunArgs) -> Result<Option<Self>, UserError> {
        let file = args
            .result
            .as_ref()
            .map(|path| file::create(path, OutputFileKind::Json, "result").map(|file| (file, path.clone())));
        let (file, summary) = (file.transpose()?, args.summary);
        if summary.is_some() && args.events.as_ref().is_some_and(|events| events == "-") {
            let help = "write the events to a file: --events FILE.jsonl";
            return Err(
                UserError::new("the summary and the events cannot both use the standard output").with_help(help)
            );
        }
        let is_wanted = file.is_some() || summary.is_some();
        Ok(is_wanted.then(|| Self {
            file,
            summary,
            errors: Listed::default(),
            notes: Listed::default(),
            prints: Listed::default(),
            log: Listed::default(),
            io: Listed::default(),
            moves: BTreeMap::new(),
        }))
    }

    /// Collects results from events.
    pub(crate) fn follow(&mut self, events: &[Event]) {
        events.iter().for_each(|event| self.follow_event(event));
    }

    fn follow_event(&mut self, event: &Event) {
        let t = event.t;
        match &event.kind {
            EventKind::Print { text } => self.prints.push(text.clone()),
            EventKind::Log { text, .. } => self.log.push(text.clone()),
            EventKind::Popup { text } => self.log.push(format!("pop-up: {text}")),
            EventKind::Notice { text } => self.notes.push(text.clone()),
            EventKind::Io { link, value } => self.io.push(IoEntry { t, link: link.clone(), value: *value }),
            // A move of a client has no program.
            EventKind::Move { phase: "started", instruction, program, line, .. } if !program.is_empty() => {
                *self.moves.entry((program.clone(), *line, instruction)).or_default() += 1;
            }
            EventKind::Error { code, program, line, file, .. } => {
                let error = runtime_errors::find(*code);
                self.errors.push(ErrorEntry {
                    t,
                    code: Some(*code),
                    message: error.map_or("unknown run-time error", |error| error.short).to_owned(),
                    task: event.task.clone().unwrap_or_default(),
                    at: code_line(program, *line, file),
                    handled: true,
                    help: error.map_or("", |error| error.long).to_owned(),
                });
            }
            EventKind::Lacking { instruction, program, line, file } => self.errors.push(ErrorEntry {
                t,
                code: None,
                message: missing_instruction(instruction),
                task: event.task.clone().unwrap_or_default(),
                at: code_line(program, *line, file),
                handled: false,
                help: "the run has ended here, because the rest of the program depends on the instruction".to_owned(),
            }),
            EventKind::Fault { instruction, text, program, line, file, .. } => self.errors.push(ErrorEntry {
                t,
                code: None,
                message: format!("the arm cannot follow the path of this `{instruction}`: {text}"),
                task: String::new(),
                at: code_line(program, *line, file),
                handled: true,
                help: "correct the move; resetMotion clears the queue".to_owned(),
            }),
            _ => {}
        }
    }

    /// Writes the result and the summary.
    pub(crate) fn close(mut self, end: &RunEnd<'_>, errors: &mut OutputErrors) {
        let (file, summary) = (self.file.take(), self.summary);
        write(file, summary, self.document(end), errors);
    }

    /// Writes the result and the summary of an application that was rejected for these errors.
    pub(crate) fn refuse(self, code: u8, errors: &[String]) -> Result<(), UserError> {
        let mut notes = Listed::default();
        errors.iter().for_each(|error| notes.push(error.clone()));
        let next = "correct the errors; `val3 check` shows them with their code".to_owned();
        let reason = ResultReason::Refused;
        let document = ResultDocument { reason, exit_code: code, notes, next: Some(next), ..ResultDocument::default() };
        let mut outputs = OutputErrors::default();
        write(self.file, self.summary, document, &mut outputs);
        outputs.into_result()
    }

    fn document(self, run: &RunEnd<'_>) -> ResultDocument {
        let RunEnd { end, code, controller, console, times } = run;
        let (failures, encounters) = (console.failures(), console.encounters());
        let mut errors = self.errors;
        for error in &mut errors.last {
            let failure = failures.unhandled(&error.task, error.t).filter(|_| error.code.is_some());
            error.handled &= failure.is_none() && !failures.path().is_some_and(|path| error.is_of(path));
            if let Some(reason) = failure.and_then(|failure| failure.reason.as_ref()) {
                error.message = format!("{}: {reason}", error.message);
            }
        }
        let unhandled = errors.last.iter().find(|error| !error.handled);
        let next = next_step(*end, controller, unhandled, encounters.contacts()).filter(|_| *code != 0);
        ResultDocument {
            ok: *code == 0,
            reason: reason(*end, controller),
            exit_code: *code,
            seconds: shown_seconds(controller.now()),
            tasks: controller.task_positions().into_iter().map(task).collect(),
            next,
            errors,
            contacts: encounters.contacts().iter().map(Encounter::sentence).collect(),
            near_misses: encounters.near_misses(),
            notes: self.notes,
            prints: self.prints,
            log: self.log,
            screen: screen(&controller.devices.state.pendant),
            moves: moves(&self.moves, &times.arm),
            waits: times.tasks.iter().filter(|row| is_wait(row)).map(wait).collect(),
            io: self.io,
        }
    }
}

/// Writes the document to the file, and its last items to the standard output.
fn write(
    file: Option<(OutputFile, Utf8PathBuf)>,
    summary: Option<SummaryFormat>,
    mut document: ResultDocument,
    errors: &mut OutputErrors,
) {
    if let Some((file, path)) = file {
        errors.collect(write_file(file, &path, &document));
    }
    document.shorten(SUMMARY_ITEMS);
    errors.collect(match summary {
        None => Ok(()),
        Some(SummaryFormat::Text) => {
            to_stdout_as(OutputContent::Data, Color::Never, |out| write!(out, "{}", text::text(&document)))
        }
        Some(SummaryFormat::Json) => to_stdout_as(OutputContent::Json, Color::Never, |out| {
            serde_json::to_writer_pretty(&mut *out, &document)?;
            writeln!(out)
        }),
    });
}

fn write_file(mut file: OutputFile, path: &Utf8Path, document: &ResultDocument) -> Result<(), UserError> {
    let refused = |reason: &dyn Display| file::refused(path, "result", reason);
    let text = serde_json::to_string_pretty(document).map_err(|error| refused(&error))?;
    file.write_all(text.as_bytes()).map_err(|error| refused(&error))?;
    file.commit().map_err(|reason| refused(&reason))
}

impl ErrorEntry {
    /// Whether the error is about this path, which the arm cannot follow.
    fn is_of(&self, path: &ImpossiblePath) -> bool {
        self.code.is_none() && path.line == self.at.line && path.file == self.at.file
    }
}

fn reason(end: End, controller: &Controller) -> ResultReason {
    match end {
        End::Controller(RunStatus::Stuck) if !controller.has_only_failed_tasks() => ResultReason::Stuck,
        End::Controller(status) => EndReason::from(status).into(),
        End::Recorded(reason) => reason.into(),
        End::BrokenOff(_) => ResultReason::Interrupted,
        End::Unread | End::Unwritten | End::Left | End::Restart => ResultReason::Stopped,
    }
}

fn code_line(program: &str, line: u32, file: &str) -> CodeLine {
    CodeLine { program: program.to_owned(), line, file: file.to_owned(), code: code(file, line) }
}

fn task(position: TaskPosition) -> TaskEntry {
    let TaskPosition { name, activity, program, line, file } = position;
    TaskEntry { name, activity: activity.to_string(), at: code_line(&program, line, &file) }
}

/// Lines of the user page up to the last one with text.
fn screen(pendant: &Pendant) -> Vec<String> {
    let Some(page) = pendant.page(pendant.shown()) else { return Vec::new() };
    let title = Some(page.title().to_owned()).filter(|title| !title.trim().is_empty());
    let mut lines: Vec<String> = page.lines().map(|line| line.trim_end().to_owned()).collect();
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    title.into_iter().chain(lines).collect()
}

/// Counts of moves by program and line, with times.
fn moves(counts: &BTreeMap<MoveLine, usize>, arm: &[TimesRow]) -> MovesEntry {
    let mut programs: BTreeMap<&str, ProgramMoves> = BTreeMap::new();
    let mut lines = Vec::new();
    for ((program, line, instruction), count) in counts {
        let seconds = moving_seconds(arm.iter().filter(|row| row.program == *program && row.line == *line));
        lines.push(LineMoves { program: program.clone(), line: *line, instruction, count: *count, seconds });
        let of_program = programs.entry(program).or_insert_with(|| ProgramMoves {
            program: program.clone(),
            count: 0,
            seconds: moving_seconds(arm.iter().filter(|row| row.program == *program)),
        });
        of_program.count += count;
    }
    let mut programs: Vec<ProgramMoves> = programs.into_values().collect();
    programs.sort_by(|one, other| other.seconds.total_cmp(&one.seconds));
    lines.sort_by(|one, other| other.seconds.total_cmp(&one.seconds));
    MovesEntry { count: counts.values().sum(), seconds: moving_seconds(arm.iter()), programs, lines }
}

/// Time during which the arm moves.
fn moving_seconds<'r>(rows: impl Iterator<Item = &'r TimesRow>) -> f64 {
    rows.filter(|row| row.is_moving).map(|row| row.seconds).sum()
}

fn is_wait(row: &TimesRow) -> bool {
    !NO_WAITS.contains(&row.what.as_str())
}

fn wait(row: &TimesRow) -> WaitEntry {
    let TimesRow { task, program, line, what, seconds, .. } = row;
    WaitEntry { task: task.clone(), program: program.clone(), line: *line, what: what.clone(), seconds: *seconds }
}
