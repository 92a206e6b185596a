//! Collection of variable accesses from the expressions at a flow node.

use val3_lang::types::BaseType;

use super::{Access, AccessKind, Effects, handed_over};
use crate::body::{Expr, ExprId};
use crate::flow::{FlowNode, PointKind};
use crate::items::project::Signature;

struct Walk<'e, 'db> {
    effects: &'e Effects<'db>,
    found: &'e mut Vec<Access>,
}

pub(super) fn point(effects: &Effects<'_>, point: &FlowNode, found: &mut Vec<Access>) {
    let mut walk = Walk { effects, found };
    match &point.kind {
        PointKind::Test { condition, .. } => walk.values(condition.as_slice()),
        PointKind::ForStart { counter, start, stop, step } => {
            walk.values(start.as_slice());
            walk.values(stop.as_slice());
            walk.values(step.as_slice());
            walk.targets(counter.as_slice());
        }
        PointKind::ForTest { counter } => {
            walk.values(counter.as_slice());
            walk.targets(counter.as_slice());
        }
        PointKind::Switch { selector, values } => {
            walk.values(selector.as_slice());
            walk.values(values);
        }
        PointKind::Call(id) => walk.program_call(*id),
        PointKind::TaskCreate(arguments) => walk.task_create(arguments),
        PointKind::Assign { target, value } => {
            walk.value(*value);
            walk.target(*target);
        }
        PointKind::Print(id) | PointKind::Expr(id) => walk.value(*id),
        PointKind::Start | PointKind::End | PointKind::Return | PointKind::Empty | PointKind::Unknown => {}
    }
}

impl Walk<'_, '_> {
    fn add(&mut self, id: ExprId, kind: AccessKind) {
        if let Some(root) = self.effects.root(id) {
            self.found.push(Access { id, root, kind });
        }
    }

    fn values(&mut self, ids: &[ExprId]) {
        for id in ids {
            self.value(*id);
        }
    }

    fn targets(&mut self, ids: &[ExprId]) {
        for id in ids {
            self.target(*id);
        }
    }

    /// Adds an expression whose value is read.
    fn value(&mut self, id: ExprId) {
        match self.effects.body.expr(id) {
            Expr::Name(_) | Expr::Path { .. } | Expr::Index(..) | Expr::Field { .. } => {
                self.indexes(id);
                self.add(id, AccessKind::Read);
            }
            Expr::Paren(inner) | Expr::Unary(_, inner) => self.value(*inner),
            Expr::Binary(_, left, right) => self.values(&[*left, *right]),
            Expr::Assign(target, value) => {
                self.value(*value);
                self.target(*target);
            }
            Expr::Call(_, args) => self.instruction(id, args),
            Expr::Struct(values) => values.iter().flatten().for_each(|value| self.value(*value)),
            Expr::Missing | Expr::Number(_) | Expr::String(_) | Expr::Bool(_) => {}
        }
    }

    /// Adds an expression to which a value is assigned.
    fn target(&mut self, id: ExprId) {
        self.indexes(id);
        let whole = matches!(self.effects.body.expr(id), Expr::Name(_) | Expr::Path { .. });
        self.add(id, if whole { AccessKind::Write } else { AccessKind::WritePart });
    }

    /// Adds the indexes within a variable, and a base expression that is no variable.
    fn indexes(&mut self, id: ExprId) {
        match self.effects.body.expr(id) {
            Expr::Index(base, keys) => {
                self.indexes(*base);
                self.values(keys);
            }
            Expr::Field { base, .. } | Expr::Paren(base) => self.indexes(*base),
            Expr::Name(_) | Expr::Path { .. } => {}
            _ => self.value(id),
        }
    }

    fn instruction(&mut self, id: ExprId, args: &[ExprId]) {
        let Some((instruction, form)) = self.effects.instruction(id) else {
            // An unknown instruction may have any effect on its arguments.
            return args.iter().for_each(|arg| self.argument(*arg, Some(AccessKind::Reference)));
        };
        for (position, arg) in args.iter().enumerate() {
            self.argument(*arg, handed_over(instruction, form, position));
        }
    }

    /// Adds an argument; `kind` is the use of a variable that is passed by reference.
    fn argument(&mut self, arg: ExprId, kind: Option<AccessKind>) {
        match kind.and_then(|kind| Some((kind, self.effects.root(arg)?))) {
            Some((kind, root)) => {
                self.indexes(arg);
                self.found.push(Access { id: arg, root, kind });
            }
            None => self.value(arg),
        }
    }

    fn program_call(&mut self, call: ExprId) {
        let Expr::Call(callee, args) = self.effects.body.expr(call) else { return self.value(call) };
        let signature = self.effects.program(*callee);
        for (position, arg) in args.iter().enumerate() {
            self.argument(*arg, passing(signature, position));
        }
    }

    /// Adds the arguments of a task creation: name, priority or period with overrun flag, and the call.
    fn task_create(&mut self, arguments: &[ExprId]) {
        let Some((call, before)) = arguments.split_last() else { return };
        for argument in before {
            // The system writes the overrun flag.
            let is_flag = matches!(self.effects.inference.ty(*argument).base.builtin(), Some(BaseType::Bool));
            self.argument(*argument, is_flag.then_some(AccessKind::Reference));
        }
        self.program_call(*call);
    }
}

/// Returns the possible use of the argument at `position` by a called program; by reference if the program is unknown.
fn passing(signature: Option<&Signature>, position: usize) -> Option<AccessKind> {
    let by_reference = match signature {
        Some(signature) => signature.params.get(position).is_some_and(|param| param.by_reference),
        None => true,
    };
    by_reference.then_some(AccessKind::Reference)
}
