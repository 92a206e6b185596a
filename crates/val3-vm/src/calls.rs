//! Programs that call others and return to them (2.6).

use std::sync::Arc;

use val3_bytecode::{CallSite, Image, Pass, Program, ProgramRef};
use val3_lang::fault::{Fault, Result};

use crate::arguments::place;
use crate::enter::{behind, enter, enter_plain, get, leave, pass, write};
use crate::instance::Imported;
use crate::machine::Machine;
use crate::task::{Base, Thread};
use crate::{Frame, InstanceId};

impl Machine<'_> {
    /// Calls a program, which returns to the step and line at `back`.
    #[inline]
    pub(crate) fn call(
        &mut self,
        thread: &mut Thread,
        image: &Image,
        (frame, caller): (&Frame, &Program),
        site: &CallSite,
        (back, back_line): (usize, u32),
    ) -> Result<()> {
        let (instance, program) = self.resolve(frame.instance, site.program)?;
        let base = behind(&frame.base, caller);
        if instance == frame.instance {
            let callee = image.programs.get(usize::from(program)).ok_or(Fault::INTERPRETER)?;
            match &site.passes {
                Some(passes) => self.open_plain(callee, &base, frame, passes)?,
                None => self.open(callee, &base, frame, site)?,
            }
        } else {
            self.open_other((instance, program), &base, frame, site)?;
        }
        let back = u32::try_from(back).unwrap_or(u32::MAX);
        thread.frames.push(Frame { instance, program, back, back_line, base });
        Ok(())
    }

    /// Makes the frame of a plain program, and passes its arguments.
    #[inline]
    fn open_plain(&mut self, callee: &Program, base: &Base, caller: &Frame, passes: &[Pass]) -> Result<()> {
        let memory = &mut self.space.memory;
        enter_plain(memory, callee, base, self.stack_size)?;
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

    /// Makes the frame of a program of a library.
    fn open_other(&mut self, program: (InstanceId, u16), base: &Base, caller: &Frame, site: &CallSite) -> Result<()> {
        let image = Arc::clone(&self.instance(program.0)?.image);
        let callee = image.programs.get(usize::from(program.1)).ok_or(Fault::INTERPRETER)?;
        self.open(callee, base, caller, site)
    }

    /// Makes the frame of a program at `base`, and passes its arguments.
    fn open(&mut self, callee: &Program, base: &Base, caller: &Frame, site: &CallSite) -> Result<()> {
        enter(&mut self.space.memory, callee, base, self.stack_size)?;
        let mut arguments = callee.params.iter().zip(&site.arguments);
        let passed = arguments.try_for_each(|(param, argument)| {
            let given = self.scope(caller)?.given(argument)?;
            pass(&mut self.space.memory, base, param, given)
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
}

/// The program of a frame, which is one of this image.
pub(crate) fn program_of<'i>(frame: &Frame, image: &'i Image) -> Result<&'i Program> {
    image.programs.get(usize::from(frame.program)).ok_or(Fault::INTERPRETER)
}
