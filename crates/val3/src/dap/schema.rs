//! JSON schemas of `launch` and `attach` for editors, derived from the arguments of `val3 run`.

use std::any::TypeId;

use clap::{Arg, ArgAction};
use serde_json::{Map, Value, json};
use val3_dap::SECRET;
use val3_debug::PastLimits;
use val3_lang::ports::Time;

use super::launch::{APPLICATION, TEST, command, is_unfit, key};

/// Schemas by request name, as text with a final newline. Editors read `editors/schema/debugger.schema.json`.
pub(crate) fn json_schemas() -> String {
    let mut attach = common();
    let port = json!({
        "type": "integer",
        "minimum": 1,
        "maximum": u16::MAX,
        "description": "The port of a run on this machine that `val3 run --debug-port PORT` has begun",
    });
    attach.insert("port".to_owned(), port);
    let schemas = json!({
        "launch": { "properties": launch(), "required": [APPLICATION] },
        "attach": { "properties": attach, "required": ["port"] },
    });
    format!("{schemas:#}\n")
}

fn launch() -> Map<String, Value> {
    let command = command();
    let options = command.get_arguments().filter(|argument| argument.get_long().is_some_and(|long| !is_unfit(long)));
    let mut properties = common();
    properties.extend(options.filter_map(|option| Some((key(option.get_long()?), property(option)))));
    let application = "The folder or .pjx of the application, or a folder that contains exactly one";
    properties.insert(APPLICATION.to_owned(), json!({ "type": "string", "description": application }));
    let test = "The test of the application to debug, with setup, teardown and its script, such as testTotal";
    properties.insert(TEST.to_owned(), json!({ "type": "string", "description": test }));
    let end =
        "Go to the end of the recording that `replay` names without stops, and stop there, from where one can go back";
    properties.insert("startAtEnd".to_owned(), json!({ "type": "boolean", "default": false, "description": end }));
    properties
}

/// Keys of both requests.
fn common() -> Map<String, Value> {
    let stop = json!({ "type": "boolean", "default": false, "description": "Stop immediately, before the first line of a launched run" });
    let exit = json!({ "type": "boolean", "default": false, "description": "Stop before the end of the last task, with the past of the run; the extension for VS Code sets it for applications unless a configuration says otherwise" });
    let screen = json!({ "type": "boolean", "default": true, "description": "Show text that programs write on user pages in the debug console" });
    let mode = json!({
        "type": "string",
        "enum": ["continuous", "step"],
        "enumDescriptions": [
            "The arm moves as on the controller",
            "The arm stops at the end of each piece of the motion",
        ],
        "default": "continuous",
        "description": "The mode of the motion at first",
    });
    let scope = json!({
        "type": "string",
        "enum": ["all", "task"],
        "enumDescriptions": ["All tasks, the clock and the arm stop", "The others, the clock and the arm continue"],
        "default": "all",
        "description": "What stops with a task",
    });
    let skip = json!({
        "type": "array",
        "items": { "type": "string", "minLength": 1 },
        "default": [],
        "description": "Libraries (`library`) and programs (`library:program`) in which steps into calls do not end; `*` stands for any text, `?` for one character",
    });
    let filter = json!({
        "type": "string",
        "default": "",
        "description": "Show only the global variables whose names match: patterns such as `nPush*` or `io:di*`, separated by commas; a name without `*` and `?` matches anywhere in a name",
    });
    let angles = json!({
        "type": "string",
        "enum": ["degrees", "radians"],
        "default": "degrees",
        "description": "The unit of angles in the values of positions",
    });
    let secret = json!({
        "type": "string",
        "description": "The secret that `val3 run --debug-port PORT` or `val3 dap --port PORT` has printed with its port",
    });
    let usual = PastLimits::default();
    let limit = |usual: u64, description: &str| json!({ "type": "integer", "minimum": 1, "default": usual, "description": description });
    let keys = [
        ("stopOnEntry", stop),
        ("stopOnExit", exit),
        ("screenOutput", screen),
        ("motionMode", mode),
        ("stopScope", scope),
        ("skip", skip),
        ("variableFilter", filter),
        ("angles", angles),
        (SECRET, secret),
        ("pastSnapshots", limit(usual.snapshots as u64, "The number of snapshots that are kept to go back in the run")),
        (
            "pastMemory",
            limit(
                usual.bytes >> 20,
                "The memory of the past, in MiB: snapshots, and what the programs have read or received meanwhile",
            ),
        ),
    ];
    keys.into_iter().map(|(key, schema)| (key.to_owned(), schema)).collect()
}

