//! The setting `version`.

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serializer};
use val3_lang::versions::Version;

#[expect(clippy::ref_option, reason = "the shape that serde asks for")]
pub(crate) fn serialize<S: Serializer>(version: &Option<Version>, out: S) -> Result<S::Ok, S::Error> {
    match version {
        Some(version) => out.collect_str(version),
        None => out.serialize_none(),
    }
}

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(input: D) -> Result<Option<Version>, D::Error> {
    let text = String::deserialize(input)?;
    let version = Version::parse(&text)
        .ok_or_else(|| D::Error::custom(format!("`{text}` is not a version of VAL 3; write it like \"s7.11\"")))?;
    Ok(Some(version))
}
