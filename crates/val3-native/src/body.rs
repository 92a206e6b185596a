//! The function that a program becomes.
//!
//! Its parameters tell where its frame is and where to begin, its results whether the program has ended or has stopped
//! on the way, and the lines that are left. It begins at its first step or at the head of a loop; how jumps become the
//! blocks and loops of WebAssembly, [`regions`](crate::regions) tells.
//!
//! A [block](crate::flow) of steps takes its lines from the budget at once; where there are fewer left, the program
//! stops before it. Where there is no code for an operation, or it would be an error, the program stops before the
//! operation and gives back the lines behind: the interpreter does it, and raises what is to be raised.

use val3_bytecode::{Image, Program, Register, Step};
use wasm_encoder::{BlockType, Function, Instruction, InstructionSink, MemArg, ValType};

use crate::containers::Shared;
use crate::flow::{Flow, LineBefore};
use crate::known::Known;
use crate::lanes::{Lane, Lanes, number, parameters};
use crate::layout::{LINE, NEXT, RECORD, RECORDS, STOPPED};
use crate::local;
use crate::operations::has_code;
use crate::regions::Regions;
use crate::whole::WholeNumbers;

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
    pub(crate) lanes: &'m Lanes,
    known: &'m Known,
    pub(crate) whole: &'m WholeNumbers,
    pub(crate) regions: &'m Regions,
    pub(crate) flow: &'m Flow,
    code: Function,
    /// What can be left or repeated, the innermost last.
    pub(crate) labels: Vec<Label>,
    /// The step at hand, and its number.
    pub(crate) step: (Step, u32),
    /// The line at hand.
    pub(crate) line: LineBefore,
    /// The lines of the block that have not begun.
    pub(crate) ahead: u32,
}

/// What a jump leaves or repeats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Label {
    /// The program stops.
    Stop,
    /// The step to go on with.
    Step(u32),
    /// The loop with this head.
    Loop(u32),
    /// The condition of an operation.
    Condition,
}

/// The function of a program; its number is its place in the image.
pub(crate) fn function(module: &Surroundings<'_>, number: u16) -> Option<Function> {
    let program = module.image.programs.get(usize::from(number))?;
    let first = *program.code.first()?;
    let lanes = Lanes::of(program, module.image);
    let regions = Regions::of(program);
    let flow = Flow::of(program, |op| has_code(module, program, op));
    let known = Known::of(program, module.shared, &lanes);
    let whole = WholeNumbers::of(program, &lanes);
    let numbers = local::NUMBERS + lanes.variables();
    let fields = u32::try_from(known.variables().count()).ok()?;
    let groups =
        [(local::WHOLE, ValType::I32), (local::INDEXES, ValType::I64), (numbers, ValType::F64), (fields, ValType::I32)];
    let mut body = Body {
        module,
        program,
        lanes: &lanes,
        known: &known,
        whole: &whole,
        regions: &regions,
        flow: &flow,
        code: Function::new(groups),
        labels: Vec::new(),
        step: (first, 0),
        line: LineBefore::Kept,
        ahead: 0,
    };
    body.begin();
    body.steps();
    body.stop_here(u32::from(number));
    Some(body.code)
}

impl Body<'_> {
    /// Behind the code so far.
    pub(crate) fn code(&mut self) -> InstructionSink<'_> {
        self.code.instructions()
    }

    /// The numbers of a new frame, or of one that is entered again, go where the code has them.
    fn begin(&mut self) {
        for (at, variable) in self.known.variables() {
            self.code().i32_const(0).i32_load(whole_at(at)).local_set(variable);
        }
        self.code().local_get(local::ROOM).i32_const(0).i32_lt_s().if_(BlockType::Empty);
        self.enter_again();
        self.code().else_();
        self.enter_new();
        self.code().end();
    }

    fn enter_again(&mut self) {
        let room = local::AGAIN - 1;
        self.code().local_get(local::ROOM).i32_const(room.cast_signed()).i32_and().local_set(local::ROOM);
        self.code().i32_const(0).i32_load(whole_at(NEXT)).local_set(local::NEXT);
        self.code().i32_const(0).i32_load(whole_at(LINE)).local_set(local::LINE);
        for (register, lane) in self.lanes.iter() {
            if let Lane::Variable(variable) = lane {
                self.load(register);
                self.code().local_set(variable);
            }
        }
    }

    /// The caller has written what it has not passed on; a variable is 0 at first.
    fn enter_new(&mut self) {
        let given: Vec<u32> = parameters(self.program).collect();
        for (register, lane) in self.lanes.iter() {
            let is_given = given.contains(&u32::from(register));
            let value = number(self.program, register).unwrap_or_default();
            match lane {
                Lane::Variable(_) if self.lanes.parameter(register).is_some() => {}
                Lane::Variable(variable) if is_given => {
                    self.load(register);
                    self.code().local_set(variable);
                }
                Lane::Variable(variable) if value.to_bits() != 0 => {
                    self.code().f64_const(value.into()).local_set(variable);
                }
                Lane::Memory if !is_given => {
                    self.code().local_get(local::BASE).f64_const(value.into()).f64_store(number_at(register));
                }
                _ => {}
            }
        }
    }

    /// The end: where a program comes to that stops.
    fn stop_here(&mut self, number: u32) {
        self.write_numbers();
        self.write_record(number);
        self.code().i32_const(1).local_get(local::BUDGET).end();
    }

    /// The numbers of the frame go where the interpreter looks for them.
    fn write_numbers(&mut self) {
        for (register, lane) in self.lanes.iter() {
            if lane != Lane::Memory {
                self.code().local_get(local::BASE);
                self.get(register);
                self.code().f64_store(number_at(register));
            }
        }
    }

    /// A record tells where the program has stopped.
    fn write_record(&mut self, number: u32) {
        let field = |number: u32| whole_at(RECORDS + number * 4);
        self.code().i32_const(0).i32_load(whole_at(STOPPED)).local_tee(local::I);
        self.code().i32_const(RECORD.cast_signed()).i32_mul().local_tee(local::J);
        self.code().i32_const(number.cast_signed()).i32_store(field(0));
        self.code().local_get(local::J).local_get(local::STEP).i32_store(field(1));
        self.code().local_get(local::J).local_get(local::LINE).i32_store(field(2));
        self.code().i32_const(0).local_get(local::I).i32_const(1).i32_add().i32_store(whole_at(STOPPED));
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

    /// A field of a description.
    pub(crate) fn field(&mut self, at: u32) {
        match self.known.variables().find(|(known, _)| *known == at) {
            Some((_, variable)) => self.code().local_get(variable),
            None => self.code().i32_const(0).i32_load(whole_at(at)),
        };
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
}

/// A number behind an address.
pub(crate) fn number_at(lane: u16) -> MemArg {
    MemArg { offset: u64::from(lane) * 8, align: 3, memory_index: 0 }
}

/// A whole number behind an address.
pub(crate) fn whole_at(offset: u32) -> MemArg {
    MemArg { offset: offset.into(), align: 2, memory_index: 0 }
}
