//! Machine code for the programs of numbers that tasks spend their time in.
//!
//! The interpreter runs everything; a program that it has been in for long is translated, with those it calls, into a
//! module of WebAssembly, which the engine compiles and keeps within a memory of its own. From then on a turn of the
//! task begins in machine code, and goes on in the interpreter where that stops: at an operation that it has no code
//! for, at what would be an error, at the end of the lines. So programs, lines, time and errors are the same with and
//! without, and only the interpreter has to know all of VAL 3.

mod arithmetic;
mod body;
mod bounds;
mod calls;
mod containers;
mod counting;
mod draft;
mod effort;
mod elements;
mod exchange;
mod fill;
mod flow;
mod frame;
mod functions;
mod inline;
mod insert;
mod known;
mod lanes;
mod layout;
mod local;
mod machinery;
mod module;
mod operands;
mod operations;
mod quotients;
mod references;
mod regions;
mod registers;
mod rotation;
mod sine;
mod sorts;
mod stretch;
mod study;
mod temporaries;
mod ways;
mod whole;

use std::sync::{Arc, Weak};

use rustc_hash::FxHashMap;
use val3_bytecode::Image;
use val3_vm::{Native, Prospect, Stretch};

use crate::machinery::{Compiled, Machinery};
use crate::module::Plan;

/// Lines for which a program has had turns before it is translated: as long as translating takes, roughly.
const WARM: u64 = 100_000;

/// What a turn counts at most: what it may execute is not what it does.
const TURN: u32 = 2_000;

/// Lines that a turn should execute in machine code, so that it pays.
const LEAST: u32 = 64;

/// How often in a row less than that may be executed, until a program is left to the interpreter.
const PATIENCE: u32 = 32;

/// Machine code for the programs of a controller.
#[derive(Debug)]
pub struct MachineCode {
    warm: u64,
    machinery: Option<Machinery>,
    modules: Vec<Compiled>,
    images: Vec<Weak<Image>>,
    programs: FxHashMap<Key, State>,
}

/// A program: the number of its image, and its own.
type Key = (usize, u16);

/// How far a program is.
#[derive(Debug, Clone, Copy)]
enum State {
    /// It has had turns of so many lines.
    Cold(u64),
    /// It is in this module; it has been of little use so many times in a row.
    Ready(usize, u32),
    /// The interpreter is as good.
    Left,
}

impl Default for MachineCode {
    fn default() -> Self {
        Self::after(WARM)
    }
}

impl MachineCode {
    /// Programs are translated when they have had turns for so many lines.
    #[must_use]
    pub fn after(lines: u64) -> Self {
        Self { warm: lines, machinery: None, modules: Vec::new(), images: Vec::new(), programs: FxHashMap::default() }
    }

    /// The number of an image. When one has left memory, all code is forgotten.
    fn image(&mut self, image: &Arc<Image>) -> usize {
        if let Some(known) = self.images.iter().position(|known| known.as_ptr() == Arc::as_ptr(image)) {
            return known;
        }
        if self.images.iter().any(|known| known.strong_count() == 0) {
            *self = Self::after(self.warm);
        }
        self.images.push(Arc::downgrade(image));
        self.images.len() - 1
    }

    /// Translates a program; `None` where that cannot be done.
    fn translate(&mut self, image: &Image, program: u16) -> Option<usize> {
        let plan = Plan::new(image, program)?;
        let machinery = match &mut self.machinery {
            Some(machinery) => machinery,
            none => none.insert(Machinery::new().ok()?),
        };
        self.modules.push(machinery.compile(plan, image).ok()?);
        Some(self.modules.len() - 1)
    }

    /// The module of a program that is worth running; counts its turns until it is.
    fn module(&mut self, key: Key, image: &Image, lines: u32) -> Option<usize> {
        match self.programs.entry(key).or_insert(State::Cold(0)) {
            State::Cold(turns) => {
                *turns += u64::from(lines.min(TURN));
                if *turns < self.warm {
                    return None;
                }
                let module = self.translate(image, key.1);
                self.programs.insert(key, module.map_or(State::Left, |module| State::Ready(module, 0)));
                module
            }
            State::Ready(module, _) => Some(*module),
            State::Left => None,
        }
    }

    /// Judges a stretch that has executed so many lines.
    fn judge(&mut self, key: Key, lines: u32) -> Prospect {
        let Some(State::Ready(_, poor)) = self.programs.get_mut(&key) else { return Prospect::None };
        *poor = if lines < LEAST { *poor + 1 } else { 0 };
        match *poor {
            0 => return Prospect::Near,
            1..=PATIENCE => {}
            _ => drop(self.programs.insert(key, State::Left)),
        }
        Prospect::None
    }
}

impl Native for MachineCode {
    fn run(&mut self, work: &mut Stretch<'_>) -> Prospect {
        let Some(frame) = work.thread.frames.last() else { return Prospect::None };
        let Some(instance) = work.space.instance(frame.instance) else { return Prospect::None };
        let image = Arc::clone(&instance.image);
        let key = (self.image(&image), frame.program);
        let Some(module) = self.module(key, &image, work.budget) else { return Prospect::None };
        let (Some(machinery), Some(code)) = (&mut self.machinery, self.modules.get(module)) else {
            return Prospect::None;
        };
        if code.entry(frame.program, work.thread.next).is_none() {
            return Prospect::Near;
        }
        let reserve = work.budget.saturating_sub(code.most_lines);
        work.budget -= reserve;
        let before = work.budget;
        let result = stretch::run(machinery, code, &image, work);
        let (left, lines) = (work.budget, before - work.budget);
        work.budget += reserve;
        match result {
            // A block that needs more lines than are left is not begun. Others outside are to look now.
            Some(()) if reserve > 0 && left < LEAST => Prospect::None,
            Some(()) => self.judge(key, lines),
            None => {
                self.programs.insert(key, State::Left);
                Prospect::None
            }
        }
    }
}
