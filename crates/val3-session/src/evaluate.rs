//! Evaluation of code in an application on its own controller. Data keep their values between evaluations.

mod answer;
mod declaration;
mod execution;
mod page_text;
mod sources;
mod variable;

use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::body::{StmtKind, body};
use val3_analysis::db::{Database, File, FileStatus, Sources};
use val3_analysis::infer::infer;
use val3_analysis::items::project::{items, program_files};
use val3_analysis::system::{Disk, OverlayFs};
use val3_bytecode::Image;
use val3_check::diagnostic::Diagnostic;
use val3_ide::{Completion, FilePosition, completions};
use val3_lang::types::{Arm, BaseType};

pub use answer::{CodeFault, EvaluationOutput};
pub use execution::Listener;
pub(crate) use page_text::PageText;
pub use sources::{has_open_block, next_text, texts};

use crate::application::Application;
use crate::connection::Tape;
use crate::error::SessionError;
use crate::settings::ControllerSettings;
use declaration::{Declaration, declarations};
use execution::Execution;
use sources::NAME;
use variable::ScratchVariable;

/// The start program. Applications contain it, libraries do not.
const START: &str = "start";

/// Data file with the declared variables.
const DATA: &str = "eval__.dtx";

/// Prefix that turns an expression into a statement that prints its value.
const PRINT: &str = "?";

/// An application on a controller, and the database from which it was compiled.
pub struct Evaluator {
    application: Application,
    /// Application files with the content that was read, and the program and data file of the evaluated code.
    files: OverlayFs<Disk>,
    manifest: Utf8PathBuf,
    execution: Execution,
    /// Variables declared by evaluated code.
    variables: Vec<ScratchVariable>,
    /// User types and data names of the application.
    types: BTreeSet<String>,
    data: BTreeSet<String>,
    arm: Option<String>,
    /// Kind of arm of declared positions.
    arm_kind: Arm,
}

/// Kind of the evaluated code.
enum Text {
    /// An expression. The value of a string is displayed in quotes.
    Expression {
        is_string: bool,
    },
    Statement,
}

impl Evaluator {
    /// Opens the application at the absolute path `application`. Without a path, opens an empty application, which
    /// behaves as if it were in the folder `current`. Each string in `variables` declares a variable, for example `num
    /// nVal` or `point pA[3]`.
    ///
    /// # Errors
    /// If the application cannot be read or loaded, if a setting is invalid, or if a variable cannot be declared.
    pub fn open(
        application: Option<&Utf8Path>,
        current: &Utf8Path,
        variables: &[String],
        settings: &ControllerSettings,
    ) -> Result<Self, SessionError> {
        let variables = variables.iter().map(|text| ScratchVariable::parse(text)).collect::<Result<Vec<_>, _>>();
        let variables = variables.map_err(|message| SessionError::Variables { message, help: String::new() })?;
        let (manifest, text) = match application {
            Some(path) => {
                let found = Application::open(&Disk, path, Some(START))?;
                found.check_readable()?;
                sources::extended(found.db(), found.project())?
            }
            None => sources::empty(&current.join(NAME)),
        };
        let mut files = OverlayFs::new(Disk);
        files.store(manifest.with_file_name(DATA), sources::data(&[], Arm::SixAxis).into());
        files.store(manifest.with_file_name(format!("{NAME}.pgx")), sources::program("").into());
        files.store(manifest.clone(), text.into());
        let arm = settings.arm.clone();
        let mut application = Application::open(&files, &manifest, None)?;
        if let Some(arm) = &arm {
            application.set_arm(arm)?;
        }
        let controller = application.controller(settings, Tape::default(), application.compile()?)?;
        keep(application.db(), &mut files);
        let items = items(application.db(), application.project());
        let types = items.types.keys().map(ToString::to_string).collect();
        let data = items.data.keys().map(ToString::to_string).collect();
        let arm_kind = items.arm.unwrap_or(Arm::SixAxis);
        let execution = Execution::new(controller);
        let mut evaluator =
            Self { application, files, manifest, execution, variables: Vec::new(), types, data, arm, arm_kind };
        if !variables.is_empty() {
            let exchanged = evaluator.exchange(variables);
            exchanged.map_err(|fault| SessionError::Variables { message: fault.message, help: String::new() })?;
        }
        Ok(evaluator)
    }

    /// Sentences about the folders outside the cell, the lines and the network to which the application has access. The
    /// empty application only has access through the settings.
    ///
    /// # Errors
    /// If a setting is invalid.
    pub fn grants(&self, settings: &ControllerSettings) -> Result<Vec<String>, SessionError> {
        self.application.grants(settings)
    }

    /// Whether evaluated code or the application declares a variable called `name`.
    pub fn has_variable(&self, name: &str) -> bool {
        self.data.contains(name) || self.variables.iter().any(|variable| variable.name() == name)
    }

