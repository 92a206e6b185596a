//! Instructions that make a number of numbers: a few are operations of the machine, the others a function of the host.

use val3_bytecode::Register;
use val3_lang::number_functions::NumberFunction;
use wasm_encoder::ValType;

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

/// The first function of the module itself.
pub(crate) const FIRST: u32 = IMPORTED + 1;

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
        let [a, ..] = arguments;
        match function {
            NumberFunction::Abs => self.set(to, |body| {
                body.get(a);
                body.code().f64_abs();
            }),
            NumberFunction::Sqrt => {
                self.get(a);
                self.code().f64_const(0.0.into()).f64_lt();
                self.when(Self::leave_it);
                self.set(to, |body| {
                    body.get(a);
                    body.code().f64_sqrt();
                });
            }
            // Zero has no sign.
            NumberFunction::RoundDown => self.set(to, |body| {
                body.get(a);
                body.code().f64_floor().f64_const(0.0.into()).f64_add();
            }),
            NumberFunction::RoundUp => self.set(to, |body| {
                body.get(a);
                body.code().f64_ceil().f64_const(0.0.into()).f64_add();
            }),
            _ => self.of_the_host(function, to, arguments),
        }
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
