//! The tools, one a file.

mod check;
mod eval;
mod explain;
mod outline;
mod rename;
mod run;
mod test;
#[cfg(test)]
pub(crate) mod testing;
mod write_data;
mod write_program;

pub(crate) use explain::{GUIDE, page};

use camino::Utf8Path;
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::answer::Answer;
use crate::arguments;
use crate::changes::Changes;
use crate::command::{CommandOutput, CommandRequest, Commands, run};
use crate::refusal::Refusal;
use crate::roots::Roots;
use crate::schema::schema;

/// Returns the tools in the order of the list; those that change files only if `may_write`.
pub(crate) fn all(may_write: bool) -> Vec<Tool> {
    let tools = [
        Tool::of::<outline::Outline>(),
        Tool::of::<explain::Explain>(),
        Tool::of::<check::Check>(),
        Tool::of::<eval::Eval>(),
        Tool::of::<run::Run>(),
        Tool::of::<test::Test>(),
        Tool::of::<write_program::WriteProgram>(),
        Tool::of::<write_data::WriteData>(),
        Tool::of::<rename::Rename>(),
    ];
    tools.into_iter().filter(|tool| may_write || tool.effect == Effect::Reads).collect()
}

/// What a tool does with files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Effect {
    /// It changes no file.
    Reads,
    /// It changes files. A second equal call changes nothing more.
    Writes,
    /// It changes files. A second equal call is refused.
    WritesOnce,
}

/// Definition of a tool.
pub(crate) trait Definition {
    /// Name.
    const NAME: &'static str;
    /// Title for people.
    const TITLE: &'static str;
    /// Description for language models.
    const DESCRIPTION: &'static str;
    /// Effect.
    const EFFECT: Effect = Effect::Reads;
    /// Arguments; the documentation of each field is its description.
    type Arguments: DeserializeOwned + JsonSchema;

    /// Executes a call.
    ///
    /// # Errors
    /// The call cannot be executed.
    fn call(call: &Call<'_>, arguments: Self::Arguments) -> Result<Answer, Refusal>;
}

/// A tool of the list.
#[derive(Debug, Clone)]
pub(crate) struct Tool {
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    pub(crate) description: &'static str,
    pub(crate) effect: Effect,
    /// JSON schema of the arguments.
    pub(crate) schema: Map<String, Value>,
    call: fn(&Call<'_>, &Map<String, Value>, Map<String, Value>) -> Result<Answer, Refusal>,
}

impl Tool {
    fn of<D: Definition>() -> Self {
        Self {
            name: D::NAME,
            title: D::TITLE,
            description: D::DESCRIPTION,
            effect: D::EFFECT,
            schema: schema::<D::Arguments>(),
            call: |call, schema, arguments| D::call(call, arguments::read(D::NAME, arguments, schema)?),
        }
    }

    /// Executes a call.
    ///
    /// # Errors
    /// The arguments are wrong, or the call cannot be executed.
    pub(crate) fn call(&self, call: &Call<'_>, arguments: Map<String, Value>) -> Result<Answer, Refusal> {
        (self.call)(call, &self.schema, arguments)
    }
}

/// Surroundings of a call.
pub(crate) struct Call<'c> {
    pub(crate) roots: &'c Roots,
    pub(crate) commands: &'c dyn Commands,
    /// Whether the client has cancelled the call.
    pub(crate) is_cancelled: &'c dyn Fn() -> bool,
}

impl Call<'_> {
    /// Starts a command.
    ///
    /// # Errors
    /// The command rejects its arguments, or was ended.
    pub(crate) fn command(&self, request: &CommandRequest) -> Result<CommandOutput, Refusal> {
        run(self.commands, request, self.is_cancelled)
    }
}

/// Writes changes unless it is a dry run, and describes them: changed lines, and findings of the projects below `path`
/// that are new.
pub(crate) fn changed(call: &Call<'_>, changes: &Changes, path: &Utf8Path, dry_run: bool) -> Result<Answer, Refusal> {
    if changes.is_empty() {
        return Ok(Answer::new(true, "nothing changes: the files already contain this"));
    }
    let effect = changes.effect(call.roots, path)?;
    if !dry_run {
        changes.write(call.roots)?;
    }
    let mut text = if dry_run { "nothing was written; the change is:\n" } else { "written\n" }.to_owned();
    text.push_str(&changes.diff(call.roots));
    let new = counted(effect.new.len() as u64, "new finding");
    text.push_str(&format!("{new}, {} solved\n", effect.solved));
    effect.new.iter().for_each(|finding| text.push_str(&format!("{finding}\n")));
    Ok(Answer::new(!effect.has_errors, text))
}

/// Parses the output of a command as JSON.
pub(crate) fn json(output: &CommandOutput) -> Result<Value, Refusal> {
    serde_json::from_str(&output.text)
        .map_err(|error| Refusal(format!("the output of the command cannot be read ({error}): {}", output.messages)))
}

/// Messages of a command on lines of their own, without advice to use options that a call does not have.
pub(crate) fn notes(messages: &str) -> String {
    let is_advice = |line: &str| line.trim_start().starts_with("help:") && line.contains("--");
    messages.trim().lines().filter(|line| !is_advice(line)).map(|line| format!("\n{line}")).collect()
}

/// Text of a JSON value; empty if it is none.
pub(crate) fn text<'v>(value: &'v Value, key: &str) -> &'v str {
    value.get(key).and_then(Value::as_str).unwrap_or_default()
}

/// Number of a JSON value; 0 if it is none.
pub(crate) fn number(value: &Value, key: &str) -> u64 {
    value.get(key).and_then(Value::as_u64).unwrap_or_default()
}

/// Items of a JSON array; empty if it is none.
pub(crate) fn items<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value.get(key).and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default()
}

/// A count with its noun: `1 error`, `2 errors`.
pub(crate) fn counted(count: u64, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// Descriptions and schemas of the tools as a client receives them, without annotations.
    fn listed() -> Value {
        let tool =
            |tool: Tool| json!({ "name": tool.name, "description": tool.description, "inputSchema": tool.schema });
        all(true).into_iter().map(tool).collect()
    }

    #[test]
    fn the_list_has_nine_tools_and_six_that_only_read() {
        assert_eq!((all(true).len(), all(false).len()), (9, 6));
    }

    #[test]
    fn the_list_fits_its_budget() {
        // Titles and annotations need about 150 bytes more for each tool.
        let bytes = listed().to_string().len() + 9 * 150;
        assert!(bytes <= 9_000, "{bytes}");
    }

    #[test]
    fn every_schema_is_one_that_clients_accept() {
        for tool in all(true) {
            let schema = Value::Object(tool.schema.clone());
            assert_eq!(schema["type"], "object", "{}", tool.name);
            assert_eq!(schema["additionalProperties"], false, "{}", tool.name);
            for (name, property) in schema["properties"].as_object().unwrap() {
                assert!(property["description"].is_string(), "{}.{name} has no description", tool.name);
                assert!(property["type"].is_string(), "{}.{name} has no single type: {property}", tool.name);
                assert!(property["type"] != "array" || property["items"].is_object(), "{}.{name}", tool.name);
            }
            let text = schema.to_string();
            assert!(!text.contains("$ref") && !text.contains("\"null\"") && !text.contains("anyOf"), "{text}");
        }
    }
}
