//! Type inference: expression types, call forms, and faults.
//!
//! `Infer` walks the expressions in a body. `scope` resolves names, `fit` and `arguments` select the form of a call,
//! `table` stores the results and `sink` the problems.

mod access;
mod arguments;
mod calls;
mod expressions;
mod fit;
mod literals;
mod programs;
mod scope;
mod sink;
mod statements;
mod table;
mod value;

use rowan::TextRange;

use self::scope::{NameResolver, Unresolved};
use self::sink::{BodyProblems, Sink};
use self::table::TypeTable;
pub use self::table::{AddOnCall, InstructionCall};
use crate::body::{Body, ExprId, body};
use crate::db::{Db, File, Project};
use crate::problem::{Problem, ProblemKind};
use crate::ty::Ty;

/// Inference results for the code of a program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Inference {
    table: TypeTable,
    faults: BodyProblems,
}

impl Inference {
    /// Returns the expression's type. An expression without an index has the container of its variable.
    pub fn ty(&self, id: ExprId) -> Ty {
        self.table.ty(id)
    }

    /// Returns the call at `id`, if it calls an instruction of the catalogue.
    pub fn call(&self, id: ExprId) -> Option<&InstructionCall> {
        self.table.call(id)
    }

    /// Returns the call at `id`, if it calls an instruction that an add-on's table declares.
    pub fn add_on_call(&self, id: ExprId) -> Option<&AddOnCall> {
        self.table.add_on_call(id)
    }

    /// Whether `id` is a call of a known instruction that returns no value.
    pub fn is_call_without_value(&self, id: ExprId) -> bool {
        self.ty(id).is_unknown() && (self.call(id).is_some() || self.add_on_call(id).is_some())
    }

    /// Returns all instruction calls, inner before outer ones.
    pub fn calls(&self) -> &[InstructionCall] {
        self.table.calls()
    }
}

/// Infers the types of the program in `file` as a part of `project`.
#[salsa::tracked(lru = 256)]
pub fn infer(db: &dyn Db, project: Project, file: File) -> Inference {
    let body = body(db, file);
    let mut infer = Infer {
        file,
        body,
        scope: NameResolver::new(db, project, file),
        table: TypeTable::new(body.len()),
        sink: Sink::new(file, body),
        may_be_absent: false,
    };
    statements::walk_block(&mut infer, &body.block);
    Inference { table: infer.table.finish(), faults: infer.sink.finish() }
}

/// Returns the problems in the code of the program in `file`, sorted by position. They remain memoised when the types
/// are evicted.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project, file: File) -> Vec<Problem> {
    infer(db, project, file).faults.lasting(db, project)
}

/// State of the walk over the expressions in a body.
struct Infer<'db> {
    file: File,
    body: &'db Body,
    scope: NameResolver<'db>,
    table: TypeTable,
    sink: Sink<'db>,
    /// Whether the value of the expression may be absent, so that its index has no bounds.
    may_be_absent: bool,
}

impl Infer<'_> {
    fn report(&mut self, id: ExprId, kind: ProblemKind) {
        self.sink.report(self.body.range(id), kind, None);
    }

    /// Returns the lookup's result for the name at `id`, or reports why the lookup failed.
    fn resolved<T>(&mut self, id: ExprId, lookup: Result<T, Unresolved>) -> Option<T> {
        self.resolved_at(self.body.range(id), lookup)
    }

    fn resolved_at<T>(&mut self, range: TextRange, lookup: Result<T, Unresolved>) -> Option<T> {
        match lookup {
            Ok(found) => Some(found),
            Err(Unresolved::Incomplete) => None,
            Err(Unresolved::Fault(fault)) => {
                self.sink.report(range, fault.kind, fault.related);
                None
            }
        }
    }
}
