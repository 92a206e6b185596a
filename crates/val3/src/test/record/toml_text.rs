//! TOML values, each in one line.

use serde_json::Value;
use val3_lang::keys::{KEYS, character};

/// Formats a key, with quotes if necessary.
pub(super) fn key(text: &str) -> String {
    let is_bare = !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'));
    if is_bare { text.to_owned() } else { quoted(text) }
}

/// Formats a quoted string. The string is literal if it contains a backslash or a quotation mark and can be written
/// without escapes.
pub(super) fn quoted(text: &str) -> String {
    if text.contains(['\\', '"']) && !text.contains(|c: char| c == '\'' || c.is_control()) {
        return format!("'{text}'");
    }
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}

fn escaped(c: char) -> String {
    match c {
        '\\' | '"' => format!("\\{c}"),
        '\n' => "\\n".to_owned(),
        '\r' => "\\r".to_owned(),
        '\t' => "\\t".to_owned(),
        c if c.is_control() => format!("\\u{:04X}", u32::from(c)),
        c => c.to_string(),
    }
}

/// Formats a number, without a fraction if it is whole.
pub(super) fn number(value: f64) -> String {
    // `to_string` returns the shortest exact text.
    value.to_string()
}

/// Formats a value in one line.
pub(super) fn value(json: &Value) -> String {
    match json {
        // Only a number that is not finite is null in JSON, and no script contains one.
        Value::Null => "nan".to_owned(),
        Value::Bool(truth) => truth.to_string(),
        Value::Number(amount) => amount.as_f64().map_or_else(|| amount.to_string(), number),
        Value::String(text) => quoted(text),
        Value::Array(items) => format!("[{}]", items.iter().map(value).collect::<Vec<_>>().join(", ")),
        Value::Object(table) => {
            let pairs: Vec<String> =
                table.iter().map(|(name, item)| format!("{} = {}", key(name), value(item))).collect();
            format!("{{ {} }}", pairs.join(", "))
        }
    }
}

/// Formats a pendant key: its name, or its code with the character in a comment.
pub(super) fn pendant_key(json: &Value) -> String {
    let code = json.as_u64().and_then(|code| u16::try_from(code).ok());
    let name = code.and_then(|code| KEYS.iter().find(|key| key.code == code)).map(|key| quoted(key.name));
    let written = code.and_then(character).map(|c| format!("{json} # {c}"));
    name.or(written).unwrap_or_else(|| value(json))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn values_are_read_back() {
        let texts = ["", "a", r"Socket\host", "it's", r#"a "b""#, "a'\\", "a\r\n\t\u{1}\u{7f}é", "\u{1b}[0m"];
        for text in texts {
            let line = format!("{} = {}", key(text), quoted(text));
            let table: toml_edit::DocumentMut = line.parse().unwrap();
            assert_eq!(table.iter().next().map(|(key, item)| (key, item.as_str())), Some((text, Some(text))), "{line}");
        }
        let action = json!({ "io": { r"Io\Go": true, "valve1": 2.5 }, "joints": [0.0, -90.0] });
        assert_eq!(value(&action), r"{ io = { 'Io\Go' = true, valve1 = 2.5 }, joints = [0, -90] }");
        assert_eq!((pendant_key(&json!(271)), pendant_key(&json!(97))), ("\"F1\"".to_owned(), "97 # a".to_owned()));
    }
}
