//! Data that are targets of moves, with the tools of these moves.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use val3_lang::motion::{self, MotionRole, keeps_configuration};
use val3_lang::types::BaseType;

use crate::body::{Body, Constant, Expr, ExprId, body};
use crate::db::{Db, File, Project};
use crate::effects::{Effects, RootVariable};
use crate::flow::{PointKind, flow};
use crate::infer::{Inference, infer};
use crate::items::positions::key_of;
use crate::items::project::program_files;

/// Use of data as a move target.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TargetUse {
    /// Data paths of the tools, for moves whose tool is data or built in.
    pub tools: FxHashSet<SmolStr>,
    /// Whether other tools are possible: a move has an unknown tool, or the data are passed to a program.
    pub is_open: bool,
}

/// Uses of data as move targets, by data name.
pub type Targets = FxHashMap<SmolStr, TargetUse>;

/// Returns the data of a project that its programs use as move targets or pass on.
#[salsa::tracked]
pub fn targets(db: &dyn Db, project: Project) -> Targets {
    let mut all = Targets::default();
    for file in program_files(db, project) {
        for (name, one) in targets_in(db, project, *file) {
            let uses = all.entry(name.clone()).or_default();
            uses.tools.extend(one.tools.iter().cloned());
            uses.is_open |= one.is_open;
        }
    }
    all
}

#[salsa::tracked]
fn targets_in(db: &dyn Db, project: Project, file: File) -> Targets {
    let mut search = TargetCollector {
        body: body(db, file),
        inference: infer(db, project, file),
        effects: Effects::new(db, project, file),
        found: Targets::default(),
    };
    for (id, expr, _) in search.body.exprs() {
        if let Expr::Call(_, args) = expr {
            search.call(id, args);
        }
    }
    for (_, point) in flow(db, file).points() {
        search.point(&point.kind);
    }
    search.found
}

struct TargetCollector<'db> {
    body: &'db Body,
    inference: &'db Inference,
    effects: Effects<'db>,
    found: Targets,
}

impl TargetCollector<'_> {
    /// Adds the targets of a move instruction.
    fn call(&mut self, id: ExprId, args: &[ExprId]) {
        let Some(call) = self.inference.call(id) else { return };
        let Some(MotionRole::Move(_)) = call.instruction.role else { return };
        let tool = call.form.and_then(motion::tool).and_then(|at| args.get(at)).copied();
        let tool = tool.and_then(|tool| path(self.body, tool));
        for target in args {
            let Some(uses) = self.uses(*target) else { continue };
            match &tool {
                Some(tool) => _ = uses.tools.insert(tool.clone()),
                None => uses.is_open = true,
            }
        }
    }

    fn point(&mut self, kind: &PointKind) {
        match kind {
            PointKind::Call(call) => {
                if let Expr::Call(_, args) = self.body.expr(*call) {
                    self.pass_on(args);
                }
            }
            PointKind::TaskCreate(args) => self.pass_on(args),
            PointKind::Assign { value, .. } => self.pass_on(&[*value]),
            _ => {}
        }
    }

    fn pass_on(&mut self, args: &[ExprId]) {
        for arg in args {
            match self.body.expr(self.body.without_parentheses(*arg)) {
                // Arguments of a call in `taskCreate`.
                Expr::Call(_, inner) if self.inference.call(*arg).is_none() => self.pass_on(inner),
                _ if self.may_hold_target(*arg) => {
                    self.uses(*arg).into_iter().for_each(|uses| uses.is_open = true);
                }
                _ => {}
            }
        }
    }

    /// Whether the value is a point, a joint, or of a user type, which may have such fields.
    fn may_hold_target(&self, id: ExprId) -> bool {
        let ty = self.inference.ty(id).base.builtin();
        ty.is_none_or(|ty| matches!(ty, BaseType::Point | BaseType::Joint))
    }

    /// Returns the use of the data whose value `id` is, or from which it is computed.
    fn uses(&mut self, id: ExprId) -> Option<&mut TargetUse> {
        let id = self.body.without_parentheses(id);
        if let Expr::Call(_, args) = self.body.expr(id) {
            let call = self.inference.call(id).filter(|call| keeps_configuration(call.instruction));
            return call.and(args.first().copied()).and_then(|point| self.uses(point));
        }
        match self.effects.root(id)? {
            RootVariable::Data(name) => Some(self.found.entry(name).or_default()),
            _ => None,
        }
    }
}

/// Returns the data path of a value with every index: `tSlots[1,2].pPlace[0]`; `None` if an index is not constant.
/// Whether such data exist is not checked.
pub fn path(body: &Body, id: ExprId) -> Option<SmolStr> {
    let id = body.without_parentheses(id);
    let (container, key) = match body.expr(id) {
        Expr::Index(base, keys) => (*base, key(body, keys)?),
        _ => (id, "0".to_owned()),
    };
    let name = match body.expr(body.without_parentheses(container)) {
        Expr::Name(name) => name.to_string(),
        Expr::Field { base, field, .. } => format!("{}.{field}", path(body, *base)?),
        _ => return None,
    };
    Some(format!("{name}[{key}]").into())
}

/// Returns the key for constant indexes, for example `1,2` or `near`.
pub fn key(body: &Body, keys: &[ExprId]) -> Option<String> {
    let parts = keys.iter().map(|key| key_part(&body.constant(*key)?));
    parts.collect::<Option<Vec<_>>>().map(|parts| key_of(&parts.join(",")))
}

fn key_part(constant: &Constant) -> Option<String> {
    match constant {
        Constant::Number(number) => Some(number.to_string()),
        Constant::String(text) => Some(text.to_string()),
        Constant::Bool(_) => None,
    }
}
