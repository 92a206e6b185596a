//! Calls of programs.

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::db::{File, Project};
use val3_analysis::items::project::{Param, items, signature};
use val3_bytecode::{CallSite, ProgramRef};
use val3_lang::instruction::Shape;
use val3_lang::types::Container;

use crate::arguments::{Boxed, Formal};
use crate::coder::Coder;
use crate::error::{Limit, Result};

impl Coder<'_, '_> {
    /// `call program(…)`
    pub(crate) fn call_stmt(&mut self, call: ExprId) -> Result<()> {
        let mut boxes = Vec::new();
        let site = self.call_site(call, &mut boxes)?;
        self.code.call(site);
        self.unbox(&boxes)
    }

    /// The program that is called, and its arguments.
    pub(crate) fn call_site(&mut self, call: ExprId, boxes: &mut Vec<Boxed>) -> Result<CallSite> {
        let Expr::Call(callee, args) = self.body.expr(call) else { return Err(Limit::Unclear) };
        let (program, project, file) = self.called_program(*callee)?;
        let params = &signature(self.unit.db, project, file).params;
        params.iter().try_for_each(|param| self.kind(param.base).map(drop))?;
        let formals: Vec<Formal> = params.iter().map(formal).collect();
        let arguments = self.arguments(&formals, args, boxes)?;
        if arguments.len() != params.len() {
            return Err(Limit::Unclear);
        }
        Ok(CallSite { program, arguments, passes: None })
    }

    fn called_program(&mut self, callee: ExprId) -> Result<(ProgramRef, Project, File)> {
        match self.body.expr(callee) {
            Expr::Name(name) => {
                let file = *self.unit.items.programs.get(name).ok_or(Limit::Unclear)?;
                Ok((ProgramRef::Own(self.unit.program(name)?), self.unit.project, file))
            }
            Expr::Path { library, item } => {
                let interface = self.unit.interface(library)?;
                let file = *items(self.unit.db, interface).programs.get(item).ok_or(Limit::Unclear)?;
                let number = self.unit.import_program(library, item, (interface, file))?;
                Ok((ProgramRef::Import(number), interface, file))
            }
            _ => Err(Limit::Unclear),
        }
    }
}

/// A parameter of a program. The old dialect does not distinguish elements by reference from arrays: all of them are
/// arrays.
pub(crate) fn formal(param: &Param) -> Formal {
    let shape = match param.container {
        Container::Element if param.by_reference => Shape::Reference,
        Container::Element => Shape::Value,
        Container::Array { dims } => Shape::Array { dims },
        Container::Collection => Shape::Collection,
    };
    Formal { base: Some(param.base), shape }
}
