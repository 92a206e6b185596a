//! `outline`: the content of a cell or a project, or a program without XML.

mod program;
mod project;

use schemars::JsonSchema;
use serde::Deserialize;
use val3_analysis::load::Workspace;
use val3_analysis::system::Disk;

use crate::answer::Answer;
use crate::projects;
use crate::refusal::Refusal;
use crate::report::counted;
use crate::tool::{Call, Definition};

/// The tool.
pub(super) struct Outline;

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Cell, application, library or user type; the list of projects if there are several
    #[serde(default = "crate::arguments::here")]
    path: String,
    /// Program whose declarations, numbered code, callers and calls are returned
    program: Option<String>,
    /// Up to 24 kB instead of 8 kB
    #[serde(default)]
    detail: bool,
}

impl Definition for Outline {
    const NAME: &'static str = "outline";
    const TITLE: &'static str = "Outline of projects";
    const DESCRIPTION: &'static str = "Lists the projects of a cell; of one project its programs with signatures, data \
        with types and values, libraries, types and tasks; of one program its code without XML, with the line numbers \
        of findings. Begin here.";
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let path = call.roots.resolve(&arguments.path)?;
        let workspace = projects::read(&Disk, call.roots, &path)?;
        let text = match (&arguments.program, workspace.projects.len()) {
            (Some(name), _) => {
                let project = projects::only(&workspace, call.roots, &path)?;
                program::shown(&workspace.db, call.roots, project, name)?
            }
            (None, 1) => project::shown(&workspace.db, call.roots, projects::only(&workspace, call.roots, &path)?),
            (None, _) => list(call, &workspace),
        };
        let text = format!("{text}{}", unreadable(call, &workspace));
        Ok(Answer::new(workspace.unreadable.is_empty(), text).with_detail(arguments.detail))
    }
}

/// List of projects, one per line.
fn list(call: &Call<'_>, workspace: &Workspace) -> String {
    let db = &workspace.db;
    let mut text =
        format!("{}; name one as `path` for its content\n", counted(workspace.projects.len() as u64, "project"));
    for project in &workspace.projects {
        let content = val3_ide::project_content(db, *project);
        let folder = call.roots.shown(&projects::folder(db, *project));
        let (programs, data) = (content.programs.len() as u64, content.data.len() as u64);
        let role = project::role(&content);
        text.push_str(&format!("- {folder}: {role}, {}, {data} data\n", counted(programs, "program")));
    }
    text
}

/// Files and folders that cannot be read, so that their projects are missing in the outline, one per line.
fn unreadable(call: &Call<'_>, workspace: &Workspace) -> String {
    let files = workspace.unreadable.iter().map(|(path, reason)| (call.roots.shown(path), reason));
    files.map(|(path, reason)| format!("- {path} cannot be read: {reason}\n")).collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::command::CommandEnd;
    use crate::testing::{Folder, call};

    #[test]
    fn an_outline_names_what_cannot_be_read() {
        let project = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
            <Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\"><Programs/></Project>\n";
        let folder = Folder::new(&[("cell/cell.pjx", project), ("other/other.pjx/is a folder", "")]);
        let outline = |path: &str| {
            let unexpected = Err(CommandEnd::Start("no command was expected".to_owned()));
            call(&folder, &crate::tool::Tool::of::<Outline>(), json!({ "path": path }), unexpected).unwrap()
        };
        let (whole, part) = (outline("."), outline("cell"));
        assert!(!whole.ok && whole.text.contains("- other/other.pjx cannot be read: "), "{}", whole.text);
        assert!(part.ok && !part.text.contains("cannot be read"), "{}", part.text);
    }
}
