//! The machine code of operations.

use val3_bytecode::{Op, Program, Register, Whole};
use wasm_encoder::Instruction;

use crate::arithmetic::{ADD, Comparison, EQUAL, LESS, LESS_EQUAL, MULTIPLY, NOT_EQUAL, SUBTRACT};
use crate::body::{Body, Surroundings};
use crate::calls::callee;
use crate::containers::can_refer;
use crate::operands::{container, located, registers};
use crate::rotation::Rotated;

/// Whether there is code for an operation, in the best case.
pub(crate) fn has_code(module: &Surroundings<'_>, program: &Program, op: Op) -> bool {
    match op {
        Op::Line | Op::Jump { .. } => true,
        Op::Return => program.is_plain(),
        Op::Call { .. } => callee(module, program, op).is_some(),
        _ => {
            let has_description = |whole| module.shared.description(whole).is_some();
            let can_refer = |(_, whole): (Register, Whole)| can_refer(whole.kind(), program, module.image);
            let is_known = registers(op).next().is_some() || located(op).is_some();
            is_known && container(op).is_none_or(has_description) && located(op).is_none_or(can_refer)
        }
    }
}

impl Body<'_> {
    /// The code of the step at hand. Whether the step behind it is never reached from it.
    pub(crate) fn operation(&mut self) -> bool {
        let (step, number) = self.step;
        if !has_code(self.module, self.program, step.op) {
            self.stop_at(number);
            return true;
        }
        self.begin_line();
        match step.op {
            Op::Jump { to } => match Rotated::at(&self.program.code, number) {
                Some(rotated) => self.rotate(rotated),
                None => {
                    self.jump(to);
                    return true;
                }
            },
            Op::Return => {
                self.end_program();
                return true;
            }
            Op::Call { .. } => self.call(),
            op => self.numbers(op),
        }
        false
    }

    fn numbers(&mut self, op: Op) {
        match op {
            Op::JumpUnless { condition, to } => {
                self.truth(condition);
                self.jump_unless(to);
            }
            Op::JumpIf { condition, to } => {
                self.truth(condition);
                self.jump_if(to);
            }
            Op::WaitUntil { condition, .. } => {
                self.truth(condition);
                self.unless(Self::leave_it);
            }
            Op::IfLess { a, b, to } => self.branch(a, b, &LESS, to),
            Op::IfLessEqual { a, b, to } => self.branch(a, b, &LESS_EQUAL, to),
            Op::UnlessLess { a, b, to } => self.branch_unless(a, b, &LESS, to),
            Op::UnlessLessEqual { a, b, to } => self.branch_unless(a, b, &LESS_EQUAL, to),
            Op::UnlessEqual { a, b, to } => self.branch(a, b, &NOT_EQUAL, to),
            Op::IfEqual { a, b, to } => self.branch(a, b, &EQUAL, to),
            Op::Move { to, from } => self.copy(to, from),
            Op::Negate { to, a } => self.set(to, |body| {
                body.get(a);
                body.code().f64_neg();
            }),
            Op::Not { to, a } => self.set_truth(to, |body| {
                body.truth(a);
                body.code().i32_eqz();
            }),
            Op::Add { to, a, b } => self.compute_either(to, (a, b), &ADD),
            Op::Subtract { to, a, b } => self.compute_either(to, (a, b), &SUBTRACT),
            Op::Multiply { to, a, b } => {
                self.check_factors(to, a, b);
                self.compute_either(to, (a, b), &MULTIPLY);
            }
            Op::Divide { to, a, b } => self.divide(to, a, b),
            Op::Remainder { to, a, b } => self.remainder(to, a, b),
            Op::Function { function, to, a, b, c } => self.function(function, to, [a, b, c]),
            Op::Less { to, a, b } => self.set_truth(to, |body| body.compare(a, b, &LESS)),
            Op::LessEqual { to, a, b } => self.set_truth(to, |body| body.compare(a, b, &LESS_EQUAL)),
            Op::Equal { to, a, b } => self.set_truth(to, |body| body.compare(a, b, &EQUAL)),
            Op::NotEqual { to, a, b } => self.set_truth(to, |body| body.compare(a, b, &NOT_EQUAL)),
            Op::Load { to, place, lane } => self.load_referred(to, place, lane),
            Op::Store { place, lane, from } => self.store_referred(place, lane, from),
            Op::ForTest { counter, limit, exit } => {
                self.is_beyond(counter, limit);
                self.jump_if(exit);
            }
            Op::ForNext { counter, limit, body } => {
                self.compute_either(counter, (counter, limit + 1), &ADD);
                self.is_beyond(counter, limit);
                self.jump_unless(body);
            }
            Op::ForNextUp { counter, limit, body } => self.next_up(counter, limit, body),
            _ => self.containers(op),
        }
    }

    pub(crate) fn all(&mut self, act: &[Instruction<'static>]) {
        for instruction in act {
            self.add(instruction);
        }
    }

    fn branch(&mut self, a: Register, b: Register, comparison: &Comparison, to: u32) {
        self.compare(a, b, comparison);
        self.jump_if(to);
    }

    pub(crate) fn branch_unless(&mut self, a: Register, b: Register, comparison: &Comparison, to: u32) {
        self.compare(a, b, comparison);
        self.jump_unless(to);
    }
}
