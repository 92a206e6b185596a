//! A scope: an application on a controller of its own, whose data stay from one text to the next.

use std::fmt::{self, Display};
use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::body::{StmtKind, body};
use val3_analysis::db::{File, Project};
use val3_analysis::infer::infer;
use val3_analysis::items::project::program_files;
use val3_analysis::load::Workspace;
use val3_bytecode::Image;
use val3_lang::runtime_errors;
use val3_lang::types::BaseType;
use val3_lang::values::printed;
use val3_machine::controller::{Controller, Step};
use val3_machine::devices::Devices;
use val3_machine::event::What;

use super::locals::Local;
use super::sources::{self, NAME};
use crate::application::{Files, Images, Media, compile, first_error, lacking, load_laid, only_application, set_arm};
use crate::args::{self, EvalArgs};
use crate::opening::current_folder;
use crate::user_error::UserError;

/// The first code of the rules on what a text means. What they find shows when it runs; so does a constant index
/// beyond an array.
const MEANING: &str = "V0225";
const CONSTANT_INDEX: &str = "V0212";

/// A scope.
pub(crate) struct Scope {
    controller: Controller,
    manifest: Utf8PathBuf,
    files: Files,
    /// The arm, where the cell does not say it.
    arm: Option<String>,
}

/// A line of what comes of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Answer {
    /// The value of an expression, or what a statement prints.
    Line(String),
    /// What is wrong with the text.
    Fault(String),
    /// The run-time error that it ends in, with its number.
    RunTime(String),
}

impl Answer {
    /// The text was evaluated.
    pub(crate) fn is_sound(&self) -> bool {
        matches!(self, Self::Line(_))
    }
}

impl Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => f.write_str(line),
            Self::Fault(fault) => write!(f, "error: {fault}"),
            Self::RunTime(fault) => write!(f, "error {fault}"),
        }
    }
}

/// What a text is.
enum Text {
    /// An expression; of a string the value is shown in quotes.
    Expression {
        is_string: bool,
    },
    Statement,
}

impl Scope {
    /// The scope that the arguments ask for.
    pub(crate) fn open(args: &EvalArgs) -> Result<Self, UserError> {
        let locals = args.local.iter().map(|text| Local::parse(text)).collect::<Result<Vec<_>, _>>();
        let locals = locals.map_err(UserError::new)?;
        let (manifest, text) = manifest(args)?;
        let folder = manifest.parent().unwrap_or(camino::Utf8Path::new("")).to_owned();
        let mut files = Files::new();
        files.insert(folder.join(format!("{NAME}.dtx")), sources::data(&locals).into());
        files.insert(folder.join(format!("{NAME}.pgx")), sources::program("").into());
        files.insert(manifest.clone(), text.into());
        let (workspace, project) = load(&files, &manifest, args.arm.as_deref())?;
        refuse_faults(&workspace, project, |file| !file.ends_with(".pgx"))
            .map_err(|fault| UserError::new(fault).with_help("`val3 check` shows it in its place"))?;
        let image = compile(&workspace.db, project)
            .map_err(|error| UserError::new(error.to_string()).with_help(error.limit.help()))?;
        let Media { roots, disk, application } = Media::of(&workspace.db, project)?;
        let devices = Devices::new(roots, Box::new(Images::new(disk)));
        let line_cost = args::microseconds(args::LINE_COST).map_err(UserError::new)?;
        let controller = Controller::new(devices, image, application, line_cost);
        Ok(Self { controller, manifest, files, arm: args.arm.clone() })
    }

    /// Evaluates a text: an expression, or statements.
    pub(crate) fn evaluate(&mut self, text: &str) -> Vec<Answer> {
        self.run(text).unwrap_or_else(|fault| vec![Answer::Fault(fault)])
    }

    fn run(&mut self, text: &str) -> Result<Vec<Answer>, String> {
        let kind = self.classify(text)?;
        let (image, is_string) = match kind {
            Text::Expression { is_string } => (self.compile(&format!("?{text}"))?, is_string),
            Text::Statement => (self.compile(text)?, false),
        };
        self.controller.exchange(image);
        Ok(self.execute(is_string))
    }

