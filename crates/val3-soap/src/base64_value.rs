//! Bytes as base64.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;

use crate::document::SoapElement;
use crate::error::SoapError;
use crate::value::SoapValue;

/// Bytes that a message contains as base64.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Binary(
    /// Decoded bytes.
    pub Vec<u8>,
);

impl SoapValue for Binary {
    fn read(element: &SoapElement) -> Result<Self, SoapError> {
        let expected = "base64";
        let text: String = element.leaf_text(expected)?.split_ascii_whitespace().collect();
        let bytes = BASE64_STANDARD.decode(&text);
        bytes.map(Self).map_err(|_| SoapError::wrong_value(&element.name, &text, expected))
    }

    fn write(&self, element: &mut SoapElement) {
        BASE64_STANDARD.encode_string(&self.0, &mut element.text);
    }
}
