//! Shared parts of the XML formats: a writer, and texts that XML can hold.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

/// A writer of indented XML.
pub(crate) type XmlWriter<'a> = Writer<&'a mut dyn WriteColor>;

/// Writes a document: the declaration, what `content` writes, and a line end.
pub(crate) fn document(
    out: &mut dyn WriteColor,
    content: impl FnOnce(&mut XmlWriter<'_>) -> io::Result<()>,
) -> io::Result<()> {
    let mut writer = Writer::new_with_indent(out, b' ', 2);
    writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    content(&mut writer)?;
    writeln!(writer.get_mut())
}

/// The text with the replacement character for each one that XML cannot hold, not even escaped.
pub(crate) fn allowed(text: &str) -> String {
    text.replace(is_forbidden, "\u{fffd}")
}

fn is_forbidden(character: char) -> bool {
    match character {
        '\t' | '\n' | '\r' => false,
        '\u{fffe}' | '\u{ffff}' => true,
        other => other < ' ',
    }
}

#[cfg(test)]
mod tests {
    use super::allowed;

    #[test]
    fn control_characters_are_replaced() {
        assert_eq!(allowed("a\u{0}\u{1b}[2Jb\té\u{ffff}"), "a\u{fffd}\u{fffd}[2Jb\té\u{fffd}");
    }
}
