//! Replacement of a line in a program that tasks may execute: their positions and stack frames are adapted to the new code.

use std::sync::Arc;

use val3_bytecode::{FrameSize, Image, Program};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{LinkPlace, Memory, Place, Stack, StoreId, Stores, View, bytes_of};
use val3_lang::ports::{CodePlace, TaskNumber};
use val3_lang::values::Text;

use crate::task::{Base, Thread};
use crate::{Frame, Host, ProgramId, Task, Vm};

/// New code of a program in memory, which differs from the present code in one line.
#[derive(Debug, Clone)]
pub struct LineReplacement {
    /// Program.
    pub program: ProgramId,
    /// Row of the replaced line in the program's file, from 1.
    pub row: u32,
    /// Image with the new code. Variables of the program have the same locations as before.
    pub image: Arc<Image>,
}

/// Positions of operations before and after the replacement of a line.
#[derive(Debug, Clone, Copy)]
pub struct MovedCode {
    program: ProgramId,
    /// First operation of the line.
    at: u32,
    /// Whether the operation at this position has moved, because the line is new.
    is_new: bool,
    /// Operations before and after the replacement.
    sizes: [u32; 2],
}

impl MovedCode {
    fn new(replacement: &LineReplacement, before: &Program, after: &Program) -> Self {
        let (at, is_new) = match [before, after].map(|program| program.first_op_at(replacement.row)) {
            [Some(at), _] => (at, false),
            [None, Some(at)] => (at, true),
            [None, None] => (u32::MAX, false),
        };
        let sizes = [before, after].map(|program| u32::try_from(program.code.len()).unwrap_or(u32::MAX));
        Self { program: replacement.program, at, is_new, sizes }
    }

    fn op(self, op: u32) -> u32 {
        let [before, after] = self.sizes;
        if op > self.at || op == self.at && self.is_new { (op + after).saturating_sub(before) } else { op }
    }

    /// Location after the replacement.
    #[must_use]
    pub fn place(self, at: CodePlace) -> CodePlace {
        let is_moved = at.instance == self.program.instance.0 && at.program == self.program.number;
        if is_moved { CodePlace { line: self.op(at.line), ..at } } else { at }
    }
}

/// Stack frame that is moved to another place on the stack.
#[derive(Debug, Clone, Copy)]
struct MovedFrame {
    from: Base,
    to: Base,
    size: FrameSize,
}

/// Frames of a task with their new places.
struct MovedStack {
    task: TaskNumber,
    frames: Vec<MovedFrame>,
    /// Additional lanes.
    growth: FrameSize,
}

impl MovedStack {
    /// Returns the moved lanes of one kind, frame by frame. `start` and `size` select the kind.
    fn runs(&self, start: fn(&Base) -> u32, size: fn(&FrameSize) -> u32) -> Vec<LaneRun> {
        let runs = self.frames.iter().map(|frame| LaneRun {
            from: start(&frame.from) as usize,
            to: start(&frame.to) as usize,
            size: size(&frame.size) as usize,
        });
        runs.collect()
    }
}

/// Consecutive lanes that are moved to another start.
#[derive(Debug, Clone, Copy)]
struct LaneRun {
    from: usize,
    to: usize,
    size: usize,
}

impl Vm {
    /// Returns a task that executes a program, or a program that it has called.
    #[must_use]
    pub fn task_in(&self, program: ProgramId) -> Option<TaskNumber> {
        self.roster.tasks.iter().find(|task| frames_of(&task.thread, program).next().is_some()).map(|task| task.id)
    }

    /// Returns a task that has begun the line at a row of a program's file and not ended it.
    #[must_use]
    pub fn task_within(&self, program: ProgramId, row: u32) -> Option<TaskNumber> {
        let image = &self.space.instance(program.instance)?.image;
        let lines = &image.programs.get(usize::from(program.number))?.lines;
        let starts: Vec<u32> = lines.iter().filter(|line| line.row == row).map(|line| line.op).collect();
        self.roster.tasks.iter().find(|task| self.has_begun_line(task, program, &starts)).map(|task| task.id)
    }

    /// Whether a task has begun and not ended a line of a program, in any frame of the program. `starts` are the first
    /// operations of the lines.
    fn has_begun_line(&self, task: &Task, program: ProgramId, starts: &[u32]) -> bool {
        let thread = &task.thread;
        frames_of(thread, program).any(|depth| match thread.frames.get(depth + 1) {
            Some(called) => starts.contains(&called.back_line),
            None => starts.contains(&thread.line) && (thread.waiting.is_some() || self.is_within_line(task.id)),
        })
    }

