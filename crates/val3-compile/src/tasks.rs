//! Creation of tasks (5.10).

use val3_analysis::body::ExprId;
use val3_bytecode::TaskSite;

use crate::coder::Coder;
use crate::error::{Limit, Result};

impl Coder<'_, '_> {
    /// `taskCreate name, priority, program(…)` and `taskCreateSync name, period, overrun, program(…)`
    pub(crate) fn task_create(&mut self, synchronous: bool, arguments: &[ExprId]) -> Result<()> {
        let (name, rate, overrun, call) = match (synchronous, arguments) {
            (false, &[name, rate, call]) => (name, rate, None, call),
            (true, &[name, rate, overrun, call]) => (name, rate, Some(overrun), call),
            _ => return Err(Limit::Unclear),
        };
        let (name, rate) = (self.text(name)?, self.num(rate)?);
        let overrun = match overrun {
            Some(id) => {
                let variable = self.variable(id)?.ok_or(Limit::Unclear)?;
                Some(self.operand(variable.location)?)
            }
            None => None,
        };
        // The task outlives the line, so its arguments are not copied back.
        let call = self.call_site(call, &mut Vec::new())?;
        self.code.task(TaskSite { name, rate, overrun, call });
        Ok(())
    }
}
