//! The parts of a report, which can be asked for alone.

use serde::Serialize;
use val3_lang::types::BaseType;

/// A part of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Class {
    /// Programs.
    Programs,
    /// Data that are neither positions nor inputs and outputs.
    Data,
    /// Points, joints, frames, tools, transformations and configurations.
    Points,
    /// Inputs, outputs and lines, and the files of the cell that describe them.
    Io,
    /// Libraries and user types with their interfaces.
    Libraries,
    /// Parameters of applications, and other files of the controller's configuration.
    Configuration,
    /// Files of other kinds.
    Files,
}

impl Class {
    /// The class of data of a type; user types are data.
    pub(crate) fn of(ty: Option<BaseType>) -> Self {
        match ty {
            Some(ty) if ty.is_linkable() => Self::Io,
            Some(ty) if ty.has_father() || ty.depends_on_arm() || ty == BaseType::Trsf => Self::Points,
            _ => Self::Data,
        }
    }
}
