//! The parts of a report, which can be asked for alone.

use serde::Serialize;
use val3_lang::types::BaseType;

use crate::model::{ApplicationChange, Change, Comparison, DataChange};

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

impl Comparison {
    /// Keeps these parts. Problems stay, because they may hide differences of any part.
    pub fn keep(&mut self, classes: &[Class]) {
        let has = |class| classes.contains(&class);
        self.settings.retain(|file| has(if file.is_io { Class::Io } else { Class::Configuration }));
        for application in &mut self.applications {
            keep_in(application, classes);
        }
        self.applications.retain(|application| has_content(application, classes));
    }
}

fn keep_in(application: &mut ApplicationChange, classes: &[Class]) {
    let has = |class| classes.contains(&class);
    if !has(Class::Programs) {
        application.programs.clear();
        application.texts.retain(|text| !text.path.to_lowercase().ends_with(".pgx"));
    }
    if !has(Class::Libraries) {
        application.libraries.clear();
        application.types.clear();
        application.interface.clear();
    }
    if !has(Class::Configuration) {
        application.project.clear();
        application.moved_from = None;
    }
    application.data.retain_mut(|data| keep_data(data, classes));
}

/// Values of a user type belong to the classes of their fields.
fn keep_data(data: &mut DataChange, classes: &[Class]) -> bool {
    if classes.contains(&data.class) {
        return true;
    }
    data.values.retain(|value| classes.contains(&value.class));
    !data.values.is_empty()
}

fn has_content(application: &ApplicationChange, classes: &[Class]) -> bool {
    let is_whole = application.change != Change::Changed && classes.contains(&Class::Configuration);
    let mut rest = application.clone();
    rest.change = Change::Changed;
    is_whole || !rest.is_empty()
}
