//! Ports: the interfaces through which instructions reach outside the program. The controller implements them.
//!
//! The catalogue names them and never runs them; the virtual controller gives each a body. Times are in nanoseconds of
//! the controller's clock.

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

/// Everything outside programs and their data.
pub trait Ports: IoPort + Serial + Screen + Robot + MotionPort + MediaPort {
    /// The origin of the next calls. The runtime sets it before each instruction.
    fn origin(&mut self, origin: Origin);

    /// A task was created, has ended, or has changed its state. `at` is where it is; `None` for the one that runs.
    fn task(&mut self, task: TaskNumber, name: &str, change: TaskChange, at: Option<CodePlace>);

    /// The number of an input, output or line by its path in a file (`BasicIO-1\%I0`); `None` where there is none.
    fn port(&mut self, base: BaseType, path: &str) -> Option<u32>;
}

/// A task, by its number in the order of creation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct TaskNumber(pub u64);

/// Where and when something happens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Origin {
    /// When.
    pub time: Time,
    /// The task.
    pub task: TaskNumber,
    /// The line.
    pub at: CodePlace,
}

/// A line of a program in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CodePlace {
    /// The application or library, by number.
    pub instance: u16,
    /// The program, by number.
    pub program: u16,
    /// The first operation of the line.
    pub line: u32,
}

/// An event of a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TaskChange {
    /// It was created.
    Created,
    /// Its program has ended.
    Ended,
    /// It was halted.
    Halted,
    /// It continues.
    Resumed,
    /// It was killed.
    Killed,
    /// An error has stopped it.
    Failed(Fault),
}

/// Work of the run time for an instruction after its handler; the resulting code is the value of the instruction (6.6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RuntimeRequest {
    /// Loads a library under an identifier (6.7).
    Load {
        /// The identifier, by number.
        library: u16,
        /// The path as the program writes it.
        path: Text,
        /// The public password, where the library is encrypted.
        password: Text,
    },
    /// Saves a library, or the application itself.
    Save {
        /// The identifier, by number.
        library: Option<u16>,
        /// Where to; where it was loaded from if nothing is said.
        path: Option<Text>,
    },
}

/// Tasks and libraries, as the task that calls sees them: those of its own application or library (5.3).
pub trait Tasks {
    /// The result of `taskStatus`.
    fn status(&self, name: &str) -> i16;

    /// Halts a task.
    ///
    /// # Errors
    /// 30 if there is no such task.
    fn suspend(&mut self, name: &str) -> Result<()>;

    /// Resumes a halted task `skip` lines after its line.
    ///
    /// # Errors
    /// 30 if there is no such task, 90 if there is no such line.
    fn resume(&mut self, name: &str, skip: f64) -> Result<()>;

    /// Ends a task; nothing happens where there is none. It is gone when the turn of the caller ends.
    fn kill(&mut self, name: &str);

    /// Global data by the name that `getData` takes, without its index: `name`, `library:name`.
    ///
    /// # Errors
    /// That of `getData`: -1 no such data, -2 no such library identifier.
    fn data(&self, name: &str) -> std::result::Result<View, i16>;

    /// Asks for what only the run time can do.
    fn request(&mut self, request: RuntimeRequest);

    /// The path that a library was loaded from; of the application itself without an identifier. Empty where nothing
    /// is loaded.
    fn path(&self, library: Option<u16>) -> String;

    /// Whether a library has public data of this name, or with `()` after it a public program (6.7).
    fn exports(&self, library: u16, symbol: &str) -> bool;
}
