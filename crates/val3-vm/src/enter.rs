//! Programs that begin and end: frames on the stack of a task (2.6).

use val3_bytecode::{Param, Passing, Program};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Link, Memory, Place, StoreId, View};
use val3_lang::values::Text;

use crate::arguments::{Given, on_frame};
use crate::task::Base;
use crate::window::NARROW;

/// The first lanes behind a frame.
#[inline]
pub(crate) fn behind(base: &Base, program: &Program) -> Base {
    let size = &program.frame;
    Base {
        num: base.num + size.lanes.num,
        text: base.text + size.lanes.text,
        link: base.link + size.lanes.link,
        part: base.part + size.lanes.part,
        place: base.place + size.places,
        view: base.view + size.views,
        bytes: base.bytes.saturating_add(program.stack_bytes),
    }
}

/// Makes the frame of `program` at `base`; its parameters are [passed](pass) then.
#[inline]
pub(crate) fn enter(memory: &mut Memory, program: &Program, base: &Base, most: u32) -> Result<()> {
    let end = behind(base, program);
    if end.bytes > most {
        return Err(Fault::STACK_FULL);
    }
    let stack = &mut memory.stack;
    fill(&mut stack.nums, base.num, end.num.max(base.num.saturating_add(NARROW)), 0.0);
    let template = base.num as usize..base.num as usize + program.nums.len();
    if let Some(nums) = stack.nums.get_mut(template) {
        nums.copy_from_slice(&program.nums);
    }
    fill(&mut stack.places, base.place, end.place, Place::first(StoreId::STACK));
    fill(&mut stack.views, base.view, end.view, View::whole(StoreId::STACK));
    if program.frame.lanes.text > 0 {
        fill(&mut stack.texts, base.text, end.text, Text::new());
        clear(&mut stack.texts, base.text, end.text, Text::new());
    }
    if program.frame.lanes.link > 0 {
        fill(&mut stack.links, base.link, end.link, Link::None);
        clear(&mut stack.links, base.link, end.link, Link::None);
    }
    for part in &program.parts {
        let store = memory.create_local(part);
        memory.stack.parts.push(store);
    }
    Ok(())
}

/// Drops what the frame at `base` holds in memory.
#[inline]
pub(crate) fn leave(memory: &mut Memory, base: &Base) {
    while memory.stack.parts.len() > base.part as usize {
        if let Some(part) = memory.stack.parts.pop() {
            memory.remove(part);
        }
    }
}

/// Copies a number from the frame of the caller: what most arguments are.
#[inline]
pub(crate) fn pass_number(nums: &mut [f64], from: u32, to: u32) -> Result<()> {
    let value = nums.get(from as usize).copied().ok_or(Fault::INTERPRETER)?;
    write(nums, to, value)
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

fn write<T>(lanes: &mut [T], at: u32, value: T) -> Result<()> {
    *lanes.get_mut(at as usize).ok_or(Fault::INTERPRETER)? = value;
    Ok(())
}

/// Makes room up to `end`; a frame that was there before may leave its values.
fn fill<T: Copy>(lanes: &mut Vec<T>, start: u32, end: u32, value: T) {
    if end > start && lanes.len() < end as usize {
        lanes.resize(end as usize, value);
    }
}

fn clear<T: Copy>(lanes: &mut [T], start: u32, end: u32, value: T) {
    if let Some(lanes) = lanes.get_mut(start as usize..end as usize) {
        lanes.fill(value);
    }
}
