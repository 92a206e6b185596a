//! Calls of a program in all applications of the workspace.

use memchr::memmem;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind, body};
use val3_analysis::db::{Db, File, Project, Sources};
use val3_analysis::effects::Effects;
use val3_analysis::infer::infer;
use val3_analysis::items::parse;
use val3_analysis::items::program::{self, header};
use val3_analysis::items::project::{items, program_files};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;
use val3_lang::instruction::CallClass;
use val3_syntax::{SyntaxKind, TextRange, TextSize, text_at};

use crate::RefactoringError;
use crate::references::{projects_using, uses};

/// Call of a program, by `call` or as a task.
pub(crate) struct Call {
    pub(crate) file: File,
    project: Project,
    arguments: Vec<ExprId>,
    /// Offset of the closing parenthesis.
    pub(crate) end: TextSize,
    /// Whether the code is outside a CDATA section.
    pub(crate) is_escaped: bool,
}

/// All calls of these programs, which have `count` parameters.
///
/// # Errors
/// If a call cannot be parsed, or passes another number of arguments.
pub(super) fn calls(db: &dyn Db, symbols: &[Symbol], count: usize) -> Result<Vec<Call>, RefactoringError> {
    let mut calls: Vec<Call> = Vec::new();
    for symbol in symbols {
        check_callers_readable(db, symbol)?;
        for (file, project, range) in uses(db, symbol) {
            let Some(call) = Call::at(db, file, project, range)? else { continue };
            if call.arguments.len() != count {
                let (caller, passed) = (&header(db, file).name, call.arguments.len());
                return Err(format!("a call in `{caller}` passes {passed} arguments instead of {count}").into());
            }
            if calls.iter().all(|known| (known.file, known.end) != (call.file, call.end)) {
                calls.push(call);
            }
        }
    }
    Ok(calls)
}

/// Checks that all programs that may call this program are free of syntax errors.
fn check_callers_readable(db: &dyn Db, symbol: &Symbol) -> Result<(), RefactoringError> {
    let Symbol::Program(project, name) = symbol else { return Ok(()) };
    for user in projects_using(db, *project) {
        for file in program_files(db, user).iter().filter(|file| mentions(db, **file, name)) {
            if !parse(db, *file).errors().is_empty() {
                let path = file.path(db).file_name().unwrap_or("");
                return Err(format!("`{path}` may call `{name}` and has syntax errors").into());
            }
        }
    }
    check_libraries_resolved(db, *project, name)
}

/// Checks that no program calls a program of this name in an unresolved library.
fn check_libraries_resolved(db: &dyn Db, project: Project, name: &str) -> Result<(), RefactoringError> {
    if !val3_analysis::interfaces::is_public(db, project, name) {
        return Ok(());
    }
    for user in Sources::get(db).projects(db).values() {
        let libraries = &items(db, *user).libraries;
        for file in program_files(db, *user).iter().filter(|file| mentions(db, **file, name)) {
            let body = body(db, *file);
            let callees = body.exprs().filter_map(|(_, expr, _)| callee(expr)).map(|id| body.expr(id));
            let mut used = callees.filter_map(|callee| match callee {
                Expr::Path { library, item } if item == name => Some(library),
                _ => None,
            });
            let unresolved = used.find(|used| libraries.get(*used).is_none_or(|library| library.interface.is_none()));
            if let Some(library) = unresolved {
                let caller = &header(db, *file).name;
                return Err(format!(
                    "`{caller}` calls `{library}:{name}`, and the library `{library}` cannot be resolved"
                )
                .into());
            }
        }
    }
    Ok(())
}

fn callee(expr: &Expr) -> Option<ExprId> {
    if let Expr::Call(callee, _) = expr { Some(*callee) } else { None }
}

/// Whether the text of a file contains the word `name`.
fn mentions(db: &dyn Db, file: File, name: &str) -> bool {
    let text = file.text(db).as_bytes();
    memmem::find_iter(text, name).any(|at| {
        let before = at.checked_sub(1).and_then(|before| text.get(before));
        let after = text.get(at + name.len());
        !before.is_some_and(is_in_word) && !after.is_some_and(is_in_word)
    })
}

