//! Machine code for the programs of numbers that tasks spend their time in.
//!
//! The interpreter runs everything; a program that it has been in for long is translated, with those it calls, into a
//! module of WebAssembly, which the engine compiles and keeps within a memory of its own. From then on a turn of the
//! task begins in machine code, and goes on in the interpreter where that stops: at an operation that it has no code
//! for, at what would be an error, at the end of the lines. So programs, lines, time and errors are the same with and
//! without, and only the interpreter has to know all of VAL 3.

mod blocks;
mod body;
mod calls;
mod containers;
mod exchange;
mod lanes;
mod layout;
mod local;
mod machinery;
mod module;
mod operands;
mod operations;
mod stretch;

use std::sync::{Arc, Weak};

use rustc_hash::FxHashMap;
use val3_bytecode::Image;
use val3_vm::{Native, Stretch};

use crate::machinery::{Compiled, Machinery};
use crate::module::Plan;

/// Lines for which a program has had turns before it is translated: as long as translating takes, roughly.
const WARM: u64 = 200_000;

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
    programs: FxHashMap<(usize, u16), State>,
}

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
    fn translate(&mut self, image: &Arc<Image>, program: u16) -> Option<usize> {
        let plan = Plan::new(image, program)?;
        let machinery = match &mut self.machinery {
            Some(machinery) => machinery,
            none => none.insert(Machinery::new().ok()?),
        };
        self.modules.push(machinery.compile(plan, image).ok()?);
        Some(self.modules.len() - 1)
    }

    /// The module of a program that is worth running; counts its turns until it is.
    fn module(&mut self, image: &Arc<Image>, program: u16, lines: u32) -> Option<usize> {
        let key = (self.image(image), program);
        match self.programs.entry(key).or_insert(State::Cold(0)) {
            State::Cold(turns) => {
                *turns += u64::from(lines.min(TURN));
                if *turns < self.warm {
                    return None;
                }
                let module = self.translate(image, program);
                self.programs.insert(key, module.map_or(State::Left, |module| State::Ready(module, 0)));
                module
            }
            State::Ready(module, _) => Some(*module),
            State::Left => None,
        }
    }

    /// Judges a stretch that has executed so many lines.
    fn judge(&mut self, key: (usize, u16), lines: u32) {
        if let Some(State::Ready(_, poor)) = self.programs.get_mut(&key) {
            *poor = if lines < LEAST { *poor + 1 } else { 0 };
            if *poor > PATIENCE {
                self.programs.insert(key, State::Left);
            }
        }
    }
}

impl Native for MachineCode {
    fn run(&mut self, work: &mut Stretch<'_>) {
        let Some(frame) = work.thread.frames.last() else { return };
        let (program, instance) = (frame.program, frame.instance);
        let Some(image) = work.space.instance(instance).map(|instance| Arc::clone(&instance.image)) else { return };
        let Some(module) = self.module(&image, program, work.budget) else { return };
        let (Some(machinery), Some(code)) = (&mut self.machinery, self.modules.get(module)) else { return };
        let before = work.budget;
        let key =
            (self.images.iter().position(|known| known.as_ptr() == Arc::as_ptr(&image)).unwrap_or_default(), program);
        match stretch::run(machinery, code, &image, work) {
            Some(()) => self.judge(key, before - work.budget),
            None => drop(self.programs.insert(key, State::Left)),
        }
    }
}