    /// Flag that interrupts the current evaluation. The caller sets it, for example on Ctrl-C.
    pub fn interrupt(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.execution.interrupt)
    }

    /// Evaluates a declaration, an expression, or statements.
    pub fn evaluate(&mut self, text: &str, listener: &mut dyn Listener) {
        let declared = declarations(text, |ty| BaseType::from_name(ty).is_some() || self.types.contains(ty));
        let fault = match declared {
            Some(Ok(declared)) => {
                declared.into_iter().find_map(|declaration| self.declare(declaration, listener).err())
            }
            Some(Err(message)) => Some(message.into()),
            None => self.image(text).map(|(image, is_string)| self.execution.run(image, is_string, listener)).err(),
        };
        if let Some(fault) = fault {
            // The evaluation has ended, so a `Break` of the listener has no effect.
            let _ = listener.answer(&EvaluationOutput::Fault(fault));
        }
    }

    /// Declares a variable and assigns its value. It replaces an earlier declaration with the same name.
    fn declare(&mut self, declaration: Declaration, listener: &mut dyn Listener) -> Result<(), CodeFault> {
        let Declaration { variable, assignment } = declaration;
        let before = self.variables.clone();
        let mut variables = before.clone();
        variables.retain(|other| other.name() != variable.name());
        let without = variables.clone();
        variables.push(variable);
        let declared = self.exchange(without).and_then(|()| self.exchange(variables));
        let image = declared.and_then(|()| assignment.map(|code| self.compile("", &code)).transpose());
        match image {
            Ok(Some(image)) => self.execution.run(image, false, listener),
            Ok(None) => {}
            Err(fault) => {
                // Earlier declarations are restored.
                self.exchange(before)?;
                return Err(fault);
            }
        }
        Ok(())
    }

    /// Replaces the declared variables. Unchanged variables keep their values.
    fn exchange(&mut self, variables: Vec<ScratchVariable>) -> Result<(), CodeFault> {
        let path = self.manifest.with_file_name(DATA);
        self.set_text(&path, sources::data(&variables, self.arm_kind));
        self.set_code("");
        if let Some(fault) = refusal(&self.application, &path) {
            return Err(fault.message.into());
        }
        let image = self.application.compile().map_err(|error| error.limit.to_string())?;
        self.execution.exchange(image).map_err(str::to_owned)?;
        self.variables = variables;
        Ok(())
    }

    /// Completions after the first `at` bytes of a line, in a statement and in an expression. Each has the offset in
    /// the line at which it is inserted.
    pub fn completions(&mut self, line: &str, at: usize) -> Vec<(usize, String)> {
        let mut all = Vec::new();
        for before in ["", PRINT] {
            let code = format!("{before}{line}");
            self.set_code(&code);
            let offset = sources::offset_in_program(code.get(..before.len() + at).unwrap_or(&code));
            let Some((file, offset)) = self.program().zip(u32::try_from(offset).ok()) else { continue };
            let found = completions(self.application.db(), FilePosition { file, offset: offset.into() });
            let in_code = |found: &Completion| sources::offset_in_code(&code, found.range.start().into());
            let start = |found: &Completion| in_code(found).saturating_sub(before.len());
            all.extend(found.into_iter().map(|found| (start(&found), found.label)));
        }
        all
    }

    /// Image whose program executes the code, and whether it prints a string.
    fn image(&mut self, text: &str) -> Result<(Arc<Image>, bool), CodeFault> {
        match self.classify(text) {
            Text::Expression { is_string } => Ok((self.compile(PRINT, text)?, is_string)),
            Text::Statement => Ok((self.compile("", text)?, false)),
        }
    }

    /// Kind of the code. A single expression with a value is an expression, because it would have no effect as a
    /// statement.
    fn classify(&mut self, text: &str) -> Text {
        self.set_code(text);
        let Some(file) = self.program() else { return Text::Statement };
        let db = self.application.db();
        let inference = infer(db, self.application.project(), file);
        let [stmt] = body(db, file).block.as_slice() else { return Text::Statement };
        match &stmt.kind {
            StmtKind::Expr(id) if !inference.is_call_without_value(*id) => {
                Text::Expression { is_string: inference.ty(*id).base.builtin() == Some(BaseType::String) }
            }
            _ => Text::Statement,
        }
    }

    /// Image with this code after the prefix `before`.
    fn compile(&mut self, before: &str, text: &str) -> Result<Arc<Image>, CodeFault> {
        let code = format!("{before}{text}");
        self.set_code(&code);
        match refusal(&self.application, &self.manifest.with_file_name(format!("{NAME}.pgx"))) {
            Some(fault) => Err(CodeFault::found(&fault, &code, before.len())),
            None => Ok(self.application.compile().map_err(|error| error.limit.to_string())?),
        }
    }

    fn set_code(&mut self, code: &str) {
        let program = self.manifest.with_file_name(format!("{NAME}.pgx"));
        self.set_text(&program, sources::program(code));
    }

    fn set_text(&mut self, path: &Utf8Path, text: String) {
        self.files.store(path.to_owned(), text.clone().into());
        self.application.set_text(&self.files, path, text, self.arm.as_deref());
    }

    /// Program that contains the code.
    fn program(&self) -> Option<File> {
        let db = self.application.db();
        let path = self.manifest.with_file_name(format!("{NAME}.pgx"));
        program_files(db, self.application.project()).iter().copied().find(|file| *file.path(db) == path)
    }
}

/// Stores the content that was read, because the data in memory originate from it even if the files change on the disk.
fn keep(db: &Database, files: &mut OverlayFs<Disk>) {
    for file in Sources::get(db).files(db).values() {
        let path = file.path(db);
        if let FileStatus::Read { encoding, .. } = file.status(db)
            && !files.covers(path)
        {
            files.store(path.clone(), encoding.encode(file.text(db)));
        }
    }
}

/// First error in a file with which the controller's compiler rejects the application.
fn refusal(application: &Application, path: &Utf8Path) -> Option<Diagnostic> {
    let db = application.db();
    application.refusals().into_iter().find(|finding| finding.place.file.path(db) == path)
}

#[cfg(test)]
mod tests;
