//! Inference of program calls and task creation.

use rowan::TextRange;
use smallvec::smallvec;
use smol_str::SmolStr;
use val3_lang::types::BaseType;

use super::Infer;
use super::arguments::Callee;
use super::fit::Formals;
use crate::body::{Expr, ExprId};
use crate::db::{File, Project};
use crate::items::declarations;
use crate::items::project::signature;
use crate::problem::ProblemKind;
use crate::ty::Base;

impl Infer<'_> {
    /// `call program(…)`
    pub(super) fn call_stmt(&mut self, call: ExprId) {
        let Expr::Call(callee, args) = self.body.expr(call) else { return };
        let db = self.scope.db();
        let program = self.program(*callee).map(|(project, file)| (signature(db, project, file), file));
        match program.filter(|(signature, _)| signature.complete) {
            Some((signature, file)) => {
                let callee = Callee {
                    name: self.text(*callee),
                    forms: smallvec![Formals::Program(&signature.params)],
                    lines: &|| vec![signature.syntax_line(db)],
                    declared: &|| declarations::program(db, file),
                    may_have_others: false,
                };
                self.arguments(call, args, &callee);
            }
            None => self.arguments_alone(args),
        }
    }

    /// Returns the called program; reports an unresolved name and returns `None`.
    fn program(&mut self, callee: ExprId) -> Option<(Project, File)> {
        let found = match self.body.expr(callee) {
            Expr::Name(name) => self.scope.program(name),
            Expr::Path { library, item } => self.scope.library_program(library, item),
            _ => return None,
        };
        self.resolved(callee, found)
    }

    /// `taskCreate name, priority, program(…)` and `taskCreateSync name, period, overrun, program(…)` (5.10).
    pub(super) fn task_create(&mut self, range: TextRange, synchronous: bool, arguments: &[ExprId]) {
        let (name, wanted): (_, &[_]) = if synchronous {
            ("taskCreateSync", &[("sName", BaseType::String), ("nPeriod", BaseType::Num), ("bOverrun", BaseType::Bool)])
        } else {
            ("taskCreate", &[("sName", BaseType::String), ("nPriority", BaseType::Num)])
        };
        for (&id, &(parameter, ty)) in arguments.iter().zip(wanted) {
            self.task_argument(name, id, parameter, ty);
        }
        let Some(&call) = arguments.get(wanted.len()) else { return };
        if matches!(self.body.expr(call), Expr::Call(..)) {
            return self.call_stmt(call);
        }
        self.expr_as(call, Some(Base::Unknown));
        if !self.sink.has_any_in(range) {
            let expected = vec![SmolStr::new_static("program(…)")];
            let found = SmolStr::new_static("value");
            let kind = ProblemKind::ArgumentType { callee: name.into(), parameter: "program".into(), expected, found };
            self.report(call, kind);
        }
    }

    fn task_argument(&mut self, callee: &'static str, id: ExprId, parameter: &'static str, ty: BaseType) {
        let value = self.expr_as(id, Some(Base::of(ty)));
        let (callee, parameter) = (SmolStr::new_static(callee), SmolStr::new_static(parameter));
        if value.lacks_index() {
            self.index_missing(id, &value);
        } else if !value.base.same_as(Base::of(ty)) {
            let (expected, found) = (vec![ty.name().into()], self.scope.show(value.base));
            self.report(id, ProblemKind::ArgumentType { callee, parameter, expected, found });
        } else if ty == BaseType::Bool && !value.is_variable() {
            self.report(id, ProblemKind::VariableExpected { callee, parameter });
        }
    }
}
