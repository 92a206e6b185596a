//! Test support: calls of tools with commands that are not started.

use serde_json::{Map, Value};

use super::{Call, Tool};
use crate::answer::Answer;
use crate::command::{CommandEnd, CommandOutput, CommandRequest, Commands};
use crate::refusal::Refusal;
use crate::testing::Folder;

/// Commands that return a prepared output and record nothing.
pub(crate) struct Prepared(pub(crate) Result<CommandOutput, CommandEnd>);

impl Commands for Prepared {
    fn start(&self, _: &CommandRequest, _: &dyn Fn() -> bool) -> Result<CommandOutput, CommandEnd> {
        self.0.clone()
    }
}

/// Calls a tool in a folder, with the output that its command will have.
pub(crate) fn call(
    folder: &Folder,
    tool: &Tool,
    arguments: Map<String, Value>,
    output: Result<CommandOutput, CommandEnd>,
) -> Result<Answer, Refusal> {
    let roots = folder.roots();
    tool.call(&Call { roots: &roots, commands: &Prepared(output), is_cancelled: &|| false }, arguments)
}

/// Calls a tool that has to refuse the call before it starts a command.
pub(crate) fn call_without_commands(tool: &Tool, arguments: Map<String, Value>) -> Result<Answer, Refusal> {
    call(&Folder::new(&[]), tool, arguments, Err(CommandEnd::Start("no command was expected".to_owned())))
}

/// The tool with a name.
pub(crate) fn tool(name: &str) -> Tool {
    super::all(true).into_iter().find(|tool| tool.name == name).unwrap()
}

/// Arguments of a call.
pub(crate) fn object(value: Value) -> Map<String, Value> {
    let Value::Object(object) = value else { panic!("{value} is no object") };
    object
}
