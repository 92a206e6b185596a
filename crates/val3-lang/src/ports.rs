//! What instructions reach outside the program: ports that the controller implements.
//!
//! The catalogue names them and never runs them; the virtual controller gives each a body. Times are in nanoseconds of
//! the controller's clock.

use std::sync::Arc;

use crate::call::Flow;
use crate::fault::Result;
use crate::memory::{Kind, Memory, View};
use crate::types::BaseType;

/// Nanoseconds since the controller was started.
pub type Time = u64;

/// Nanoseconds of a second.
pub const SECOND: Time = 1_000_000_000;

/// Everything outside programs and their data.
pub trait Ports {
    /// The number of an input, output or line by its path in a file (`BasicIO-1\%I0`); `None` where there is none.
    fn port(&mut self, base: BaseType, path: &str) -> Option<u32>;

    /// Shows a line of text that `?` prints.
    fn print(&mut self, text: &str);
}

/// Tasks and libraries, as the task that calls sees them: those of its own application or library (5.3).
pub trait Tasks {
    /// What `taskStatus` gives.
    fn status(&self, name: &str) -> i16;

    /// Halts a task.
    ///
    /// # Errors
    /// 30 if there is no such task.
    fn suspend(&mut self, name: &str) -> Result<()>;

    /// Lets a halted task go on `skip` lines behind its line.
    ///
    /// # Errors
    /// 30 if there is no such task, 90 if there is no such line.
    fn resume(&mut self, name: &str, skip: f64) -> Result<Flow>;

    /// Ends a task; nothing happens where there is none.
    ///
    /// # Errors
    /// None of its own.
    fn kill(&mut self, memory: &mut Memory, name: &str) -> Result<Flow>;

    /// Global data by the name that `getData` takes, without its index: `name`, `library:name`.
    ///
    /// # Errors
    /// That of `getData`: -1 no such data, -2 no such library identifier.
    fn data(&self, name: &str) -> std::result::Result<(View, Arc<Kind>), i16>;
}
