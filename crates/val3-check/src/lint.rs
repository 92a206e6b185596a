//! Rules that look at what a program does, beyond what the controller's compiler asks: the lints.
//!
//! A lint is a function over a [`Program`] or a [`ProjectView`]; it runs on files without faults only, so that one
//! mistake makes one message.

mod choices;
mod edit;
mod elsewhere;
mod findings;
#[cfg(test)]
pub(crate) mod fixed;
mod locals;
mod motion;
pub(crate) mod naming;
mod points;
mod program;
mod project;
pub(crate) mod ranges;
pub(crate) mod removal;
mod run;
mod same;
mod sizes;
mod tasks;
#[cfg(test)]
pub(crate) mod testing;
pub(crate) mod unused_data;
pub(crate) mod variable_use;

pub(crate) use choices::Choices;
pub(crate) use findings::Findings;
pub(crate) use locals::{LocalUse, Locals};
pub(crate) use motion::{Motion, Phase};
pub(crate) use program::{Call, Program};
pub(crate) use project::{DataFile, ProjectView};
pub(crate) use run::{data, member, program, project};
