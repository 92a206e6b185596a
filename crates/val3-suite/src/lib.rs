//! Tests of VAL 3 applications: finds them, and executes each on a controller of its own.
//!
//! A test is a program whose name begins with `test` in an application that is named `…Test` or lies below a folder `tests`.
//! It asserts by the programs of the library `val3assert`, which is plain VAL 3: a failure is a line of the event log, on a
//! real controller too.

mod case;
mod execute;
pub mod library;
mod result;
mod stages;

pub use case::{TestCase, cases};
pub use execute::{TestSettings, execute};
pub use result::{Failure, Place, TestResult};
pub use stages::{Stages, Transition};
