//! Shared parts of the XML formats: a writer, and replacement of characters that XML cannot contain.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};

use crate::printable::{one_line, pictured};

/// Writer of indented XML.
pub(crate) type XmlWriter<'a> = Writer<&'a mut dyn WriteColor>;

/// Writes a document: the declaration, the elements that `content` writes, and a line end.
pub(crate) fn document(
    out: &mut dyn WriteColor,
    content: impl FnOnce(&mut XmlWriter<'_>) -> io::Result<()>,
) -> io::Result<()> {
    let mut writer = Writer::new_with_indent(out, b' ', 2);
    writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    content(&mut writer)?;
    writeln!(writer.get_mut())
}

/// Returns the text with visible forms of control characters, which XML cannot contain even in escaped form.
pub(crate) fn allowed(text: &str) -> String {
    pictured(text).replace(is_forbidden, "\u{fffd}")
}

/// As [`allowed`], in one line, for names and paths.
pub(crate) fn allowed_name(text: &str) -> String {
    one_line(text).replace(is_forbidden, "\u{fffd}")
}

fn is_forbidden(character: char) -> bool {
    matches!(character, '\u{fffe}' | '\u{ffff}')
}

#[cfg(test)]
mod tests {
    use super::{allowed, allowed_name};

    #[test]
    fn control_characters_are_replaced() {
        assert_eq!(allowed("a\u{0}\u{1b}[2Jb\té\n\u{ffff}"), "a␀␛[2Jb\té\n\u{fffd}");
        assert_eq!(allowed_name("a\nb"), "a␊b");
    }
}
