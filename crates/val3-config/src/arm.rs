//! The setting `arm`.

use camino::Utf8Path;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};
use val3_lang::types::Arm;

/// Words for the kinds of arms.
const KINDS: [(&str, Arm); 3] = [("six-axis", Arm::SixAxis), ("scara", Arm::Scara), ("other", Arm::Vrb)];

/// Arm setting of a cell.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct ArmSetting {
    /// A kind of arm, a model name, or the path of a file that ends with `.toml`.
    name: String,
    /// Kind of arm; `None` for a file, which defines the kind.
    #[serde(skip)]
    kind: Option<Arm>,
}

impl ArmSetting {
    /// Parses a kind of arm (`scara`), a model name (`tx2-60l`) or the path of a file.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let kind = kind_of(text);
        (kind.is_some() || is_file(text)).then(|| Self { name: text.to_owned(), kind })
    }

    /// Returns the kind of arm; `None` if a file defines it.
    #[must_use]
    pub const fn kind(&self) -> Option<Arm> {
        self.kind
    }

    /// Returns the model name or the path of a file; `None` if only the kind is set.
    #[must_use]
    pub fn model(&self) -> Option<ArmModel<'_>> {
        match self.name.as_str() {
            path if is_file(path) => Some(ArmModel::File(Utf8Path::new(path))),
            word if KINDS.iter().any(|(kind, _)| kind.eq_ignore_ascii_case(word)) => None,
            name => Some(ArmModel::Name(name)),
        }
    }
}

/// Arm model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArmModel<'a> {
    /// Model name, for example `tx2-60l`.
    Name(&'a str),
    /// Description file, relative to the folder of the configuration.
    File(&'a Utf8Path),
}

impl<'de> Deserialize<'de> for ArmSetting {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        let text = String::deserialize(input)?;
        Self::parse(&text).ok_or_else(|| {
            D::Error::custom(format!(
                "`{text}` is not an arm; write \"six-axis\", \"scara\", \"other\", a model such as \"tx2-60l\", or the \
                 path of a file such as \"cell/my-arm.toml\""
            ))
        })
    }
}

fn is_file(text: &str) -> bool {
    Utf8Path::new(text).extension() == Some("toml")
}

fn kind_of(text: &str) -> Option<Arm> {
    if is_file(text) {
        return None;
    }
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
        let kind = |text| ArmSetting::parse(text).and_then(|arm| arm.kind());
        assert_eq!(kind("six-axis"), Some(Arm::SixAxis));
        assert_eq!(kind("tx2-60l"), Some(Arm::SixAxis));
        assert_eq!(kind("TS60"), Some(Arm::Scara));
        assert_eq!(kind("tp80"), Some(Arm::Scara));
        assert_eq!(kind("other"), Some(Arm::Vrb));
        assert_eq!(ArmSetting::parse("txt"), None);
        assert_eq!(ArmSetting::parse("kr210"), None);
    }

    #[test]
    fn a_model_or_a_file_says_more_than_the_kind() {
        let arms = ["scara", "TX2-60L", "cell/tx60.toml"].map(|text| ArmSetting::parse(text).unwrap());
        let [kind, name, file] = &arms;
        assert_eq!(kind.model(), None);
        assert_eq!(name.model(), Some(ArmModel::Name("TX2-60L")));
        assert_eq!((file.kind(), file.model()), (None, Some(ArmModel::File(Utf8Path::new("cell/tx60.toml")))));
    }
}
