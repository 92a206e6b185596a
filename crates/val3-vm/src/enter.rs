//! Programs that begin and end: frames on the stack of a task (2.6).

use val3_bytecode::{Param, Passing, Program};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Link, Memory, Place, Room, StoreId, View, bytes_of};
use val3_lang::values::Text;

use crate::arguments::{Given, on_frame};
use crate::task::Base;
use crate::window::NARROW;

/// Makes the frame of `program` at `base`; its parameters are [passed](pass) then. If it cannot be made, nothing of it
/// remains.
pub(crate) fn enter(memory: &mut Memory, program: &Program, base: &Base, most: u32) -> Result<()> {
    enter_plain(memory, program, base, most)?;
    let (end, stack, room) = (base.behind(program), &mut memory.stack, &mut memory.stores.room);
    fill(&mut stack.views, room, (base.view, end.view), View::whole(StoreId::STACK))?;
    fill(&mut stack.texts, room, (base.text, end.text), Text::new())?;
    clear(&mut stack.texts, base.text, end.text, Text::new());
    fill(&mut stack.links, room, (base.link, end.link), Link::None)?;
    clear(&mut stack.links, base.link, end.link, Link::None);
    for part in &program.parts {
        let store = memory.create_local(part).inspect_err(|_| leave(memory, base))?;
        memory.stack.parts.push(store);
    }
    Ok(())
}

/// Makes the frame of `program` at `base` with its arguments. If that fails, nothing of it remains.
pub(crate) fn enter_with(
    memory: &mut Memory,
    program: &Program,
    base: &Base,
    most: u32,
    arguments: &[Given],
) -> Result<()> {
    enter(memory, program, base, most)?;
    let mut given = program.params.iter().zip(arguments);
    given.try_for_each(|(param, argument)| pass(memory, base, param, *argument)).inspect_err(|_| leave(memory, base))
}

/// As [`enter`], for a program whose frame has nothing but numbers and places.
///
/// The stack has the numbers of a narrow frame behind each base.
#[inline(always)]
pub(crate) fn enter_plain(memory: &mut Memory, program: &Program, base: &Base, most: u32) -> Result<()> {
    if base.bytes.saturating_add(program.stack_bytes) > most {
        return Err(Fault::STACK_FULL);
    }
    let (stack, room) = (&mut memory.stack, &mut memory.stores.room);
    let lanes = program.frame.lanes.num.max(NARROW);
    fill(&mut stack.nums, room, (base.num, base.num + lanes), 0.0)?;
    let places = (base.place, base.place + program.frame.places);
    fill(&mut stack.places, room, places, Place::first(StoreId::STACK))?;
    let template = base.num as usize..base.num as usize + program.nums.len();
    stack.nums.get_mut(template).ok_or(Fault::INTERPRETER)?.copy_from_slice(&program.nums);
    Ok(())
}

/// Drops what the frame at `base` holds in memory.
#[inline]
pub(crate) fn leave(memory: &mut Memory, base: &Base) {
    memory.cut_links(base.link);
    while memory.stack.parts.len() > base.part as usize {
        if let Some(part) = memory.stack.parts.pop() {
            memory.remove(part);
        }
    }
}

/// Gives a parameter of the frame at `base` its argument.
#[inline]
pub(crate) fn pass(memory: &mut Memory, base: &Base, param: &Param, argument: Given) -> Result<()> {
    let from = match argument {
        Given::Value(place) => place,
        Given::Container(view) => match param.passing {
            Passing::View(number) => return write(&mut memory.stack.views, base.view + number, view),
            _ => memory.element(view, 0)?,
        },
    };
    match param.passing {
        Passing::Value(_, lanes) => memory.copy(&param.kind, from, on_frame(base, lanes)),
        Passing::UserValue(part) => {
            let part = memory.stack.parts.get((base.part + part) as usize).copied().ok_or(Fault::INTERPRETER)?;
            memory.copy(&param.kind, from, Place::first(part))
        }
        Passing::Reference(number) => write(&mut memory.stack.places, base.place + number, from),
        Passing::View(_) => Err(Fault::INTERPRETER),
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

/// Makes room up to `end`; a frame that was there before may leave its values.
#[inline(always)]
fn fill<T: Copy>(lanes: &mut Vec<T>, room: &mut Room, (start, end): (u32, u32), value: T) -> Result<()> {
    if end > start && lanes.len() < end as usize { grow(lanes, room, end, value) } else { Ok(()) }
}

#[cold]
fn grow<T: Copy>(lanes: &mut Vec<T>, room: &mut Room, end: u32, value: T) -> Result<()> {
    room.take(bytes_of::<T>((end as usize).saturating_sub(lanes.len())))?;
    lanes.resize(end as usize, value);
    Ok(())
}

fn clear<T: Copy>(lanes: &mut [T], start: u32, end: u32, value: T) {
    if let Some(lanes) = lanes.get_mut(start as usize..end as usize) {
        lanes.fill(value);
    }
}
