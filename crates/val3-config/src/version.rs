//! The setting `version`.

use std::ops::RangeInclusive;

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serializer};
use val3_lang::versions::Version;

/// Existing versions, by their first number.
const MAJOR: RangeInclusive<u8> = 5..=8;

#[expect(clippy::ref_option, reason = "the shape that serde asks for")]
pub(crate) fn serialize<S: Serializer>(version: &Option<Version>, out: S) -> Result<S::Ok, S::Error> {
    match version {
        Some(version) => out.collect_str(version),
        None => out.serialize_none(),
    }
}

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(input: D) -> Result<Option<Version>, D::Error> {
    let text = String::deserialize(input)?;
    let version = Version::parse(&text).filter(|version| MAJOR.contains(&version.major));
    let unknown = || format!("`{text}` is not a version of VAL 3 from s5 to s8; write it like \"s7.11\"");
    version.map(Some).ok_or_else(|| D::Error::custom(unknown()))
}
