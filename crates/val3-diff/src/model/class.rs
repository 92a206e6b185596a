//! Parts of a report, which can be selected individually.

use serde::Serialize;
use val3_lang::types::BaseType;

/// A part of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ReportClass {
    /// Programs.
    Programs,
    /// Data except positions, inputs and outputs.
    Data,
    /// Points, joints, frames, tools, transformations and configurations.
    Points,
    /// Inputs, outputs and serial lines, and the cell's files that describe them.
    Io,
    /// Libraries and user types with their interfaces.
    Libraries,
    /// Parameters of applications, and other configuration files of the controller.
    Configuration,
    /// Other kinds of files.
    Files,
}

impl ReportClass {
    /// Returns the class of data by type; user types are data.
    pub(crate) fn of(ty: Option<BaseType>) -> Self {
        match ty {
            Some(ty) if ty.is_linkable() => Self::Io,
            Some(ty) if ty.has_father() || ty.depends_on_arm() || ty == BaseType::Trsf => Self::Points,
            _ => Self::Data,
        }
    }
}
