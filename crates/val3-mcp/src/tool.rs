//! Definition of a tool, and context of a call.

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::answer::Answer;
use crate::arguments;
use crate::command::{CommandOutput, CommandRequest, Commands, Report, report, run};
use crate::refusal::Refusal;
use crate::roots::Roots;
use crate::schema::schema;

/// Effect of a tool on files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Effect {
    /// No file is changed.
    Reads,
    /// Files are changed. An identical second call changes nothing more.
    Writes,
    /// Files are changed. An identical second call is rejected.
    WritesOnce,
}

/// Definition of a tool.
pub(crate) trait Definition {
    /// Name.
    const NAME: &'static str;
    /// Title for users.
    const TITLE: &'static str;
    /// Description for language models.
    const DESCRIPTION: &'static str;
    /// Effect on files.
    const EFFECT: Effect = Effect::Reads;
    /// Arguments. The doc comment of each field is the description in the schema.
    type Arguments: DeserializeOwned + JsonSchema;

    /// Executes a call.
    ///
    /// # Errors
    /// The call cannot be executed.
    fn call(call: &Call<'_>, arguments: Self::Arguments) -> Result<Answer, Refusal>;
}

/// Executes a call, with its context, the schema of the arguments, and the arguments.
type ToolFunction = fn(&Call<'_>, &Map<String, Value>, Map<String, Value>) -> Result<Answer, Refusal>;

/// A tool in the list of tools.
#[derive(Debug, Clone)]
pub(crate) struct Tool {
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    pub(crate) description: &'static str,
    pub(crate) effect: Effect,
    /// JSON schema of the arguments.
    pub(crate) schema: Map<String, Value>,
    call: ToolFunction,
}

impl Tool {
    /// Creates the list entry for a definition.
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

/// Context of a call.
pub(crate) struct Call<'c> {
    pub(crate) roots: &'c Roots,
    pub(crate) commands: &'c dyn Commands,
    /// Whether the client has cancelled the call.
    pub(crate) is_cancelled: &'c dyn Fn() -> bool,
}

impl Call<'_> {
    /// Starts a command of `val3`.
    ///
    /// # Errors
    ///
    /// The command rejects its arguments, or was ended.
    pub(crate) fn command(&self, request: &CommandRequest) -> Result<CommandOutput, Refusal> {
        run(self.commands, request, self.is_cancelled)
    }

    /// Starts a command of `val3` that writes its report as a JSON document.
    ///
    /// # Errors
    ///
    /// The command rejects its arguments or writes no report, or was ended.
    pub(crate) fn report(&self, request: &CommandRequest) -> Result<Report, Refusal> {
        report(self.commands, request, self.is_cancelled)
    }
}
