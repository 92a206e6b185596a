//! A scope: an application on a controller of its own, whose data stay from one text to the next.

use std::collections::BTreeSet;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::body::{StmtKind, body};
use val3_analysis::db::{Database, File, FileStatus, Project, Sources};
use val3_analysis::infer::infer;
use val3_analysis::items::project::{items, program_files};
use val3_analysis::load::Workspace;
use val3_bytecode::Image;
use val3_check::diagnostic::Diagnostic;

use val3_ide::{Completion, FilePosition, completions};
use val3_lang::types::BaseType;

use super::answer::{Answer, Fault};
use super::declaration::{Declaration, declarations};
use super::execution::{Execution, Listener};
use super::interrupt::Interrupt;
use super::locals::Local;
use super::sources::{self, BEFORE, NAME};
use crate::application::{Files, Tape, compile, controller, first_refusal, load_laid, only_application, set_arm};
use crate::args::{self, EvalArgs};
use crate::engine::Session;
use crate::opening::{Request, current_folder};
use crate::user_error::UserError;

/// The file with the variables of the texts.
const DATA: &str = "eval__.dtx";

/// What makes a statement of an expression that shows its value.
const SHOW: &str = "?";

/// A scope.
pub(super) struct Scope {
    execution: Execution,
    manifest: Utf8PathBuf,
    files: Files,
    /// The variables of the texts.
    locals: Vec<Local>,
    /// The user types and the data of the application.
    types: BTreeSet<String>,
    data: BTreeSet<String>,
    /// The arm, where the cell does not say it.
    arm: Option<String>,
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
    pub(super) fn open(args: &EvalArgs) -> Result<Self, UserError> {
        let locals = args.local.iter().map(|text| Local::parse(text)).collect::<Result<Vec<_>, _>>();
        let locals = locals.map_err(UserError::new)?;
        let (manifest, text) = manifest(args)?;
        let folder = manifest.parent().unwrap_or(Utf8Path::new("")).to_owned();
        let mut files = Files::new();
        files.insert(folder.join(DATA), sources::data(&locals).into());
        files.insert(folder.join(format!("{NAME}.pgx")), sources::program("").into());
        files.insert(manifest.clone(), text.into());
        let arm = args.controller.arm.clone();
        let (workspace, project) = load(&files, &manifest, arm.as_deref())?;
        let of_locals = folder.join(DATA);
        if let Some(fault) = refusal(&workspace, project, |file| file == of_locals) {
            return Err(UserError::new(fault.message).with_help("`val3 check` shows it in its place"));
        }
        let image = compile(&workspace.db, project)
            .map_err(|error| UserError::new(error.to_string()).with_help(error.limit.help()))?;
        let controller = controller(&args.controller, Tape::default(), (&workspace.db, project), image)?;
        keep(&workspace.db, &mut files);
        let items = items(&workspace.db, project);
        let types = items.types.keys().map(ToString::to_string).collect();
        let data = items.data.keys().map(ToString::to_string).collect();
        Ok(Self { execution: Execution::new(controller), manifest, files, locals, types, data, arm })
    }

    /// A variable of the texts or of the application has this name.
    pub(super) fn has_variable(&self, name: &str) -> bool {
        self.data.contains(name) || self.locals.iter().any(|local| local.name() == name)
    }

    /// What ends a text from outside.
    pub(super) fn interrupt(&self) -> &Interrupt {
        &self.execution.interrupt
    }

    /// Evaluates a text: a declaration, an expression, or statements. What comes of it is told as it comes.
    ///
    /// # Errors
    /// The listener cannot listen.
    pub(super) fn evaluate(&mut self, text: &str, tell: &mut Listener<'_>) -> Result<(), UserError> {
        let is_type = |ty: &str| BaseType::from_name(ty).is_some() || self.types.contains(ty);
        match declarations(text, is_type) {
            Some(Ok(declared)) => declared.into_iter().try_for_each(|declaration| self.declare(declaration, tell)),
            Some(Err(message)) => tell(&Answer::Fault(message.into())),
            None => match self.image(text) {
                Ok((image, is_string)) => self.execution.run(image, is_string, tell),
                Err(fault) => tell(&Answer::Fault(fault)),
            },
        }
    }

