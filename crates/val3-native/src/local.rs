//! The parameters and variables of the function that a program becomes, by number.

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
pub(crate) const NUMBERS_GIVEN: usize = 4;

/// The frame has its numbers, and words in memory tell where to begin.
pub(crate) const AGAIN: u32 = 1 << 31;

/// Where to begin; later where a loop begins that is entered on the way.
pub(crate) const NEXT: u32 = 8;
/// The first step of the line at hand.
pub(crate) const LINE: u32 = 9;
/// The step that the interpreter goes on with.
pub(crate) const STEP: u32 = 10;
/// An address, for the time of one operation.
pub(crate) const ADDRESS: u32 = 11;
/// A whole number, for the time of one operation.
pub(crate) const I: u32 = 12;
/// Another.
pub(crate) const J: u32 = 13;

/// How many variables are whole numbers.
pub(crate) const WHOLE: u32 = 6;

/// An index, for the time of one operation.
pub(crate) const ROW: u32 = 14;
/// Another.
pub(crate) const COLUMN: u32 = 15;

/// How many variables are indexes.
pub(crate) const INDEXES: u32 = 2;

/// A number, for the time of one operation.
pub(crate) const A: u32 = 16;
/// Another.
pub(crate) const B: u32 = 17;

/// How many variables are numbers for the time of one operation.
pub(crate) const NUMBERS: u32 = 2;

/// The first number of the frame.
pub(crate) const LANES: u32 = 18;
