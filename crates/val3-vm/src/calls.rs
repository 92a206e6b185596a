//! Program calls and returns (2.6).

use val3_bytecode::{CallSite, Pass, Program, ProgramRef};
use val3_lang::fault::{Fault, Result};

use crate::enter::{enter, enter_plain, get, leave, pass, write};
use crate::operands::OperandContext;
use crate::task::Base;
use crate::turn_context::TurnContext;
use crate::{Frame, Instance, InstanceId, ProgramId};

impl TurnContext<'_> {
    /// Creates the stack frame of a called program, with its arguments. The program returns to the operation `back`
    /// on the line `back_line`.
    ///
    /// The frame is built in processor registers: writing it to memory and reading it again costs more than the rest of
    /// a call.
    #[inline(always)]
    pub(crate) fn call(
        &mut self,
        frame: &Frame,
        scope: &OperandContext<'_>,
        site: &CallSite,
        back: usize,
        back_line: u32,
    ) -> Result<Frame> {
        let base = frame.base.after(scope.program);
        let program = match (site.program, &site.passes) {
            (ProgramRef::Own(number), Some(passes)) => {
                let callee = scope.instance.image.programs.get(usize::from(number)).ok_or(Fault::INTERPRETER)?;
                self.open_plain(callee, &base, scope, passes)?;
                ProgramId { instance: frame.instance, number }
            }
            _ => self.open_any(base, frame.instance, scope, site)?,
        };
        #[allow(clippy::cast_possible_truncation, reason = "the compiler refuses programs of more operations")]
        Ok(Frame { base, back: back as u32, back_line, instance: program.instance, program: program.number })
    }

    /// Creates the frame of a plain program, and passes the arguments.
    #[inline(always)]
    fn open_plain(
        &mut self,
        callee: &Program,
        base: &Base,
        caller: &OperandContext<'_>,
        passes: &[Pass],
    ) -> Result<()> {
        let memory = &mut self.space.memory;
        enter_plain(memory, callee, base, self.stack_size)?;
        for pass in passes {
            match *pass {
                Pass::Number(from, to) => {
                    let value = get(&memory.stack.nums, caller.base.num + u32::from(from))?;
                    write(&mut memory.stack.nums, base.num + u32::from(to), value)?;
                }
                Pass::Text(from, to) => {
                    let text = *caller.text(memory, from)?;
                    write(&mut memory.stack.texts, base.text + u32::from(to), text)?;
                }
                Pass::Reference(from, to) => {
                    let from = caller.place(memory, from)?;
                    write(&mut memory.stack.places, base.place + u32::from(to), from)?;
                }
                Pass::Container(container, start, to) => {
                    let view = caller.view_from(memory, container, start)?;
                    write(&mut memory.stack.views, base.view + u32::from(to), view)?;
                }
            }
        }
        Ok(())
    }

    /// Creates the frame of any program at `base`, and passes the arguments.
    #[inline(never)]
    fn open_any(
        &mut self,
        base: Base,
        from: InstanceId,
        caller: &OperandContext<'_>,
        site: &CallSite,
    ) -> Result<ProgramId> {
        let called = self.space.called(from, site.program).ok_or(Fault::LIBRARY_ITEM_MISSING)?;
        let instance = self.space.instances.get(usize::from(called.instance.0)).ok_or(Fault::INTERPRETER)?;
        let callee = instance.image.programs.get(usize::from(called.number)).ok_or(Fault::INTERPRETER)?;
        let memory = &mut self.space.memory;
        enter(memory, callee, &base, self.stack_size)?;
        let mut arguments = callee.params.iter().zip(&site.arguments);
        let passed = arguments.try_for_each(|(param, argument)| {
            let argument = caller.argument(memory, argument)?;
            pass(memory, &base, param, argument)
        });
        passed.inspect_err(|_| leave(memory, &base))?;
        Ok(called)
    }
}

/// Returns the program of a frame, which belongs to this application or library.
pub(crate) fn program_of<'i>(frame: &Frame, instance: &'i Instance) -> Result<&'i Program> {
    let found = instance.image.programs.get(usize::from(frame.program));
    found.map_or_else(|| instance.fragment(frame.program), Ok)
}
