//! Takes a declaration out of a file.

use val3_analysis::db::{Db, File};
use val3_analysis::items::declarations::element_around;
use val3_syntax::{TextRange, TextSize};

use crate::diagnostic::{Edit, Span};

/// The edit that removes an element of a file, with its lines where nothing else stands there.
pub(crate) fn of_element(db: &dyn Db, file: File, element: TextRange) -> Edit {
    Edit { place: Span { file, range: with_lines(file.text(db), element) }, text: String::new() }
}

/// The edit that removes the element around a name.
pub(crate) fn of_entry(db: &dyn Db, file: File, name: TextRange) -> Option<Edit> {
    Some(of_element(db, file, element_around(db, file, name)?))
}

fn with_lines(text: &str, range: TextRange) -> TextRange {
    let (before, behind) = (text.get(..range.start().into()), text.get(range.end().into()..));
    let (Some(before), Some(behind)) = (before, behind) else { return range };
    let is_blank = |c: char| matches!(c, ' ' | '\t');
    let start = before.trim_end_matches(is_blank);
    let rest = behind.trim_start_matches(is_blank);
    let rest = rest.strip_prefix('\r').unwrap_or(rest);
    match rest.strip_prefix('\n') {
        Some(rest) if start.ends_with('\n') => {
            let end = range.end() + TextSize::of(behind) - TextSize::of(rest);
            TextRange::new(TextSize::of(start), end)
        }
        _ => range,
    }
}

#[cfg(test)]
mod tests {
    use super::with_lines;
    use val3_syntax::TextRange;

    fn removed(text: &str) -> String {
        let range = |from: usize, to: usize| {
            TextRange::new(u32::try_from(from).unwrap().into(), u32::try_from(to).unwrap().into())
        };
        let found = with_lines(text, range(text.find("<x").unwrap(), text.find("/>").unwrap() + 2));
        text[..found.start().into()].to_owned() + &text[found.end().into()..]
    }

    #[test]
    fn lines_go_where_nothing_else_stands_on_them() {
        assert_eq!(removed("<a>\n  <x />\n  <y/>"), "<a>\n  <y/>");
        assert_eq!(removed("<a>\r\n\t<x\r\nn='1'/> \r\n<y></y>"), "<a>\r\n<y></y>");
        assert_eq!(removed("<a> <x /> <y>\n"), "<a>  <y>\n");
        assert_eq!(removed("<a>\n<x /><y>\n"), "<a>\n<y>\n");
    }
}
