//! Calls of programs, and the creation of tasks.

use rowan::TextRange;
use smallvec::smallvec;
use smol_str::{SmolStr, format_smolstr};
use val3_lang::instructions;
use val3_lang::types::BaseType;

use super::Infer;
use super::arguments::Callee;
use super::fit::Formals;
use crate::body::{Expr, ExprId};
use crate::db::{Db, File, Project};
use crate::interfaces::is_left_out;
use crate::items::declarations;
use crate::items::project::{Signature, items, signature};
use crate::near::nearest;
use crate::problem::{NameKind, ProblemKind, Role};
use crate::ty::{Base, brackets};

impl Infer<'_> {
    /// `call program(…)`
    pub(super) fn call_stmt(&mut self, call: ExprId) {
        let Expr::Call(callee, args) = self.body.expr(call) else { return };
        let db = self.db;
        let program = self.program(*callee).map(|(project, file)| (signature(db, project, file), file));
        match program.filter(|(signature, _)| signature.complete) {
            Some((signature, file)) => {
                let callee = Callee {
                    name: self.text(*callee),
                    forms: smallvec![Formals::Program(&signature.params)],
                    lines: &|| vec![syntax_line(db, signature)],
                    declared: &|| declarations::program(db, file),
                };
                self.arguments(call, args, &callee);
            }
            None => self.arguments_alone(args),
        }
    }

    /// The program that is called; `None` where it is not known, which is reported.
    fn program(&mut self, callee: ExprId) -> Option<(Project, File)> {
        match self.body.expr(callee) {
            Expr::Name(name) => {
                if let Some(file) = self.items.programs.get(name) {
                    return Some((self.project, *file));
                }
                if self.items.may_have_program(name) {
                    return None;
                }
                let is = self.variable_kind(name).or_else(|| instructions::find(name).map(|_| NameKind::Instruction));
                let near = nearest(name, self.items.programs.keys().map(SmolStr::as_str));
                let near = if is.is_some() { None } else { near };
                self.report(callee, ProblemKind::UnknownProgram { name: name.clone(), near, is });
                None
            }
            Expr::Path { library, item } => self.library_program(callee, &library.clone(), &item.clone()),
            _ => None,
        }
    }

    fn library_program(&mut self, id: ExprId, library: &SmolStr, item: &SmolStr) -> Option<(Project, File)> {
        let interface = self.interface(id, library)?;
        let items = items(self.db, interface);
        let programs = &items.programs;
        match programs.get(item) {
            None if items.may_have_program(item) => None,
            None if is_left_out(self.db, interface, item, NameKind::Program) => None,
            Some(file) if signature(self.db, interface, *file).public => Some((interface, *file)),
            Some(file) => {
                let place = declarations::program(self.db, *file);
                let kind = self.private_item(library, item, NameKind::Program);
                self.report_with(id, kind, Role::Declared, place);
                None
            }
            None => {
                let near = nearest(item, programs.keys().map(SmolStr::as_str));
                let kind = ProblemKind::LibraryItemUnknown {
                    alias: library.clone(),
                    item: item.clone(),
                    what: NameKind::Program,
                    near,
                };
                let place = declarations::library(self.db, self.project, library.clone());
                self.report_with(id, kind, Role::Interface, place);
                None
            }
        }
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
        if !self.problems.iter().any(|problem| range.contains_range(problem.place.range)) {
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
            let (expected, found) = (vec![ty.name().into()], self.show(value.base));
            self.report(id, ProblemKind::ArgumentType { callee, parameter, expected, found });
        } else if ty == BaseType::Bool && !value.is_variable() {
            self.report(id, ProblemKind::VariableExpected { callee, parameter });
        }
    }
}

/// A program as a programmer writes its head: `pick(num x_nCount, string& x_sName[])`.
pub(crate) fn syntax_line(db: &dyn Db, signature: &Signature) -> SmolStr {
    let params: Vec<String> = signature
        .params
        .iter()
        .map(|param| {
            let reference = if param.by_reference { "&" } else { "" };
            format!("{}{reference} {}{}", param.base.display(db), param.name, brackets(param.container))
        })
        .collect();
    format_smolstr!("{}({})", signature.name, params.join(", "))
}
