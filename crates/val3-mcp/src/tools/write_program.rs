//! `write_program`: creates or replaces a program from text, with its XML and its entry in the project file.

use camino::Utf8Path;
use schemars::JsonSchema;
use serde::Deserialize;
use val3_analysis::system::Disk;
use val3_ide::write_program;

use crate::answer::Answer;
use crate::changes::Changes;
use crate::command::{CommandRequest, OF_RUNS};
use crate::projects;
use crate::refusal::Refusal;
use crate::tool::{Call, Definition, Effect};
use crate::written::changed;

/// The tool.
pub(super) struct WriteProgram;

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Folder of the application or library, such as usr/usrapp/pick; a new folder becomes a new application
    path: String,
    /// The whole program, in the form of `outline`: head, locals, begin, code, end. Example:
    /// `public program pick(num x_nCount, string& x_sName, num x_nList[])\n  num l_n\n  point l_p[3]\nbegin\n  l_n=1\nend`
    text: String,
    /// Only show the effect, and write nothing
    #[serde(default)]
    dry_run: bool,
}

impl Definition for WriteProgram {
    const NAME: &'static str = "write_program";
    const TITLE: &'static str = "Write a program";
    const DESCRIPTION: &'static str = "Creates or replaces a program from plain text, and writes its XML and its entry \
        in the project file. Returns the changed lines and the findings that are new.";
    const EFFECT: Effect = Effect::Writes;
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let path = call.roots.resolve(&arguments.path)?;
        let mut created = String::new();
        if !path.exists() {
            if arguments.dry_run {
                return Err(Refusal(format!(
                    "`{}` does not exist: call without `dry_run` to create it",
                    arguments.path
                )));
            }
            created = create(call, &path)?;
        }
        let workspace = projects::read(&Disk, call.roots, &path)?;
        let project = projects::only(&workspace, call.roots, &path)?;
        let (change, _) = write_program(&workspace.db, project, &arguments.text).map_err(Refusal)?;
        let changes = Changes::of(&workspace.db, call.roots, &change)?;
        let answer = changed(call, &changes, &path, arguments.dry_run)?;
        Ok(Answer { text: format!("{created}{}", answer.text), ..answer })
    }
}

/// Creates an application with `val3 new`. Returns a description of the written files.
fn create(call: &Call<'_>, path: &Utf8Path) -> Result<String, Refusal> {
    let (Some(name), Some(parent)) = (path.file_name(), path.parent().filter(|parent| parent.is_dir())) else {
        return Err(Refusal(format!("the folder around `{}` does not exist", call.roots.shown(path))));
    };
    if name.starts_with('-') {
        return Err(Refusal(format!("`{name}` is no name of an application: use letters, digits and `_`")));
    }
    let output = call.command(&CommandRequest::new(["new", name, "--folder", parent.as_str()], OF_RUNS))?;
    if path.is_dir() {
        return Ok(format!("{}\n", output.messages.trim()));
    }
    let written = output.messages.trim();
    Err(Refusal(format!(
        "the new application is not in `{}`, because no cell contains this folder; use its path: {written}",
        call.roots.shown(path)
    )))
}
