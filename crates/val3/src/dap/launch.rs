//! Conversion of a launch configuration to arguments of `val3 run`.

use clap::{Args as _, Command, FromArgMatches as _};
use serde_json::{Map, Value};

use crate::args::{RunArgs, RunTime};

/// Configuration key of the application.
pub(super) const APPLICATION: &str = "program";
/// Configuration key of the option `--program`, because `program` is the application.
const START_PROGRAM: &str = "startProgram";
/// Configuration key of the test.
pub(super) const TEST: &str = "test";
/// Configuration keys that exclude a test.
const UNFIT_FOR_TESTS: [&str; 4] = [START_PROGRAM, "script", "keys", "startAtEnd"];
/// Options of `val3 run` that a debugged run does not support, with the reason.
const UNFIT: [(&str, &str); 10] = [
    ("interactive", "needs a terminal, which a debugged run does not have"),
    ("screen", "needs a terminal, which a debugged run does not have"),
    ("output", "is for runs without a client, which shows the output"),
    ("scene", "is for applications that do not run"),
    ("debug-port", "is for runs that begin without a debugger"),
    ("debug-wait", "is for runs that begin without a debugger"),
    ("serve", "is for runs that begin without a debugger"),
    ("modbus", "is for runs that begin without a debugger"),
    ("controller", "is for runs that begin without a debugger"),
    ("open", "is for runs that begin without a debugger"),
];

/// Converts a configuration to arguments of `val3 run`. Option names are keys in camel case; other keys belong to the
/// client and the adapter.
///
/// # Errors
/// The reason why an option cannot be used.
pub(super) fn arguments(configuration: &Map<String, Value>) -> Result<RunArgs, String> {
    let command = command();
    let mut line = Vec::new();
    for option in command.get_arguments() {
        let Some(long) = option.get_long() else { continue };
        let key = key(long);
        let Some(value) = configuration.get(&key) else { continue };
        if let Some((_, reason)) = UNFIT.iter().find(|(unfit, _)| *unfit == long) {
            return Err(format!("`{key}` {reason}"));
        }
        let values = match value {
            Value::Array(values) if option.get_value_delimiter().is_some() => {
                vec![Value::String(values.iter().map(shown).collect::<Vec<_>>().join(","))]
            }
            Value::Array(values) => values.clone(),
            other => vec![other.clone()],
        };
        for value in values {
            match value {
                Value::Bool(false) | Value::Null => {}
                Value::Bool(true) => line.push(format!("--{long}")),
                other => line.push(format!("--{long}={}", shown(&other))),
            }
        }
    }
    match configuration.get(APPLICATION) {
        Some(Value::String(path)) => line.extend(["--".to_owned(), path.clone()]),
        None => {}
        Some(_) => return Err(format!("`{APPLICATION}` is the path of an application")),
    }
    let matches = command.try_get_matches_from(line).map_err(|error| worded(&error.to_string()))?;
    let args = RunArgs::from_arg_matches(&matches).map_err(|error| worded(&error.to_string()))?;
    match args.events.as_ref().is_some_and(|path| path == "-") {
        true => Err("`events` is a file: the standard output belongs to the debugger".to_owned()),
        false => Ok(args),
    }
}

/// Sets the options of a run that goes to its end: the time is virtual.
///
/// # Errors
/// The run repeats no recording.
pub(super) fn go_to_end(args: &mut RunArgs) -> Result<(), String> {
    args.time = Some(RunTime::Virtual);
    match args.replay {
        Some(_) => Ok(()),
        None => Err("`startAtEnd` needs `replay`, the recording of a run".to_owned()),
    }
}

/// Returns the name of the test that the configuration debugs.
///
/// # Errors
/// The value is no name, or a key excludes a test.
pub(super) fn test(configuration: &Map<String, Value>) -> Result<Option<String>, String> {
    let name = match configuration.get(TEST) {
        None | Some(Value::Null) => return Ok(None),
        Some(Value::String(name)) => name.clone(),
        Some(_) => return Err(format!("`{TEST}` is the name of a test, such as `testTotal`")),
    };
    match UNFIT_FOR_TESTS.iter().find(|key| configuration.contains_key(**key)) {
        Some(key) => Err(format!("`{key}` is for runs: a test has its own program and the script next to it")),
        None => Ok(Some(name)),
    }
}

