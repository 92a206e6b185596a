//! Lists and texts that must not be empty: an expectation that compares nothing would always hold.

use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
use toml::Spanned;

/// Message for an expectation without content.
pub(super) const NOTHING: &str = "this compares nothing, so it always holds: write what is expected, or remove it";

/// Message for the empty text in `screen`.
const ON_EVERY_PAGE: &str = "every page contains the empty text, so this always holds: write a text of the page";

/// Deserialises a list with at least one entry.
pub(super) fn list<'de, D: Deserializer<'de>, T: Deserialize<'de>>(deserializer: D) -> Result<Vec<T>, D::Error> {
    let entries = Vec::deserialize(deserializer)?;
    if entries.is_empty() { Err(D::Error::custom(NOTHING)) } else { Ok(entries) }
}

/// Deserialises a text of the page.
pub(super) fn page_text<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    PageText::deserialize(deserializer).map(|text| text.0)
}

/// Deserialises a list of texts of the page.
pub(super) fn page_texts<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Spanned<String>>, D::Error> {
    let texts: Vec<Spanned<PageText>> = list(deserializer)?;
    Ok(texts.into_iter().map(|text| Spanned::new(text.span(), text.into_inner().0)).collect())
}

/// A text that not every page contains.
#[derive(Deserialize)]
#[serde(try_from = "String")]
struct PageText(String);

impl TryFrom<String> for PageText {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        if text.is_empty() { Err(ON_EVERY_PAGE) } else { Ok(Self(text)) }
    }
}
