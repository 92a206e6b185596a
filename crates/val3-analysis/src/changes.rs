//! Data that the programs of a project may change, directly or through parameters by reference.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use val3_lang::data_path::DataPath;

use crate::body::{Body, Expr, ExprId, body};
use crate::db::{Db, File, Project};
use crate::effects::{AccessKind, Effects, RootVariable};
use crate::flow::{PointKind, flow};
use crate::items::program::header;
use crate::items::project::{program_files, signature};

/// Maximum length of a field path in bytes. A longer path counts as a change of the entire parameter, so that recursive
/// calls terminate.
const LONGEST: usize = 80;

/// Whether a program of the project may change the value at a path, a value that contains it, or a field in it.
pub fn is_changed(db: &dyn Db, project: Project, path: &str) -> bool {
    let path = DataPath::new(path);
    changes(db, project).get(path.before_index()).is_some_and(|changes| {
        let fields = path.without_indexes();
        changes.iter().any(|changed| is_part(&fields, changed) || is_part(changed, &fields))
    })
}

/// Fields that programs may change, without indexes (`tSlots.bFull`), by data name.
type FieldChanges = FxHashMap<SmolStr, FxHashSet<SmolStr>>;

/// Fields of parameters that programs may change, as the rest of a path (`.bFull`), by program and parameter position.
type ParamChanges = FxHashMap<(SmolStr, usize), FxHashSet<SmolStr>>;

#[salsa::tracked]
fn changes(db: &dyn Db, project: Project) -> FieldChanges {
    let programs: Vec<&ProgramChanges> =
        program_files(db, project).iter().map(|file| program_changes(db, project, *file)).collect();
    let mut changes = KnownChanges::default();
    for program in &programs {
        for target in &program.changed {
            changes.add(program, target, "");
        }
    }
    let mut is_growing = true;
    while is_growing {
        is_growing = false;
        for program in &programs {
            for HandOver { target, callee, position } in &program.handed_over {
                let rests = changes.params.get(&(callee.clone(), *position)).cloned().unwrap_or_default();
                for rest in rests {
                    is_growing |= changes.add(program, target, &rest);
                }
            }
        }
    }
    changes.data
}

/// Changes found so far.
#[derive(Debug, Default)]
struct KnownChanges {
    data: FieldChanges,
    params: ParamChanges,
}

impl KnownChanges {
    /// Adds that `program` may change `target` followed by `rest`. Returns whether the change is new.
    fn add(&mut self, program: &ProgramChanges, target: &ChangedPath, rest: &str) -> bool {
        match target {
            ChangedPath::Data(path) => {
                let name = path.split('.').next().unwrap_or_default();
                self.data.entry(name.into()).or_default().insert(format!("{path}{rest}").into())
            }
            ChangedPath::Param(position, fields) => {
                let rest = format!("{fields}{rest}");
                let rest = if rest.len() > LONGEST { SmolStr::default() } else { rest.into() };
                self.params.entry((program.name.clone(), *position)).or_default().insert(rest)
            }
        }
    }
}

/// Variables that a program changes directly, and variables that it passes by reference.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct ProgramChanges {
    name: SmolStr,
    changed: FxHashSet<ChangedPath>,
    handed_over: Vec<HandOver>,
}

/// Data or a parameter, with fields and without indexes.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum ChangedPath {
    /// `tSlots.bFull`
    Data(SmolStr),
    /// Parameter position, and rest of the path, for example `.bFull`.
    Param(usize, SmolStr),
}

/// A variable that is passed by reference to a program of the same project.
#[derive(Debug, Clone, PartialEq, Eq)]
struct HandOver {
    target: ChangedPath,
    callee: SmolStr,
    position: usize,
}

#[salsa::tracked(returns(ref))]
fn program_changes(db: &dyn Db, project: Project, file: File) -> ProgramChanges {
    let search = ChangeCollector { db, project, file, body: body(db, file), effects: Effects::new(db, project, file) };
    let mut found = ProgramChanges { name: header(db, file).name.clone(), ..ProgramChanges::default() };
    let mut arguments = FxHashSet::default();
    for (_, point) in flow(db, file).points() {
        if let Some((call, args)) = search.called(&point.kind) {
            for (position, argument) in args.iter().enumerate() {
                if let Some(hand_over) = search.hand_over(call, position, *argument) {
                    found.handed_over.push(hand_over);
                    arguments.insert(*argument);
                }
            }
        }
    }
    let accesses = search.effects.all().iter();
    let changes = accesses.filter(|access| access.kind != AccessKind::Read && !arguments.contains(&access.id));
    found.changed = changes.filter_map(|access| search.target(access.id)).collect();
    found
}

struct ChangeCollector<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    body: &'db Body,
    effects: Effects<'db>,
}

impl<'db> ChangeCollector<'db> {
    /// Returns the called program and the arguments of a line.
    fn called(&self, point: &PointKind) -> Option<(ExprId, &'db [ExprId])> {
        let call = match point {
            PointKind::Call(call) => call,
            PointKind::TaskCreate(arguments) => arguments.last()?,
            _ => return None,
        };
        match self.body.expr(*call) {
            Expr::Call(callee, args) => Some((*callee, args)),
            _ => None,
        }
    }

    /// Returns the argument if it is passed by reference to a program of the project.
    fn hand_over(&self, callee: ExprId, position: usize, argument: ExprId) -> Option<HandOver> {
        let (project, file) = self.effects.program_file(callee).filter(|(project, _)| *project == self.project)?;
        let called = signature(self.db, project, file);
        called.params.get(position).filter(|param| param.by_reference)?;
        Some(HandOver { target: self.target(argument)?, callee: called.name.clone(), position })
    }

    fn target(&self, id: ExprId) -> Option<ChangedPath> {
        let path = fields(self.body, id);
        match self.effects.root(id)? {
            RootVariable::Data(_) => Some(ChangedPath::Data(path.into())),
            RootVariable::Param(name) => {
                let params = &header(self.db, self.file).params;
                let position = params.iter().position(|param| param.name == name)?;
                Some(ChangedPath::Param(position, path.strip_prefix(name.as_str())?.into()))
            }
            RootVariable::Local(_) | RootVariable::Item(..) => None,
        }
    }
}

/// Returns the variable or field as spelt in the code, without indexes.
fn fields(body: &Body, id: ExprId) -> String {
    match body.expr(id) {
        Expr::Name(name) => name.to_string(),
        Expr::Field { base, field, .. } => format!("{}.{field}", fields(body, *base)),
        Expr::Index(base, _) | Expr::Paren(base) => fields(body, *base),
        _ => String::new(),
    }
}

/// Whether `part` is equal to `whole` or is a field in it.
fn is_part(part: &str, whole: &str) -> bool {
    part.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}