/// Command with the options of `val3 run`.
pub(super) fn command() -> Command {
    RunArgs::augment_args(Command::new("launch").no_binary_name(true).color(clap::ColorChoice::Never))
}

/// Whether a debugged run does not support the option.
pub(super) fn is_unfit(long: &str) -> bool {
    UNFIT.iter().any(|(unfit, _)| *unfit == long)
}

/// An option's configuration key.
pub(super) fn key(long: &str) -> String {
    if long == "program" { START_PROGRAM.to_owned() } else { camel_case(long) }
}

fn shown(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

fn camel_case(option: &str) -> String {
    let mut words = option.split('-');
    let first = words.next().unwrap_or_default().to_owned();
    words.fold(first, |name, word| {
        let (initial, rest) = word.split_at_checked(1).unwrap_or((word, ""));
        name + &initial.to_ascii_uppercase() + rest
    })
}

/// First line of a command-line error; the following lines describe the usage.
fn worded(error: &str) -> String {
    error.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn of(configuration: Value) -> Result<RunArgs, String> {
        let Value::Object(configuration) = configuration else { panic!("no object") };
        arguments(&configuration)
    }

    #[test]
    fn each_option_of_a_run_has_a_key() {
        let args = of(json!({
            "type": "val3", "request": "launch", "name": "x", "stopOnEntry": true, "__sessionId": 4,
            "program": "cell/app", "startProgram": "main", "arm": "TX2-60", "monitorSpeed": 50, "time": "real",
            "until": 2.5, "untilOk": true, "power": true, "network": false,
            "start": [0, 0, 90, 0, -90.5, 0], "line": ["Socket\\a=server:2000", "Socket\\b=server:2001"],
        }))
        .unwrap();
        assert_eq!(args.application, "cell/app");
        assert_eq!((args.program.as_str(), args.until, args.until_ok), ("main", Some(2.5), true));
        let controller = &args.controller;
        assert_eq!((controller.arm.as_deref(), controller.monitor_speed), (Some("TX2-60"), Some(50)));
        assert_eq!((controller.power, controller.network, controller.line.len()), (true, false, 2));
        assert_eq!(controller.start.as_deref(), Some(&[0.0, 0.0, 90.0, 0.0, -90.5, 0.0][..]));
        assert!(args.follows_wall());
    }

    #[test]
    fn faults_name_the_option() {
        assert!(of(json!({ "monitorSpeed": 200 })).unwrap_err().contains("--monitor-speed"));
        assert!(of(json!({ "interactive": true })).unwrap_err().contains("terminal"));
        assert!(of(json!({ "events": "-" })).unwrap_err().contains("standard output"));
        assert!(of(json!({ "program": 5 })).unwrap_err().contains("path"));
    }

    #[test]
    fn a_run_to_the_end_repeats_a_recording_in_virtual_time() {
        let mut args = of(json!({ "replay": "run.jsonl", "time": "real" })).unwrap();
        assert_eq!(go_to_end(&mut args), Ok(()));
        assert!(!args.follows_wall());
        assert!(go_to_end(&mut of(json!({})).unwrap()).unwrap_err().contains("`replay`"));
    }

    #[test]
    fn a_test_has_its_own_program_and_script() {
        let named = |configuration: Value| test(configuration.as_object().unwrap());
        assert_eq!(named(json!({ "program": "appTest" })), Ok(None));
        assert_eq!(named(json!({ "test": "testSum" })), Ok(Some("testSum".to_owned())));
        assert!(named(json!({ "test": 1 })).unwrap_err().contains("name of a test"));
        for key in ["startProgram", "script", "keys", "startAtEnd"] {
            assert!(named(json!({ "test": "testSum", key: "x" })).unwrap_err().contains(key));
        }
    }
}
