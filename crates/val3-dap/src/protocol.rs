//! Types of the specification.
//!
//! `cargo xtask dap` generates the files of this folder. Each type has the name of the definition in the schema. Types
//! of responses and events describe the bodies. Unknown properties are ignored, and an open enumeration keeps
//! unknown values in its variant `Other`.

#![allow(missing_docs, reason = "the specification describes each property and value")]

mod arguments;
mod enumerations;
mod events;
mod operations;
mod responses;
mod types;

use std::collections::BTreeMap;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

pub use self::arguments::*;
pub use self::enumerations::*;
pub use self::events::*;
pub use self::operations::*;
pub use self::responses::*;
pub use self::types::*;

/// Decodes arguments or a body. Missing arguments and bodies are decoded like an empty object.
pub(crate) fn content<T: DeserializeOwned>(value: Option<Value>) -> serde_json::Result<T> {
    let properties = match value {
        None | Some(Value::Null) => Map::new(),
        // serde would also read a structure from a list, which the protocol does not allow.
        Some(value) => serde_json::from_value(value)?,
    };
    serde_json::from_value(Value::Object(properties))
}