    /// What the text is: read alone, an expression is a line without effect.
    fn classify(&mut self, text: &str) -> Result<Text, String> {
        let (workspace, project, file) = self.load(text)?;
        let db = &workspace.db;
        let inference = infer(db, project, file);
        match body(db, file).block.as_slice() {
            [stmt] => match &stmt.kind {
                StmtKind::Expr(id) if !inference.ty(*id).is_unknown() || inference.call(*id).is_none() => {
                    let is_string = inference.ty(*id).base.builtin() == Some(BaseType::String);
                    Ok(Text::Expression { is_string })
                }
                _ => Ok(Text::Statement),
            },
            _ => Ok(Text::Statement),
        }
    }

    fn load(&mut self, code: &str) -> Result<(Workspace, Project, File), String> {
        let program = self.manifest.with_file_name(format!("{NAME}.pgx"));
        self.files.insert(program.clone(), sources::program(code).into());
        let loaded = load(&self.files, &self.manifest, self.arm.as_deref());
        let (workspace, project) = loaded.map_err(|error| error.to_string())?;
        let files = program_files(&workspace.db, project);
        let file = files.iter().copied().find(|file| *file.path(&workspace.db) == program);
        let file = file.ok_or("the text has no program")?;
        Ok((workspace, project, file))
    }

    fn compile(&mut self, code: &str) -> Result<Arc<Image>, String> {
        let (workspace, project, file) = self.load(code)?;
        let path = file.path(&workspace.db).to_string();
        refuse_faults(&workspace, project, |file| file == path)?;
        compile(&workspace.db, project).map_err(|error| error.limit.to_string())
    }

    /// Executes the program of the text to its end.
    fn execute(&mut self, is_string: bool) -> Vec<Answer> {
        let mut answers = Vec::new();
        if self.controller.start(NAME).is_err() {
            return vec![Answer::Fault("the text cannot be started".to_owned())];
        }
        loop {
            let step = self.controller.step_tasks();
            for event in self.controller.devices.take_events() {
                match event.what {
                    What::Print { text } if is_string => answers.push(Answer::Line(printed::string(&text))),
                    What::Print { text } => answers.push(Answer::Line(text)),
                    What::Error { code, .. } => answers.push(Answer::RunTime(worded(code))),
                    What::Lacking { instruction, .. } => answers.push(Answer::Fault(lacking(&instruction))),
                    _ => {}
                }
            }
            match step {
                Step::Finished => break,
                Step::Stuck | Step::Lacking => break self.controller.kill_tasks(),
                Step::Idle(Some(wake)) => self.controller.jump(wake),
                Step::Idle(None) => {
                    answers.push(Answer::Fault("it waits for what cannot happen here".to_owned()));
                    break self.controller.kill_tasks();
                }
                Step::Busy => {}
            }
        }
        answers
    }
}

fn worded(code: u16) -> String {
    let short = runtime_errors::find(code).map_or("unknown", |error| error.short);
    format!("{code}: {short}")
}

fn manifest(args: &EvalArgs) -> Result<(Utf8PathBuf, String), UserError> {
    let current = current_folder()?;
    let Some(app) = &args.app else { return Ok(sources::empty(&current.join(NAME))) };
    let request = crate::opening::Request { asked: vec![app.clone()], ..Default::default() };
    let session = crate::engine::Session::open(&request)?;
    let project = only_application(&session, app, Some(args::START))?;
    sources::extended(session.db(), project)
}

fn load(files: &Files, manifest: &Utf8PathBuf, arm: Option<&str>) -> Result<(Workspace, Project), UserError> {
    let (mut workspace, project) = load_laid(files.clone(), manifest).map_err(UserError::new)?;
    if let Some(arm) = arm {
        set_arm(&mut workspace.db, project, arm)?;
    }
    Ok((workspace, project))
}

/// What the controller's compiler would refuse in the files that `counts`.
fn refuse_faults(workspace: &Workspace, project: Project, counts: impl Fn(&str) -> bool) -> Result<(), String> {
    let db = &workspace.db;
    let is_refused = |code: &str| code < MEANING && code != CONSTANT_INDEX;
    let fault = first_error(db, project, |finding| {
        is_refused(finding.rule.code) && counts(finding.place.file.path(db).as_str())
    })?;
    fault.map_or(Ok(()), |fault| Err(fault.message))
}
