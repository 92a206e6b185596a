//! Entity references: `&lt;`, `&#13;`, `&#x41;`.

use std::borrow::Cow;

use crate::characters::is_allowed;
use crate::never::TextSlice;

/// Resolves the entity reference at the start of `text`: its character and length; `None` if there is no reference that
/// XML itself defines.
pub fn resolve(text: &str) -> Option<(char, usize)> {
    let body = text.strip_prefix('&')?;
    let end = body.bytes().take(12).position(|byte| byte == b';')?;
    let name = body.get(..end)?;
    let character = match name {
        "lt" => '<',
        "gt" => '>',
        "amp" => '&',
        "quot" => '"',
        "apos" => '\'',
        _ => numeric(name)?,
    };
    Some((character, end + 2))
}

fn numeric(name: &str) -> Option<char> {
    let digits = name.strip_prefix('#')?;
    let (digits, radix) = match digits.strip_prefix(['x', 'X']) {
        Some(hex) => (hex, 16),
        None => (digits, 10),
    };
    // Rust accepts a sign in a number, XML does not.
    let code = u32::from_str_radix(digits, radix).ok().filter(|_| !digits.starts_with('+'))?;
    char::from_u32(code).filter(|character| is_allowed(*character))
}

/// Replaces every reference by its character. Text that is no reference is unchanged.
pub fn decode_entities(text: &str) -> Cow<'_, str> {
    if memchr::memchr(b'&', text.as_bytes()).is_none() {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('&') {
        let (before, from) = rest.split_at(at);
        out.push_str(before);
        let (character, len) = resolve(from).unwrap_or(('&', 1));
        out.push(character);
        rest = from.part(len..);
    }
    out.push_str(rest);
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_and_numeric_references_are_decoded() {
        assert_eq!(resolve("&lt;="), Some(('<', 4)));
        assert_eq!(resolve("&#13;x"), Some(('\r', 5)));
        assert_eq!(resolve("&#x41;"), Some(('A', 6)));
        assert_eq!(resolve("&nbsp;"), None);
        assert_eq!(resolve("& b"), None);
        assert_eq!(resolve("&#xD800;"), None);
        assert_eq!(resolve("&#+65;"), None);
        assert_eq!(resolve("&#;"), None);
        assert_eq!(resolve("&#0;"), None);
        assert_eq!(resolve("&#x1;"), None);
    }

    #[test]
    fn decoding_keeps_other_text() {
        assert_eq!(decode_entities("a &lt; b && c &x;"), "a < b && c &x;");
        assert_eq!(decode_entities("plain"), "plain");
    }
}