    /// Replaces a line of a program in memory. No task may be [within](Self::task_within) the line. Returns where the
    /// code has moved.
    ///
    /// # Errors
    /// 40 if the memory does not suffice; then nothing has changed. 61 if the program does not exist.
    pub fn replace_line(&mut self, replacement: LineReplacement, host: &mut dyn Host) -> Result<MovedCode> {
        let LineReplacement { program: id, ref image, .. } = replacement;
        let number = usize::from(id.number);
        let before = self.space.instance(id.instance).map(|instance| Arc::clone(&instance.image));
        let before = before.ok_or(Fault::INTERPRETER)?;
        let old = before.programs.get(number).ok_or(Fault::INTERPRETER)?;
        let image = Arc::clone(image);
        let new = image.programs.get(number).ok_or(Fault::INTERPRETER)?;
        let moved = MovedCode::new(&replacement, old, new);
        let stacks = self.moved_stacks(id, old, new)?;
        let bytes = stacks.iter().map(|stack| bytes(&stack.growth)).sum();
        self.space.memory.stores.room.take(bytes)?;
        if let Err(fault) = self.space.exchange(id.instance, Arc::clone(&image), host) {
            self.space.memory.stores.room.give_back(bytes);
            return Err(fault);
        }
        for stack in &stacks {
            self.move_stack(stack, id, new);
        }
        for task in &mut self.roster.tasks {
            move_positions(&mut task.thread, moved);
        }
        self.forget_positions();
        Ok(moved)
    }

    /// Returns the tasks with frames of a program, and the new places of their frames.
    fn moved_stacks(&self, id: ProgramId, old: &Program, new: &Program) -> Result<Vec<MovedStack>> {
        let mut stacks = Vec::new();
        for task in self.roster.tasks.iter().filter(|task| frames_of(&task.thread, id).next().is_some()) {
            let mut to = task.thread.frames.first().map(|frame| frame.base).unwrap_or_default();
            let mut end = to;
            let mut frames = Vec::with_capacity(task.thread.frames.len());
            for frame in &task.thread.frames {
                let is_replaced = executes(frame, id);
                let instance = self.space.instance(frame.instance);
                let program = instance.and_then(|instance| instance.program(frame.program));
                let program = program.ok_or(Fault::INTERPRETER)?;
                let from = frame.base;
                let size = if is_replaced { old.frame } else { program.frame };
                frames.push(MovedFrame { from, to: Base { bytes: from.bytes, ..to }, size });
                end = from.after(program);
                to = to.after(if is_replaced { new } else { program });
            }
            stacks.push(MovedStack { task: task.id, frames, growth: difference(&end, &to) });
        }
        Ok(stacks)
    }

    /// Moves the frames of a task, and extends the frames of the program with its further constants.
    fn move_stack(&mut self, moved: &MovedStack, id: ProgramId, new: &Program) {
        let Some(at) = self.roster.position(moved.task) else { return };
        let Some(task) = self.roster.tasks.get_mut(at) else { return };
        let stack = &mut task.thread.stack;
        let FrameSize { lanes, places, views } = moved.growth;
        spread(&mut stack.nums, &moved.runs(|base| base.num, |size| size.lanes.num), lanes.num, 0.0);
        spread(&mut stack.texts, &moved.runs(|base| base.text, |size| size.lanes.text), lanes.text, Text::new());
        spread(&mut stack.links, &moved.runs(|base| base.link, |size| size.lanes.link), lanes.link, LinkPlace::None);
        let nowhere = Place::first(StoreId::STACK);
        spread(&mut stack.places, &moved.runs(|base| base.place, |size| size.places), places, nowhere);
        spread(&mut stack.views, &moved.runs(|base| base.view, |size| size.views), views, View::whole(StoreId::STACK));
        for (frame, MovedFrame { to, size, .. }) in task.thread.frames.iter_mut().zip(&moved.frames) {
            frame.base = *to;
            if executes(frame, id) {
                let known = size.lanes.num as usize;
                let constants = new.nums.get(known..).unwrap_or_default();
                let start = to.num as usize + known;
                if let Some(lanes) = stack.nums.get_mut(start..start + constants.len()) {
                    lanes.copy_from_slice(constants);
                }
            }
        }
        move_references(stack, &mut self.space.memory, &moved.frames);
    }
}

/// Returns the indexes of a program's frames, from the outermost.
fn frames_of(thread: &Thread, id: ProgramId) -> impl Iterator<Item = usize> {
    thread.frames.iter().enumerate().filter(move |(_, frame)| executes(frame, id)).map(|(depth, _)| depth)
}

/// Whether a frame belongs to a call of the program.
fn executes(frame: &Frame, program: ProgramId) -> bool {
    (frame.instance, frame.program) == (program.instance, program.number)
}

