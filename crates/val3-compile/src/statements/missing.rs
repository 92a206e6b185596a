//! Lines that use something unresolved: a library without an interface, an add-on instruction, a user type. The
//! application starts nevertheless, and such a line stops its task when it is reached.

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::items::program::Header;
use val3_analysis::ty::Base;
use val3_bytecode::{Callee, InstructionSite};

use crate::expressions::Expressions;
use crate::statements::Statements;

/// Finds unresolved parts of a line.
pub(crate) struct Missing<'a, 'u, 'db> {
    values: &'a Expressions<'u, 'db>,
    header: &'db Header,
}

impl<'a, 'u, 'db> Missing<'a, 'u, 'db> {
    pub(crate) fn new(statements: &'a Statements<'u, 'db>) -> Self {
        Self { values: &statements.values, header: statements.header }
    }

    /// Returns the instruction that stops the line, for the first unresolved part in an expression.
    pub(crate) fn of(&self, id: ExprId) -> Option<InstructionSite> {
        let calls = || self.values.body().within(id).filter_map(|id| self.callee(id));
        self.values.body().within(id).find_map(|id| match self.values.body().expr(id) {
            Expr::Path { library, item }
                if !self.values.unit().has_item(library, item) && calls().all(|callee| callee != id) =>
            {
                Some(InstructionSite::new(Callee::MissingItem(format!("{library}:{item}"))))
            }
            Expr::Call(callee, _) if !self.values.is_known_call(id) => self.lacking(self.called_name(*callee)?),
            Expr::Name(name) if self.values.base(id) == Base::Unknown => self.lacking(self.type_name(name)?),
            Expr::Field { field, .. } if self.values.base(id) == Base::Unknown => self.lacking(field),
            _ => None,
        })
    }

    fn lacking(&self, name: &str) -> Option<InstructionSite> {
        Some(InstructionSite::new(Callee::Lacking(name.to_owned())))
    }

    fn callee(&self, call: ExprId) -> Option<ExprId> {
        match self.values.body().expr(call) {
            Expr::Call(callee, _) => Some(*callee),
            _ => None,
        }
    }

    fn called_name(&self, callee: ExprId) -> Option<&str> {
        match self.values.body().expr(callee) {
            Expr::Name(name) | Expr::Path { item: name, .. } => Some(name),
            _ => None,
        }
    }

    /// Returns the declared type of a variable.
    fn type_name(&self, variable: &str) -> Option<&str> {
        let param = self.header.params.iter().find(|param| param.name == variable).map(|param| &param.type_name);
        let local = || self.header.locals.iter().find(|local| local.name == variable).map(|local| &local.type_name);
        let data = || self.values.unit().items.data.get(variable).map(|data| &data.decl.type_name);
        param.or_else(local).or_else(data).map(|name| name.as_str())
    }
}

/// Returns the instruction for a line that the analysis has accepted without resolving it.
pub(crate) fn unknown_meaning() -> InstructionSite {
    InstructionSite::new(Callee::Invalid)
}
