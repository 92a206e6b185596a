//! The code of programs as part of the function that calls them.
//!
//! Such a program still has its frame behind that of the caller, with its lines, its share of the declared stack and
//! its record where it stops; but its numbers are variables of the function, and those that the caller passes by
//! reference are variables of the caller.

use val3_bytecode::Operand;
use wasm_encoder::ValType;

use crate::body::{Body, Label, whole_at};
use crate::bounds::Facts;
use crate::calls::Call;
use crate::flow::LineBefore;
use crate::frame::{Frame, Reference, Variables};
use crate::inline::Opening;
use crate::lanes::{Lane, Lanes};
use crate::local;
use crate::study::Study;

impl Body<'_> {
    /// The code of a program instead of its call.
    pub(crate) fn inline(&mut self, call: &Call<'_>) {
        self.open_block(Label::Ended);
        self.insert(call, None);
        self.close();
    }

    /// The opening of a program before the call of its function.
    pub(crate) fn inline_opening(&mut self, call: &Call<'_>, opening: Opening) {
        self.open_block(Label::Ended);
        self.open_block(Label::Step(opening.end));
        self.insert(call, Some(opening.end));
        self.close();
        self.give_back(opening.lines);
        self.call_function(call);
        self.close();
    }

    /// The code of a program that is called here, as far as the step `end`. Where it stops, so does this one.
    fn insert(&mut self, call: &Call<'_>, end: Option<u32>) {
        let levels = self.frame.levels.saturating_sub(1);
        let study = Study::of(self.module, call.callee, levels);
        let frame = self.frame_of(call, &study, levels);
        self.pass_numbers(call, &study.lanes, &frame);
        let mut body = Body {
            module: self.module,
            program: call.callee,
            number: call.number,
            study: &study,
            known: self.known,
            draft: self.draft,
            frame,
            labels: [Label::Ended].into_iter().chain(end.map(Label::Step)).collect(),
            step: self.step,
            line: LineBefore::Known(0),
            ahead: 0,
            entered: None,
            facts: Facts::new(),
        };
        body.begin_anew();
        body.steps(end);
        body.write_frame();
        body.write_references();
        self.stop_behind();
    }

    /// The frame of a program that is called here, with what it gets by reference.
    fn frame_of(&mut self, call: &Call<'_>, study: &Study, levels: u32) -> Frame {
        let size = &self.program.frame;
        let mut frame = Frame::new(study, levels, self.draft);
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
