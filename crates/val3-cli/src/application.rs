//! An application on its way to the controller, for the commands that execute: found, read, checked, compiled.

mod arm;
mod cell;
mod compiling;
mod controller;
mod images;
mod laid;
mod lines;
mod media;
mod pace;
mod settings;

use camino::Utf8Path;
use val3_analysis::db::Project;
use val3_analysis::items::project::{folder, items};
use val3_lang::{instructions, motion};

use crate::engine::Session;
use crate::user_error::UserError;

pub(crate) use arm::set as set_arm;
pub(crate) use compiling::{compile, first_refusal, load_laid};
pub(crate) use controller::controller;
pub(crate) use laid::Files;
pub(crate) use lines::{LineArg, Tape};
pub(crate) use pace::Pace;

use images::Images;
use media::Media;

/// The application that is meant: the only one there, or the only one with a program of this name.
pub(crate) fn only_application(
    session: &Session<'_>,
    asked: &Utf8Path,
    program: Option<&str>,
) -> Result<Project, UserError> {
    let (projects, db) = (session.projects(), session.db());
    let has_program = |project: &&Project| program.is_some_and(|name| items(db, **project).programs.contains_key(name));
    let starting: Vec<Project> = projects.iter().filter(has_program).copied().collect();
    match (projects, starting.as_slice()) {
        ([project], _) | (_, [project]) => Ok(*project),
        (_, several) => {
            let shown = if several.is_empty() { projects } else { several };
            let names: Vec<&str> = shown.iter().filter_map(|project| folder(db, *project).file_name()).collect();
            let help = format!("name the folder of one of them: {}", names.join(", "));
            Err(UserError::new(format!("`{asked}` holds {} applications", shown.len())).with_help(help))
        }
    }
}

/// What is missing for an instruction.
pub(crate) fn lacking(instruction: &str) -> String {
    if instructions::find(instruction).is_some_and(motion::needs_arm) {
        format!("motion is not there yet: `{instruction}` cannot be executed")
    } else {
        format!("this controller does not have `{instruction}`")
    }
}
