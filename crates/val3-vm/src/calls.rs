//! Programs that call others and return to them (2.6).

use std::sync::Arc;

use val3_bytecode::{CallSite, Image, Pass, Program, ProgramRef};
use val3_lang::fault::{Fault, Result};

use crate::arguments::place;
use crate::enter::{enter, enter_plain, get, leave, pass, write};
use crate::instance::Imported;
use crate::task::Base;
use crate::turn_context::TurnContext;
use crate::{Frame, InstanceId};

impl TurnContext<'_> {
    /// The frame of a program that is called, with its arguments; it returns to the step and line at `back`.
    ///
    /// The frame is made in registers: one that is written and read again at once costs more than all of the rest.
    #[inline(always)]
    pub(crate) fn call(
        &mut self,
        image: &Image,
        (frame, caller): (&Frame, &Program),
        site: &CallSite,
        (back, back_line): (usize, u32),
    ) -> Result<Frame> {
        let base = frame.base.behind(caller);
        let (instance, program) = match (site.program, &site.passes) {
            (ProgramRef::Own(number), Some(passes)) => {
                let callee = image.programs.get(usize::from(number)).ok_or(Fault::INTERPRETER)?;
                self.open_plain(callee, base, frame, passes)?;
                (frame.instance, number)
            }
            _ => self.open_any(base, frame, site)?,
        };
        #[allow(clippy::cast_possible_truncation, reason = "the compiler refuses programs of more steps")]
        Ok(Frame { base, back: back as u32, back_line, instance, program })
    }

    /// Makes the frame of a plain program, and passes its arguments.
    #[inline(always)]
    fn open_plain(&mut self, callee: &Program, base: Base, caller: &Frame, passes: &[Pass]) -> Result<()> {
        let memory = &mut self.space.memory;
        enter_plain(memory, callee, &base, self.stack_size)?;
        for pass in passes {
            match *pass {
                Pass::Number(from, to) => {
                    let value = get(&memory.stack.nums, caller.base.num + u32::from(from))?;
                    write(&mut memory.stack.nums, base.num + u32::from(to), value)?;
                }
                Pass::Reference(from, to) => {
                    let from = place(memory, &caller.base, from)?;
                    write(&mut memory.stack.places, base.place + to, from)?;
                }
            }
        }
        Ok(())
    }

    /// Makes the frame of any program at `base`, and passes its arguments.
    #[inline(never)]
    fn open_any(&mut self, base: Base, caller: &Frame, site: &CallSite) -> Result<(InstanceId, u16)> {
        let (instance, number) = self.resolve(caller.instance, site.program)?;
        let image = Arc::clone(&self.instance(instance)?.image);
        let callee = image.programs.get(usize::from(number)).ok_or(Fault::INTERPRETER)?;
        enter(&mut self.space.memory, callee, &base, self.stack_size)?;
        let mut arguments = callee.params.iter().zip(&site.arguments);
        let passed = arguments.try_for_each(|(param, argument)| {
            let given = self.scope(caller)?.given(argument)?;
            pass(&mut self.space.memory, &base, param, given)
        });
        passed.inspect_err(|_| leave(&mut self.space.memory, &base))?;
        Ok((instance, number))
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
}

/// The program of a frame, which is one of this image.
pub(crate) fn program_of<'i>(frame: &Frame, image: &'i Image) -> Result<&'i Program> {
    image.programs.get(usize::from(frame.program)).ok_or(Fault::INTERPRETER)
}
