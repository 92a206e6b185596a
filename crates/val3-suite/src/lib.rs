//! Tests of VAL 3 applications: finds them, and executes each on a controller of its own.
//!
//! A test is a program, or a scenario: a file that says what happens around an application, and what is expected of it.
//!
//! A test program is one whose name begins with `test` in an application that is named `…Test` or lies below a folder `tests`.
//! It asserts by the programs of the library `val3assert`, which is plain VAL 3: a failure is a line of the event log, on a
//! real controller too.

mod application;
mod assertion;
mod case;
mod controller_keys;
mod coverage;
mod execute;
mod exemption;
mod expect;
mod expected_code;
mod failure;
mod final_state;
mod golden_text;
mod journal;
mod killed;
pub mod library;
mod recorded;
mod result;
mod scenario;
mod source;
mod stages;
mod table;
mod unfinished;

pub use case::{TestCase, TestKind, cases};
pub use controller_keys::ControllerKeys;
pub use coverage::counted;
pub use execute::{Supervision, TestSettings, execute};
pub use exemption::Exemption;
pub use failure::{Failure, Place};
pub use final_state::{Difference, FinalState};
pub use golden_text::GoldenText;
pub use journal::RepeatedEvent;
pub use recorded::{Judgement, RecordedMotion};
pub use result::TestResult;
pub use scenario::{Role, Scenario, ScenarioError};
pub use stages::{Stages, Transition};
