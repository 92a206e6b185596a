//! A run-time error as a value; it stops a task at its line (5.2, 12.1).

use crate::runtime_errors;

/// Number of a run-time error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Fault(pub u16);

impl Fault {
    /// 20: an index beyond the size, or a key that does not exist.
    pub const INDEX_TOO_LARGE: Self = Self(runtime_errors::INDEX_TOO_LARGE);
    /// 21: an index below zero.
    pub const INDEX_NEGATIVE: Self = Self(runtime_errors::INDEX_NEGATIVE);
    /// 40: out of memory, or more values than a variable may contain.
    pub const NO_MEMORY: Self = Self(runtime_errors::NO_MEMORY);
    /// 41: the stack of the task is full.
    pub const STACK_FULL: Self = Self(runtime_errors::STACK_FULL);
    /// 61: the interpreter cannot continue.
    pub const INTERPRETER: Self = Self(runtime_errors::INTERPRETER);
    /// 70: an invalid argument.
    pub const INVALID_PARAMETER: Self = Self(runtime_errors::INVALID_PARAMETER);
    /// 80: a library that is not loaded, or data or a program that does not exist in the library.
    pub const LIBRARY_ITEM_MISSING: Self = Self(runtime_errors::LIBRARY_ITEM_MISSING);
}

/// Result of an operation that can raise a run-time error.
pub type Result<T> = std::result::Result<T, Fault>;
