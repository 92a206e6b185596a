//! Numbers that become others, and comparisons: of whole numbers where all of them are there as such.

use val3_bytecode::Register;
use wasm_encoder::Instruction::{
    self, F64Add, F64Eq, F64Gt, F64Le, F64Lt, F64Mul, F64Ne, F64Sub, I64Add, I64Eq, I64GtS, I64LeS, I64LtS, I64Mul,
    I64Ne, I64Sub,
};

use crate::body::Body;
use crate::bounds::Bounds;
use crate::lanes::Lane;
use crate::local;
use crate::sorts::Sort;

type Plain = Instruction<'static>;

/// How numbers are compared, and how whole numbers.
pub(crate) type Comparison = (Plain, Plain);

/// How numbers become another, whole numbers, and their bounds.
pub(crate) struct Arithmetic {
    numbers: Plain,
    whole: Plain,
    bounds: fn(Bounds, Bounds) -> Bounds,
}

pub(crate) const ADD: Arithmetic = Arithmetic { numbers: F64Add, whole: I64Add, bounds: |a, b| a + b };
pub(crate) const SUBTRACT: Arithmetic = Arithmetic { numbers: F64Sub, whole: I64Sub, bounds: |a, b| a - b };
pub(crate) const MULTIPLY: Arithmetic = Arithmetic { numbers: F64Mul, whole: I64Mul, bounds: |a, b| a * b };

pub(crate) const LESS: Comparison = (F64Lt, I64LtS);
pub(crate) const LESS_EQUAL: Comparison = (F64Le, I64LeS);
pub(crate) const GREATER: Comparison = (F64Gt, I64GtS);
pub(crate) const EQUAL: Comparison = (F64Eq, I64Eq);
pub(crate) const NOT_EQUAL: Comparison = (F64Ne, I64Ne);

impl Body<'_> {
    pub(crate) fn compare(&mut self, a: Register, b: Register, (of_numbers, of_whole): &Comparison) {
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

    pub(crate) fn copy(&mut self, to: Register, from: Register) {
        if let (Sort::Whole, Some(bounds)) = (self.sort(to), self.bounds(from)) {
            self.set_whole(to, bounds, |body| body.whole(from));
        } else {
            self.set(to, |body| body.get(from));
        }
    }

    /// Computes with numbers, or with whole numbers where the result is there as one.
    pub(crate) fn compute_either(&mut self, to: Register, (a, b): (Register, Register), how: &Arithmetic) {
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
    pub(crate) fn check_factors(&mut self, to: Register, a: Register, b: Register) {
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
    pub(crate) fn next_up(&mut self, counter: Register, limit: Register, body: u32) {
        if self.sort(counter) != Sort::Whole || !self.is_whole(limit) {
            self.compute_either(counter, (counter, limit + 1), &ADD);
            self.branch_unless(counter, limit, &GREATER, body);
            return;
        }
        let most = self.study.sorts.bounds(counter).most();
        self.step_counter(counter, limit + 1, &I64Add);
        self.facts.remove(&counter);
        self.compare(counter, limit, &LESS_EQUAL);
        self.jump_if(body);
        self.whole(counter);
        self.code().i64_const(most).i64_gt_s();
        self.when(|code| {
            code.step_counter(counter, limit + 1, &I64Sub);
            code.leave_it();
        });
    }

    /// The counter of a `for` goes a step on, or back.
    fn step_counter(&mut self, counter: Register, step: Register, way: &Plain) {
        self.whole(counter);
        match self.study.lanes.get(step) {
            Lane::Constant(1.0) => self.one(),
            _ => self.whole(step),
        }
        self.add(way);
        self.code().local_set(local::COLUMN);
        self.keep_whole(counter);
    }

    /// Whether the counter of a `for` has passed its limit; the step is the number behind the limit.
    pub(crate) fn is_beyond(&mut self, counter: Register, limit: Register) {
        self.compare(counter, limit, &LESS);
        self.compare(counter, limit, &GREATER);
        self.get(limit + 1);
        self.code().f64_const(0.0.into()).f64_lt().select();
    }
}
