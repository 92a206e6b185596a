//! The machine code of operations.

use val3_bytecode::{Op, Program, Register, Whole};
use wasm_encoder::Instruction;
use wasm_encoder::Instruction::{
    F64Add, F64Div, F64Eq, F64Gt, F64Le, F64Lt, F64Mul, F64Ne, F64Sub, I64Add, I64Eq, I64GtS, I64LeS, I64LtS, I64Mul,
    I64Ne, I64Sub,
};

use crate::body::{Body, Surroundings};
use crate::bounds::Bounds;
use crate::calls::callee;
use crate::containers::can_refer;
use crate::lanes::Lane;
use crate::local;
use crate::operands::{container, located, registers};
use crate::rotation::Rotated;
use crate::sorts::Sort;

/// Instructions on what is on the stack.
type Act = &'static [Instruction<'static>];

type Plain = Instruction<'static>;

/// How numbers are compared, and how whole numbers.
type Comparison = (Plain, Plain);

/// How numbers become another, whole numbers, and their bounds.
struct Arithmetic {
    numbers: Plain,
    whole: Plain,
    bounds: fn(Bounds, Bounds) -> Bounds,
}

const ADD: Arithmetic = Arithmetic { numbers: F64Add, whole: I64Add, bounds: |a, b| a + b };
const SUBTRACT: Arithmetic = Arithmetic { numbers: F64Sub, whole: I64Sub, bounds: |a, b| a - b };
const MULTIPLY: Arithmetic = Arithmetic { numbers: F64Mul, whole: I64Mul, bounds: |a, b| a * b };

