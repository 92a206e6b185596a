//! What a program gets by reference (2.6): numbers in memory, or in variables of the function.

use val3_bytecode::{Operand, Register};

use crate::body::{Body, bytes_behind, number_at, whole_at};
use crate::frame::{Reference, Variables};
use crate::lanes::Lane;
use crate::local;

impl Body<'_> {
    /// Reads a number behind a place.
    pub(crate) fn load_referred(&mut self, to: Register, place: Register, lane: u16) {
        let variable = self.variable_behind(place, lane);
        if variable.is_none() {
            self.referred(place);
        }
        self.set(to, |body| {
            match variable {
                Some(variable) => body.code().local_get(variable),
                None => body.code().local_get(local::ADDRESS).f64_load(number_at(lane)),
            };
        });
    }

    /// Writes a number behind a place.
    pub(crate) fn store_referred(&mut self, place: Register, lane: u16, from: Register) {
        if let Some(variable) = self.variable_behind(place, lane) {
            self.get(from);
            self.code().local_set(variable);
            return;
        }
        self.referred(place);
        self.code().local_get(local::ADDRESS);
        self.get(from);
        self.code().f64_store(number_at(lane));
    }

    /// The variable with a number behind a place, if there is one.
    fn variable_behind(&self, place: Register, lane: u16) -> Option<u32> {
        match self.frame.reference(place.into())? {
            Reference::Variables(variables) => variables.numbers.get(usize::from(lane)).copied(),
            Reference::Address(_) => None,
        }
    }

    /// The address of what a place refers to goes to a variable; what has none is left to the interpreter.
    pub(crate) fn referred(&mut self, place: Register) {
        self.place(place);
        self.code().local_set(local::ADDRESS);
        if self.frame.reference(place.into()).is_none() {
            self.code().local_get(local::ADDRESS).i32_eqz();
            self.when(Self::leave_it);
        }
    }

    /// The address of what a place refers to that is not in variables.
    pub(crate) fn place(&mut self, place: Register) {
        if let Some(Reference::Address(variable)) = self.frame.reference(place.into()) {
            let variable = *variable;
            self.code().local_get(variable);
        } else {
            let at = whole_at(self.frame.places + u32::from(place) * 4);
            self.code().local_get(local::PLACES).i32_load(at);
        }
    }

    /// The address goes to a place.
    pub(crate) fn locate(&mut self, place: Register) {
        let at = whole_at(self.frame.places + u32::from(place) * 4);
        self.code().local_get(local::PLACES).local_get(local::ADDRESS).i32_store(at);
    }

    /// The address of the numbers of a value, of which there are so many.
    pub(crate) fn address(&mut self, operand: Operand, count: u32) {
        let skipped = match (self.variables_of(operand, count), operand) {
            (Some(variables), _) => {
                self.code().local_get(local::BASE);
                variables.at
            }
            (None, Operand::Frame(lanes)) => {
                self.code().local_get(local::BASE);
                self.frame.numbers + lanes.num * 8
            }
            (None, Operand::Place(place, lanes)) => {
                self.place(place);
                lanes.num * 8
            }
        };
        self.code().i32_const(skipped.cast_signed()).i32_add();
    }

    /// The variables with the numbers of a value, of which there are so many; `None` where they are in memory alone.
    pub(crate) fn variables_of(&self, operand: Operand, count: u32) -> Option<Variables> {
        match operand {
            Operand::Frame(lanes) => {
                let registers = lanes.num..lanes.num + count;
                let variables = registers.map(|register| self.variable(Register::try_from(register).ok()?));
                let numbers = variables.collect::<Option<Vec<u32>>>()?;
                Some(Variables { at: self.frame.numbers + lanes.num * 8, numbers })
            }
            Operand::Place(place, lanes) => {
                let Reference::Variables(Variables { at, numbers }) = self.frame.reference(place.into())? else {
                    return None;
                };
                let numbers = numbers.iter().skip(lanes.num as usize).take(count as usize);
                Some(Variables { at: at + lanes.num * 8, numbers: numbers.copied().collect() })
            }
        }
    }

    fn variable(&self, register: Register) -> Option<u32> {
        match self.study.lanes.get(register) {
            Lane::Variable(number) => Some(self.frame.variable(number)),
            _ => None,
        }
    }

    /// Numbers in variables go to memory, so that a function that is called can refer to them.
    pub(crate) fn lend(&mut self, variables: &Variables) {
        for (variable, at) in variables.numbers.iter().zip((variables.at..).step_by(8)) {
            self.code().local_get(local::BASE).local_get(*variable).f64_store(bytes_behind(at));
        }
    }

    /// They come back, whatever it has made of them.
    pub(crate) fn take_back(&mut self, variables: &Variables) {
        for (variable, at) in variables.numbers.iter().zip((variables.at..).step_by(8)) {
            self.code().local_get(local::BASE).f64_load(bytes_behind(at)).local_set(*variable);
        }
    }
}
