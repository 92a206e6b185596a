//! Phrases that several rules share.

use val3_analysis::problem::{FileRole, NameKind};
use val3_lang::runtime_errors;
use val3_lang::suggest::question;
use val3_syntax::error::XmlPart;

/// For example ``did you mean `near`?``; empty without a name.
pub(crate) fn did_you_mean(near: Option<&str>) -> String {
    question(near).unwrap_or_default()
}

/// Formats the similar name as a question, or other advice without a similar name.
pub(crate) fn did_you_mean_or(near: Option<&str>, otherwise: &str) -> String {
    question(near).unwrap_or_else(|| otherwise.to_owned())
}

/// For example "run-time error 70: invalid parameter".
pub(crate) fn runtime_error(number: u16) -> String {
    let short = runtime_errors::find(number).map_or("", |error| error.short);
    format!("run-time error {number}: {short}")
}

/// A kind of name in the manual's terms: `program`, `library identifier`.
pub(crate) fn name_kind(kind: NameKind) -> &'static str {
    match kind {
        NameKind::Data => "data",
        NameKind::Local => "local variable",
        NameKind::Parameter => "parameter",
        NameKind::Program => "program",
        NameKind::Instruction => "instruction",
        NameKind::Library => "library identifier",
        NameKind::Type => "user type",
        NameKind::Field => "field",
    }
}

/// Name for an XML part.
pub(crate) fn xml_part(part: XmlPart) -> &'static str {
    match part {
        XmlPart::Comment => "the comment",
        XmlPart::CData => "the code section",
        XmlPart::ProcessingInstruction => "the processing instruction",
        XmlPart::Tag => "the tag",
        XmlPart::AttributeValue => "the value of the attribute",
    }
}

/// Bracket that `closing` closes.
pub(crate) fn opening_bracket(closing: char) -> char {
    match closing {
        ')' => '(',
        ']' => '[',
        '}' => '{',
        other => other,
    }
}

/// The role of a file in a project: `program file`, `library`.
pub(crate) fn file_role(role: FileRole) -> &'static str {
    match role {
        FileRole::Project => "project file",
        FileRole::Program => "program file",
        FileRole::Data => "data file",
        FileRole::Library => "library",
        FileRole::Type => "user type",
    }
}

/// Last key in an array with this `size` attribute: `2,3` for `3 4`. `None` if a dimension is empty or not a number.
pub(crate) fn last_key(size: &str) -> Option<String> {
    let last = |dimension: &str| dimension.parse::<u32>().ok()?.checked_sub(1);
    let keys: Option<Vec<String>> = size.split_whitespace().map(|d| Some(last(d)?.to_string())).collect();
    keys.filter(|keys| !keys.is_empty()).map(|keys| keys.join(","))
}

/// Describes the text that was found in place of the expected text: `text`, or the end of the line if it is empty.
pub(crate) fn found_text(text: &str) -> String {
    if text.is_empty() {
        return "the line ends".to_owned();
    }
    format!("`{}` was found", shortened(text))
}

/// First characters of a text that may be long.
pub(crate) fn shortened(text: &str) -> String {
    const LIMIT: usize = 30;
    match text.char_indices().nth(LIMIT) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or(text)),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_key_depends_on_the_dimensions() {
        assert_eq!(last_key("3").as_deref(), Some("2"));
        assert_eq!(last_key("3 4").as_deref(), Some("2,3"));
        assert_eq!(last_key("0"), None);
        assert_eq!(last_key(""), None);
    }
}
