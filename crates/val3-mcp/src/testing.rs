//! Test support: a folder with files, and calls of tools with commands that are not started.

use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use serde_json::Value;
use tempfile::TempDir;
use val3_files::replace;

use crate::answer::Answer;
use crate::command::{CommandEnd, CommandOutput, CommandRequest, Commands};
use crate::refusal::Refusal;
use crate::roots::Roots;
use crate::tool::{Call, Tool};

/// A temporary folder with files.
pub(crate) struct Folder(TempDir);

impl Folder {
    pub(crate) fn new(files: &[(&str, &str)]) -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        for (path, text) in files {
            let path = folder.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            replace(&path, text.as_bytes()).unwrap();
        }
        folder
    }

    pub(crate) fn path(&self) -> Utf8PathBuf {
        Utf8Path::from_path(self.0.path()).unwrap().to_owned()
    }

    pub(crate) fn roots(&self) -> Roots {
        Roots::new(&self.path(), &[]).unwrap()
    }
}

/// Commands that end as prepared, without a process.
pub(crate) struct Prepared(pub(crate) Result<CommandOutput, CommandEnd>);

impl Commands for Prepared {
    fn start(&self, _: &CommandRequest, _: &dyn Fn() -> bool) -> Result<CommandOutput, CommandEnd> {
        self.0.clone()
    }
}

/// Calls a tool in a folder. A command that it starts ends with `end`.
pub(crate) fn call(
    folder: &Folder,
    tool: &Tool,
    arguments: Value,
    end: Result<CommandOutput, CommandEnd>,
) -> Result<Answer, Refusal> {
    let Value::Object(arguments) = arguments else { panic!("{arguments} is no object") };
    let (roots, commands) = (folder.roots(), Prepared(end));
    tool.call(&Call { roots: &roots, commands: &commands, is_cancelled: &|| false }, arguments)
}
