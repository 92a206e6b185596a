//! Results of handlers.

use val3_geometry::Trsf;

use super::{Call, Flow, StoredValue};
use crate::fault::Result;
use crate::memory::{Link, Place};
use crate::values::{ConfigValue, Text};

/// The value of an instruction.
pub trait InstructionValue {
    /// Writes it to where the program wants it.
    ///
    /// # Errors
    /// 20 if that is gone.
    fn give(self, call: &mut Call<'_>) -> Result<()>;
}

impl InstructionValue for () {
    fn give(self, _: &mut Call<'_>) -> Result<()> {
        Ok(())
    }
}

/// A point: its position in a frame, how the arm reaches it, and the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointValue {
    /// Position in the reference frame.
    pub trsf: Trsf,
    /// Arm configuration.
    pub config: ConfigValue,
    /// The reference frame.
    pub frame: Link,
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
stored!(f64, bool, Text, Trsf, [f64; 6], ConfigValue, PointValue);

/// The result of a handler: a value, or a wait of the task.
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
