//! Debugger contribution of the VS Code extension: the keys of launch configurations, which derive from the arguments
//! of `val3 run`, and example configurations. If `program` is empty, the extension shows a choice of applications.

use serde_json::{Value, json};

/// Returns the debuggers of the extension. `schema` contains the keys of the requests.
pub(crate) fn all(schema: &Value) -> Value {
    json!([{
        "type": "val3",
        "label": "VAL 3",
        "languages": ["val3", "val3-code"],
        "configurationAttributes": schema,
        "initialConfigurations": [launch("Debug an application", "", json!({}))],
        "configurationSnippets": snippets(),
    }])
}

fn snippets() -> Value {
    let folder = "^\"\\${workspaceFolder}/usr/usrapp/${1:application}\"";
    let snippet = |label: &str, description: &str, body: Value| json!({ "label": label, "description": description, "body": body });
    json!([
        snippet(
            "VAL 3: Debug an application",
            "Runs an application on the embedded controller in real time",
            launch("Debug ${1:application}", folder, json!({})),
        ),
        snippet(
            "VAL 3: Debug an application with a script",
            "The script operates the pendant and sets inputs. The time is virtual, so that each run is the same",
            launch(
                "Debug ${1:application} with ${2:cell}",
                folder,
                json!({ "time": "virtual", "script": "^\"\\${workspaceFolder}/${2:cell}.toml\"" }),
            ),
        ),
        snippet(
            "VAL 3: Step the motion of an application",
            "The arm stops at the end of each piece of the motion",
            launch(
                "Step ${1:application}",
                folder,
                json!({ "power": true, "motionMode": "step", "stopOnEntry": true })
            ),
        ),
        snippet(
            "VAL 3: Debug a recorded run from its end",
            "Opens the events that `val3 run --events FILE` has recorded at their end, from where one can go back",
            launch(
                "Recording of ${1:application}",
                folder,
                json!({
                    "time": "virtual",
                    "replay": "^\"\\${workspaceFolder}/${2:run.jsonl}\"",
                    "startAtEnd": true,
                }),
            ),
        ),
        snippet(
            "VAL 3: Attach to a run",
            "Debugs what `val3 run --debug-port PORT` has begun",
            json!({ "type": "val3", "request": "attach", "name": "Attach to a run", "port": "^${1:4711}" }),
        ),
    ])
}

/// Returns a configuration that runs an application in real time, with further keys.
fn launch(name: &str, program: &str, further: Value) -> Value {
    let mut configuration =
        json!({ "type": "val3", "request": "launch", "name": name, "program": program, "time": "real" });
    if let (Some(configuration), Value::Object(further)) = (configuration.as_object_mut(), further) {
        configuration.extend(further);
    }
    configuration
}
