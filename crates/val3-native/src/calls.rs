//! Programs that call others and return to them (2.6).

use val3_bytecode::{Op, Operand, Pass, Program, ProgramRef};
use val3_lang::memory;
use wasm_encoder::ValType::{self, F64, I32};

use crate::body::{Body, Surroundings, number_at, whole_at};
use crate::functions::FIRST;
use crate::lanes::Lanes;
use crate::layout::NUMBERS;
use crate::local;

/// What a function is given and what it gives: [`local`] tells the parameters; whether the program has stopped, and
/// the lines that are left.
pub(crate) const SIGNATURE: ([ValType; 8], [ValType; 2]) = ([I32, I32, I32, I32, F64, F64, F64, F64], [I32; 2]);

/// A call between programs with machine code.
pub(crate) struct Call<'p> {
    callee: &'p Program,
    function: u32,
    passes: &'p [Pass],
}

/// The program that an operation calls, if both have machine code.
pub(crate) fn callee<'m>(module: &Surroundings<'m>, program: &'m Program, op: Op) -> Option<Call<'m>> {
    let (passes, number) = plain_call(op, program)?;
    let function = FIRST as usize + module.programs.iter().position(|known| *known == number)?;
    let callee = module.image.programs.get(usize::from(number)).filter(|callee| takes_numbers(callee))?;
    Some(Call { callee, function: u32::try_from(function).ok()?, passes })
}

impl Body<'_> {
    /// The frame of the program is behind this one; where there is no room for it, the interpreter raises the error.
    pub(crate) fn call(&mut self) {
        let Some(Call { callee, function, passes }) = callee(self.module, self.program, self.step.0.op) else { return };
        let size = &self.program.frame;
        let (numbers, places) = (size.lanes.num * 8, size.places * 4);
        let taken = callee.stack_bytes.cast_signed();
        self.code().local_get(local::ROOM).i32_const(taken).i32_lt_u();
        self.when(Self::leave_it);
        for pass in passes {
            if let Pass::Reference(Operand::Place(place, _), _) = pass {
                self.referred(*place);
            }
        }
        let lanes = Lanes::of(callee, self.module.image);
        self.write_arguments(passes, &lanes);
        self.code().local_get(local::BASE).i32_const(numbers.cast_signed()).i32_add();
        self.code().local_get(local::PLACES).i32_const(places.cast_signed()).i32_add();
        self.code().local_get(local::ROOM).i32_const(taken).i32_sub();
        self.code().local_get(local::BUDGET);
        self.give_arguments(passes, &lanes);
        self.code().call(function).local_set(local::BUDGET);
        let (_, number) = self.step;
        self.when(|body| body.stop_at(number + 1));
    }

    /// References, and numbers that are no parameters of the function, go to the frame of the program that is called,
    /// which has `lanes`.
    fn write_arguments(&mut self, passes: &[Pass], lanes: &Lanes) {
        let size = &self.program.frame;
        let (numbers, places) = (size.lanes.num * 8, size.places * 4);
        for pass in passes {
            match *pass {
                Pass::Number(_, to) if lanes.parameter(to).is_some() => {}
                Pass::Number(from, to) => {
                    self.code().local_get(local::BASE);
                    self.get(from);
                    let mut at = number_at(to);
                    at.offset += u64::from(numbers);
                    self.code().f64_store(at);
                }
                Pass::Reference(from, to) => {
                    self.code().local_get(local::PLACES);
                    self.address(from);
                    self.code().i32_store(whole_at(places + to * 4));
                }
            }
        }
    }

    /// The numbers that are parameters of the function come in their order.
    fn give_arguments(&mut self, passes: &[Pass], lanes: &Lanes) {
        for parameter in 0..local::NUMBERS_GIVEN {
            let given = passes.iter().find_map(|pass| match *pass {
                Pass::Number(from, to) => (lanes.parameter(to) == Some(parameter)).then_some(from),
                Pass::Reference(..) => None,
            });
            match given {
                Some(from) => self.get(from),
                None => _ = self.code().f64_const(0.0.into()),
            }
        }
    }

    /// The address of the numbers of a value.
    fn address(&mut self, operand: Operand) {
        let lanes = match operand {
            Operand::Frame(lanes) => {
                self.code().local_get(local::BASE);
                lanes
            }
            Operand::Place(place, lanes) => {
                self.code().local_get(local::PLACES).i32_load(whole_at(u32::from(place) * 4));
                lanes
            }
        };
        self.code().i32_const((lanes.num * 8).cast_signed()).i32_add();
    }

    /// The program ends. Where its frame may be the first of the task, the interpreter ends the task.
    pub(crate) fn end_program(&mut self) {
        self.code().local_get(local::BASE).i32_const(NUMBERS.cast_signed()).i32_eq();
        self.when(Self::leave_it);
        self.code().i32_const(0).local_get(local::BUDGET).return_();
    }
}

/// What a program gets by reference has nothing but numbers.
fn takes_numbers(program: &Program) -> bool {
    program.params.iter().all(|param| param.kind.size == memory::Lanes::nums(param.kind.size.num))
}

/// A call that needs nothing but numbers and references: what it passes, and the number of the program.
pub(crate) fn plain_call(op: Op, program: &Program) -> Option<(&[Pass], u16)> {
    let Op::Call { site } = op else { return None };
    let site = program.calls.get(site as usize)?;
    match (site.program, &site.passes) {
        (ProgramRef::Own(number), Some(passes)) => Some((passes, number)),
        _ => None,
    }
}
