//! Results of handlers.

use val3_geometry::Trsf;

use super::{Call, Flow, StoredValue};
use crate::fault::Result;
use crate::memory::{LinkPlace, Place};
use crate::values::{ConfigValue, JointValue, Text};

/// Instruction value.
pub trait InstructionValue {
    /// Writes the value to the destination in the program.
    ///
    /// # Errors
    /// 20 if the destination does not exist.
    fn give(self, call: &mut Call<'_>) -> Result<()>;
}

impl InstructionValue for () {
    fn give(self, _: &mut Call<'_>) -> Result<()> {
        Ok(())
    }
}

/// A point: its position in a frame, the arm configuration, and the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointValue {
    /// Position in the frame.
    pub trsf: Trsf,
    /// Arm configuration.
    pub config: ConfigValue,
    /// Father of the point.
    pub frame: LinkPlace,
}

impl StoredValue for PointValue {
    fn read(memory: &crate::memory::Memory, at: Place) -> Result<Self> {
        let trsf = Trsf::read(memory, at)?;
        Ok(Self { trsf, config: ConfigValue(memory.nums(at, 6)?), frame: memory.link(at, 0)? })
    }

    fn write(self, memory: &mut crate::memory::Memory, at: Place) -> Result<()> {
        self.trsf.write(memory, at)?;
        memory.set_nums(at, 6, self.config.0)?;
        memory.set_link(at, 0, self.frame)
    }
}

macro_rules! stored {
    ($($ty:ty),*) => {
        $(impl InstructionValue for $ty {
            #[inline]
            fn give(self, call: &mut Call<'_>) -> Result<()> {
                match call.result() {
                    Some(place) => self.write(call.memory, place),
                    None => Ok(()),
                }
            }
        })*
    };
}
stored!(f64, bool, Text, Trsf, JointValue, ConfigValue, PointValue);

/// Result of a handler: a value, or a wait of the task.
pub trait HandlerResult {
    /// Writes the value, if there is one.
    ///
    /// # Errors
    /// The run-time error of the instruction.
    fn settle(self, call: &mut Call<'_>) -> Result<Flow>;
}

impl<T: InstructionValue> HandlerResult for T {
    #[inline]
    fn settle(self, call: &mut Call<'_>) -> Result<Flow> {
        self.give(call).map(Flow::Done)
    }
}

impl<T: InstructionValue> HandlerResult for Flow<T> {
    #[inline]
    fn settle(self, call: &mut Call<'_>) -> Result<Flow> {
        match self {
            Self::Done(value) => value.give(call).map(Flow::Done),
            Self::Wait(wait) => Ok(Flow::Wait(wait)),
        }
    }
}

impl<T: HandlerResult> HandlerResult for Result<T> {
    #[inline]
    fn settle(self, call: &mut Call<'_>) -> Result<Flow> {
        self?.settle(call)
    }
}
