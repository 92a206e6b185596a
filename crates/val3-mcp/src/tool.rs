//! A tool: its definition, and the surroundings of its calls.

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::answer::Answer;
use crate::arguments;
use crate::command::{CommandOutput, CommandRequest, Commands, run};
use crate::refusal::Refusal;
use crate::roots::Roots;
use crate::schema::schema;

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
    /// Creates the tool of a definition.
    pub(crate) fn of<D: Definition>() -> Self {
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
