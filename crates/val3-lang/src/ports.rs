//! Ports: interfaces through which instructions access everything outside the program. The controller implements them.
//!
//! Handlers of instructions call the ports; this crate contains no implementation, except for tests. Times are in
//! nanoseconds on the controller's clock.

mod io;
mod media;
mod motion;
mod robot;
mod screen;
mod serial;
mod time;

pub use io::{IoDescription, IoPort};
pub use media::MediaPort;
pub use motion::{MotionPort, MoveRequest};
pub use robot::Robot;
pub use screen::{DEFAULT_PAGE, InputKind, InputResult, OperatorInput, Screen};
pub use serial::{LineValue, Outgoing, Reply, Serial};
pub use time::{SECOND, Time, nanoseconds};

use crate::fault::{Fault, Result};
use crate::memory::View;
use crate::types::BaseType;
use crate::values::Text;

/// All ports of the controller.
pub trait Ports: IoPort + Serial + Screen + Robot + MotionPort + MediaPort {
    /// Sets the origin of the next calls. The runtime calls this before each instruction.
    fn origin(&mut self, origin: Origin);

    /// Reports that a task was created, has ended or has changed its state. `at` is the task's current line; `None` for
    /// the running task.
    fn task(&mut self, task: TaskNumber, name: &str, change: TaskChange, at: Option<CodePlace>);

    /// Returns the number of the input, output or serial line with this path as in files (`BasicIO-1\%I0`); `None` if
    /// it does not exist.
    fn port(&mut self, base: BaseType, path: &str) -> Option<u32>;
}

/// Task number, in the order of creation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct TaskNumber(pub u64);

/// Time and code line of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Origin {
    /// Time.
    pub time: Time,
    /// Task.
    pub task: TaskNumber,
    /// Line.
    pub at: CodePlace,
}

/// Line of a program in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CodePlace {
    /// Number of the application or library.
    pub instance: u16,
    /// Number of the program.
    pub program: u16,
    /// Index of the line's first operation.
    pub line: u32,
}

/// Change in a task's state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TaskChange {
    /// Created.
    Created,
    /// The task's program has ended.
    Ended,
    /// Suspended.
    Halted,
    /// Resumed.
    Resumed,
    /// Killed.
    Killed,
    /// Stopped by a run-time error.
    Failed(Fault),
}

/// Work that the runtime performs after an instruction's handler; the resulting code is the instruction's value (6.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RuntimeRequest {
    /// Loads a library under an identifier (6.7).
    Load {
        /// Number of the library identifier.
        library: u16,
        /// Path as the program writes it.
        path: Text,
        /// Public password, for an encrypted library.
        password: Text,
    },
    /// Saves a library, or the application itself.
    Save {
        /// Number of the library identifier; `None` for the application itself.
        library: Option<u16>,
        /// Destination; `None` for the path from which the library was loaded.
        path: Option<Text>,
    },
}

/// Tasks and libraries of the calling task's application or library (5.3).
pub trait Tasks {
    /// Returns the result of `taskStatus`.
    fn status(&self, name: &str) -> i16;

    /// Suspends a task.
    ///
    /// # Errors
    /// 30 if the task does not exist.
    fn suspend(&mut self, name: &str) -> Result<()>;

    /// Resumes a suspended task `skip` lines after its current line.
    ///
    /// # Errors
    /// 30 if the task does not exist, 90 if the line does not exist.
    fn resume(&mut self, name: &str, skip: f64) -> Result<()>;

    /// Kills a task, if it exists. It is removed at the end of the caller's turn.
    fn kill(&mut self, name: &str);

    /// Finds global data by the name in `getData` without index: `name`, `library:name`.
    ///
    /// # Errors
    /// Result of `getData`: -1 for unknown data, -2 for an unknown library identifier.
    fn data(&self, name: &str) -> std::result::Result<View, i16>;

    /// Requests work from the runtime.
    fn request(&mut self, request: RuntimeRequest);

    /// Returns the path from which a library was loaded, or the application's path without an identifier. Empty if no
    /// library is loaded.
    fn path(&self, library: Option<u16>) -> String;

    /// Whether a library has public data with this name, or a public program if `()` follows the name (6.7).
    fn exports(&self, library: u16, symbol: &str) -> bool;
}
