//! The numbers of a stack frame, as operations access them.

use val3_bytecode::{Program, Register};
use val3_lang::fault::{Fault, Result};

use crate::Frame;

/// Largest size of a narrow frame, in numbers. After the start of each frame the stack has at least this many numbers,
/// so that a one-byte register number is always valid.
pub(crate) const FIXED_REGISTERS: u32 = 256;

/// Numbers of a narrow frame.
pub(crate) type FixedRegisters = [f64; FIXED_REGISTERS as usize];

/// Numbers of a frame.
pub(crate) trait Registers {
    /// Whether the frames of a program have this width.
    fn suits(program: &Program) -> bool;

    /// Borrows the numbers of a frame from the numbers of the stack.
    fn of<'s>(nums: &'s mut [f64], frame: &Frame, program: &Program) -> Result<&'s mut Self>;

    fn get(&self, register: Register) -> Result<f64>;

    fn set(&mut self, register: Register, value: f64) -> Result<()>;
}

/// A frame of at most 256 numbers, as nearly all frames are. No access needs a check.
impl Registers for FixedRegisters {
    #[inline(always)]
    fn suits(program: &Program) -> bool {
        program.frame.lanes.num <= FIXED_REGISTERS
    }

    #[inline(always)]
    fn of<'s>(nums: &'s mut [f64], frame: &Frame, _: &Program) -> Result<&'s mut Self> {
        let nums = nums.get_mut(frame.base.num as usize..).and_then(|nums| nums.first_chunk_mut());
        nums.ok_or(Fault::INTERPRETER)
    }

    #[inline(always)]
    fn get(&self, register: Register) -> Result<f64> {
        let [low, _] = register.to_le_bytes();
        self.as_slice().get(usize::from(low)).copied().ok_or(Fault::INTERPRETER)
    }

    #[inline(always)]
    fn set(&mut self, register: Register, value: f64) -> Result<()> {
        let [low, _] = register.to_le_bytes();
        *self.as_mut_slice().get_mut(usize::from(low)).ok_or(Fault::INTERPRETER)? = value;
        Ok(())
    }
}

/// A frame of any width.
impl Registers for [f64] {
    fn suits(program: &Program) -> bool {
        program.frame.lanes.num > FIXED_REGISTERS
    }

    fn of<'s>(nums: &'s mut [f64], frame: &Frame, program: &Program) -> Result<&'s mut Self> {
        let start = frame.base.num as usize;
        nums.get_mut(start..start + program.frame.lanes.num as usize).ok_or(Fault::INTERPRETER)
    }

    #[inline]
    fn get(&self, register: Register) -> Result<f64> {
        self.get(usize::from(register)).copied().ok_or(Fault::INTERPRETER)
    }

    #[inline]
    fn set(&mut self, register: Register, value: f64) -> Result<()> {
        *self.get_mut(usize::from(register)).ok_or(Fault::INTERPRETER)? = value;
        Ok(())
    }
}
