//! Names in the code of a program.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use val3_lang::{builtins, enumerations};
use val3_syntax::{TextRange, TextSize};

use super::occurrence::{Occurrence, Symbol, Usage};
use crate::body::{Body, Expr, ExprId, body};
use crate::db::{Db, File, Project};
use crate::effects::{AccessKind, Effects};
use crate::flow::{PointKind, flow};
use crate::infer::{Inference, infer};
use crate::items::program::{Header, header};
use crate::items::project::{Items, items};
use crate::ty::Base;

struct NameCollector<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    header: &'db Header,
    items: &'db Items,
    inference: &'db Inference,
    /// Names that are called as programs.
    programs: FxHashSet<ExprId>,
    /// Names that are called as instructions.
    instructions: FxHashSet<ExprId>,
    /// Usage of the variable whose root is at the expression, if it is more than a read.
    usages: FxHashMap<ExprId, Usage>,
    found: Vec<Occurrence>,
}

pub(super) fn names(db: &dyn Db, project: Project, file: File) -> Vec<Occurrence> {
    let body = body(db, file);
    let mut names = NameCollector {
        db,
        project,
        file,
        header: header(db, file),
        items: items(db, project),
        inference: infer(db, project, file),
        programs: called_programs(db, file, body),
        instructions: FxHashSet::default(),
        usages: usages(db, project, file, body),
        found: Vec::new(),
    };
    names.instructions = body.exprs().filter_map(|(_, expr, _)| callee(expr)).collect();
    names.instructions.retain(|id| !names.programs.contains(id));
    for (id, expr, range) in body.exprs() {
        names.expr(id, expr, range);
    }
    names.found
}

fn callee(expr: &Expr) -> Option<ExprId> {
    if let Expr::Call(callee, _) = expr { Some(*callee) } else { None }
}

/// Returns the program names after `call` and in the call of `taskCreate`.
fn called_programs(db: &dyn Db, file: File, body: &Body) -> FxHashSet<ExprId> {
    let calls = flow(db, file).points().filter_map(|(_, point)| match &point.kind {
        PointKind::Call(call) => Some(*call),
        PointKind::TaskCreate(arguments) => arguments.last().copied(),
        _ => None,
    });
    calls.filter_map(|call| callee(body.expr(call))).collect()
}

fn usages(db: &dyn Db, project: Project, file: File, body: &Body) -> FxHashMap<ExprId, Usage> {
    let mut usages = FxHashMap::default();
    for access in Effects::new(db, project, file).all() {
        let usage = match access.kind {
            AccessKind::Read => continue,
            AccessKind::Write | AccessKind::WritePart => Usage::Write,
            AccessKind::Reference => Usage::Reference,
        };
        usages.insert(root(body, access.id), usage);
        usages.insert(last_name(body, access.id), usage);
    }
    usages
}

fn root(body: &Body, mut id: ExprId) -> ExprId {
    while let Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) = body.expr(id) {
        id = *base;
    }
    id
}

/// Returns the name before the last indexes, for example the field `b` for `a.b[1]`.
fn last_name(body: &Body, mut id: ExprId) -> ExprId {
    while let Expr::Index(base, _) | Expr::Paren(base) = body.expr(id) {
        id = *base;
    }
    id
}

impl NameCollector<'_> {
    fn expr(&mut self, id: ExprId, expr: &Expr, range: TextRange) {
        match expr {
            Expr::Name(name) => {
                let symbol = self.name(id, name);
                self.add(range, symbol, id);
            }
            Expr::Path { library, item } => self.path(id, library, item, range),
            Expr::Field { base, field, range } => {
                let symbol = match self.inference.ty(*base).base {
                    Base::Builtin(ty, _) => Some(Symbol::Field(ty, field.clone())),
                    Base::User(project) => Some(Symbol::Data(project, field.clone())),
                    Base::Unknown => None,
                };
                self.add(*range, symbol, id);
            }
            _ => {}
        }
    }

    fn add(&mut self, range: TextRange, symbol: Option<Symbol>, id: ExprId) {
        let usage = self.usages.get(&id).copied().unwrap_or(Usage::Read);
        self.found.extend(symbol.map(|symbol| Occurrence { range, symbol, usage }));
    }

    fn name(&self, id: ExprId, name: &SmolStr) -> Option<Symbol> {
        if self.programs.contains(&id) {
            return self.items.programs.contains_key(name).then(|| Symbol::Program(self.project, name.clone()));
        }
        if self.instructions.contains(&id) {
            return Some(Symbol::Instruction(name.clone()));
        }
        if self.header.locals.iter().any(|local| local.name == *name) {
            return Some(Symbol::Local(self.file, name.clone()));
        }
        if self.header.params.iter().any(|param| param.name == *name) {
            return Some(Symbol::Param(self.file, name.clone()));
        }
        if self.items.data.contains_key(name) {
            return Some(Symbol::Data(self.project, name.clone()));
        }
        let builtin = builtins::find(name).map(|_| Symbol::Builtin(name.clone()));
        builtin.or_else(|| enumerations::find(name).map(|_| Symbol::Enumerator(name.clone())))
    }

    /// Adds the names of `library:item`, with or without blanks around the colon.
    fn path(&mut self, id: ExprId, library: &SmolStr, item: &SmolStr, range: TextRange) {
        let library_range = TextRange::at(range.start(), TextSize::of(library.as_str()));
        let known = self.items.libraries.get(library);
        self.add(library_range, known.map(|_| Symbol::Library(self.project, library.clone())), id);
        let item_range = TextRange::new(range.end() - TextSize::of(item.as_str()), range.end());
        let symbol = self.item(id, known.and_then(|library| library.interface), item);
        self.add(item_range, symbol, id);
    }

    fn item(&self, id: ExprId, interface: Option<Project>, item: &SmolStr) -> Option<Symbol> {
        if self.instructions.contains(&id) {
            return Some(Symbol::Instruction(item.clone()));
        }
        let interface = interface?;
        let offered = items(self.db, interface);
        if self.programs.contains(&id) {
            return offered.programs.contains_key(item).then(|| Symbol::Program(interface, item.clone()));
        }
        offered.data.contains_key(item).then(|| Symbol::Data(interface, item.clone()))
    }
}
