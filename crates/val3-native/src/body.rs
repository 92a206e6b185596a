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

use crate::bounds::Facts;
use crate::containers::Shared;
use crate::draft::Draft;
use crate::flow::LineBefore;
use crate::frame::Frame;
use crate::inline;
use crate::known::Known;
use crate::lanes::{Lane, number, parameters};
use crate::layout::{LINE, NEXT, RECORD, RECORDS, STOPPED};
use crate::local;
use crate::study::Study;

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
    /// Its number in the image.
    pub(crate) number: u16,
    pub(crate) study: &'m Study,
    pub(crate) known: &'m Known,
    pub(crate) draft: &'m mut Draft,
    pub(crate) frame: Frame,
    /// What can be left or repeated, the innermost last.
    pub(crate) labels: Vec<Label>,
    /// The step at hand, and its number.
    pub(crate) step: (Step, u32),
    /// The line at hand.
    pub(crate) line: LineBefore,
    /// The lines of the block that have not begun.
    pub(crate) ahead: u32,
    /// The variable that tells whether the program was entered again, where that matters.
    pub(crate) entered: Option<u32>,
    /// What is known of whole numbers, which holds as far as the block goes.
    pub(crate) facts: Facts,
}

/// What a jump leaves or repeats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Label {
    /// The program has ended, and the one that called it goes on in the same function.
    Ended,
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
    let levels = inline::levels(module, program);
    let study = Study::of(module, program, levels);
    let mut draft = Draft::new();
    let known = Known::of(&inline::with_inlined(module, program, levels), module.shared, &mut draft);
    let frame = Frame::of_function(&study, levels, &mut draft);
    let entered = (!study.fills.is_empty()).then(|| draft.variable(ValType::I32));
    let mut body = Body {
        module,
        program,
        number,
        study: &study,
        known: &known,
        draft: &mut draft,
        frame,
        labels: Vec::new(),
        step: (first, 0),
        line: LineBefore::Kept,
        ahead: 0,
        entered,
        facts: Facts::new(),
    };
    body.begin();
    body.steps(None);
    body.write_frame();
    body.code().i32_const(1).local_get(local::BUDGET).end();
    Some(draft.finish())
}

impl Body<'_> {
    /// Behind the code so far.
    pub(crate) fn code(&mut self) -> InstructionSink<'_> {
        self.draft.code()
    }

    /// The numbers of a new frame, or of one that is entered again, go where the code has them.
    fn begin(&mut self) {
        for (at, variable) in self.known.variables() {
            self.code().i32_const(0).i32_load(whole_at(at)).local_set(variable);
        }
        self.code().local_get(local::ROOM).i32_const(0).i32_lt_s().if_(BlockType::Empty);
        self.enter_again();
        self.code().else_();
        self.take_given();
        self.begin_anew();
        self.code().end();
    }

    fn enter_again(&mut self) {
        let room = local::AGAIN - 1;
        self.code().local_get(local::ROOM).i32_const(room.cast_signed()).i32_and().local_set(local::ROOM);
        self.code().i32_const(0).i32_load(whole_at(NEXT)).local_set(local::NEXT);
        let line = self.frame.line;
        self.code().i32_const(0).i32_load(whole_at(LINE)).local_set(line);
        if let Some(entered) = self.entered {
            self.code().i32_const(1).local_set(entered);
        }
        for (register, lane) in self.study.lasting() {
            if let Lane::Variable(_) = lane {
                self.set(register, |body| body.load(register));
            }
        }
    }

    /// The caller has written what it has not passed on.
    fn take_given(&mut self) {
        for given in parameters(self.program) {
            if let Ok(register) = Register::try_from(given)
                && let Lane::Variable(_) = self.study.lanes.get(register)
                && self.study.lanes.parameter(register).is_none()
            {
                self.set(register, |body| body.load(register));
            }
        }
    }

    /// The numbers of a new frame, but for parameters.
    pub(crate) fn begin_anew(&mut self) {
        let given: Vec<u32> = parameters(self.program).collect();
        for (register, lane) in self.study.lasting().filter(|(register, _)| !given.contains(&u32::from(*register))) {
            let value = number(self.program, register).unwrap_or_default();
            match lane {
                Lane::Variable(_) => self.set(register, |body| _ = body.code().f64_const(value.into())),
                Lane::Memory => {
                    let at = self.at(register);
                    self.code().local_get(local::BASE).f64_const(value.into()).f64_store(at);
                }
                Lane::Constant(_) => {}
            }
        }
    }

    /// The program has stopped: its numbers go where the interpreter looks for them, and a record tells where it is.
    pub(crate) fn write_frame(&mut self) {
        for (register, lane) in self.study.lasting() {
            if lane != Lane::Memory {
                self.save(register);
            }
        }
        let field = |number: u32| whole_at(RECORDS + number * 4);
        let (number, line) = (i32::from(self.number), self.frame.line);
        self.code().i32_const(0).i32_load(whole_at(STOPPED)).local_tee(local::I);
        self.code().i32_const(RECORD.cast_signed()).i32_mul().local_tee(local::J);
        self.code().i32_const(number).i32_store(field(0));
        self.code().local_get(local::J).local_get(local::STEP).i32_store(field(1));
        self.code().local_get(local::J).local_get(line).i32_store(field(2));
        self.code().i32_const(0).local_get(local::I).i32_const(1).i32_add().i32_store(whole_at(STOPPED));
    }

    /// A number of the frame goes to its memory.
    pub(crate) fn save(&mut self, register: Register) {
        let at = self.at(register);
        self.code().local_get(local::BASE);
        self.get(register);
        self.code().f64_store(at);
    }

    /// Where a number of the frame is in memory, from the address of the function's frame on.
    pub(crate) fn at(&self, register: Register) -> MemArg {
        bytes_behind(self.frame.numbers + u32::from(register) * 8)
    }

    pub(crate) fn load(&mut self, register: Register) {
        let at = self.at(register);
        self.code().local_get(local::BASE).f64_load(at);
    }

    /// Adds an instruction behind the code so far.
    pub(crate) fn add(&mut self, instruction: &Instruction<'_>) {
        self.draft.add(instruction);
    }

    /// A field of a description.
    pub(crate) fn field(&mut self, at: u32) {
        match self.known.variables().find(|(known, _)| *known == at) {
            Some((_, variable)) => self.code().local_get(variable),
            None => self.code().i32_const(0).i32_load(whole_at(at)),
        };
    }
}

/// A number behind an address.
pub(crate) fn number_at(lane: u16) -> MemArg {
    bytes_behind(u32::from(lane) * 8)
}

/// A number so many bytes behind an address.
pub(crate) fn bytes_behind(offset: u32) -> MemArg {
    MemArg { offset: offset.into(), align: 3, memory_index: 0 }
}

/// A whole number behind an address.
pub(crate) fn whole_at(offset: u32) -> MemArg {
    MemArg { offset: offset.into(), align: 2, memory_index: 0 }
}
