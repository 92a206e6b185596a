//! One stretch of work: the task that runs goes on in machine code as far as that goes.

use val3_bytecode::Image;
use val3_lang::memory::{Memory, Place, StoreId};
use val3_vm::{Frame, Stretch, Thread};

use crate::exchange::{Exchange, read, references, write};
use crate::layout::{DEPTH, LINE, MOST_NUMBERS, MOST_PLACES, NEXT, NUMBERS, PLACES, RECORD, RECORDS, STOPPED};
use crate::local;
use crate::machinery::{Compiled, Machinery};
use crate::module::{MOST_LANES, MOST_PLACES_OF_ONE};

/// The least that a frame takes of the declared stack (2.1.4.2): with it, bytes limit the depth of calls.
const LEAST_BYTES: u32 = 16;

/// Numbers of containers that may be copied for each line that may be executed, and besides.
const COPIED: (usize, usize) = (4, 1000);

/// Where a task is within its innermost program.
#[derive(Debug, Clone, Copy)]
struct At {
    step: u32,
    line: u32,
}

/// A program that has stopped on the way.
#[derive(Debug)]
struct Stopped {
    program: u16,
    at: At,
}

/// Where machine code has come to.
struct Reached {
    /// How many of the frames are left.
    frames: usize,
    /// The programs that have stopped, the outermost first: that of the last frame, and those it has called. None
    /// where all machine code has returned.
    stopped: Vec<Stopped>,
    at: At,
    budget: u32,
}

/// Runs what it can of the task that runs, whose innermost program is of `image`.
///
/// `None` where machine code has failed, of which no case is known: then nothing has changed.
pub(crate) fn run(machinery: &mut Machinery, code: &Compiled, image: &Image, work: &mut Stretch<'_>) -> Option<()> {
    let Stretch { space, thread, .. } = &*work;
    let innermost = thread.frames.last()?;
    let instance = space.instance(innermost.instance)?;
    let end = innermost.base.behind(image.programs.get(usize::from(innermost.program))?);
    let numbers = (end.num + DEPTH * MOST_LANES) as usize;
    let places = (end.place + DEPTH * MOST_PLACES_OF_ONE) as usize;
    if numbers > MOST_NUMBERS || places > MOST_PLACES {
        return Some(());
    }
    let mut exchange = Exchange::new(work.budget as usize * COPIED.0 + COPIED.1);
    Exchange::give_stack(machinery.bytes(code), &space.memory, end.num as usize)?;
    exchange.describe_shared(machinery.bytes(code), &space.memory, &code.shared, instance)?;
    let reached = go(machinery, (code, image), work, &mut exchange)?;
    work.budget = reached.budget;
    let memory = &mut work.space.memory;
    settle(work.thread, memory, image, &reached)?;
    let end = work.thread.frames.last().map_or(end, |frame| frame.base);
    let end = (end.num + MOST_LANES) as usize;
    let bytes = machinery.bytes(code);
    exchange.take_back(bytes, memory, end)?;
    // The frame that was entered has stopped as the first, if one has.
    let entered = reached.frames - usize::from(!reached.stopped.is_empty());
    for (frame, number) in work.thread.frames.iter().zip(0..).skip(entered) {
        let program = image.programs.get(usize::from(frame.program))?;
        let given = references(program).filter(|_| number >= reached.frames);
        exchange.take_references(bytes, memory, frame, given.chain(code.located(frame.program)));
    }
    Some(())
}

