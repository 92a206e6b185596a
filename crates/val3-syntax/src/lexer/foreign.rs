//! Foreign words at the start of a line: block keywords of other languages.

/// Foreign block keywords, which have one or two words, with the VAL 3 keyword.
const FOREIGN_WORDS: &[(&str, &str, &str)] = &[
    ("end", "if", "endIf"),
    ("end", "while", "endWhile"),
    ("end", "for", "endFor"),
    ("end", "switch", "endSwitch"),
    ("elsif", "", "elseIf"),
    ("elif", "", "elseIf"),
    ("wend", "", "endWhile"),
    ("repeat", "", "do"),
];

/// Returns the length and the VAL 3 keyword if the line `code` starts with a foreign block keyword, whose first word
/// has `len` bytes. The text after a single word distinguishes it from a variable.
pub(super) fn word(code: &[u8], len: usize) -> Option<(usize, &'static str)> {
    if !(3..=6).contains(&len) {
        return None;
    }
    FOREIGN_WORDS.iter().find_map(|&(first, second, keyword)| {
        let (word, after) = code.split_at_checked(len)?;
        if !word.eq_ignore_ascii_case(first.as_bytes()) {
            return None;
        }
        let gap = after.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let (next, after) = after.get(gap..)?.split_at_checked(second.len())?;
        let ends = match after.first() {
            Some(byte) if second.is_empty() => !matches!(byte, b'=' | b'[' | b'.' | b':'),
            Some(byte) => byte.is_ascii_whitespace(),
            None => true,
        };
        let length = if second.is_empty() { len } else { len + gap + second.len() };
        (ends && next.eq_ignore_ascii_case(second.as_bytes())).then_some((length, keyword))
    })
}