/// Option schema.
fn property(option: &Arg) -> Value {
    let mut schema = Map::new();
    let choices = option.get_possible_values();
    let is_switch = matches!(option.get_action(), ArgAction::SetTrue);
    let is_list = matches!(option.get_action(), ArgAction::Append) || option.get_value_delimiter().is_some();
    let is_optional = option.get_num_args().is_some_and(|range| range.min_values() == 0);
    let ty = if is_switch { "boolean" } else { type_name(option) };
    match (is_list, is_optional) {
        (true, _) => {
            schema.insert("type".to_owned(), json!("array"));
            schema.insert("items".to_owned(), json!({ "type": ty }));
        }
        (false, true) if !is_switch => _ = schema.insert("type".to_owned(), json!(["boolean", ty])),
        _ => _ = schema.insert("type".to_owned(), json!(ty)),
    }
    if !is_switch && !choices.is_empty() {
        let names: Vec<_> = choices.iter().map(clap::builder::PossibleValue::get_name).collect();
        let helps: Vec<_> = choices.iter().filter_map(|choice| Some(choice.get_help()?.to_string())).collect();
        schema.insert("enum".to_owned(), json!(names));
        schema.insert("enumDescriptions".to_owned(), json!(helps));
    }
    if let Some(default) = option.get_default_values().first().filter(|_| !is_switch) {
        schema.insert("default".to_owned(), json!(default.to_string_lossy()));
    }
    let help = option.get_help().map(ToString::to_string).unwrap_or_default();
    schema.insert("description".to_owned(), json!(with_keys(&help)));
    Value::Object(schema)
}

fn type_name(option: &Arg) -> &'static str {
    let ty = option.get_value_parser().type_id();
    if ty == TypeId::of::<u8>() || ty == TypeId::of::<u16>() {
        "integer"
    } else if ty == TypeId::of::<f64>() || ty == TypeId::of::<Time>() {
        "number"
    } else {
        "string"
    }
}

/// Replaces options in a help text by their configuration keys.
fn with_keys(help: &str) -> String {
    help.split(' ').map(word_with_key).collect::<Vec<_>>().join(" ")
}

/// Replaces the option with which the word begins, if any, by its configuration key.
fn word_with_key(word: &str) -> String {
    let Some(option) = word.strip_prefix("--") else { return word.to_owned() };
    let end = option.find(|letter: char| !letter.is_ascii_lowercase() && letter != '-').unwrap_or(option.len());
    let (long, rest) = option.split_at(end);
    format!("`{}`{rest}", key(long))
}

#[cfg(test)]
mod tests {
    use expect_test::expect_file;

    use super::*;

    /// `UPDATE_EXPECT=1 cargo test -p val3 the_shipped_schemas` updates the file.
    #[test]
    fn the_shipped_schemas_are_up_to_date() {
        expect_file!["../../../../editors/schema/debugger.schema.json"].assert_eq(&json_schemas());
    }

    #[test]
    fn options_have_the_types_that_a_configuration_takes() {
        let properties = launch();
        let types = |key: &str| properties[key]["type"].clone();
        assert_eq!(types("monitorSpeed"), "integer");
        assert_eq!(types("until"), "number");
        assert_eq!(types("lineCost"), "number");
        assert_eq!(types("power"), "boolean");
        assert_eq!(types("times"), json!(["boolean", "string"]));
        assert_eq!(properties["start"]["items"]["type"], "number");
        assert_eq!(properties["root"]["items"]["type"], "string");
        assert_eq!(properties["time"]["enum"], json!(["virtual", "real"]));
        assert_eq!(properties["startProgram"]["default"], "start");
        assert!(!properties.contains_key("interactive"));
    }

    #[test]
    fn descriptions_mention_keys_instead_of_options() {
        assert_eq!(with_keys("As --trace-all, or --program"), "As `traceAll`, or `startProgram`");
    }
}
