//! Whether other projects may use a program or data, as files of both dialects write it.

use val3_analysis::xml::Element;
use val3_syntax::{TextRange, TextSize};

/// How a dialect writes the access.
struct Spelling {
    attribute: &'static str,
    public: &'static str,
    private: &'static str,
}

impl Spelling {
    fn of(element: Element<'_>) -> Self {
        match element.name() {
            "Program" | "Data" => Self { attribute: "access", public: "public", private: "private" },
            _ => Self { attribute: "public", public: "true", private: "false" },
        }
    }
}

/// The element says that other projects may use what it declares.
pub(crate) fn is_public(element: Element<'_>) -> bool {
    let spelling = Spelling::of(element);
    element.value(spelling.attribute).is_some_and(|text| text.trim() == spelling.public)
}

/// What to replace so that an element with a name has this access.
pub(crate) fn set(element: Element<'_>, public: bool) -> Option<(TextRange, String)> {
    let Spelling { attribute, public: yes, private: no } = Spelling::of(element);
    let word = if public { yes } else { no };
    if let Some(found) = element.attribute(attribute) {
        return Some((found.range, word.to_owned()));
    }
    let name = element.attribute("name")?;
    let at = name.range.end() + TextSize::of(name.quote);
    Some((TextRange::empty(at), format!(" {attribute}=\"{word}\"")))
}
