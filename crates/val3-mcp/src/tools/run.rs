//! `run`: executes an application in virtual time.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

use crate::answer::Answer;
use crate::command::{CommandRequest, OF_RUNS};
use crate::refusal::Refusal;
use crate::report::notes;
use crate::tool::{Call, Definition};

/// The tool.
pub(super) struct Run;

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Folder of the application
    #[serde(default = "crate::arguments::here")]
    path: String,
    /// Program to start with, instead of `start`
    program: Option<String>,
    /// Seconds of the controller's clock after which the run ends, at most 600. Default: 30
    until: Option<f64>,
    /// Whether `until` is the normal end, as of a cyclic program
    #[serde(default)]
    until_ok: bool,
    /// Events outside of the application: TOML text such as `[[at]]\nt = 1\nio = { diPart = true }`, or the path of a
    /// .toml file
    script: Option<String>,
    /// Arm, such as tx2-60l, instead of the cell's arm
    arm: Option<String>,
    /// Whether the operator has switched the arm's power on
    #[serde(default)]
    power: bool,
    /// Values of global variables and fields before the run, such as {"nSpeed": 50, "mFast.leave": 20}
    #[serde(default)]
    set: BTreeMap<String, Value>,
}

/// Maximum length of a run, in seconds of the controller's clock.
const LONGEST: f64 = 600.0;

/// Default length of a run, in seconds of the controller's clock.
const USUAL: f64 = 30.0;

impl Definition for Run {
    const NAME: &'static str = "run";
    const TITLE: &'static str = "Run an application";
    const DESCRIPTION: &'static str = "Executes an application with its arm on a virtual controller and summarises the \
        run: why it ended, errors with their lines, prints, user page, moves, waits, I/O, what to do next. Takes no real \
        time, changes no file, reaches no network. Equal calls have equal results.";
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let until = arguments.until.unwrap_or(USUAL);
        if !(0.0..=LONGEST).contains(&until) {
            return Err(Refusal(format!("`until` is {until}: write seconds from 0 to {LONGEST}")));
        }
        let path = call.roots.resolve(&arguments.path)?;
        let mut command = vec!["run".to_owned(), path.into_string(), "--summary".to_owned()];
        command.extend(["--until".to_owned(), until.to_string()]);
        if arguments.until_ok {
            command.push("--until-ok".to_owned());
        }
        if let Some(program) = &arguments.program {
            command.push(format!("--program={program}"));
        }
        if let Some(arm) = &arguments.arm {
            command.push(format!("--arm={}", known_arm(call, arm)?));
        }
        if arguments.power {
            command.push("--power".to_owned());
        }
        for (name, value) in &arguments.set {
            command.push(format!("--set={name}={}", literal(value)?));
        }
        let mut request = CommandRequest::new(command, OF_RUNS);
        request.script = arguments.script.as_deref().map(|script| script_text(call, script)).transpose()?;
        let output = call.command(&request)?;
        let text = format!("{}{}", output.text.trim_end(), notes(&output.messages));
        Ok(Answer::new(output.exit_code == 0, with_arguments(&text)))
    }
}

/// Replaces option names in a message of the command by the arguments of this tool.
fn with_arguments(text: &str) -> String {
    let options = [("(--script)", "(`script`)"), ("--until-ok", "`until_ok`"), ("--until", "`until`")];
    options.iter().fold(text.to_owned(), |text, (option, argument)| text.replace(option, argument))
}

/// Returns an arm's name unchanged, or the resolved path of an arm file inside of the roots.
fn known_arm(call: &Call<'_>, arm: &str) -> Result<String, Refusal> {
    let is_path = arm.contains(['/', '\\', '.', ':']) || arm.starts_with('-');
    if is_path { call.roots.resolve(arm).map(Into::into) } else { Ok(arm.to_owned()) }
}

/// Text of a script: the argument itself, or the content of a file inside of the roots.
fn script_text(call: &Call<'_>, script: &str) -> Result<String, Refusal> {
    if script.contains(['\n', '=', '[']) {
        return Ok(script.to_owned());
    }
    let path = call.roots.resolve(script)?;
    val3_files::read_text(&path, val3_files::FileClass::Settings).map_err(|reason| {
        Refusal(format!(
            "cannot read the script `{script}`: {reason}. Write the TOML text itself, or the path of a file"
        ))
    })
}

/// Formats a value in the syntax of `--set`.
fn literal(value: &Value) -> Result<String, Refusal> {
    match value {
        Value::String(text) => Ok(Value::from(text.as_str()).to_string()),
        Value::Bool(_) | Value::Number(_) => Ok(value.to_string()),
        _ => Err(Refusal(format!("`set` has the value {value}: write a number, true, false or a string"))),
    }
}