    /// Declares a variable, and gives it its value. One of the same name that a text has declared before is gone.
    fn declare(&mut self, declaration: Declaration, tell: &mut Listener<'_>) -> Result<(), UserError> {
        let Declaration { local, assignment } = declaration;
        let before = self.locals.clone();
        let mut locals = before.clone();
        locals.retain(|known| known.name() != local.name());
        let without = locals.clone();
        locals.push(local);
        let declared = self.exchange(without).and_then(|()| self.exchange(locals));
        let image = declared.and_then(|()| assignment.map(|code| self.compile("", &code)).transpose());
        match image {
            Ok(Some(image)) => self.execution.run(image, false, tell),
            Ok(None) => Ok(()),
            Err(fault) => {
                // The names that were there before stay declared.
                if self.exchange(before).is_err() {
                    return Err(UserError::new("the variables of the texts cannot be declared again"));
                }
                tell(&Answer::Fault(fault))
            }
        }
    }

    /// Makes `locals` the variables of the texts. Those that stay as they are keep their values.
    fn exchange(&mut self, locals: Vec<Local>) -> Result<(), Fault> {
        let path = self.manifest.with_file_name(DATA);
        self.files.insert(path.clone(), sources::data(&locals).into());
        let (workspace, project, _) = self.load("")?;
        if let Some(fault) = refusal(&workspace, project, |file| file == path) {
            return Err(fault.message.into());
        }
        let image = compile(&workspace.db, project).map_err(|error| error.limit.to_string())?;
        self.execution.exchange(image).map_err(str::to_owned)?;
        self.locals = locals;
        Ok(())
    }

    /// What can be written behind the first `at` bytes of a line: in a statement, and in an expression; with the offset
    /// in the line where it goes.
    pub(super) fn completions(&mut self, line: &str, at: usize) -> Result<Vec<(usize, String)>, String> {
        let mut all = Vec::new();
        for before in ["", SHOW] {
            let (workspace, _, file) = self.load(&format!("{before}{line}"))?;
            let length = BEFORE.len() + before.len();
            let offset = u32::try_from(length + at).map_err(|error| error.to_string())?;
            let found = completions(&workspace.db, FilePosition { file, offset: offset.into() });
            let start = |found: &Completion| usize::from(found.range.start()).saturating_sub(length);
            all.extend(found.into_iter().map(|found| (start(&found), found.label)));
        }
        Ok(all)
    }

    /// The image whose program executes the text, and whether it shows a string.
    fn image(&mut self, text: &str) -> Result<(Arc<Image>, bool), Fault> {
        match self.classify(text)? {
            Text::Expression { is_string } => Ok((self.compile(SHOW, text)?, is_string)),
            Text::Statement => Ok((self.compile("", text)?, false)),
        }
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

    /// The image with this text, behind what makes a statement of it.
    fn compile(&mut self, before: &str, text: &str) -> Result<Arc<Image>, Fault> {
        let (workspace, project, file) = self.load(&format!("{before}{text}"))?;
        let path = file.path(&workspace.db).to_string();
        match refusal(&workspace, project, |file| file == path) {
            Some(fault) => Err(Fault::found(&fault, BEFORE.len() + before.len(), text)),
            None => Ok(compile(&workspace.db, project).map_err(|error| error.limit.to_string())?),
        }
    }
}

fn manifest(args: &EvalArgs) -> Result<(Utf8PathBuf, String), UserError> {
    let current = current_folder()?;
    let Some(app) = &args.app else { return Ok(sources::empty(&current.join(NAME))) };
    let request = Request { asked: vec![app.clone()], ..Request::default() };
    let session = Session::open(&request)?;
    let project = only_application(&session, app, Some(args::START))?;
    sources::extended(session.db(), project)
}

/// Keeps the files as they were read: the data in memory are those of these files, whatever becomes of them.
fn keep(db: &Database, files: &mut Files) {
    for file in Sources::get(db).files(db).values() {
        if let FileStatus::Read { encoding, .. } = file.status(db) {
            files.entry(file.path(db).clone()).or_insert_with(|| encoding.encode(file.text(db)));
        }
    }
}

fn load(files: &Files, manifest: &Utf8Path, arm: Option<&str>) -> Result<(Workspace, Project), UserError> {
    let (mut workspace, project) = load_laid(files.clone(), &manifest.to_owned()).map_err(UserError::new)?;
    if let Some(arm) = arm {
        set_arm(&mut workspace.db, project, arm)?;
    }
    Ok((workspace, project))
}

/// What the controller's compiler refuses in the files that `counts`.
fn refusal(workspace: &Workspace, project: Project, counts: impl Fn(&str) -> bool) -> Option<Diagnostic> {
    let db = &workspace.db;
    first_refusal(db, project, |finding| counts(finding.place.file.path(db).as_str()))
}
