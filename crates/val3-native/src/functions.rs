//! Instructions that make a number of numbers: a few are operations of the machine, sine and cosine functions of the
//! module, the others a function of the host.

use val3_bytecode::{Op, Register};
use val3_geometry::sine::MANY_TURNS;
use val3_lang::number_functions::NumberFunction;
use wasm_encoder::Instruction::{
    self, F64Abs, F64Add, F64Ceil, F64Const, F64Floor, F64Gt, F64Lt, F64Ne, F64Sqrt, I32And, I32Or, I32Xor, Select,
};
use wasm_encoder::{Ieee64, ValType};

use crate::body::Body;
use crate::local;

/// The name of what a module imports.
pub(crate) const HOST: &str = "compute";

/// What the function of the host is given and what it gives: the number of the function, and its arguments; what it
/// makes of them, and whether that is an error.
pub(crate) const COMPUTE: ([ValType; 4], [ValType; 2]) =
    ([ValType::I32, ValType::F64, ValType::F64, ValType::F64], [ValType::F64, ValType::I32]);

/// The function of the host comes before those of the module.
const IMPORTED: u32 = 0;

/// The function of the first program. Sine and cosine are behind the last, in modules that have them.
pub(crate) const FIRST: u32 = IMPORTED + 1;

/// Whether an operation needs sine or cosine.
pub(crate) fn is_of_angle(op: Op) -> bool {
    matches!(op, Op::Function { function: NumberFunction::Sin | NumberFunction::Cos, .. })
}

const ZERO: Instruction<'static> = F64Const(Ieee64::new(0));

/// The function of the host.
pub(crate) fn compute(function: u32, a: f64, b: f64, c: f64) -> (f64, u32) {
    match NumberFunction::numbered(function).map(|function| function.compute([a, b, c])) {
        Some(Ok(number)) => (number, 0),
        _ => (0.0, 1),
    }
}

impl Body<'_> {
    /// What is an error is left to the interpreter, which raises it.
    pub(crate) fn function(&mut self, function: NumberFunction, to: Register, arguments: [Register; 3]) {
        let [a, b, c] = arguments;
        match function {
            NumberFunction::Abs => self.of_one(to, a, &[F64Abs]),
            NumberFunction::RoundDown => self.of_one(to, a, &[F64Floor, ZERO, F64Add]),
            NumberFunction::RoundUp => self.of_one(to, a, &[F64Ceil, ZERO, F64Add]),
            NumberFunction::Sqrt => {
                self.get(a);
                self.all(&[ZERO, F64Lt]);
                self.when(Self::leave_it);
                self.of_one(to, a, &[F64Sqrt]);
            }
            NumberFunction::Round => self.set(to, |body| body.rounded(a)),
            NumberFunction::And => self.of_bits(to, (a, b), I32And),
            NumberFunction::Or => self.of_bits(to, (a, b), I32Or),
            NumberFunction::Xor => self.of_bits(to, (a, b), I32Xor),
            NumberFunction::Min => self.either(to, (a, b), F64Lt),
            NumberFunction::Max => self.either(to, (a, b), F64Gt),
            NumberFunction::Sel => self.set(to, |body| {
                body.get(b);
                body.get(c);
                body.get(a);
                body.all(&[ZERO, F64Ne, Select]);
            }),
            NumberFunction::Sin => self.of_angle(to, a, 0),
            NumberFunction::Cos => self.of_angle(to, a, 1),
            _ => self.of_the_host(function, to, arguments),
        }
    }

    fn of_one(&mut self, to: Register, a: Register, act: &[Instruction<'static>]) {
        self.set(to, |body| {
            body.get(a);
            body.all(act);
        });
    }

    /// An angle of very many turns is left to the interpreter.
    fn of_angle(&mut self, to: Register, a: Register, behind_sine: u32) {
        let programs = u32::try_from(self.module.programs.len()).unwrap_or(u32::MAX);
        let function = FIRST.saturating_add(programs).saturating_add(behind_sine);
        self.get(a);
        self.code().f64_abs().f64_const(MANY_TURNS.into()).f64_lt();
        self.unless(Self::leave_it);
        self.set(to, |body| {
            body.get(a);
            body.code().call(function);
        });
    }

    /// The second number if it compares so with the first, or if the first is no number; else the first.
    fn either(&mut self, to: Register, (a, b): (Register, Register), compare: Instruction<'static>) {
        self.set(to, |body| {
            for register in [b, a, b, a] {
                body.get(register);
            }
            body.add(&compare);
            for register in [a, a] {
                body.get(register);
            }
            body.all(&[F64Ne, I32Or, Select]);
        });
    }

    fn of_bits(&mut self, to: Register, (a, b): (Register, Register), act: Instruction<'static>) {
        self.set(to, |body| {
            for register in [a, b] {
                body.rounded(register);
                body.code().i32_trunc_sat_f64_u();
            }
            body.add(&act);
            body.code().f64_convert_i32_u();
        });
    }

    /// The nearest whole number, of two the larger; without a sign if it is zero.
    fn rounded(&mut self, register: Register) {
        self.get(register);
        self.code().f64_floor().local_tee(local::A).f64_const(1.0.into()).f64_add().local_get(local::A);
        self.get(register);
        self.code().local_get(local::A).f64_sub().f64_const(0.5.into()).f64_ge();
        self.all(&[Select, ZERO, F64Add]);
    }

    fn of_the_host(&mut self, function: NumberFunction, to: Register, arguments: [Register; 3]) {
        self.code().i32_const(function.number().cast_signed());
        for argument in arguments {
            self.get(argument);
        }
        self.code().call(IMPORTED).local_set(local::I).local_set(local::A).local_get(local::I);
        self.when(Self::leave_it);
        self.set(to, |body| {
            body.code().local_get(local::A);
        });
    }
}
