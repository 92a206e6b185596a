//! The values of containers: elements by their indexes, and what has no index.

use val3_bytecode::{Op, Register, Whole};
use val3_lang::values::numbers::BELOW_HALF;
use wasm_encoder::MemArg;

use crate::body::{Body, number_at};
use crate::bounds::Bounds;
use crate::containers::Width;
use crate::layout::{ADDRESS, COLUMNS, COUNT, ROWS, SIZE};
use crate::local;

/// A byte behind an address.
const BYTE: MemArg = MemArg { offset: 0, align: 0, memory_index: 0 };

impl Body<'_> {
    /// The code of an operation on a container.
    pub(crate) fn containers(&mut self, op: Op) {
        match op {
            Op::LoadFirst { to, whole, lane } => {
                self.first(whole, lane);
                self.load_value(to, whole, lane);
            }
            Op::StoreFirst { whole, lane, from } => {
                self.first(whole, lane);
                self.store_value(whole, lane, from);
            }
            Op::LoadElement { to, whole, index } => {
                self.element(whole, index);
                self.load_value(to, whole, 0);
            }
            Op::StoreElement { whole, index, from } => {
                self.element(whole, index);
                self.store_value(whole, 0, from);
            }
            Op::LoadElement2 { to, whole, i, j } => {
                self.element2(whole, i, j);
                self.load_value(to, whole, 0);
            }
            Op::StoreElement2 { whole, i, j, from } => {
                self.element2(whole, i, j);
                self.store_value(whole, 0, from);
            }
            Op::LocateFirst { to, whole } => {
                self.first(whole, 0);
                self.locate(to);
            }
            Op::Locate { to, whole, index } => {
                self.element(whole, index);
                self.locate(to);
            }
            Op::Locate2 { to, whole, i, j } => {
                self.element2(whole, i, j);
                self.locate(to);
            }
            // A step that does no more than begin a line.
            _ => {}
        }
    }

    fn width(&self, whole: Whole) -> Width {
        Width::declared(whole.kind(), self.program, self.module.image)
    }

    /// Reads a number of the value at the address.
    fn load_value(&mut self, to: Register, whole: Whole, lane: u16) {
        match self.width(whole) {
            Width::Byte => self.set_truth(to, |body| _ = body.code().local_get(local::ADDRESS).i32_load8_u(BYTE)),
            Width::Eight => {
                self.set(to, |body| _ = body.code().local_get(local::ADDRESS).f64_load(number_at(lane)));
            }
        }
    }

    /// Writes a number of the value at the address.
    fn store_value(&mut self, whole: Whole, lane: u16, from: Register) {
        self.code().local_get(local::ADDRESS);
        match self.width(whole) {
            Width::Byte => {
                self.truth(from);
                self.code().i32_store8(BYTE);
            }
            Width::Eight => {
                self.get(from);
                self.code().f64_store(number_at(lane));
            }
        }
    }

    /// The address of the first value of a container, if it has so many numbers.
    fn first(&mut self, whole: Whole, lane: u16) {
        let Some(at) = self.module.shared.description(whole) else { return };
        self.field(at + COUNT);
        self.code().i32_const(lane.into()).i32_le_u();
        self.when(Self::leave_it);
        self.field(at + ADDRESS);
        self.code().local_set(local::ADDRESS);
    }

    /// The address of a value of an array.
    fn element(&mut self, whole: Whole, index: Register) {
        let Some(at) = self.module.shared.description(whole) else { return };
        self.index(local::COLUMN, index, at + SIZE);
        self.field(at + ADDRESS);
        self.code().local_get(local::COLUMN).i32_wrap_i64();
        self.value(whole);
    }

    /// The address of a value of an array of two dimensions.
    fn element2(&mut self, whole: Whole, i: Register, j: Register) {
        let Some(at) = self.module.shared.description(whole) else { return };
        self.index(local::ROW, i, at + ROWS);
        self.index(local::COLUMN, j, at + COLUMNS);
        self.field(at + ADDRESS);
        self.code().local_get(local::ROW).i32_wrap_i64();
        self.field(at + COLUMNS);
        self.code().i32_mul().local_get(local::COLUMN).i32_wrap_i64().i32_add();
        self.value(whole);
    }

    /// The address of a value, from that of the first and its number.
    fn value(&mut self, whole: Whole) {
        let shift = self.width(whole).shift().cast_signed();
        self.code().i32_const(shift).i32_shl().i32_add().local_set(local::ADDRESS);
    }

    /// An index goes to a variable, if it is one of those of which the field at `size` tells how many there are.
    ///
    /// An index is rounded (2.5.3): above zero, [`BELOW_HALF`] tells how. The bits of a whole number to which 2^52 is
    /// added are those of 2^52 and the number; what is negative, too large or no number is far beyond every size then.
    fn index(&mut self, variable: u32, index: Register, size: u32) {
        const BEYOND: f64 = (1_u64 << 52) as f64;
        if self.is_whole(index) {
            self.whole(index);
        } else {
            self.get(index);
            if !self.study.whole.has(index) {
                self.code().f64_const(BELOW_HALF.into()).f64_add().f64_floor();
            }
            self.code().f64_const(BEYOND.into()).f64_add().i64_reinterpret_f64();
            self.code().i64_const(BEYOND.to_bits().cast_signed()).i64_sub();
        }
        self.code().local_tee(variable);
        self.field(size);
        self.code().i64_extend_i32_u().i64_lt_u();
        self.unless(Self::leave_it);
        if let Some(bounds) = self.bounds(index) {
            self.facts.insert(index, bounds.and(Bounds::INDEXES));
        }
    }
}
