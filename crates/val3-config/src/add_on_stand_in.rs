//! Stand-ins for instructions of add-ons that a simulated controller does not have.

use std::borrow::Cow;
use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};

/// The value that the stand-in of an instruction returns.
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

impl JsonSchema for StandInValue {
    fn schema_name() -> Cow<'static, str> {
        "StandInValue".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["boolean", "integer", "number", "string"] })
    }
}

/// Reads stand-ins by the names of instructions, which begin with `$`.
pub(crate) fn read<'de, D: Deserializer<'de>>(input: D) -> Result<BTreeMap<String, StandInValue>, D::Error> {
    let stand_ins = BTreeMap::<String, StandInValue>::deserialize(input)?;
    match stand_ins.keys().find(|name| !name.starts_with('$')) {
        Some(name) => Err(D::Error::custom(format!(
            "`{name}` is not the name of an instruction of an add-on, which begins with `$`"
        ))),
        None => Ok(stand_ins),
    }
}
