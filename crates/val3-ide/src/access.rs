//! Access of a program or data (public or private) in files of both dialects.

use val3_analysis::xml::XmlElement;
use val3_syntax::{TextRange, TextSize, TextSlice, text_at};

/// Spelling of the access in a dialect.
struct Spelling {
    attribute: &'static str,
    public: &'static str,
    private: &'static str,
}

impl Spelling {
    fn of(element: XmlElement<'_>) -> Self {
        match element.name() {
            "Program" | "Data" => Self { attribute: "access", public: "public", private: "private" },
            _ => Self { attribute: "public", public: "true", private: "false" },
        }
    }
}

/// Whether the element makes its declaration public.
pub(crate) fn is_public(element: XmlElement<'_>) -> bool {
    let spelling = Spelling::of(element);
    element.value(spelling.attribute).is_some_and(|text| text.trim() == spelling.public)
}

/// Edit that sets the access of a named element. `None` if the access cannot be inserted.
pub(crate) fn set(text: &str, element: XmlElement<'_>, public: bool) -> Option<(TextRange, String)> {
    let Spelling { attribute, public: yes, private: no } = Spelling::of(element);
    let word = if public { yes } else { no };
    if let Some(found) = element.attribute(attribute) {
        return Some(match !public && omits_private(text, element) {
            true => (with_blank(text, found.range), String::new()),
            false => (found.range, word.to_owned()),
        });
    }
    let name = element.attribute("name")?;
    let at = name.range.end() + TextSize::of(name.quote);
    Some((TextRange::empty(at), format!(" {attribute}=\"{word}\"")))
}

/// Whether the element omits the access of a private program, as the vendor's editor does. The controller writes the
/// access, and a space before the end of the tag.
fn omits_private(text: &str, element: XmlElement<'_>) -> bool {
    let tag = text_at(text, element.tag_range());
    element.name() == "Program" && !tag.trim_end_matches(['>', '/']).ends_with(' ')
}

/// Range of the attribute with this value, including the space before it.
fn with_blank(text: &str, value: TextRange) -> TextRange {
    let before = text.part(..usize::from(value.start()));
    let start = before.rfind([' ', '\t', '\n']).and_then(|at| TextSize::try_from(at).ok()).unwrap_or(value.start());
    TextRange::new(start, value.end() + TextSize::of('"'))
}
