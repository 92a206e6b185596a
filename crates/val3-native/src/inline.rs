//! Short programs become part of the function that calls them.
//!
//! Such a program still has its frame behind that of the caller, with its lines, its share of the declared stack and
//! its record where it stops; but its numbers are variables of the function, and those that the caller passes by
//! reference are variables of the caller.

use std::iter;

use val3_bytecode::{Operand, Program};
use wasm_encoder::ValType;

use crate::body::{Body, Label, Surroundings, whole_at};
use crate::calls::{Call, callee};
use crate::flow::{LineBefore, target};
use crate::frame::{Frame, Reference, Variables};
use crate::lanes::{Lane, Lanes};
use crate::local;
use crate::study::Study;

/// Steps of a program that is short.
const SHORT: usize = 24;

/// Levels of calls at most.
const DEEPEST: u32 = 3;

/// Steps that calls may become in one function, and in all functions of a module: translating takes time.
const MOST_STEPS: (usize, usize) = (200, 2_000);

/// On how many levels the calls of a program, of what it calls and so on become code of one function.
pub(crate) fn levels(module: &Surroundings<'_>, program: &Program) -> u32 {
    let most = MOST_STEPS.0.min(MOST_STEPS.1 / module.programs.len().max(1));
    (1..=DEEPEST).take_while(|levels| steps(module, program, *levels) <= most).last().unwrap_or_default()
}

/// How many steps the calls become.
fn steps(module: &Surroundings<'_>, program: &Program, levels: u32) -> usize {
    let within = inlined(module, program, levels);
    within.map(|callee| callee.code.len() + steps(module, callee, levels.saturating_sub(1))).sum()
}

/// The programs whose code the calls become.
fn inlined<'m>(
    module: &'m Surroundings<'m>,
    program: &'m Program,
    levels: u32,
) -> impl Iterator<Item = &'m Program> + 'm {
    let calls = program.code.iter().filter_map(move |step| callee(module, program, step.op));
    calls.filter(move |call| call.is_inlined(levels)).map(|call| call.callee)
}

/// A program with all whose code its calls become.
pub(crate) fn with_inlined<'m>(module: &'m Surroundings<'m>, program: &'m Program, levels: u32) -> Vec<&'m Program> {
    let within = inlined(module, program, levels);
    let all = within.flat_map(|callee| with_inlined(module, callee, levels.saturating_sub(1)));
    iter::once(program).chain(all).collect()
}

/// The bytes of the declared stack that a call takes at most, with all calls in the code that it becomes.
pub(crate) fn most_taken(module: &Surroundings<'_>, call: &Call<'_>, levels: u32) -> u32 {
    let within = if call.is_inlined(levels) { call.callee.code.as_slice() } else { &[] };
    let calls = within.iter().filter_map(|step| callee(module, call.callee, step.op));
    let most = calls.map(|call| most_taken(module, &call, levels.saturating_sub(1))).max();
    call.callee.stack_bytes + most.unwrap_or_default()
}

impl Call<'_> {
    /// Whether the call becomes the code of what it calls, which is short and has no loop.
    pub(crate) fn is_inlined(&self, levels: u32) -> bool {
        let mut steps = self.callee.code.iter().zip(0..);
        levels > 0
            && self.callee.code.len() <= SHORT
            && steps.all(|(step, number)| target(step.op).is_none_or(|to| to > number))
    }
}

impl Body<'_> {
    /// The code of a program instead of its call. Where it stops, the program stops behind the call.
    pub(crate) fn inline(&mut self, call: &Call<'_>) {
        let levels = self.frame.levels.saturating_sub(1);
        let study = Study::of(self.module, call.callee, levels);
        let frame = self.frame_of(call, &study.lanes, levels);
        self.pass_numbers(call, &study.lanes, &frame);
        self.open_block(Label::Ended);
        let mut body = Body {
            module: self.module,
            program: call.callee,
            number: call.number,
            study: &study,
            known: self.known,
            draft: self.draft,
            frame,
            labels: vec![Label::Ended],
            step: self.step,
            line: LineBefore::Known(0),
            ahead: 0,
        };
        body.begin_anew();
        body.steps();
        body.write_frame();
        body.write_references();
        self.stop_behind();
        self.close();
    }

    /// The frame of a program that is called here, with what it gets by reference.
    fn frame_of(&mut self, call: &Call<'_>, lanes: &Lanes, levels: u32) -> Frame {
        let size = &self.program.frame;
        let mut frame = Frame::new(lanes, levels, self.draft);
        frame.numbers = self.frame.numbers + size.lanes.num * 8;
        frame.places = self.frame.places + size.places * 4;
        frame.taken = self.frame.taken + call.callee.stack_bytes;
        for (from, count, to) in call.references() {
            let place = to as usize;
            frame.references.resize(frame.references.len().max(place + 1), None);
            if let Some(reference) = frame.references.get_mut(place) {
                *reference = Some(self.reference_to(from, count));
            }
        }
        frame
    }

    /// What a parameter refers to that is given a value of so many numbers.
    fn reference_to(&mut self, operand: Operand, count: u32) -> Reference {
        if let Some(variables) = self.variables_of(operand, count) {
            return Reference::Variables(variables);
        }
        let variable = self.draft.variable(ValType::I32);
        self.address(operand, count);
        self.code().local_set(variable);
        Reference::Address(variable)
    }

    /// The numbers of a call go where the code of the program has them.
    fn pass_numbers(&mut self, call: &Call<'_>, lanes: &Lanes, frame: &Frame) {
        for (from, to) in call.numbers() {
            match lanes.get(to) {
                Lane::Variable(number) => {
                    self.get(from);
                    self.code().local_set(frame.variable(number));
                }
                _ => self.write_number(from, frame.numbers, to),
            }
        }
    }

    /// What the parameters by reference refer to goes where the interpreter looks for it.
    fn write_references(&mut self) {
        for (place, reference) in (0..).zip(std::mem::take(&mut self.frame.references)) {
            let at = whole_at(self.frame.places + place * 4);
            match reference {
                Some(Reference::Address(variable)) => {
                    self.code().local_get(local::PLACES).local_get(variable).i32_store(at);
                }
                Some(Reference::Variables(Variables { at: numbers, .. })) => {
                    self.code().local_get(local::PLACES);
                    self.code().local_get(local::BASE).i32_const(numbers.cast_signed()).i32_add().i32_store(at);
                }
                None => {}
            }
        }
    }
}