const LESS: Comparison = (F64Lt, I64LtS);
const LESS_EQUAL: Comparison = (F64Le, I64LeS);
const GREATER: Comparison = (F64Gt, I64GtS);
const EQUAL: Comparison = (F64Eq, I64Eq);
const NOT_EQUAL: Comparison = (F64Ne, I64Ne);

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

    fn is_zero(&mut self, register: Register) {
        self.get(register);
        self.code().f64_const(0.0.into()).f64_eq();
    }

    fn branch(&mut self, a: Register, b: Register, comparison: &Comparison, to: u32) {
        self.compare(a, b, comparison);
        self.jump_if(to);
    }

    fn branch_unless(&mut self, a: Register, b: Register, comparison: &Comparison, to: u32) {
        self.compare(a, b, comparison);
        self.jump_unless(to);
    }

    fn compare(&mut self, a: Register, b: Register, (of_numbers, of_whole): &Comparison) {
        if self.is_whole(a) && self.is_whole(b) {
            self.whole(a);
            self.whole(b);
            self.add(of_whole);
        } else {
            self.get(a);
            self.get(b);
            self.add(of_numbers);
        }
    }

    fn copy(&mut self, to: Register, from: Register) {
        if let (Sort::Whole, Some(bounds)) = (self.sort(to), self.bounds(from)) {
            self.set_whole(to, bounds, |body| body.whole(from));
        } else {
            self.set(to, |body| body.get(from));
        }
    }

    /// Computes with numbers, or with whole numbers where the result is there as one.
    fn compute_either(&mut self, to: Register, (a, b): (Register, Register), how: &Arithmetic) {
        let Arithmetic { numbers, whole, bounds } = how;
        if let (Sort::Whole, Some(one), Some(other)) = (self.sort(to), self.bounds(a), self.bounds(b)) {
            self.set_whole(to, bounds(one, other), |body| {
                body.whole(a);
                body.whole(b);
                body.add(whole);
            });
        } else {
            self.set(to, |body| {
                body.get(a);
                body.get(b);
                body.add(numbers);
            });
        }
    }

    /// Factors of more than 32 bits whose product may be too large, and those whose product may be the negative zero,
    /// are left to the interpreter.
    fn check_factors(&mut self, to: Register, a: Register, b: Register) {
        let (Sort::Whole, Some(one), Some(other)) = (self.sort(to), self.bounds(a), self.bounds(b)) else { return };
        if !(one * other).are_exact() {
            for factor in [a, b] {
                self.whole(factor);
                self.code().i64_extend32_s();
                self.whole(factor);
                self.code().i64_ne();
            }
            self.code().i32_or();
            self.when(Self::leave_it);
        }
        if !(one.are_positive() && other.are_positive()) {
            for (zero, negative) in [(a, b), (b, a)] {
                self.whole(zero);
                self.code().i64_eqz();
                self.whole(negative);
                self.code().i64_const(0).i64_lt_s().i32_and();
            }
            self.code().i32_or();
            self.when(Self::leave_it);
        }
    }

    /// The next round of a `for` that counts up. What is within its limit is within all bounds.
    fn next_up(&mut self, counter: Register, limit: Register, body: u32) {
        if self.sort(counter) != Sort::Whole || !self.is_whole(limit) {
            self.compute_either(counter, (counter, limit + 1), &ADD);
            self.branch_unless(counter, limit, &GREATER, body);
            return;
        }
        let most = self.study.sorts.bounds(counter).most();
        self.whole(counter);
        self.whole(limit + 1);
        self.code().i64_add().local_tee(local::COLUMN);
        self.whole(limit);
        self.code().i64_gt_s();
        self.facts.remove(&counter);
        self.when_else(
            |code| {
                code.code().local_get(local::COLUMN).i64_const(most).i64_gt_s();
                code.when(Self::leave_it);
                code.keep_whole(counter);
            },
            |code| {
                code.keep_whole(counter);
                code.jump(body);
            },
        );
    }

    fn compute(&mut self, to: Register, (a, b): (Register, Register), act: Act) {
        self.set(to, |body| {
            body.get(a);
            body.get(b);
            body.all(act);
        });
    }

    /// Whether the counter of a `for` has passed its limit; the step is the number behind the limit.
    fn is_beyond(&mut self, counter: Register, limit: Register) {
        self.compare(counter, limit, &LESS);
        self.compare(counter, limit, &GREATER);
        self.get(limit + 1);
        self.code().f64_const(0.0.into()).f64_lt().select();
    }

    /// To divide by a power of two is to multiply with its inverse, to the last bit.
    fn divide(&mut self, to: Register, a: Register, b: Register) {
        match self.study.lanes.get(b) {
            Lane::Constant(divisor) if is_power_of_two(divisor) => self.set(to, |body| {
                body.get(a);
                body.code().f64_const((1.0 / divisor).into()).f64_mul();
            }),
            Lane::Constant(divisor) if divisor != 0.0 => self.compute(to, (a, b), &[F64Div]),
            _ => {
                self.is_zero(b);
                self.when(Self::leave_it);
                self.compute(to, (a, b), &[F64Div]);
            }
        }
    }

    /// The remainder by a whole number: that of the whole part, and the fraction, which is exact. Others, and those of
    /// numbers that are no `i32`, are left to the interpreter.
    fn remainder(&mut self, to: Register, a: Register, b: Register) {
        match self.study.lanes.get(b) {
            Lane::Constant(divisor) if is_whole(divisor) && divisor != 0.0 => {
                if self.study.whole.has(a) {
                    self.whole_remainder_by(to, a, divisor.abs());
                } else {
                    self.remainder_by(to, a, divisor.abs());
                }
            }
            _ => self.remainder_of(to, a, b),
        }
    }

    /// The remainder by a constant, without a division: half a unit more than the whole part, times the inverse, lies
    /// between the quotient and the next, far from both where neither number has more than 31 bits.
    fn remainder_by(&mut self, to: Register, a: Register, divisor: f64) {
        self.get(a);
        self.code().f64_abs().local_tee(local::B).f64_trunc().local_tee(local::A);
        self.code().f64_const(f64::from(i32::MAX).into()).f64_le();
        self.unless(Self::leave_it);
        self.set(to, |body| {
            body.left_by(divisor);
            body.code().local_get(local::B).local_get(local::A).f64_sub().f64_add();
            body.get(a);
            body.code().f64_copysign();
        });
    }

    /// The same where there is no fraction.
    fn whole_remainder_by(&mut self, to: Register, a: Register, divisor: f64) {
        self.get(a);
        self.code().f64_abs().local_tee(local::A).f64_const(f64::from(i32::MAX).into()).f64_le();
        self.unless(Self::leave_it);
        self.set(to, |body| {
            body.left_by(divisor);
            body.get(a);
            body.code().f64_copysign();
        });
    }

    /// What is left of the whole number in a variable.
    fn left_by(&mut self, divisor: f64) {
        self.code().local_get(local::A);
        self.code().local_get(local::A).f64_const(0.5.into()).f64_add().f64_const((1.0 / divisor).into()).f64_mul();
        self.code().f64_trunc().f64_const(divisor.into()).f64_mul().f64_sub();
    }

    /// The remainder by a number that is known when it is computed. The one by -1 may leave the range.
    fn remainder_of(&mut self, to: Register, a: Register, b: Register) {
        self.get(b);
        self.code().i32_trunc_sat_f64_s().local_tee(local::J).f64_convert_i32_s();
        self.get(b);
        self.code().f64_ne();
        // 0 and -1.
        self.code().local_get(local::J).i32_const(1).i32_add().i32_const(2).i32_lt_u().i32_or();
        self.when(Self::leave_it);
        self.get(a);
        self.code().i32_trunc_sat_f64_s().local_tee(local::I).f64_convert_i32_s().local_tee(local::A);
        self.get(a);
        self.code().f64_trunc().f64_ne();
        self.when(Self::leave_it);
        self.set(to, |body| {
            body.code().local_get(local::I).local_get(local::J).i32_rem_s().f64_convert_i32_s();
            body.get(a);
            body.code().local_get(local::A).f64_sub().f64_add().f64_abs();
            body.get(a);
            body.code().f64_copysign();
        });
    }
}

/// An `i32`.
fn is_whole(number: f64) -> bool {
    number.trunc() == number && number.abs() <= f64::from(i32::MAX)
}

/// A number whose inverse is exact.
fn is_power_of_two(number: f64) -> bool {
    const FRACTION: u64 = (1 << 52) - 1;
    number.to_bits() & FRACTION == 0 && number.is_normal() && (1.0 / number).is_normal()
}

#[cfg(test)]
mod tests {
    use super::{is_power_of_two, is_whole};

    #[test]
    fn numbers_with_an_exact_inverse() {
        for number in [1.0, 2.0, -2.0, 0.5, 1024.0, f64::MIN_POSITIVE * 4.0] {
            assert!(is_power_of_two(number), "{number}");
        }
        for number in [0.0, -0.0, 3.0, 0.1, f64::INFINITY, f64::NAN, f64::MIN_POSITIVE / 2.0, f64::MAX] {
            assert!(!is_power_of_two(number), "{number}");
        }
    }

    #[test]
    fn whole_numbers() {
        assert!([0.0, 3.0, -3.0, 2_147_483_647.0].into_iter().all(is_whole));
        assert!(![0.5, 2_147_483_648.0, f64::NAN, f64::NEG_INFINITY].into_iter().any(is_whole));
    }
}
