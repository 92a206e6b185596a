//! Program calls, and creation of tasks (5.10).

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::db::{File, Project};
use val3_analysis::items::project::{items, signature};
use val3_bytecode::{CallSite, ProgramRef, TaskSite};

use crate::error::{CompileLimit, Result};
use crate::expressions::arguments::{Boxed, Formal};
use crate::statements::Statements;

impl Statements<'_, '_> {
    /// Compiles `call program(…)`.
    pub(crate) fn call_stmt(&mut self, call: ExprId) -> Result<()> {
        let mut boxes = Vec::new();
        let site = self.call_site(call, &mut boxes)?;
        self.out().code().call(site);
        self.values.unbox(&boxes)
    }

    /// Compiles the called program and its arguments.
    pub(crate) fn call_site(&mut self, call: ExprId, boxes: &mut Vec<Boxed>) -> Result<CallSite> {
        let Expr::Call(callee, args) = self.values.body().expr(call) else { return Err(CompileLimit::Unclear) };
        let (program, project, file) = self.called_program(*callee)?;
        let params = &signature(self.values.unit().db, project, file).params;
        params.iter().try_for_each(|param| self.out().kind(param.base).map(drop))?;
        let formals: Vec<Formal> = params.iter().map(Formal::of).collect();
        let arguments = self.values.arguments(&formals, args, boxes)?;
        if arguments.len() != params.len() {
            return Err(CompileLimit::Unclear);
        }
        Ok(CallSite { program, arguments, passes: None })
    }

    fn called_program(&mut self, callee: ExprId) -> Result<(ProgramRef, Project, File)> {
        match self.values.body().expr(callee) {
            Expr::Name(name) => {
                let file = *self.values.unit().items.programs.get(name).ok_or(CompileLimit::Unclear)?;
                Ok((ProgramRef::Own(self.values.unit().program(name)?), self.values.unit().project, file))
            }
            Expr::Path { library, item } => {
                let interface = self.values.unit().interface(library)?;
                let file = *items(self.values.unit().db, interface).programs.get(item).ok_or(CompileLimit::Unclear)?;
                let number = self.out().unit_mut().import_program(library, item, interface, file)?;
                Ok((ProgramRef::Import(number), interface, file))
            }
            _ => Err(CompileLimit::Unclear),
        }
    }

    /// Compiles `taskCreate name, priority, program(…)` or `taskCreateSync name, period, overrun, program(…)`.
    pub(crate) fn task_create(&mut self, synchronous: bool, arguments: &[ExprId]) -> Result<()> {
        let (name, rate, overrun, call) = match (synchronous, arguments) {
            (false, &[name, rate, call]) => (name, rate, None, call),
            (true, &[name, rate, overrun, call]) => (name, rate, Some(overrun), call),
            _ => return Err(CompileLimit::Unclear),
        };
        let (name, rate) = (self.values.text(name)?, self.values.num(rate)?);
        let overrun = match overrun {
            Some(id) => {
                let variable = self.values.variable(id)?.ok_or(CompileLimit::Unclear)?;
                Some(self.out().operand(variable.location)?)
            }
            None => None,
        };
        // The task outlives the line, so boxed arguments are not assigned back.
        let call = self.call_site(call, &mut Vec::new())?;
        self.out().code().task(TaskSite { name, rate, overrun, call });
        Ok(())
    }
}
