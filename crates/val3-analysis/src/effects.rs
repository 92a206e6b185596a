//! Variables that the lines of a program read, write and pass by reference.

mod walk;

use std::cell::OnceCell;

use smol_str::SmolStr;
use val3_lang::instruction::{ArgumentForm, CallClass, Instruction, Overload};
use val3_lang::instructions::LINK;
use val3_lang::types::BaseType;

use crate::body::{Body, Expr, ExprId, body};
use crate::db::{Db, File, Project};
use crate::flow::{FlowGraph, FlowNode, FlowNodeId, PerPoint, PointKind, flow};
use crate::infer::{Inference, infer};
use crate::items::program::{Header, header};
use crate::items::project::{Items, Signature, items, signature};

/// Root variable, for example `a` for the expression `a[1].x`.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum RootVariable {
    /// A local variable.
    Local(SmolStr),
    /// A parameter.
    Param(SmolStr),
    /// Global data of the own project.
    Data(SmolStr),
    /// Data of a library.
    Item(SmolStr, SmolStr),
}

/// Kind of variable use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum AccessKind {
    /// The value is read.
    Read,
    /// The entire variable is written.
    Write,
    /// An element or a field of the variable is written.
    WritePart,
    /// The variable is passed by reference, so that it may be read and written.
    Reference,
}

/// One use of a variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Access {
    /// Variable with its indexes and fields.
    pub id: ExprId,
    /// Root variable.
    pub root: RootVariable,
    /// Kind of use.
    pub kind: AccessKind,
}

/// Typical number of expressions for each use of a variable, in programs with many computations.
const EXPRESSIONS_AN_ACCESS: usize = 2;

#[salsa::tracked(lru = 256, no_eq)]
fn accesses(db: &dyn Db, project: Project, file: File) -> PerPoint<Access> {
    let effects = Effects::new(db, project, file);
    let mut accesses = PerPoint::with_capacity(effects.flow.len(), effects.body.len() / EXPRESSIONS_AN_ACCESS);
    effects.flow.points().for_each(|(_, point)| accesses.push_with(|found| walk::point(&effects, point, found)));
    accesses.shrink_to_fit();
    accesses
}

/// Context for computing the effects of a program on variables.
pub struct Effects<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    body: &'db Body,
    flow: &'db FlowGraph,
    inference: &'db Inference,
    header: &'db Header,
    items: &'db Items,
    /// Accesses of the program, computed on first use.
    accesses: OnceCell<&'db PerPoint<Access>>,
}

impl<'db> Effects<'db> {
    /// Returns the effects of the program in `file` as a part of `project`.
    pub fn new(db: &'db dyn Db, project: Project, file: File) -> Self {
        Self {
            db,
            project,
            file,
            body: body(db, file),
            flow: flow(db, file),
            inference: infer(db, project, file),
            header: header(db, file),
            items: items(db, project),
            accesses: OnceCell::new(),
        }
    }

    /// Returns the instruction of the call `id`, with the form that matches the arguments.
    pub fn instruction(&self, id: ExprId) -> Option<(&'static Instruction, Option<&'static Overload>)> {
        self.inference.call(id).map(|call| (call.instruction, call.form))
    }

    /// Whether the scheduler may switch tasks during the program: an instruction waits, a serial line is accessed
    /// (5.4), or a library program with unknown effects is called.
    pub fn may_wait(&self) -> bool {
        let blocks = self.inference.calls().iter().any(|call| call.instruction.blocking);
        blocks
            || self.body.exprs().any(|(id, ..)| self.is_serial(id))
            || self.flow.points().any(|(_, point)| self.is_foreign(point))
    }

    /// Whether the scheduler may switch tasks at this flow node.
    pub fn may_wait_at(&self, point: &FlowNode) -> bool {
        let mut parts = point.kind.exprs().flat_map(|id| self.body.within(id));
        let blocks = |id| self.instruction(id).is_some_and(|(instruction, _)| instruction.blocking);
        self.is_foreign(point) || parts.any(|id| blocks(id) || self.is_serial(id))
    }

    fn is_serial(&self, id: ExprId) -> bool {
        self.inference.ty(id).base.builtin() == Some(BaseType::Sio)
    }

    /// Whether the flow node calls a library program.
    fn is_foreign(&self, point: &FlowNode) -> bool {
        let PointKind::Call(call) = point.kind else { return false };
        match self.body.expr(call) {
            Expr::Call(callee, _) => !matches!(self.body.expr(*callee), Expr::Name(_)),
            _ => true,
        }
    }

    /// Returns the effects at a flow node in the order of evaluation.
    pub fn at(&self, point: FlowNodeId) -> &'db [Access] {
        self.accesses().at(point)
    }

    /// Returns every use of a variable in the program.
    pub fn all(&self) -> &'db [Access] {
        self.accesses().all()
    }

    fn accesses(&self) -> &'db PerPoint<Access> {
        self.accesses.get_or_init(|| accesses(self.db, self.project, self.file))
    }

    /// Returns the root variable of `id`; `None` for constants, computed values and built-in names.
    pub fn root(&self, id: ExprId) -> Option<RootVariable> {
        match self.body.expr(id) {
            Expr::Name(name) => self.named(name),
            Expr::Path { library, item } => {
                self.items.libraries.contains_key(library).then(|| RootVariable::Item(library.clone(), item.clone()))
            }
            Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) => self.root(*base),
            _ => None,
        }
    }

    fn named(&self, name: &SmolStr) -> Option<RootVariable> {
        if self.header.locals.iter().any(|local| local.name == *name) {
            Some(RootVariable::Local(name.clone()))
        } else if self.header.params.iter().any(|param| param.name == *name) {
            Some(RootVariable::Param(name.clone()))
        } else {
            self.items.data.contains_key(name).then(|| RootVariable::Data(name.clone()))
        }
    }

    /// Returns the signature of the program that `callee` names, in the project or in a library's interface.
    pub fn program(&self, callee: ExprId) -> Option<&'db Signature> {
        let (project, file) = self.program_file(callee)?;
        Some(signature(self.db, project, file))
    }

    /// Returns the file of the program that `callee` names, with its project.
    pub fn program_file(&self, callee: ExprId) -> Option<(Project, File)> {
        let (project, items, name) = match self.body.expr(callee) {
            Expr::Name(name) => (self.project, self.items, name),
            Expr::Path { library, item } => {
                let interface = self.items.libraries.get(library)?.interface?;
                (interface, items(self.db, interface), item)
            }
            _ => return None,
        };
        Some((project, *items.programs.get(name)?))
    }
}

/// Returns the use of the argument at `position` by an instruction; `None` for an argument by value.
fn handed_over(
    instruction: &'static Instruction,
    form: Option<&'static Overload>,
    position: usize,
) -> Option<AccessKind> {
    if instruction.name == LINK && position == 0 {
        return Some(AccessKind::Reference);
    }
    let forms = form.map_or(instruction.overloads, std::slice::from_ref);
    let mut kind = None;
    for form in forms {
        let Some(param) = form.params.get(position) else { continue };
        if param.shape != ArgumentForm::Value {
            let acts = form.class == CallClass::Modifier && param.shape != ArgumentForm::ProgramCall;
            kind = kind.max(Some(if acts { AccessKind::Reference } else { AccessKind::Read }));
        }
    }
    kind
}
