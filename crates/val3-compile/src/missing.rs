//! Lines that use what is missing: a library whose interface is not there, an instruction of an add-on, a user type.
//! The application starts all the same, and such a line stops its task when it is reached.

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::items::project::items;
use val3_analysis::ty::Base;
use val3_bytecode::{Callee, InstructionSite};

use crate::coder::Coder;
use crate::error::{Limit, Result};

impl Coder<'_, '_> {
    /// Compiles a line that uses these expressions. If something is missing, the line stops its task instead, and the
    /// result is `None`.
    pub(crate) fn or_stop<T>(
        &mut self,
        ids: &[ExprId],
        compile: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<Option<T>> {
        let (code, frame) = (self.code.mark(), self.frame.mark());
        self.is_pure = ids.iter().all(|id| self.is_pure(*id));
        match compile(self) {
            Err(Limit::Unclear) => {
                self.code.take_back(code);
                self.frame.release(frame);
                let missing = ids.iter().find_map(|id| self.missing(*id));
                self.code.instruction(missing.unwrap_or_else(unknown_meaning));
                Ok(None)
            }
            done => done.map(Some),
        }
    }

    /// The callee and the arguments of the call of a program.
    pub(crate) fn call_parts(&self, call: ExprId) -> Vec<ExprId> {
        match self.body.expr(call) {
            Expr::Call(callee, args) => std::iter::once(*callee).chain(args.iter().copied()).collect(),
            _ => Vec::new(),
        }
    }

    /// The instruction that stops a line with this expression, for the first of its parts that is missing.
    fn missing(&self, id: ExprId) -> Option<InstructionSite> {
        let calls = || self.body.within(id).filter_map(|id| self.callee(id));
        self.body.within(id).find_map(|id| match self.body.expr(id) {
            Expr::Path { library, item } if !self.has_item(library, item) && calls().all(|callee| callee != id) => {
                Some(InstructionSite::new(Callee::MissingItem(format!("{library}:{item}"))))
            }
            Expr::Call(callee, _) if !self.is_known_call(id) => self.lacking(self.called_name(*callee)?),
            Expr::Name(name) if self.base(id) == Base::Unknown => self.lacking(self.type_name(name)?),
            Expr::Field { field, .. } if self.base(id) == Base::Unknown => self.lacking(field),
            _ => None,
        })
    }

    fn lacking(&self, name: &str) -> Option<InstructionSite> {
        Some(InstructionSite::new(Callee::Lacking(name.to_owned())))
    }

    fn callee(&self, call: ExprId) -> Option<ExprId> {
        match self.body.expr(call) {
            Expr::Call(callee, _) => Some(*callee),
            _ => None,
        }
    }

    fn called_name(&self, callee: ExprId) -> Option<&str> {
        match self.body.expr(callee) {
            Expr::Name(name) | Expr::Path { item: name, .. } => Some(name),
            _ => None,
        }
    }

    fn is_known_call(&self, call: ExprId) -> bool {
        self.types.call(call).is_some() || self.types.add_on_call(call).is_some()
    }

    /// Whether the interface of a library identifier exists and has this item.
    pub(crate) fn has_item(&self, library: &str, item: &str) -> bool {
        self.unit.interface(library).is_ok_and(|interface| {
            let items = items(self.unit.db, interface);
            items.data.contains_key(item) || items.programs.contains_key(item)
        })
    }

    /// The declared type of a variable.
    fn type_name(&self, variable: &str) -> Option<&str> {
        let param = self.header.params.iter().find(|param| param.name == variable).map(|param| &param.type_name);
        let local = || self.header.locals.iter().find(|local| local.name == variable).map(|local| &local.type_name);
        let data = || self.unit.items.data.get(variable).map(|data| &data.decl.type_name);
        param.or_else(local).or_else(data).map(|name| name.as_str())
    }
}

/// The instruction for a line that the analysis has accepted although the compiler does not know its meaning.
fn unknown_meaning() -> InstructionSite {
    InstructionSite::new(Callee::Invalid)
}
