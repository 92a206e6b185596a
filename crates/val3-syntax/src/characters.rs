//! Characters that are invalid in XML files of any encoding.

use rowan::TextRange;

use crate::error::{SyntaxError, SyntaxErrorKind};

/// Whether XML 1.0 allows the character: all control characters except tab, line feed and carriage return are invalid.
#[must_use]
pub fn is_allowed(character: char) -> bool {
    !matches!(character, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}')
}

/// Adds an error for each line with such characters to the parser's errors. Parser errors that the characters cause in
/// the code of the same line are removed.
pub fn add_control_characters(text: &str, errors: &mut Vec<SyntaxError>) {
    let found: Vec<(TextRange, SyntaxError)> = lines(text).filter_map(|(start, line)| first_in(start, line)).collect();
    if found.is_empty() {
        return;
    }
    errors.retain(|error| {
        let next = found.partition_point(|(line, _)| line.end() <= error.range.start());
        let is_in_line = found.get(next).is_some_and(|(line, _)| line.contains(error.range.start()));
        !(is_in_line && error.kind.is_local_to_line())
    });
    errors.extend(found.into_iter().map(|(_, error)| error));
    errors.sort_by_key(|error| error.range.start());
}

/// Returns the lines that may contain such characters, with their offsets and line ends.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let starts = text.split_inclusive('\n').scan(0, |start, line| {
        let at = *start;
        *start += line.len();
        Some((at, line))
    });
    starts.filter(|(_, line)| {
        line.bytes().any(|byte| byte < b' ' && !matches!(byte, b'\t' | b'\n' | b'\r') || byte == 0xef)
    })
}

/// Returns an error for the first sequence of such characters in a line, with the range of the line.
fn first_in(start: usize, line: &str) -> Option<(TextRange, SyntaxError)> {
    let (at, character) = line.char_indices().find(|(_, character)| !is_allowed(*character))?;
    let run = line.get(at..)?;
    let len = run.find(is_allowed).unwrap_or(run.len());
    let range = range(start + at, len)?;
    let kind = SyntaxErrorKind::ControlCharacter { character };
    Some((self::range(start, line.len())?, SyntaxError { kind, range, related: None }))
}

fn range(start: usize, len: usize) -> Option<TextRange> {
    Some(TextRange::at(u32::try_from(start).ok()?.into(), u32::try_from(len).ok()?.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn errors(text: &str) -> Vec<String> {
        let mut errors = crate::parse(text).errors().to_vec();
        add_control_characters(text, &mut errors);
        errors.iter().map(|error| format!("{:?} {:?}", error.range, error.kind)).collect()
    }

    #[test]
    fn each_line_has_one_error() {
        assert_eq!(
            errors("<a>\n<b x=\"\0\u{1}2\u{2}\"/>\r\n<c y=\"\u{7}\"/></a>"),
            ["10..12 ControlCharacter { character: '\\0' }", "25..26 ControlCharacter { character: '\\u{7}' }"]
        );
    }

    #[test]
    fn no_other_fault_is_reported_on_the_line() {
        let code = |line: &str| format!("<Code><![CDATA[begin\n{line}\nn==\nend]]></Code>");
        let faults = errors(&code("n\u{c}=\0 1"));
        assert_eq!(faults.len(), 2, "{faults:?}");
        assert!(faults[0].ends_with("ControlCharacter { character: '\\u{c}' }"), "{faults:?}");
        assert_eq!(errors(&code("n=1")).len(), 1);
    }

    #[test]
    fn tabs_line_ends_and_other_scripts_are_allowed() {
        assert!(errors("<a>\t\r\n<b x=\"é\u{7f}漢\u{feff}\u{ef00}\"/></a>").is_empty());
        assert_eq!(errors("<a x=\"\u{ffff}\"/>").len(), 1);
    }
}
