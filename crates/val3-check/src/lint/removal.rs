//! Removes a declaration from a file.

use val3_analysis::db::{Db, File, FileEdit};
use val3_analysis::items::declarations::element_around;
use val3_analysis::items::parse;
use val3_analysis::items::unlisted::is_program;
use val3_syntax::xml::{self, XmlElement};
use val3_syntax::{TextRange, TextSize, TextSlice};

/// Removes an element of a file, with the preceding line end if it has its own line. If it was the last element of a
/// list, the list becomes an empty tag; in programs, which omit empty lists, it is removed.
pub(crate) fn of_element(db: &dyn Db, file: File, element: TextRange) -> FileEdit {
    let text = file.text(db);
    let parse = parse(db, file);
    // Only the last element of a list requires a search: a file may have thousands of unused data.
    let root = if is_last(element, text) { xml::root(parse.view()) } else { None };
    let list = root.and_then(|root| list_of(root, element)).filter(|list| is_first(*list, element, text));
    let (range, text) = match list {
        None => (with_blanks(text, element), ""),
        Some(list) if is_program(file.path(db).as_str()) => (with_blanks(text, list.view().range()), ""),
        Some(list) => (after_attributes(list, text), " />"),
    };
    FileEdit { file, range, text: text.to_owned() }
}

/// Removes the element that contains a name.
pub(crate) fn of_entry(db: &dyn Db, file: File, name: TextRange) -> Option<FileEdit> {
    Some(of_element(db, file, element_around(db, file, name)?))
}

/// The element that directly contains the element at `inner`.
fn list_of(root: XmlElement<'_>, inner: TextRange) -> Option<XmlElement<'_>> {
    let mut list = root;
    loop {
        let next = list.elements().find(|element| element.view().range().contains_range(inner))?;
        if next.view().range() == inner {
            return Some(list);
        }
        list = next;
    }
}

/// Whether only blanks follow before the end tag of the list.
fn is_last(element: TextRange, text: &str) -> bool {
    text.get(element.end().into()..).is_some_and(|behind| behind.trim_start().starts_with("</"))
}

/// Whether only blanks are between the start tag of `list` and `element`.
fn is_first(list: XmlElement<'_>, element: TextRange, text: &str) -> bool {
    let between = text.get(list.tag_range().end().into()..element.start().into());
    between.is_some_and(|between| between.trim().is_empty())
}

/// Range from the last attribute in the start tag of a list to the end of the list.
fn after_attributes(list: XmlElement<'_>, text: &str) -> TextRange {
    let tag = list.tag_range();
    let start = text.part(tag.start().into()..tag.end().into());
    let attributes = start.trim_end_matches('>').trim_end();
    TextRange::new(tag.start() + TextSize::of(attributes), list.view().range().end())
}

const BLANKS: [char; 2] = [' ', '\t'];

/// Extends the range by the preceding blanks, and by the preceding line end if the range has its own lines. Ranges of
/// neighbours touch, so they are removed one after the other, and the last one removes the list.
fn with_blanks(text: &str, range: TextRange) -> TextRange {
    let (before, behind) = (text.get(..range.start().into()), text.get(range.end().into()..));
    let (Some(before), Some(behind)) = (before, behind) else { return range };
    let start = before.trim_end_matches(BLANKS);
    let line = start.strip_suffix("\r\n").or_else(|| start.strip_suffix(['\n', '\r']));
    let ends_line = behind.trim_start_matches(BLANKS).starts_with(['\r', '\n']);
    match line {
        Some(_) if !ends_line => range,
        line => TextRange::new(TextSize::of(line.unwrap_or(start)), range.end()),
    }
}

#[cfg(test)]
mod tests {
    use super::with_blanks;
    use val3_syntax::TextRange;

    fn removed(text: &str) -> String {
        let [from, to] = [text.find("<x").unwrap(), text.find("/>").unwrap() + 2].map(|at| u32::try_from(at).unwrap());
        let found = with_blanks(text, TextRange::new(from.into(), to.into()));
        text[..found.start().into()].to_owned() + &text[found.end().into()..]
    }

    #[test]
    fn a_line_without_other_code_is_removed_entirely() {
        assert_eq!(removed("<a>\n  <x />\n  <y/>"), "<a>\n  <y/>");
        assert_eq!(removed("<a>\r\n\t<x\r\nn='1'/>\r\n<y></y>"), "<a>\r\n<y></y>");
        assert_eq!(removed("<a> <x /> <y>\n"), "<a> <y>\n");
        assert_eq!(removed("<a>\n<x /><y>\n"), "<a>\n<y>\n");
    }
}
