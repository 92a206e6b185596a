//! Lints: rules about the behaviour of a program, beyond the errors of the controller's compiler.
//!
//! A lint is a function of a [`ProgramView`] or a [`ProjectView`]. It only runs on files without faults, so that one
//! mistake causes one message.

mod call;
mod choices;
mod contacts;
mod corners;
mod descriptors;
mod edit;
mod findings;
#[cfg(test)]
pub(crate) mod fix_testing;
mod flow_queries;
mod locals;
mod locations;
mod motion;
#[cfg(test)]
pub(crate) mod motion_testing;
pub(crate) mod naming;
mod nominal;
mod paths;
mod planned_moves;
mod program;
mod project;
pub(crate) mod ranges;
mod reachability;
pub(crate) mod removal;
mod run;
mod same;
mod sizes;
mod tasks;
#[cfg(test)]
pub(crate) mod testing;
pub(crate) mod unused_data;
mod variable_use;

pub(crate) use call::Call;
pub(crate) use choices::Choices;
pub(crate) use contacts::{CellContacts, MoveContact, PositionContact};
pub(crate) use descriptors::descriptor_numbers;
pub(crate) use findings::Findings;
pub(crate) use locals::{LocalUse, Locals};
pub(crate) use motion::{ArmActivity, MotionFacts};
pub(crate) use planned_moves::{ImpossibleMove, UnreachablePath};
pub(crate) use program::ProgramView;
pub(crate) use project::{DataFile, ProjectView, is_library};
pub(crate) use reachability::{
    ArmReach, FlangeTool, of_project as arm_of_project, position as position_of, range as range_of,
};
pub(crate) use run::{data, member, program, project, versions};
