//! Keys in written form.

use val3_lang::keys::{KEYS, character};

/// Parses a list of key codes and names with commas between them: `97,270,F1`.
///
/// # Errors
/// The part that is neither the code nor the name of a key (12.2).
pub fn key_codes(list: &str) -> Result<Vec<u16>, String> {
    let parts = list.split(',').map(str::trim).filter(|part| !part.is_empty());
    parts.map(|part| key_code(part).ok_or_else(|| no_key(part))).collect()
}

/// Returns the keys that type a text. A text with a comma is read as a list of codes and names if [`key_codes`] accepts
/// it; within a text, names are in braces: `12.5{Return}`.
///
/// # Errors
/// The character that no key writes, or the name that no key has.
pub fn typed_keys(text: &str) -> Result<Vec<u16>, String> {
    if text.contains(',')
        && let Ok(codes) = key_codes(text)
    {
        return Ok(codes);
    }
    let mut codes = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let named = rest.strip_prefix('{').and_then(|inner| inner.split_once('}'));
        if let Some((name, behind)) = named {
            codes.push(key_code(name).ok_or_else(|| no_key(name))?);
            rest = behind;
        } else {
            let code = u16::try_from(u32::from(first)).ok().filter(|code| character(*code).is_some());
            codes.push(code.ok_or_else(|| format!("no key types `{}`", first.escape_default()))?);
            rest = rest.get(first.len_utf8()..).unwrap_or_default();
        }
    }
    Ok(codes)
}

/// Returns the text of these keys for [`typed_keys`]: characters with names in braces, or else a list of codes.
pub(super) fn key_text(codes: &[u16]) -> String {
    let named = |code: &u16| KEYS.iter().find(|key| key.code == *code).map(|key| format!("{{{}}}", key.name));
    let one = |code: &u16| character(*code).map(String::from).or_else(|| named(code)).unwrap_or_default();
    let text: String = codes.iter().map(one).collect();
    if typed_keys(&text).as_deref() == Ok(codes) {
        return text;
    }
    codes.iter().map(|code| format!("{code},")).collect()
}

/// Parses the code or name of a key; the letter case of names does not matter.
fn key_code(text: &str) -> Option<u16> {
    let known = |code: &u16| character(*code).is_some() || KEYS.iter().any(|key| key.code == *code);
    match text.parse() {
        Ok(code) => Some(code).filter(known),
        Err(_) => KEYS.iter().find(|key| key.name.eq_ignore_ascii_case(text)).map(|key| key.code),
    }
}

fn no_key(text: &str) -> String {
    format!("`{text}` is not a key: write a code such as 97 for `a`, or a name such as Return, Esc or F1")
}

#[cfg(test)]
mod tests {
    use super::{key_codes, key_text, typed_keys};

    #[test]
    fn codes_and_names_are_read_from_a_list() {
        assert_eq!(key_codes("97, 270,f1,Esc").unwrap(), [97, 270, 271, 255]);
        assert!(key_codes("").unwrap().is_empty());
        assert!(key_codes("97,Enter").unwrap_err().starts_with("`Enter` is not a key"));
        assert!(key_codes("12").is_err());
    }

    #[test]
    fn a_text_is_typed_key_by_key() {
        assert_eq!(typed_keys("1.5{Return}").unwrap(), [49, 46, 53, 270]);
        assert_eq!(typed_keys("a{").unwrap(), [97, 123]);
        assert_eq!(typed_keys("1,5").unwrap(), [49, 44, 53]);
        assert_eq!(typed_keys("270,271").unwrap(), [270, 271]);
        assert_eq!(typed_keys("\n").unwrap_err(), "no key types `\\n`");
        assert!(typed_keys("{Enter}").is_err());
    }
    #[test]
    fn the_text_of_keys_types_them_again() {
        for (codes, text) in [
            (&[49, 46, 53, 270][..], "1.5{Return}"),
            (&[49, 44, 53], "1,5"),
            (&[49, 44, 53, 44, 270], "1,5,{Return}"),
            (&[50, 55, 48, 44, 50, 55, 49], "50,55,48,44,50,55,49,"),
            (&[123, 70, 49, 125], "123,70,49,125,"),
            (&[], ""),
        ] {
            assert_eq!(key_text(codes), text);
            assert_eq!(typed_keys(text).as_deref(), Ok(codes), "{text}");
        }
    }
}
