//! Programs that call others and return to them (2.6).

use std::sync::Arc;

use val3_bytecode::{ArgumentSite, CallSite, Image, Operand, Passing, Program, ProgramRef};
use val3_lang::fault::{Fault, Result};
use val3_lang::types::BaseType;

use crate::arguments::{Given, place};
use crate::enter::{behind, enter, leave, pass, pass_number};
use crate::instance::Imported;
use crate::machine::Machine;
use crate::task::{Base, Thread};
use crate::{Frame, InstanceId};

/// The innermost program of a task with its frame, where it is one of the same application.
type Innermost<'i> = Option<(Frame, &'i Program)>;

impl Machine<'_> {
    /// Calls a program, which returns to the step and line at `back`.
    #[inline]
    pub(crate) fn call<'i>(
        &mut self,
        thread: &mut Thread,
        image: &'i Image,
        caller: (&Frame, &Program),
        site: &CallSite,
        (back, back_line): (usize, u32),
    ) -> Result<Innermost<'i>> {
        let (instance, program) = self.resolve(caller.0.instance, site.program)?;
        let base = behind(&caller.0.base, caller.1);
        let own = instance == caller.0.instance;
        let callee = if own { image.programs.get(usize::from(program)) } else { None };
        match callee {
            Some(callee) => self.open(callee, &base, caller.0, site)?,
            None => self.open_other((instance, program), &base, caller.0, site)?,
        }
        let back = u32::try_from(back).unwrap_or(u32::MAX);
        let frame = Frame { instance, program, back, back_line, base };
        thread.frames.push(frame);
        Ok(callee.map(|callee| (frame, callee)))
    }

    /// Makes the frame of a program of a library.
    fn open_other(&mut self, program: (InstanceId, u16), base: &Base, caller: &Frame, site: &CallSite) -> Result<()> {
        let image = Arc::clone(&self.instance(program.0)?.image);
        let callee = image.programs.get(usize::from(program.1)).ok_or(Fault::INTERPRETER)?;
        self.open(callee, base, caller, site)
    }

    /// Makes the frame of a program at `base`, and passes its arguments.
    #[inline]
    fn open(&mut self, callee: &Program, base: &Base, caller: &Frame, site: &CallSite) -> Result<()> {
        enter(&mut self.space.memory, callee, base, self.stack_size)?;
        let mut arguments = callee.params.iter().zip(&site.arguments);
        let passed = arguments.try_for_each(|(param, argument)| match (param.passing, *argument) {
            (Passing::Value(BaseType::Num | BaseType::Bool, to), ArgumentSite::Value(Operand::Frame(from), _)) => {
                pass_number(&mut self.space.memory.stack.nums, caller.base.num + from.num, base.num + to.num)
            }
            (_, ArgumentSite::Value(operand, _)) => {
                let from = place(&self.space.memory, &caller.base, operand)?;
                pass(&mut self.space.memory, base, param, Given::Value(from))
            }
            _ => {
                let given = self.scope(caller)?.given(argument)?;
                pass(&mut self.space.memory, base, param, given)
            }
        });
        passed.inspect_err(|_| leave(&mut self.space.memory, base))
    }

    pub(crate) fn resolve(&self, from: InstanceId, program: ProgramRef) -> Result<(InstanceId, u16)> {
        match program {
            ProgramRef::Own(number) => Ok((from, number)),
            ProgramRef::Import(number) => match self.instance(from)?.imports.get(usize::from(number)) {
                Some(Some(Imported::Program(instance, number))) => Ok((*instance, *number)),
                _ => Err(Fault::LIBRARY_ITEM_MISSING),
            },
        }
    }

    /// Ends the innermost program, which has this frame.
    #[inline]
    pub(crate) fn end_program<'i>(
        &mut self,
        thread: &mut Thread,
        image: &'i Image,
        frame: &Frame,
    ) -> Result<Innermost<'i>> {
        leave(&mut self.space.memory, &frame.base);
        thread.frames.pop();
        match thread.frames.last() {
            Some(caller) if caller.instance == frame.instance => Ok(Some((*caller, program_of(caller, image)?))),
            _ => Ok(None),
        }
    }
}

/// The program of a frame, which is one of this image.
pub(crate) fn program_of<'i>(frame: &Frame, image: &'i Image) -> Result<&'i Program> {
    image.programs.get(usize::from(frame.program)).ok_or(Fault::INTERPRETER)
}
