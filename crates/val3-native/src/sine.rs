//! Sine and cosine as functions of a module: the computation of [`val3_geometry::sine`], written down instead of done.

use std::cell::RefCell;
use std::ops::{Add, Mul, Sub};

use val3_geometry::sine::{HEAD, Real, sine_of};
use wasm_encoder::{Function, InstructionSink, ValType};

/// What such a function is given and what it gives.
pub(crate) const SINE_OF: ([ValType; 1], [ValType; 1]) = ([ValType::F64], [ValType::F64]);

/// The sine of an angle in degrees, of fewer turns than [`MANY_TURNS`](val3_geometry::sine::MANY_TURNS), so many
/// quarters of a turn further on.
pub(crate) fn sine(ahead: u64) -> Function {
    let steps = Steps(RefCell::new(vec![Step::Given]));
    sine_of(Term { steps: &steps, at: 0 }, ahead);
    let steps = steps.0.into_inner();
    let last = number(steps.len()) - 1;
    let mut function = Function::new([(last, ValType::F64)]);
    let mut code = function.instructions();
    for (step, at) in steps.iter().zip(0..).skip(1) {
        step.write(&mut code);
        code.local_set(at);
    }
    code.local_get(last).end();
    function
}

/// The steps of a computation; the number of each is that of the variable with its result.
struct Steps(RefCell<Vec<Step>>);

/// A step, with the numbers of those whose results it takes.
#[derive(Debug, Clone, Copy)]
enum Step {
    Given,
    Constant(f64),
    Add(u32, u32),
    Subtract(u32, u32),
    Multiply(u32, u32),
    Head(u32),
    SineAfter { quarters: u32, ahead: u64, sin: u32, cos: u32 },
}

/// The result of a step.
#[derive(Clone, Copy)]
struct Term<'s> {
    steps: &'s Steps,
    at: u32,
}

impl Steps {
    fn then(&self, step: Step) -> Term<'_> {
        let mut steps = self.0.borrow_mut();
        steps.push(step);
        Term { steps: self, at: number(steps.len()) - 1 }
    }
}

fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

impl Step {
    fn write(self, code: &mut InstructionSink<'_>) {
        match self {
            Self::Given => {}
            Self::Constant(value) => _ = code.f64_const(value.into()),
            Self::Add(a, b) => _ = code.local_get(a).local_get(b).f64_add(),
            Self::Subtract(a, b) => _ = code.local_get(a).local_get(b).f64_sub(),
            Self::Multiply(a, b) => _ = code.local_get(a).local_get(b).f64_mul(),
            Self::Head(a) => {
                code.local_get(a).i64_reinterpret_f64().i64_const(HEAD.cast_signed()).i64_and().f64_reinterpret_i64();
            }
            Self::SineAfter { quarters, ahead, sin, cos } => {
                let ahead = ahead.cast_signed();
                code.local_get(sin).local_get(cos);
                code.local_get(quarters).i64_reinterpret_f64().i64_const(ahead).i64_add();
                code.i64_const(1).i64_and().i64_eqz().select().i64_reinterpret_f64();
                code.local_get(quarters).i64_reinterpret_f64().i64_const(ahead).i64_add();
                code.i64_const(2).i64_and().i64_const(62).i64_shl().i64_xor().f64_reinterpret_i64();
            }
        }
    }
}

impl Real for Term<'_> {
    fn head(self) -> Self {
        self.steps.then(Step::Head(self.at))
    }

    fn sine_after(self, ahead: u64, sin: Self, cos: Self) -> Self {
        self.steps.then(Step::SineAfter { quarters: self.at, ahead, sin: sin.at, cos: cos.at })
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident $step:ident;)+) => {$(
        impl $operator for Term<'_> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                self.steps.then(Step::$step(self.at, other.at))
            }
        }

        impl $operator<f64> for Term<'_> {
            type Output = Self;

            fn $method(self, other: f64) -> Self {
                self.$method(self.steps.then(Step::Constant(other)))
            }
        }
    )+};
}

operators! {
    Add add Add;
    Sub sub Subtract;
    Mul mul Multiply;
}
