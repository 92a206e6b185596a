//! Evaluation of a statement's expressions: their order, their number of evaluations, and their use as values.

use val3_analysis::body::{Body, Expr, ExprId, Stmt, StmtKind};
use val3_analysis::effects::Effects;
use val3_analysis::infer::Inference;
use val3_lang::instruction::{ArgumentForm, Overload};
use val3_lang::instructions::{WAIT, WATCH};
use val3_lang::operators::BinaryOp;
use val3_lang::types::BaseType;

use super::context::Context;
use crate::RefactoringError;

/// Whether the statement is a loop.
pub(super) fn is_loop(stmt: &Stmt) -> bool {
    matches!(stmt.kind, StmtKind::While { .. } | StmtKind::Do { .. } | StmtKind::For { .. })
}

/// Expressions in a program.
pub(super) struct Evaluation<'db> {
    pub(super) body: &'db Body,
    pub(super) effects: Effects<'db>,
    pub(super) inference: &'db Inference,
    /// Parent expressions, by expression index.
    parents: Vec<Option<ExprId>>,
}

impl<'db> Evaluation<'db> {
    pub(super) fn new(context: &Context<'db>) -> Self {
        let body = context.body();
        let mut parents = vec![None; body.len()];
        for (parent, expr, _) in body.exprs() {
            for part in parts(expr) {
                parents.get_mut(part.index()).into_iter().for_each(|slot| *slot = Some(parent));
            }
        }
        let effects = Effects::new(context.db, context.project, context.file);
        Self { body, effects, inference: context.inference(), parents }
    }

    /// Parent of the expression `id`.
    pub(super) fn parent(&self, id: ExprId) -> Option<ExprId> {
        *self.parents.get(id.index())?
    }

    /// `id` and all its ancestors.
    fn ancestors(&self, id: ExprId) -> impl Iterator<Item = ExprId> {
        std::iter::successors(Some(id), |id| self.parent(*id))
    }

    /// Block and index of the statement that evaluates `id`.
    pub(super) fn stmt(&self, id: ExprId) -> Option<(&'db [Stmt], usize)> {
        let root = self.ancestors(id).last()?;
        let body: &'db Body = self.body;
        body.blocks().find_map(|block| Some((block, block.iter().position(|it| it.kind.exprs().contains(&root))?)))
    }

    /// Whether only the value of `id` is used, so that another expression with the same value can replace it.
    pub(super) fn is_value(&self, id: ExprId) -> bool {
        if let Some(parent) = self.parent(id)
            && matches!(self.body.expr(parent), Expr::Index(base, _) if *base == id)
        {
            return false;
        }
        let place = self.place(id);
        match self.parent(place) {
            Some(parent) => self.is_value_in(place, parent),
            None => self.stmt(place).and_then(|(block, at)| block.get(at)).is_some_and(|stmt| match &stmt.kind {
                StmtKind::Assign { target, .. } => *target != place,
                StmtKind::For { counter, .. } => *counter != Some(place),
                StmtKind::Expr(_) | StmtKind::Call(_) => false,
                // The system writes the overrun flag, and the last argument is a call.
                StmtKind::TaskCreate { arguments, .. } => {
                    self.inference.ty(place).base.builtin() != Some(BaseType::Bool) && arguments.last() != Some(&place)
                }
                _ => true,
            }),
        }
    }

