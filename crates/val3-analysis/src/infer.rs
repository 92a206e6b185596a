//! Types: what every expression of a program is, and what does not fit.

mod access;
mod arguments;
mod calls;
mod expressions;
mod fit;
mod literals;
mod names;
pub(crate) mod programs;
mod statements;
mod value;

pub(crate) use expressions::STRING_LIMIT;

use rowan::TextRange;
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::add_on::AddOnOverload;
use val3_lang::instruction::{Instruction, Overload};
use val3_lang::types::Arm;

use crate::body::{Body, ExprId, body};
use crate::db::{Db, File, FileRange, Project};
use crate::items::program::{Header, header};
use crate::items::project::{Items, items};
use crate::problem::{Problem, ProblemKind, Related, Role};
use crate::resizing::is_resized;
use crate::ty::{Base, Ty};

/// What the analysis knows about the code of one program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Inference {
    types: Vec<Ty>,
    /// Calls of instructions, by number: inner ones before outer ones.
    calls: Vec<InstructionCall>,
    /// Calls of instructions that the tables of add-ons declare, by number.
    add_on_calls: Vec<AddOnCall>,
    problems: Vec<Problem>,
    overflows: Vec<Overflow>,
}

/// A call of an instruction that the table of an add-on declares.
#[derive(Debug, Clone, PartialEq)]
pub struct AddOnCall {
    /// The whole call, an [`Expr::Call`](crate::body::Expr::Call).
    pub id: ExprId,
    /// The name with its `$`.
    pub name: SmolStr,
    /// The form that suits the arguments.
    pub form: AddOnOverload,
}

/// A call of an instruction of the catalogue.
#[derive(Debug, Clone, PartialEq)]
pub struct InstructionCall {
    /// The whole call, an [`Expr::Call`](crate::body::Expr::Call).
    pub id: ExprId,
    /// The instruction.
    pub instruction: &'static Instruction,
    /// The form that suits the arguments; `None` where none does, or where several might.
    pub form: Option<&'static Overload>,
}

/// A constant index beyond the size at the start: wrong where no program of the project changes that size. Asking
/// them here would make every body depend on all others.
#[derive(Debug, Clone, PartialEq)]
struct Overflow {
    data: SmolStr,
    problem: Problem,
}

impl Inference {
    /// The type of an expression; a whole container keeps its container.
    pub fn ty(&self, id: ExprId) -> Ty {
        self.types.get(id.index()).copied().unwrap_or(Ty::UNKNOWN)
    }

    /// The call that `id` is, if it calls an instruction.
    pub fn call(&self, id: ExprId) -> Option<&InstructionCall> {
        let at = self.calls.binary_search_by_key(&id, |call| call.id).ok()?;
        self.calls.get(at)
    }

    /// The call that `id` is, if it calls an instruction that the table of an add-on declares.
    pub fn add_on_call(&self, id: ExprId) -> Option<&AddOnCall> {
        let at = self.add_on_calls.binary_search_by_key(&id, |call| call.id).ok()?;
        self.add_on_calls.get(at)
    }

    /// Every call of an instruction, inner ones before outer ones.
    pub fn calls(&self) -> &[InstructionCall] {
        &self.calls
    }
}

/// Infers the types of the program in `file` as a part of `project`.
#[salsa::tracked(lru = 256)]
pub fn infer(db: &dyn Db, project: Project, file: File) -> Inference {
    let body = body(db, file);
    let mut infer = Infer::new(db, project, file, body);
    infer.block(&body.block);
    infer.calls.sort_unstable_by_key(|call| call.id);
    infer.add_on_calls.sort_unstable_by_key(|call| call.id);
    Inference {
        types: infer.types,
        calls: infer.calls,
        add_on_calls: infer.add_on_calls,
        problems: infer.problems,
        overflows: infer.overflows,
    }
}

/// What is wrong with the code of the program in `file`, by position. Kept when the types are dropped.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project, file: File) -> Vec<Problem> {
    let inference = infer(db, project, file);
    let lasting = inference.overflows.iter().filter(|overflow| !is_resized(db, project, &overflow.data));
    let overflows = lasting.map(|overflow| &overflow.problem);
    let mut problems: Vec<Problem> = inference.problems.iter().chain(overflows).cloned().collect();
    problems.sort_by_key(|problem| problem.place.range.start());
    problems
}

/// The walk over one body.
struct Infer<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    body: &'db Body,
    items: &'db Items,
    header: &'db Header,
    /// Parameters and locals.
    scope: FxHashMap<&'db str, value::Value>,
    types: Vec<Ty>,
    calls: Vec<InstructionCall>,
    add_on_calls: Vec<AddOnCall>,
    problems: Vec<Problem>,
    overflows: Vec<Overflow>,
    /// The expression names a value that need not be there: its index has no bounds.
    may_be_absent: bool,
}

impl<'db> Infer<'db> {
    fn new(db: &'db dyn Db, project: Project, file: File, body: &'db Body) -> Self {
        let items = items(db, project);
        let header = header(db, file);
        let scope = names::scope(items, header);
        let types = vec![Ty::UNKNOWN; body.len()];
        Self {
            db,
            project,
            file,
            body,
            items,
            header,
            scope,
            types,
            calls: Vec::new(),
            add_on_calls: Vec::new(),
            problems: Vec::new(),
            overflows: Vec::new(),
            may_be_absent: false,
        }
    }

    fn arm(&self) -> Option<Arm> {
        self.items.arm
    }

    fn place(&self, range: TextRange) -> FileRange {
        FileRange { file: self.file, range }
    }

    /// Reports a fault at an expression.
    fn report(&mut self, id: ExprId, kind: ProblemKind) {
        self.report_at(self.body.range(id), kind, None);
    }

    /// Reports a fault at an expression and names the place of a declaration.
    fn report_with(&mut self, id: ExprId, kind: ProblemKind, role: Role, declared: Option<FileRange>) {
        self.report_at(self.body.range(id), kind, declared.map(|place| Related { place, role }));
    }

    fn report_at(&mut self, range: TextRange, kind: ProblemKind, related: Option<Related>) {
        // A name that is missing is one mistake, however often the program uses it.
        if kind.is_about_missing_name() && self.problems.iter().any(|problem| problem.kind == kind) {
            return;
        }
        let place = self.place(range);
        self.problems.push(Problem { kind, place, related: related.into_iter().collect() });
    }

    fn set_type(&mut self, id: ExprId, ty: Ty) {
        if let Some(slot) = self.types.get_mut(id.index()) {
            *slot = ty;
        }
    }

    fn show(&self, base: Base) -> SmolStr {
        base.display(self.db)
    }
}
