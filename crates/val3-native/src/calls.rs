//! Programs that call others and return to them (2.6).

use val3_bytecode::{Op, Operand, Pass, Program, ProgramRef, Register};
use val3_lang::memory;
use wasm_encoder::ValType::{self, F64, I32};

use crate::body::{Body, Label, Surroundings, number_at, whole_at};
use crate::functions::FIRST;
use crate::inline::{self, Becomes};
use crate::lanes::Lanes;
use crate::layout::NUMBERS;
use crate::local;

/// What a function is given and what it gives: [`local`] tells the parameters; whether the program has stopped, and
/// the lines that are left.
pub(crate) const SIGNATURE: ([ValType; 8], [ValType; 2]) = ([I32, I32, I32, I32, F64, F64, F64, F64], [I32; 2]);

/// A call between programs with machine code.
pub(crate) struct Call<'p> {
    /// The program that is called, and its number in the image.
    pub(crate) callee: &'p Program,
    pub(crate) number: u16,
    function: u32,
    pub(crate) passes: &'p [Pass],
}

impl<'p> Call<'p> {
    /// The numbers that it passes by value: their registers in the caller, and in the program.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = (Register, Register)> + 'p {
        self.passes.iter().filter_map(|pass| match *pass {
            Pass::Number(from, to) => Some((from, to)),
            Pass::Reference(..) => None,
        })
    }

    /// What it passes by reference: the value of the caller, how many numbers it has, and the place in the program.
    pub(crate) fn references(&self) -> impl Iterator<Item = (Operand, u32, u32)> + 'p {
        self.callee.params.iter().zip(self.passes).filter_map(|(param, pass)| match *pass {
            Pass::Number(..) => None,
            Pass::Reference(from, to) => Some((from, param.kind.size.num, to)),
        })
    }
}

/// The program that an operation calls, if both have machine code.
pub(crate) fn callee<'m>(module: &Surroundings<'m>, program: &'m Program, op: Op) -> Option<Call<'m>> {
    let (passes, number) = plain_call(op, program)?;
    let function = FIRST as usize + module.programs.iter().position(|known| *known == number)?;
    let callee = module.image.programs.get(usize::from(number)).filter(|callee| takes_numbers(callee))?;
    Some(Call { callee, number, function: u32::try_from(function).ok()?, passes })
}

impl Body<'_> {
    /// The frame of the program is behind this one; where there is no room for it, the interpreter raises the error.
    ///
    /// Where a call becomes the code of what it calls, the room is for all calls in there, which do not ask again.
    pub(crate) fn call(&mut self) {
        let Some(call) = callee(self.module, self.program, self.step.0.op) else { return };
        for pass in call.passes {
            if let Pass::Reference(Operand::Place(place, _), _) = pass
                && self.frame.reference(u32::from(*place)).is_none()
            {
                self.referred(*place);
            }
        }
        match call.becomes(self.frame.levels) {
            Becomes::Function => {
                self.check_room(&call);
                self.call_function(&call);
            }
            Becomes::Opening(opening) => {
                self.check_room(&call);
                self.inline_opening(&call, opening);
            }
            Becomes::Code if self.frame.is_inlined() => self.inline(&call),
            Becomes::Code => {
                let most = inline::most_taken(self.module, &call, self.frame.levels);
                self.code().local_get(local::ROOM).i32_const(most.cast_signed()).i32_lt_u();
                self.when_else(
                    |body| {
                        body.check_room(&call);
                        body.call_function(&call);
                    },
                    |body| body.inline(&call),
                );
            }
        }
    }

    /// Where there is no room for a frame, the interpreter raises the error.
    fn check_room(&mut self, call: &Call<'_>) {
        if !self.frame.is_inlined() {
            self.code().local_get(local::ROOM).i32_const(call.callee.stack_bytes.cast_signed()).i32_lt_u();
            self.when(Self::leave_it);
        }
    }

    /// The call of the function of a program.
    pub(crate) fn call_function(&mut self, call: &Call<'_>) {
        let taken = self.frame.taken + call.callee.stack_bytes;
        let size = &self.program.frame;
        let numbers = self.frame.numbers + size.lanes.num * 8;
        let places = self.frame.places + size.places * 4;
        let lanes = Lanes::of(call.callee, self.module.image);
        let lent: Vec<_> = call.references().filter_map(|(from, count, _)| self.variables_of(from, count)).collect();
        lent.iter().for_each(|variables| self.lend(variables));
        for (from, count, to) in call.references() {
            self.code().local_get(local::PLACES);
            self.address(from, count);
            self.code().i32_store(whole_at(places + to * 4));
        }
        for (from, to) in call.numbers().filter(|(_, to)| lanes.parameter(*to).is_none()) {
            self.write_number(from, numbers, to);
        }
        self.code().local_get(local::BASE).i32_const(numbers.cast_signed()).i32_add();
        self.code().local_get(local::PLACES).i32_const(places.cast_signed()).i32_add();
        self.code().local_get(local::ROOM).i32_const(taken.cast_signed()).i32_sub();
        self.code().local_get(local::BUDGET);
        self.give_numbers(call, &lanes);
        self.code().call(call.function).local_set(local::BUDGET);
        lent.iter().for_each(|variables| self.take_back(variables));
        self.when(Self::stop_behind);
    }

    /// The interpreter goes on behind the call at hand, when what it calls has ended.
    pub(crate) fn stop_behind(&mut self) {
        let (_, number) = self.step;
        self.give_back(self.ahead);
        self.stop_at(number + 1);
    }

    /// A number goes to the frame of the program that is called, so many bytes behind that of the function.
    pub(crate) fn write_number(&mut self, from: Register, numbers: u32, to: Register) {
        self.code().local_get(local::BASE);
        self.get(from);
        let mut at = number_at(to);
        at.offset += u64::from(numbers);
        self.code().f64_store(at);
    }

    /// The numbers that are parameters of the function come in their order; it takes any for what is none.
    fn give_numbers(&mut self, call: &Call<'_>, lanes: &Lanes) {
        let given = |parameter| call.numbers().find(|(_, to)| lanes.parameter(*to) == Some(parameter));
        for parameter in 0..local::NUMBERS_GIVEN {
            match given(parameter).or_else(|| call.numbers().next()) {
                Some((from, _)) => self.get(from),
                None => _ = self.code().f64_const(0.0.into()),
            }
        }
    }

    /// The program ends. Where its frame may be the first of the task, the interpreter ends the task.
    pub(crate) fn end_program(&mut self) {
        if let Some(out) = self.depth(Label::Ended) {
            self.code().br(out);
            return;
        }
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
