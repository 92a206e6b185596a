//! Tests of VAL 3 applications: finds tests, and executes each on its own controller.
//!
//! A test is a program or a scenario: a file with expectations and the environment in which an application runs.
//!
//! A test program has a name that begins with `test`, in an application that is named `…Test` or is in a folder
//! `tests`. Its assertions are programs of the library `val3assert`, which is plain VAL 3: a failure is a line in the
//! event log, also on a real controller.

mod application;
mod assertion;
mod case;
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
pub use coverage::{counted, executed, project_name, tested_projects};
pub use execute::{Supervision, TestSettings, execute};
pub use exemption::Exemption;
pub use expect::CycleEvent;
pub use failure::{Failure, FailureLocation};
pub use final_state::{Difference, FinalState};
pub use golden_text::GoldenText;
pub use journal::RepeatedEvent;
pub use recorded::{Judgement, RecordedMotion};
pub use result::TestResult;
pub use scenario::{ControllerKeys, Scenario, ScenarioError, TestFileRole};
pub use stages::{Stages, Transition};