/// Lets machine code run: program by program, as each returns to the one before.
fn go(
    machinery: &mut Machinery,
    (code, image): (&Compiled, &Image),
    work: &Stretch<'_>,
    exchange: &mut Exchange,
) -> Option<Reached> {
    let frames = &work.thread.frames;
    let instance = frames.last()?.instance;
    let at = At { step: work.thread.next, line: work.thread.line };
    let mut reached = Reached { frames: frames.len(), stopped: Vec::new(), at, budget: work.budget };
    while let Some(frame) = frames.get(..reached.frames).and_then(<[Frame]>::last)
        && frame.instance == instance
        && code.entry(frame.program, reached.at.step).is_some()
        && code.takes(frame.program, work.space.memory.stack.nums.get(frame.base.num as usize..)?)
    {
        let program = image.programs.get(usize::from(frame.program))?;
        exchange.describe_own(machinery.bytes(code), &work.space.memory, (program, image), &frame.base)?;
        let taken = frame.base.bytes.saturating_add(program.stack_bytes);
        let room = work.stack_size.saturating_sub(taken).min(DEPTH * LEAST_BYTES);
        call(machinery, code, (frame, room), &mut reached)?;
        if !reached.stopped.is_empty() {
            break;
        }
        reached.frames -= 1;
        reached.at = At { step: frame.back, line: frame.back_line };
    }
    Some(reached)
}

/// Lets machine code run a program whose frame is there, up to its end or to where it stops.
fn call(machinery: &mut Machinery, code: &Compiled, (frame, room): (&Frame, u32), reached: &mut Reached) -> Option<()> {
    let numbers = NUMBERS + frame.base.num * 8;
    loop {
        let (entry, begin) = code.entry(frame.program, reached.at.step)?;
        let bytes = machinery.bytes(code);
        for (at, word) in [(STOPPED, 0), (NEXT, begin), (LINE, reached.at.line)] {
            write(bytes, at, &word.to_le_bytes())?;
        }
        let places = PLACES + frame.base.place * 4;
        let given = (numbers, places, room | local::AGAIN, reached.budget, 0.0, 0.0, 0.0, 0.0);
        let (has_stopped, left) = machinery.call(entry, given).ok()?;
        reached.budget = left;
        if has_stopped == 0 {
            return Some(());
        }
        let bytes = machinery.bytes(code);
        reached.stopped = stopped(bytes)?;
        reached.at = reached.stopped.last()?.at;
        let fill = code.fill(frame.program, reached.at.step).filter(|_| reached.stopped.len() == 1);
        let Some((fill, lines)) = fill.and_then(|fill| Some((fill, fill.run(bytes, numbers, left)?))) else {
            return Some(());
        };
        reached.stopped.clear();
        reached.budget -= lines;
        reached.at.line = fill.last_line;
    }
}

/// The programs that have stopped, the outermost first.
fn stopped(bytes: &[u8]) -> Option<Vec<Stopped>> {
    let count = u32::from_le_bytes(read(bytes, STOPPED)?);
    let field = |number: u32, field: u32| read(bytes, RECORDS + number * RECORD + field * 4).map(u32::from_le_bytes);
    let record = |number| {
        let at = At { step: field(number, 1)?, line: field(number, 2)? };
        Some(Stopped { program: u16::try_from(field(number, 0)?).ok()?, at })
    };
    (0..count).rev().map(record).collect()
}

/// The frames of the task as machine code has left them.
fn settle(thread: &mut Thread, memory: &mut Memory, image: &Image, reached: &Reached) -> Option<()> {
    thread.frames.truncate(reached.frames);
    (thread.next, thread.line) = (reached.at.step, reached.at.line);
    let callers = reached.stopped.iter();
    for (caller, callee) in callers.zip(reached.stopped.iter().skip(1)) {
        let frame = *thread.frames.last()?;
        let base = frame.base.behind(image.programs.get(usize::from(frame.program))?);
        let (back, back_line) = (caller.at.step, caller.at.line);
        thread.frames.push(Frame { instance: frame.instance, program: callee.program, back, back_line, base });
    }
    let frame = thread.frames.last()?;
    let end = frame.base.behind(image.programs.get(usize::from(frame.program))?);
    let least = (frame.base.num + MOST_LANES) as usize;
    let stack = &mut memory.stack;
    stack.nums.resize(stack.nums.len().max(least), 0.0);
    stack.places.resize(stack.places.len().max(end.place as usize), Place::first(StoreId::STACK));
    Some(())
}