fn is_in_word(byte: &u8) -> bool {
    byte.is_ascii_alphanumeric() || *byte == b'_'
}

impl Call {
    /// Call whose program name is at `range`; `None` if the name is not called.
    pub(crate) fn at(
        db: &dyn Db,
        file: File,
        project: Project,
        range: TextRange,
    ) -> Result<Option<Self>, RefactoringError> {
        let body = body(db, file);
        let mut calls = body.exprs().filter_map(|(_, expr, whole)| match expr {
            Expr::Call(callee, arguments) => Some((whole, body.range(*callee), arguments)),
            _ => None,
        });
        let call = calls.find(|(_, callee, _)| callee.end() == range.end());
        let Some((whole, _, arguments)) = call else { return Ok(None) };
        let arguments = arguments.to_vec();
        let text = text_at(file.text(db), whole);
        if !text.ends_with(')') {
            return Err(format!("a call in `{}` has no end", header(db, file).name).into());
        }
        let end = whole.end() - TextSize::of(')');
        let parse = parse(db, file);
        let is_escaped = program::code(parse.view()).is_none_or(|code| code.token(SyntaxKind::CDATA_OPEN).is_none());
        Ok(Some(Self { file, project, arguments, end, is_escaped }))
    }

    /// Whether the call passes arguments.
    pub(crate) fn has_arguments(&self) -> bool {
        !self.arguments.is_empty()
    }

    /// Ranges of the arguments.
    pub(super) fn places(&self, db: &dyn Db) -> Vec<TextRange> {
        let body = body(db, self.file);
        self.arguments.iter().map(|id| body.range(*id)).collect()
    }

    /// Whether the argument is a variable of type `ty`, and the call does not create a task.
    pub(super) fn passes_variable(&self, db: &dyn Db, index: usize, ty: Base) -> bool {
        let Some(argument) = self.arguments.get(index) else { return false };
        let body = body(db, self.file);
        let is_variable = matches!(body.expr(*argument), Expr::Name(_) | Expr::Path { .. } | Expr::Index(..))
            && Effects::new(db, self.project, self.file).root(*argument).is_some();
        let is_same = infer(db, self.project, self.file).ty(*argument).base.same_as(ty);
        is_variable && is_same && !is_in_task_create(body, body.range(*argument))
    }

    /// Indexes of the arguments whose evaluation has side effects.
    pub(super) fn with_effects(&self, db: &dyn Db) -> Vec<usize> {
        let body = body(db, self.file);
        let acts = |id: &ExprId| body.within(*id).any(|part| self.acts(db, body, part));
        (0..).zip(&self.arguments).filter(|(_, id)| acts(id)).map(|(index, _)| index).collect()
    }

    fn acts(&self, db: &dyn Db, body: &Body, id: ExprId) -> bool {
        match body.expr(id) {
            Expr::Call(..) => {
                let Some(call) = infer(db, self.project, self.file).call(id) else { return true };
                let forms = call.form.map_or(call.instruction.overloads, std::slice::from_ref);
                call.instruction.blocking || forms.iter().any(|form| form.class == CallClass::Modifier)
            }
            Expr::Assign(..) | Expr::Missing => true,
            _ => false,
        }
    }

    /// Text between two arguments.
    pub(super) fn separator(&self, db: &dyn Db) -> &'static str {
        let places = self.places(db);
        let text: &str = self.file.text(db);
        let pairs = places.iter().zip(places.iter().skip(1));
        let mut separators = pairs.map(|(one, next)| text.get(usize::from(one.end())..usize::from(next.start())));
        if separators.any(|separator| separator == Some(", ")) { ", " } else { "," }
    }
}

/// Whether a `taskCreate` contains the range.
fn is_in_task_create(body: &Body, range: TextRange) -> bool {
    let stmts = body.stmts();
    let mut creations = stmts.iter().filter(|stmt| matches!(stmt.kind, StmtKind::TaskCreate { .. }));
    creations.any(|stmt| stmt.range.contains_range(range))
}
