//! Creation and removal of stack frames (2.6).

use val3_bytecode::{Program, ProgramParam, Storage};
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{LinkPlace, Memory, MemoryBudget, Place, StoreId, View, bytes_of};
use val3_lang::values::Text;

use crate::operands::on_frame;
use crate::registers::FIXED_REGISTERS;
use crate::task::Base;

/// Creates the frame of `program` at `base`, whose arguments are [passed](pass) afterwards. After an error nothing of
/// the frame remains.
pub(crate) fn enter(memory: &mut Memory, program: &Program, base: &Base, most: u32) -> Result<()> {
    enter_plain(memory, program, base, most)?;
    let (end, stack, room) = (base.after(program), &mut memory.stack, &mut memory.stores.room);
    fill(&mut stack.links, room, base.link, end.link, LinkPlace::None)?;
    if let Some(links) = stack.links.get_mut(base.link as usize..end.link as usize) {
        links.fill(LinkPlace::None);
    }
    for part in &program.parts {
        let store = memory.create_local(part).inspect_err(|_| leave(memory, base))?;
        memory.stack.parts.push(store);
    }
    Ok(())
}

/// Creates the frame of `program` at `base` with its arguments. After an error nothing of the frame remains.
pub(crate) fn enter_with(
    memory: &mut Memory,
    program: &Program,
    base: &Base,
    most: u32,
    arguments: &[Argument],
) -> Result<()> {
    enter(memory, program, base, most)?;
    let mut given = program.params.iter().zip(arguments);
    given.try_for_each(|(param, argument)| pass(memory, base, param, *argument)).inspect_err(|_| leave(memory, base))
}

/// Like [`enter`], for a program whose frame contains neither links nor containers.
///
/// The stack has at least [`FIXED_REGISTERS`] numbers after each base.
#[inline(always)]
pub(crate) fn enter_plain(memory: &mut Memory, program: &Program, base: &Base, most: u32) -> Result<()> {
    if base.bytes.saturating_add(program.stack_bytes) > most {
        return Err(Fault::STACK_FULL);
    }
    let (stack, room) = (&mut memory.stack, &mut memory.stores.room);
    let lanes = program.frame.lanes.num.max(FIXED_REGISTERS);
    fill(&mut stack.nums, room, base.num, base.num + lanes, 0.0)?;
    let size = &program.frame;
    fill(&mut stack.places, room, base.place, base.place + size.places, Place::first(StoreId::STACK))?;
    fill(&mut stack.views, room, base.view, base.view + size.views, View::whole(StoreId::STACK))?;
    if size.lanes.text > 0 {
        open_texts(memory, base.text, size.lanes.text)?;
    }
    let stack = &mut memory.stack;
    let template = base.num as usize..base.num as usize + program.nums.len();
    stack.nums.get_mut(template).ok_or(Fault::INTERPRETER)?.copy_from_slice(&program.nums);
    Ok(())
}

/// Reserves the strings of a frame, and clears them.
fn open_texts(memory: &mut Memory, start: u32, count: u32) -> Result<()> {
    let end = start + count;
    fill(&mut memory.stack.texts, &mut memory.stores.room, start, end, Text::new())?;
    memory.stack.texts.get_mut(start as usize..end as usize).unwrap_or_default().iter_mut().for_each(Text::clear);
    Ok(())
}

/// Removes the links and containers of the frame at `base`.
#[inline]
pub(crate) fn leave(memory: &mut Memory, base: &Base) {
    memory.cut_links(base.link);
    while memory.stack.parts.len() > base.part as usize {
        if let Some(part) = memory.stack.parts.pop() {
            memory.remove(part);
        }
    }
}

/// Passes an argument to a parameter of the frame at `base`.
#[inline]
pub(crate) fn pass(memory: &mut Memory, base: &Base, param: &ProgramParam, argument: Argument) -> Result<()> {
    let from = match argument {
        Argument::Value(place, _) | Argument::UserValue(place) => place,
        Argument::View(view) => match param.storage {
            Storage::View(number) => return write(&mut memory.stack.views, base.view + u32::from(number), view),
            _ => memory.element(view, 0)?,
        },
        Argument::Slot(_) | Argument::Library(_) => return Err(Fault::INTERPRETER),
    };
    match param.storage {
        Storage::Value(lanes) => memory.copy(&param.kind, from, on_frame(base, lanes)),
        Storage::Part(number) => {
            let at = base.part as usize + usize::from(number);
            let part = memory.stack.parts.get(at).copied().ok_or(Fault::INTERPRETER)?;
            memory.copy(&param.kind, from, Place::first(part))
        }
        Storage::Place(number) => write(&mut memory.stack.places, base.place + u32::from(number), from),
        Storage::View(_) => Err(Fault::INTERPRETER),
    }
}

#[inline]
pub(crate) fn get(nums: &[f64], at: u32) -> Result<f64> {
    nums.get(at as usize).copied().ok_or(Fault::INTERPRETER)
}

#[inline]
pub(crate) fn write<T>(lanes: &mut [T], at: u32, value: T) -> Result<()> {
    *lanes.get_mut(at as usize).ok_or(Fault::INTERPRETER)? = value;
    Ok(())
}

/// Extends the lanes to `end`. They may contain values of earlier frames.
#[inline(always)]
fn fill<T: Copy>(lanes: &mut Vec<T>, room: &mut MemoryBudget, start: u32, end: u32, value: T) -> Result<()> {
    if end > start && lanes.len() < end as usize { grow(lanes, room, end, value) } else { Ok(()) }
}

#[cold]
fn grow<T: Copy>(lanes: &mut Vec<T>, room: &mut MemoryBudget, end: u32, value: T) -> Result<()> {
    room.take(bytes_of::<T>((end as usize).saturating_sub(lanes.len())))?;
    lanes.resize(end as usize, value);
    Ok(())
}
