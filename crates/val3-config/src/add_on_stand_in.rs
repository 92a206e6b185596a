//! Stand-ins for add-on instructions that a simulated controller does not have: values and programs.

use std::borrow::Cow;
use std::collections::BTreeMap;

use camino::{Utf8Path, Utf8PathBuf};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};

/// Stand-in for an add-on instruction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(
    untagged,
    expecting = "a stand-in is a number, `true`, `false`, a text, or a program: `{ program = \"FOLDER/PROGRAM.pgx\" }`"
)]
pub enum AddOnStandIn {
    /// A value that the instruction returns.
    Value(StandInValue),
    /// A program that is called.
    Program(StandInProgram),
}

/// Value that a stand-in returns in place of the instruction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum StandInValue {
    /// A `bool`.
    Bool(bool),
    /// A `num`.
    Number(f64),
    /// A `string`.
    Text(String),
}

/// Program that is called in place of the instruction.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StandInProgram {
    /// The program file in the folder of its library, from the folder of the settings file: `standIns/velJoint.pgx`.
    /// The ending may be omitted.
    pub program: Utf8PathBuf,
}

impl StandInProgram {
    /// Returns the folder of the library, relative to the folder of the settings file; empty if the path contains no
    /// folder.
    pub fn folder(&self) -> &Utf8Path {
        self.program.parent().unwrap_or(Utf8Path::new(""))
    }

    /// Returns the program name.
    pub fn name(&self) -> &str {
        let name = self.program.file_name().unwrap_or_default();
        name.strip_suffix(".pgx").unwrap_or(name)
    }
}

impl JsonSchema for AddOnStandIn {
    fn schema_name() -> Cow<'static, str> {
        "AddOnStandIn".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": ["boolean", "integer", "number", "string", "object"],
            "properties": {
                "program": {
                    "description": "The program file in the folder of its library, from the folder of this file: \
                        `standIns/velJoint.pgx`.",
                    "type": "string"
                }
            },
            "required": ["program"],
            "additionalProperties": false
        })
    }
}

/// Reads stand-ins by instruction name. The names must begin with `$`.
pub(crate) fn read<'de, D: Deserializer<'de>>(input: D) -> Result<BTreeMap<String, AddOnStandIn>, D::Error> {
    let stand_ins = BTreeMap::<String, AddOnStandIn>::deserialize(input)?;
    for (name, stand_in) in &stand_ins {
        check_name(name).map_err(D::Error::custom)?;
        if let AddOnStandIn::Program(program) = stand_in {
            check_folder(program).map_err(D::Error::custom)?;
        }
    }
    Ok(stand_ins)
}

fn check_name(name: &str) -> Result<(), String> {
    if name.starts_with('$') {
        return Ok(());
    }
    Err(format!("`{name}` is not the name of an instruction of an add-on, which begins with `$`"))
}

fn check_folder(program: &StandInProgram) -> Result<(), String> {
    if program.folder().file_name().is_some() {
        return Ok(());
    }
    let path = &program.program;
    Err(format!("the path `{path}` does not name the folder of the library with the program: `standIns/{path}`"))
}
