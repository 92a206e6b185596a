//! The setting `arm`.

use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serializer};
use val3_lang::types::Arm;

/// The words for kinds of arms.
const KINDS: [(&str, Arm); 3] = [("six-axis", Arm::SixAxis), ("scara", Arm::Scara), ("other", Arm::Vrb)];

#[expect(clippy::ref_option, reason = "the shape that serde asks for")]
pub(crate) fn serialize<S: Serializer>(arm: &Option<Arm>, out: S) -> Result<S::Ok, S::Error> {
    match KINDS.iter().find(|(_, kind)| Some(*kind) == *arm) {
        Some((word, _)) => out.serialize_str(word),
        None => out.serialize_none(),
    }
}

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(input: D) -> Result<Option<Arm>, D::Error> {
    let text = String::deserialize(input)?;
    let arm = named(&text).ok_or_else(|| {
        D::Error::custom(format!(
            "`{text}` is not an arm; write \"six-axis\", \"scara\", \"other\", or a model such as \"tx2-60l\""
        ))
    })?;
    Ok(Some(arm))
}

fn named(text: &str) -> Option<Arm> {
    let kind = KINDS.iter().find(|(word, _)| word.eq_ignore_ascii_case(text)).map(|(_, arm)| *arm);
    kind.or_else(|| Some(Arm::from_model(text)).filter(|arm| *arm != Arm::Vrb && text.bytes().any(is_digit)))
}

fn is_digit(byte: u8) -> bool {
    byte.is_ascii_digit()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_and_models_are_read() {
        assert_eq!(named("six-axis"), Some(Arm::SixAxis));
        assert_eq!(named("tx2-60l"), Some(Arm::SixAxis));
        assert_eq!(named("TS60"), Some(Arm::Scara));
        assert_eq!(named("tp80"), Some(Arm::Scara));
        assert_eq!(named("other"), Some(Arm::Vrb));
        assert_eq!(named("txt"), None);
        assert_eq!(named("kr210"), None);
    }
}
