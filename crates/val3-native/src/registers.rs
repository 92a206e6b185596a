//! The numbers of a frame as machine code reads and writes them, whatever [holds](crate::sorts) them.

use val3_bytecode::Register;

use crate::body::Body;
use crate::bounds::Bounds;
use crate::lanes::Lane;
use crate::local;
use crate::sorts::Sort;

impl Body<'_> {
    /// A number of the frame.
    pub(crate) fn get(&mut self, register: Register) {
        match self.study.lanes.get(register) {
            Lane::Constant(value) => _ = self.code().f64_const(value.into()),
            Lane::Memory => self.load(register),
            Lane::Variable(number) => {
                let variable = self.frame.variable(number);
                self.code().local_get(variable);
                match self.sort(register) {
                    Sort::Number => {}
                    Sort::Whole => _ = self.code().f64_convert_i64_s(),
                    Sort::Truth => _ = self.code().f64_convert_i32_u(),
                }
            }
        }
    }

    /// Writes a number of the frame.
    pub(crate) fn set(&mut self, register: Register, value: impl FnOnce(&mut Self)) {
        match self.study.lanes.get(register) {
            Lane::Constant(_) => {
                value(self);
                self.code().drop();
            }
            Lane::Memory => {
                let at = self.at(register);
                self.code().local_get(local::BASE);
                value(self);
                self.code().f64_store(at);
            }
            Lane::Variable(number) => {
                let variable = self.frame.variable(number);
                value(self);
                match self.sort(register) {
                    Sort::Number => {}
                    Sort::Whole => _ = self.code().i64_trunc_sat_f64_s(),
                    Sort::Truth => _ = self.code().f64_const(0.0.into()).f64_ne(),
                }
                self.code().local_set(variable);
            }
        }
    }

    /// What the variable of a register holds.
    pub(crate) fn sort(&self, register: Register) -> Sort {
        self.study.sorts.get(register)
    }

    /// The variable of a register that holds such things.
    fn variable_of(&self, register: Register, sort: Sort) -> Option<u32> {
        match self.study.lanes.get(register) {
            Lane::Variable(number) if self.sort(register) == sort => Some(self.frame.variable(number)),
            _ => None,
        }
    }

    /// A number as a truth value.
    pub(crate) fn truth(&mut self, register: Register) {
        if let Lane::Constant(value) = self.study.lanes.get(register) {
            self.code().i32_const((value != 0.0).into());
        } else if let Some(variable) = self.variable_of(register, Sort::Truth) {
            self.code().local_get(variable);
        } else {
            self.get(register);
            self.code().f64_const(0.0.into()).f64_ne();
        }
    }

    /// Writes a truth value.
    pub(crate) fn set_truth(&mut self, register: Register, value: impl FnOnce(&mut Self)) {
        match self.variable_of(register, Sort::Truth) {
            Some(variable) => {
                value(self);
                self.code().local_set(variable);
            }
            None => self.set(register, |body| {
                value(body);
                body.code().f64_convert_i32_u();
            }),
        }
    }

    /// Whether a register is there as a whole number.
    pub(crate) fn is_whole(&self, register: Register) -> bool {
        self.bounds(register).is_some()
    }

    /// The bounds of a register that is there as a whole number.
    pub(crate) fn bounds(&self, register: Register) -> Option<Bounds> {
        match self.study.lanes.get(register) {
            Lane::Constant(value) => Bounds::of(value),
            _ if self.sort(register) == Sort::Whole => {
                let everywhere = self.study.sorts.bounds(register);
                Some(self.facts.get(&register).map_or(everywhere, |here| here.and(everywhere)))
            }
            _ => None,
        }
    }

    /// A register that is there as a whole number.
    pub(crate) fn whole(&mut self, register: Register) {
        if let Lane::Constant(value) = self.study.lanes.get(register) {
            #[expect(clippy::cast_possible_truncation, reason = "it is a whole number of less than 2^53")]
            self.code().i64_const(value as i64);
        } else if let Some(variable) = self.variable_of(register, Sort::Whole) {
            self.code().local_get(variable);
        }
    }

    /// Writes a register that is there as a whole number. What may be too large is left to the interpreter.
    pub(crate) fn set_whole(&mut self, register: Register, bounds: Bounds, value: impl FnOnce(&mut Self)) {
        value(self);
        self.code().local_set(local::COLUMN);
        if !bounds.are_exact() {
            self.check_exact();
        }
        self.keep_whole(register);
        self.facts.insert(register, bounds.and(Bounds::EXACT));
    }

    /// A computed whole number that is too large is left to the interpreter: 54 bits are all of it where it is not.
    fn check_exact(&mut self) {
        self.code().local_get(local::COLUMN).i64_const(10).i64_shl().i64_const(10).i64_shr_s();
        self.code().local_get(local::COLUMN).i64_ne();
        self.when(Self::leave_it);
    }

    /// A computed whole number goes to its register.
    pub(crate) fn keep_whole(&mut self, register: Register) {
        if let Some(variable) = self.variable_of(register, Sort::Whole) {
            self.code().local_get(local::COLUMN).local_set(variable);
        }
    }
}
