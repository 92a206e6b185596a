//! Where things are in the memory of the machine code, in bytes.

/// How many programs have stopped within one another: the first record is that of the innermost.
pub(crate) const STOPPED: u32 = 0;

/// Where the program that is entered begins.
pub(crate) const NEXT: u32 = 4;

/// The line that it is in.
pub(crate) const LINE: u32 = 8;

/// The number 1 of eight bytes, for [counting](crate::counting).
pub(crate) const ONE: u32 = 16;

/// Small numbers from 0 on, each of four bytes, for [counting](crate::counting).
pub(crate) const SMALL: u32 = 24;

/// How many there are.
pub(crate) const SMALL_NUMBERS: u32 = (RECORDS - SMALL) / 4;

/// A record for each of them: program, next step, line.
pub(crate) const RECORDS: u32 = 128;

/// The bytes of a record.
pub(crate) const RECORD: u32 = 12;

/// Containers that all programs of a module reach: global data, and that of libraries.
pub(crate) const SHARED: u32 = 1 << 18;

/// Containers of the frame that was entered: local arrays, and containers by reference.
pub(crate) const OWN: u32 = 1 << 19;

/// How many containers of each sort there is room for.
pub(crate) const CONTAINERS: usize = (OWN - SHARED) as usize / CONTAINER as usize;

/// The bytes that describe a container.
pub(crate) const CONTAINER: u32 = 20;

/// In the description of a container: the address of its first number.
pub(crate) const ADDRESS: u32 = 0;
/// How many numbers there are from there on.
pub(crate) const COUNT: u32 = 4;
/// The size as an array of one dimension; 0 if it is none.
pub(crate) const SIZE: u32 = 8;
/// The rows of an array of two dimensions; 0 if it is none.
pub(crate) const ROWS: u32 = 12;
/// Its columns.
pub(crate) const COLUMNS: u32 = 16;

/// The places of all frames: the address of the number that each refers to, 0 if it is none that can be reached.
pub(crate) const PLACES: u32 = 1 << 20;

/// How many there is room for.
pub(crate) const MOST_PLACES: usize = (NUMBERS - PLACES) as usize / 4;

/// The numbers of all frames.
pub(crate) const NUMBERS: u32 = 1 << 21;

/// How many there is room for.
pub(crate) const MOST_NUMBERS: usize = (VALUES - NUMBERS) as usize / 8;

/// The numbers of containers.
pub(crate) const VALUES: u32 = 1 << 23;

/// The end of the memory.
pub(crate) const END: u32 = 1 << 26;

/// The bytes of a page.
pub(crate) const PAGE: u32 = 1 << 16;

/// How deep machine code calls itself. Beyond that the interpreter makes the call, and machine code begins anew.
pub(crate) const DEPTH: u32 = 512;
