//! The parameters of the function that a program becomes, and the variables that every function has, by number.

use wasm_encoder::ValType::{self, F64, I32, I64};

/// The address of the numbers of its frame.
pub(crate) const BASE: u32 = 0;
/// The address of the places of its frame.
pub(crate) const PLACES: u32 = 1;
/// The bytes of the declared stack that programs called from here may take. With [`AGAIN`] the frame is no new one.
pub(crate) const ROOM: u32 = 2;
/// The lines that may still be begun.
pub(crate) const BUDGET: u32 = 3;

/// The first of the numbers that the program gets by value.
pub(crate) const GIVEN: u32 = 4;

/// How many of them are parameters of the function; a program need not have so many. The others are in memory.
pub(crate) const NUMBERS_GIVEN: u32 = 4;

/// How many parameters there are.
pub(crate) const PARAMETERS: u32 = GIVEN + NUMBERS_GIVEN;

/// The frame has its numbers, and words in memory tell where to begin.
pub(crate) const AGAIN: u32 = 1 << 31;

/// Where to begin; later where a loop begins that is entered on the way.
pub(crate) const NEXT: u32 = PARAMETERS;
/// The step that the interpreter goes on with.
pub(crate) const STEP: u32 = NEXT + 1;
/// An address, for the time of one operation.
pub(crate) const ADDRESS: u32 = STEP + 1;
/// A whole number, for the time of one operation.
pub(crate) const I: u32 = ADDRESS + 1;
/// Another.
pub(crate) const J: u32 = I + 1;

/// An index, for the time of one operation.
pub(crate) const ROW: u32 = J + 1;
/// Another.
pub(crate) const COLUMN: u32 = ROW + 1;

/// A number, for the time of one operation.
pub(crate) const A: u32 = COLUMN + 1;
/// Another.
pub(crate) const B: u32 = A + 1;

/// The types of the variables above, in their order.
pub(crate) const VARIABLES: [ValType; 9] = [I32, I32, I32, I32, I32, I64, I64, F64, F64];