/// Moves the positions of a task in the program.
fn move_positions(thread: &mut Thread, moved: MovedCode) {
    let is_replaced = |frame: &Frame| executes(frame, moved.program);
    if thread.frames.last().is_some_and(is_replaced) {
        (thread.next, thread.line) = (moved.op(thread.next), moved.op(thread.line));
    }
    for fragment in &mut thread.fragments {
        let below = fragment.depth.checked_sub(1).and_then(|depth| thread.frames.get(depth));
        if below.is_some_and(is_replaced) {
            let position = &mut fragment.position;
            (position.next, position.line) = (moved.op(position.next), moved.op(position.line));
        }
    }
    for depth in 1..thread.frames.len() {
        if thread.frames.get(depth - 1).is_some_and(is_replaced)
            && let Some(called) = thread.frames.get_mut(depth)
        {
            (called.back, called.back_line) = (moved.op(called.back), moved.op(called.back_line));
        }
    }
}

/// Moves the references to values on the stack: on the stack itself, and in its containers.
fn move_references(stack: &mut Stack, memory: &mut Memory, frames: &[MovedFrame]) {
    stack.places.iter_mut().for_each(|place| *place = moved_place(*place, frames));
    move_links(&mut stack.links, frames);
    move_links_in(&stack.parts, &mut memory.stores, frames);
}

fn move_links_in(containers: &[StoreId], stores: &mut Stores, frames: &[MovedFrame]) {
    for id in containers {
        // A container of a frame exists as long as the frame.
        let Ok(store) = stores.get_mut(*id) else { continue };
        move_links(&mut store.links, frames);
        let inner = store.parts.clone();
        move_links_in(&inner, stores, frames);
    }
}

fn move_links(links: &mut [LinkPlace], frames: &[MovedFrame]) {
    for link in links {
        if let LinkPlace::Data(place) = link {
            *place = moved_place(*place, frames);
        }
    }
}

fn moved_place(place: Place, frames: &[MovedFrame]) -> Place {
    if place.store != StoreId::STACK {
        return place;
    }
    let mut target = place;
    target.num = moved_lane(place.num, frames, |base| base.num);
    target.text = moved_lane(place.text, frames, |base| base.text);
    target.link = moved_lane(place.link, frames, |base| base.link);
    target.part = moved_lane(place.part, frames, |base| base.part);
    target
}

/// Returns the new number of a lane on the stack, which moves with its frame. `start` selects the kind of lane. Lanes
/// below all frames stay.
fn moved_lane(lane: u32, frames: &[MovedFrame], start: fn(&Base) -> u32) -> u32 {
    let frame = frames.iter().rev().find(|frame| start(&frame.from) <= lane);
    frame.map_or(lane, |frame| lane - start(&frame.from) + start(&frame.to))
}

/// Adds lanes, and moves runs of lanes to their new starts. The lanes between the runs get the filler.
fn spread<T: Copy>(lanes: &mut Vec<T>, runs: &[LaneRun], growth: u32, filler: T) {
    let mut moved = vec![filler; lanes.len() + growth as usize];
    for LaneRun { from, to, size } in runs.iter().copied() {
        if let (Some(source), Some(target)) = (lanes.get(from..from + size), moved.get_mut(to..to + size)) {
            target.copy_from_slice(source);
        }
    }
    *lanes = moved;
}

fn difference(before: &Base, after: &Base) -> FrameSize {
    let more = |of: fn(&Base) -> u32| of(after).saturating_sub(of(before));
    let lanes = val3_lang::memory::Lanes {
        num: more(|base| base.num),
        text: more(|base| base.text),
        link: more(|base| base.link),
        part: 0,
    };
    FrameSize { lanes, places: more(|base| base.place), views: more(|base| base.view) }
}

fn bytes(size: &FrameSize) -> u64 {
    size.lanes.bytes() + bytes_of::<Place>(size.places as usize) + bytes_of::<View>(size.views as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_move_with_their_frame() {
        let at = |num| Base { num, ..Base::default() };
        let frame = |from, to| MovedFrame { from: at(from), to: at(to), size: FrameSize::default() };
        let frames = [frame(2, 2), frame(4, 7)];
        let moved = [0, 2, 3, 4, 9].map(|lane| moved_lane(lane, &frames, |base| base.num));
        assert_eq!(moved, [0, 2, 3, 7, 12]);
    }

    #[test]
    fn lanes_between_runs_are_filled() {
        let mut lanes = vec![1, 2, 3, 4];
        let runs = [LaneRun { from: 0, to: 0, size: 2 }, LaneRun { from: 2, to: 3, size: 2 }];
        spread(&mut lanes, &runs, 1, 0);
        assert_eq!(lanes, [1, 2, 0, 3, 4]);
    }
}
