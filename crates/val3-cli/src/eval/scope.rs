//! A scope: an application on a controller of its own, whose data stay from one text to the next.

use std::fmt::{self, Display};
use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::body::{StmtKind, body};
use val3_analysis::db::{File, Project};
use val3_analysis::infer::infer;
use val3_analysis::items::project::folder;
use val3_analysis::load::{self, Workspace};
use val3_bytecode::Image;
use val3_check::rule::Severity;
use val3_check::settings::{Selection, WorkspaceSettings};
use val3_lang::runtime_errors;
use val3_lang::types::BaseType;
use val3_lang::values::printed;
use val3_machine::controller::{Controller, Step};
use val3_machine::devices::Devices;
use val3_machine::event::What;
use val3_machine::files::Roots;

use super::locals::Local;
use super::sources::{self, Files, NAME};
use crate::args::EvalArgs;
use crate::opening::current_folder;
use crate::run::{Images, Laid, lacking};
use crate::user_error::UserError;

/// The first code of the rules on what a text means. What they find shows when it runs; so does a constant index
/// beyond an array.
const MEANING: &str = "V0225";
const CONSTANT_INDEX: &str = "V0212";

/// What a line of `val3 run` takes.
const LINE_COST: u64 = 2_000;

/// A scope.
pub(crate) struct Scope {
    controller: Controller,
    manifest: Utf8PathBuf,
    files: Files,
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
        if let Some(arm) = &args.arm {
            files.insert(folder.join("val3.toml"), format!("arm = \"{arm}\"\n").into());
        }
        let workspace = workspace(&files, &manifest).map_err(UserError::new)?;
        let project = only(&workspace).map_err(UserError::new)?;
        refuse_faults(&workspace, project, |file| !file.ends_with(".pgx"))
            .map_err(|fault| UserError::new(fault).with_help("`val3 check` shows it in its place"))?;
        let image = compiled(&workspace, project).map_err(UserError::new)?;
        let (roots, path, disk) = roots(&workspace, project)?;
        let devices = Devices::new(roots, Box::new(Images::new(disk)));
        let controller = Controller::new(devices, image, path, LINE_COST);
        Ok(Self { controller, manifest, files })
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
        let workspace = workspace(&self.files, &self.manifest)?;
        let project = only(&workspace)?;
        let files = val3_analysis::items::project::program_files(&workspace.db, project);
        let file = files.iter().copied().find(|file| *file.path(&workspace.db) == program);
        let file = file.ok_or("the text has no program")?;
        Ok((workspace, project, file))
    }

    fn compile(&mut self, code: &str) -> Result<Arc<Image>, String> {
        let (workspace, project, file) = self.load(code)?;
        let path = file.path(&workspace.db).to_string();
        refuse_faults(&workspace, project, |file| file == path)?;
        compiled(&workspace, project)
    }

    /// Executes the program of the text to its end.
    fn execute(&mut self, is_string: bool) -> Vec<Answer> {
        let mut answers = Vec::new();
        if !self.controller.start(NAME) {
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
    let project = crate::run::only_application(&session, app, None)?;
    sources::extended(session.db(), project)
}

fn workspace(files: &Files, manifest: &camino::Utf8Path) -> Result<Workspace, String> {
    let system = Laid { files: files.clone() };
    load::load(&system, &[manifest.to_owned()]).map_err(|error| error.to_string())
}

fn only(workspace: &Workspace) -> Result<Project, String> {
    match workspace.projects.as_slice() {
        [project] => Ok(*project),
        _ => Err("there is no such application".to_owned()),
    }
}

/// What the controller's compiler would refuse in the files that `counts`.
fn refuse_faults(workspace: &Workspace, project: Project, counts: impl Fn(&str) -> bool) -> Result<(), String> {
    let db = &workspace.db;
    let settings = WorkspaceSettings::new(db, &[project], &Selection::default())
        .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))?;
    let units = val3_check::units(db, &[project]);
    let mut findings = units.iter().flat_map(|unit| val3_check::check_unit(db, *unit, &settings).findings);
    let fault = findings.find(|finding| {
        finding.severity == Severity::Error
            && finding.rule.code < MEANING
            && finding.rule.code != CONSTANT_INDEX
            && counts(finding.place.file.path(db).as_str())
    });
    fault.map_or(Ok(()), |fault| Err(fault.message))
}

fn compiled(workspace: &Workspace, project: Project) -> Result<Arc<Image>, String> {
    val3_compile::compile(&workspace.db, project).map(Arc::new).map_err(|error| error.to_string())
}

/// The media; an application of its own has none.
fn roots(workspace: &Workspace, project: Project) -> Result<(Roots, String, Utf8PathBuf), UserError> {
    let db = &workspace.db;
    let application = folder(db, project);
    let disk = project.disk(db).or(application.parent()).unwrap_or(application).to_owned();
    let mut roots = Roots::default();
    if disk.is_dir() {
        roots
            .mount("Disk", &disk)
            .map_err(|error| UserError::new(format!("cannot open the folder `{disk}` for `Disk://`: {error}")))?;
    }
    let inside = application.strip_prefix(&disk).unwrap_or(camino::Utf8Path::new(""));
    Ok((roots, format!("Disk://{inside}"), disk))
}
