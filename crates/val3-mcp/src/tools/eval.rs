//! `eval`: values of expressions, and effects of statements.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::answer::Answer;
use crate::command::{CommandRequest, OF_RUNS};
use crate::refusal::Refusal;
use crate::report::notes;
use crate::tool::{Call, Definition};

/// The tool.
pub(super) struct Eval;

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Expressions, declarations (`num nA=2`, `point pA[3]`) and statements, one a line; lines share their variables
    code: String,
    /// Application whose data, programs and libraries the code uses
    path: Option<String>,
}

impl Definition for Eval {
    const NAME: &'static str = "eval";
    const TITLE: &'static str = "Evaluate VAL 3";
    const DESCRIPTION: &'static str = "Executes VAL 3 code on a virtual controller and returns the values of \
        expressions. Changes no file. For expressions, transformations, string functions and single instructions.";
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let mut command = vec!["eval".to_owned()];
        if let Some(path) = &arguments.path {
            command.extend(["--app".to_owned(), call.roots.resolve(path)?.into_string()]);
        }
        let request = CommandRequest { input: arguments.code, ..CommandRequest::new(command, OF_RUNS) };
        let output = call.command(&request)?;
        let (values, messages) = (output.text.trim_end(), notes(&output.messages));
        Ok(Answer::new(output.exit_code == 0, format!("\n```text\n{values}{messages}\n```")))
    }
}
