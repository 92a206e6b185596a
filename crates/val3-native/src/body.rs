//! The function that a program becomes.
//!
//! Its parameters tell where its frame is and where to begin, its results whether the program has ended or has stopped
//! on the way, and the lines that are left. Blocks of code stand one behind the other, each within the ones behind it,
//! so that a jump forward leaves some of them; a jump backward goes through the table at the head of the loop around
//! all of them, as the entry does:
//!
//! ```text
//! block: stop
//!   loop: head
//!     block 3 { block 2 { block 1 { block 0 { table } code 0 } code 1 } code 2 } code 3
//!   end
//! end
//! numbers to memory, a record of where the program has stopped
//! ```
//!
//! Where there is no code for an operation, or it would be an error, the program stops before it: the interpreter does
//! it, and raises what is to be raised.

use val3_bytecode::{Image, Program, Register, Step};
use wasm_encoder::{BlockType, Function, Instruction, InstructionSink, MemArg, ValType};

use crate::blocks::Blocks;
use crate::containers::Shared;
use crate::lanes::{Lane, Lanes, number, parameters};
use crate::layout::{RECORD, RECORDS, STOPPED};
use crate::local;

/// What is known of the module that a function is part of.
pub(crate) struct Surroundings<'m> {
    pub(crate) image: &'m Image,
    /// The programs with machine code, in the order of their functions.
    pub(crate) programs: &'m [u16],
    pub(crate) shared: &'m Shared,
}

/// The code of one program in the making.
pub(crate) struct Body<'m> {
    pub(crate) module: &'m Surroundings<'m>,
    pub(crate) program: &'m Program,
    pub(crate) lanes: Lanes,
    blocks: Blocks,
    code: Function,
    /// The block at hand.
    block: u32,
    /// How many `if` are open in it.
    depth: u32,
    /// The step at hand, and its number.
    pub(crate) step: (Step, u32),
}

/// The function of a program; its number is its place in the image.
pub(crate) fn function(module: &Surroundings<'_>, number: u16) -> Option<Function> {
    let program = module.image.programs.get(usize::from(number))?;
    let first = *program.code.first()?;
    let (lanes, blocks) = (Lanes::of(program, module.image), Blocks::of(program));
    let groups = [(local::WHOLE, ValType::I32), (local::NUMBERS + lanes.variables(), ValType::F64)];
    let code = Function::new(groups);
    let mut body = Body { module, program, lanes, blocks, code, block: 0, depth: 0, step: (first, 0) };
    body.begin();
    body.blocks();
    body.stop_here(u32::from(number));
    Some(body.code)
}

