//! Which variables the lines of a program read, write and hand over.

mod walk;

use std::cell::OnceCell;

use smol_str::SmolStr;
use val3_lang::instruction::{Class, Instruction, Overload, Shape};
use val3_lang::instructions::LINK;
use val3_lang::types::BaseType;

use crate::body::{Body, Expr, ExprId, body};
use crate::db::{Db, File, Project};
use crate::flow::{Flow, PerPoint, Point, PointId, PointKind, flow};
use crate::infer::{Inference, infer};
use crate::items::program::{Header, header};
use crate::items::project::{Items, Signature, items, signature};

/// A variable by its root: `a` of `a[1].x`.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Root {
    /// A local variable.
    Local(SmolStr),
    /// A parameter.
    Param(SmolStr),
    /// Global data of the own project.
    Data(SmolStr),
    /// Data of a library.
    Item(SmolStr, SmolStr),
}

/// A use of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum AccessKind {
    /// Its value is used.
    Read,
    /// All of it gets a value.
    Write,
    /// An element or a field of it gets a value.
    WritePart,
    /// It is handed over by reference to something that may read and write it.
    Reference,
}

/// One use of a variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Access {
    /// The variable with its indexes and fields.
    pub id: ExprId,
    /// The variable that it is a part of.
    pub root: Root,
    /// The kind of use.
    pub kind: AccessKind,
}

/// Expressions for each use of a variable, in programs that compute much.
const EXPRESSIONS_AN_ACCESS: usize = 2;

#[salsa::tracked(lru = 256, no_eq)]
fn accesses(db: &dyn Db, project: Project, file: File) -> PerPoint<Access> {
    let effects = Effects::new(db, project, file);
    let mut accesses = PerPoint::with_capacity(effects.flow.len(), effects.body.len() / EXPRESSIONS_AN_ACCESS);
    effects.flow.points().for_each(|(_, point)| accesses.push_with(|found| walk::point(&effects, point, found)));
    accesses.shrink_to_fit();
    accesses
}

/// The context for finding the effects of a program on its variables.
pub struct Effects<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    body: &'db Body,
    flow: &'db Flow,
    inference: &'db Inference,
    header: &'db Header,
    items: &'db Items,
    /// Computed on first use.
    accesses: OnceCell<&'db PerPoint<Access>>,
}

impl<'db> Effects<'db> {
    /// Those of the program in `file` as a part of `project`.
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

    /// The instruction that the call `id` calls, with the form that suits the arguments.
    pub fn instruction(&self, id: ExprId) -> Option<(&'static Instruction, Option<&'static Overload>)> {
        self.inference.call(id).map(|call| (call.instruction, call.form))
    }

    /// The scheduler may go on to the next task somewhere in the program: an instruction waits, a serial line is read
    /// or written (5.4), or a program of a library is called, which may do anything.
    pub fn may_wait(&self) -> bool {
        let blocks = self.inference.calls().iter().any(|call| call.instruction.blocking);
        blocks
            || self.body.exprs().any(|(id, ..)| self.is_serial(id))
            || self.flow.points().any(|(_, point)| self.is_foreign(point))
    }

    /// The scheduler may go on to the next task at this point.
    pub fn may_wait_at(&self, point: &Point) -> bool {
        let mut parts = point.kind.exprs().flat_map(|id| self.body.within(id));
        let blocks = |id| self.instruction(id).is_some_and(|(instruction, _)| instruction.blocking);
        self.is_foreign(point) || parts.any(|id| blocks(id) || self.is_serial(id))
    }

    fn is_serial(&self, id: ExprId) -> bool {
        self.inference.ty(id).base.builtin() == Some(BaseType::Sio)
    }

    /// The call of a program of a library.
    fn is_foreign(&self, point: &Point) -> bool {
        let PointKind::Call(call) = point.kind else { return false };
        match self.body.expr(call) {
            Expr::Call(callee, _) => !matches!(self.body.expr(*callee), Expr::Name(_)),
            _ => true,
        }
    }

    /// The effects at a point, in the order of evaluation.
    pub fn at(&self, point: PointId) -> &'db [Access] {
        self.accesses().at(point)
    }

    /// Every use of a variable in the program.
    pub fn all(&self) -> &'db [Access] {
        self.accesses().all()
    }

    fn accesses(&self) -> &'db PerPoint<Access> {
        self.accesses.get_or_init(|| accesses(self.db, self.project, self.file))
    }

    /// The variable that `id` is or is a part of; `None` for constants, computed values and names that are built in.
    pub fn root(&self, id: ExprId) -> Option<Root> {
        match self.body.expr(id) {
            Expr::Name(name) => self.named(name),
            Expr::Path { library, item } => {
                self.items.libraries.contains_key(library).then(|| Root::Item(library.clone(), item.clone()))
            }
            Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) => self.root(*base),
            _ => None,
        }
    }

    fn named(&self, name: &SmolStr) -> Option<Root> {
        if self.header.locals.iter().any(|local| local.name == *name) {
            Some(Root::Local(name.clone()))
        } else if self.header.params.iter().any(|param| param.name == *name) {
            Some(Root::Param(name.clone()))
        } else {
            self.items.data.contains_key(name).then(|| Root::Data(name.clone()))
        }
    }

    /// The signature of the program that `callee` names, of the own project or of a library's interface.
    pub fn program(&self, callee: ExprId) -> Option<&'db Signature> {
        let (project, file) = self.program_file(callee)?;
        Some(signature(self.db, project, file))
    }

    /// The file of the program that `callee` names, with its project.
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

/// The use of the argument at `position` by an instruction; `None` for a value.
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
        if param.shape != Shape::Value {
            let acts = form.class == Class::Modifier && param.shape != Shape::ProgramCall;
            kind = kind.max(Some(if acts { AccessKind::Reference } else { AccessKind::Read }));
        }
    }
    kind
}