    /// Longest variable expression, with fields and indexes, that starts with `id`.
    fn place(&self, id: ExprId) -> ExprId {
        let mut place = id;
        while let Some(parent) = self.parent(place) {
            let is_start = match self.body.expr(parent) {
                Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) => *base == place,
                _ => false,
            };
            if !is_start {
                break;
            }
            place = parent;
        }
        place
    }

    fn is_value_in(&self, id: ExprId, parent: ExprId) -> bool {
        match self.body.expr(parent) {
            Expr::Assign(target, _) => *target != id,
            Expr::Call(callee, arguments) => {
                let position = arguments.iter().position(|argument| *argument == id);
                position.is_some_and(|position| self.is_passed_by_value(parent, *callee, position))
            }
            _ => true,
        }
    }

    fn is_passed_by_value(&self, call: ExprId, callee: ExprId, position: usize) -> bool {
        if let Some(found) = self.inference.call(call) {
            return found
                .form
                .and_then(|form| form.params.get(position))
                .is_some_and(|it| it.shape == ArgumentForm::Value);
        }
        if let Some(found) = self.inference.add_on_call(call) {
            return found.form.params.get(position).is_some_and(|param| param.shape == ArgumentForm::Value);
        }
        let signature = self.effects.program(callee);
        signature.and_then(|signature| signature.params.get(position)).is_some_and(|param| !param.by_reference)
    }

    /// Whether `{…}` can replace the argument `id`: all forms with the same number of parameters expect the same type
    /// there.
    pub(super) fn takes_list(&self, id: ExprId) -> bool {
        let Some(call) = self.parent(id) else { return false };
        let Expr::Call(callee, arguments) = self.body.expr(call) else { return false };
        let Some(position) = arguments.iter().position(|argument| *argument == id) else { return false };
        let Some((instruction, form)) = self.effects.instruction(call) else {
            return self.effects.program(*callee).is_some();
        };
        let wanted = |form: &Overload| form.params.get(position).and_then(|param| param.ty);
        let mut forms = instruction.overloads.iter().filter(|form| form.params.len() == arguments.len());
        form.and_then(wanted).is_some_and(|ty| forms.all(|form| wanted(form) == Some(ty)))
    }

    /// Checks that `id` can be evaluated just before its statement, at the same time and equally often. The error is a
    /// reason for the user.
    pub(super) fn movable(&self, id: ExprId) -> Result<(), RefactoringError> {
        self.movable_as(id, id)
    }

    /// Like [`Self::movable`], for `value` in place of `id`.
    pub(super) fn movable_as(&self, id: ExprId, value: ExprId) -> Result<(), RefactoringError> {
        let (block, at) = self.stmt(id).ok_or_else(|| "No statement evaluates the expression".to_owned())?;
        let stmt = block.get(at).ok_or_else(|| "No statement evaluates the expression".to_owned())?;
        let chain: Vec<ExprId> = self.ancestors(id).collect();
        let root = chain.last().copied().unwrap_or(id);
        once(&stmt.kind, root)?;
        let mut earlier = earlier_roots(&stmt.kind, root);
        for pair in chain.windows(2) {
            let [part, whole] = pair else { continue };
            self.always(*part, *whole)?;
            let evaluated = evaluated(self.body.expr(*whole));
            earlier.extend(evaluated.into_iter().take_while(|other| other != part));
        }
        if self.body.constant(value).is_none() && earlier.iter().any(|other| self.conflict(value, *other)) {
            return Err("The statement evaluates something else first, and one of the two has an effect".into());
        }
        Ok(())
    }

    /// Whether the order in which the two expressions are evaluated matters.
    fn conflict(&self, value: ExprId, other: ExprId) -> bool {
        match self.has_effects(value) {
            true => self.body.constant(other).is_none(),
            false => self.has_effects(other),
        }
    }

    /// Checks that `whole` evaluates `part` exactly once.
    fn always(&self, part: ExprId, whole: ExprId) -> Result<(), RefactoringError> {
        match self.body.expr(whole) {
            Expr::Binary(op @ (BinaryOp::And | BinaryOp::Or), _, right) if *right == part => {
                Err(format!("The right side of `{}` is evaluated only if the left side does not decide", op.symbol())
                    .into())
            }
            Expr::Call(callee, _) => match self.body.expr(*callee) {
                Expr::Name(name) if [WAIT, WATCH].contains(&name.as_str()) && self.waits_for(whole, part) => {
                    Err(format!("`{name}` evaluates its condition again in every cycle").into())
                }
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }

    fn waits_for(&self, call: ExprId, part: ExprId) -> bool {
        matches!(self.body.expr(call), Expr::Call(_, arguments) if arguments.first() == Some(&part))
    }

    /// Whether the evaluation of `id` has side effects, or a second evaluation may yield another value.
    pub(super) fn has_effects(&self, id: ExprId) -> bool {
        self.body.within(id).any(|part| match self.body.expr(part) {
            Expr::Assign(..) | Expr::Missing => true,
            Expr::Call(..) => self
                .effects
                .instruction(part)
                .is_none_or(|(instruction, form)| form.is_none_or(|form| instruction.has_effects(form))),
            _ => self.inference.ty(part).base.builtin() == Some(BaseType::Sio),
        })
    }
}

/// Direct subexpressions, in the order of the text.
fn parts(expr: &Expr) -> Vec<ExprId> {
    match expr {
        Expr::Paren(inner) | Expr::Unary(_, inner) | Expr::Field { base: inner, .. } => vec![*inner],
        Expr::Binary(_, left, right) | Expr::Assign(left, right) => vec![*left, *right],
        Expr::Index(base, parts) | Expr::Call(base, parts) => std::iter::once(*base).chain(parts.to_vec()).collect(),
        Expr::Struct(parts) => parts.iter().flatten().copied().collect(),
        Expr::Missing | Expr::Number(_) | Expr::String(_) | Expr::Bool(_) | Expr::Name(_) | Expr::Path { .. } => {
            Vec::new()
        }
    }
}

/// Direct subexpressions, in evaluation order.
fn evaluated(expr: &Expr) -> Vec<ExprId> {
    match expr {
        Expr::Assign(target, value) => vec![*value, *target],
        Expr::Call(_, arguments) => arguments.to_vec(),
        _ => parts(expr),
    }
}

/// Checks that a statement evaluates its expression `root` exactly once, when it begins.
fn once(kind: &StmtKind, root: ExprId) -> Result<(), RefactoringError> {
    let reason = match kind {
        StmtKind::While { .. } => "The condition of `while` is evaluated before every pass",
        StmtKind::Do { .. } => "The condition of `until` is evaluated after every pass",
        StmtKind::For { .. } => "The manual does not define how often `for` evaluates its bounds",
        StmtKind::If { arms, .. } if arms.first().and_then(|(condition, _)| *condition) != Some(root) => {
            "The condition of `elseIf` is evaluated only if the conditions before it are false"
        }
        StmtKind::Switch { selector, .. } if *selector != Some(root) => {
            "The values of a `case` are compared only if the values before them differ"
        }
        _ => return Ok(()),
    };
    Err(reason.into())
}

/// Expressions of a statement that are evaluated before `root`.
fn earlier_roots(kind: &StmtKind, root: ExprId) -> Vec<ExprId> {
    let order = match kind {
        StmtKind::Assign { target, value } => vec![*value, *target],
        other => other.exprs(),
    };
    order.into_iter().take_while(|other| *other != root).collect()
}