impl Body<'_> {
    /// Behind the code so far.
    pub(crate) fn code(&mut self) -> InstructionSink<'_> {
        self.code.instructions()
    }

    /// The numbers of a new frame, or of one that is entered again, where the code has them.
    fn begin(&mut self) {
        self.code().local_get(local::NEXT);
        self.code().if_(BlockType::Empty);
        self.each_variable(|body, register, variable| {
            body.load(register);
            body.code().local_set(variable);
        });
        self.code().local_get(local::NEXT).i32_const(1).i32_sub().local_set(local::NEXT);
        self.code().else_();
        let given: Vec<u32> = parameters(self.program).collect();
        let lanes: Vec<(Register, Lane)> = self.lanes.iter().collect();
        for (register, lane) in lanes {
            let value = number(self.program, register).unwrap_or_default();
            match lane {
                Lane::Variable(variable) if given.contains(&u32::from(register)) => {
                    self.load(register);
                    self.code().local_set(variable);
                }
                Lane::Variable(variable) if value.to_bits() != 0 => {
                    self.code().f64_const(value.into()).local_set(variable);
                }
                Lane::Memory if !given.contains(&u32::from(register)) => {
                    self.code().local_get(local::BASE).f64_const(value.into()).f64_store(number_at(register));
                }
                _ => {}
            }
        }
        self.code().end();
    }

    /// The loop with all blocks.
    fn blocks(&mut self) {
        let count = self.blocks.len();
        self.code().block(BlockType::Empty).loop_(BlockType::Empty);
        (0..count).for_each(|_| {
            self.code().block(BlockType::Empty);
        });
        self.code().local_get(local::NEXT).br_table(0..count, 0);
        let mut is_dead = false;
        for (step, number) in self.program.code.iter().zip(0..) {
            if let Some(block) = self.blocks.at(number) {
                self.code().end();
                self.block = block;
                is_dead = false;
            }
            if !is_dead {
                self.step = (*step, number);
                is_dead = self.operation();
            }
        }
        self.code().unreachable().end().end();
    }

    /// The end: where stopped programs come to.
    fn stop_here(&mut self, number: u32) {
        let lanes: Vec<(Register, Lane)> = self.lanes.iter().collect();
        for (register, lane) in lanes {
            let mut keep = |value: &dyn Fn(&mut InstructionSink<'_>)| {
                let mut code = self.code.instructions();
                code.local_get(local::BASE);
                value(&mut code);
                code.f64_store(number_at(register));
            };
            match lane {
                Lane::Variable(variable) => keep(&|code| {
                    code.local_get(variable);
                }),
                Lane::Constant(value) => keep(&|code| {
                    code.f64_const(value.into());
                }),
                Lane::Memory => {}
            }
        }
        let field = |number: u32| whole_at(RECORDS + number * 4);
        self.code().i32_const(0).i32_load(whole_at(STOPPED)).local_tee(local::I);
        #[allow(clippy::cast_possible_wrap, reason = "a small constant, and the number of a program")]
        let (record, number) = (RECORD as i32, number as i32);
        self.code().i32_const(record).i32_mul().local_tee(local::J).i32_const(number).i32_store(field(0));
        self.code().local_get(local::J).local_get(local::STEP).i32_store(field(1));
        self.code().local_get(local::J).local_get(local::LINE).i32_store(field(2));
        self.code().i32_const(0).local_get(local::I).i32_const(1).i32_add().i32_store(whole_at(STOPPED));
        self.code().i32_const(1).local_get(local::BUDGET).end();
    }

    fn each_variable(&mut self, act: impl Fn(&mut Self, Register, u32)) {
        let lanes: Vec<(Register, Lane)> = self.lanes.iter().collect();
        for (register, lane) in lanes {
            if let Lane::Variable(variable) = lane {
                act(self, register, variable);
            }
        }
    }

    fn load(&mut self, register: Register) {
        self.code().local_get(local::BASE).f64_load(number_at(register));
    }

    /// Adds an instruction behind the code so far.
    pub(crate) fn add(&mut self, instruction: &Instruction<'_>) {
        self.code.instruction(instruction);
    }

    /// A number of the frame.
    pub(crate) fn get(&mut self, register: Register) {
        match self.lanes.get(register) {
            Lane::Constant(value) => {
                self.code().f64_const(value.into());
            }
            Lane::Variable(variable) => {
                self.code().local_get(variable);
            }
            Lane::Memory => self.load(register),
        }
    }

    /// Writes a number of the frame.
    pub(crate) fn set(&mut self, register: Register, value: impl FnOnce(&mut Self)) {
        match self.lanes.get(register) {
            Lane::Constant(_) => {
                value(self);
                self.code().drop();
            }
            Lane::Variable(variable) => {
                value(self);
                self.code().local_set(variable);
            }
            Lane::Memory => {
                self.code().local_get(local::BASE);
                value(self);
                self.code().f64_store(number_at(register));
            }
        }
    }

    /// What is done if the condition on the stack holds.
    pub(crate) fn when(&mut self, act: impl FnOnce(&mut Self)) {
        self.code().if_(BlockType::Empty);
        self.depth += 1;
        act(self);
        self.depth -= 1;
        self.code().end();
    }

    /// Goes on at another step.
    pub(crate) fn jump(&mut self, to: u32) {
        let Some(block) = self.blocks.at(to) else { return self.stop_at(to) };
        if block > self.block {
            let out = block - self.block - 1 + self.depth;
            self.code().br(out);
        } else {
            let head = self.blocks.len() - 1 - self.block + self.depth;
            self.code().i32_const(block.cast_signed()).local_set(local::NEXT).br(head);
        }
    }

    /// Goes on at another step if the condition on the stack holds.
    pub(crate) fn jump_if(&mut self, to: u32) {
        self.when(|body| body.jump(to));
    }

    /// The interpreter goes on at a step.
    pub(crate) fn stop_at(&mut self, step: u32) {
        let out = self.blocks.len() - self.block + self.depth;
        self.code().i32_const(step.cast_signed()).local_set(local::STEP).br(out);
    }

    /// The interpreter does this operation; a line that began with it has not begun.
    pub(crate) fn leave_it(&mut self) {
        let (step, number) = self.step;
        if step.line {
            self.code().local_get(local::BUDGET).i32_const(1).i32_add().local_set(local::BUDGET);
        }
        self.stop_at(number);
    }

    /// A line begins, unless none may.
    pub(crate) fn begin_line(&mut self) {
        let (_, number) = self.step;
        self.code().local_get(local::BUDGET).i32_eqz();
        self.when(|body| body.stop_at(number));
        self.code().local_get(local::BUDGET).i32_const(1).i32_sub().local_set(local::BUDGET);
        self.code().i32_const(number.cast_signed()).local_set(local::LINE);
    }
}

/// A number behind an address.
pub(crate) fn number_at(lane: u16) -> MemArg {
    MemArg { offset: u64::from(lane) * 8, align: 3, memory_index: 0 }
}

/// A number of an address in all.
pub(crate) fn number_behind(offset: u32) -> MemArg {
    MemArg { offset: offset.into(), align: 3, memory_index: 0 }
}

/// A whole number behind an address.
pub(crate) fn whole_at(offset: u32) -> MemArg {
    MemArg { offset: offset.into(), align: 2, memory_index: 0 }
}
