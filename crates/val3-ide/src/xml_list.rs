//! Insertion of elements into XML lists such as `<Locals>`, `<Datas>`, `<Programs>`.

use val3_analysis::xml::XmlElement;
pub(crate) use val3_syntax::xml::{escaped, whole_line};
use val3_syntax::xml::{indentation, line_end};
use val3_syntax::{TextRange, TextSize, TextSlice};

/// One level of indentation in XML written by the tools.
const LEVEL: &str = "  ";

/// A list, and the information required to insert elements.
pub(crate) struct XmlList<'a> {
    /// Text of the file.
    pub(crate) text: &'a str,
    /// Parent element of the list.
    pub(crate) parent: XmlElement<'a>,
    /// Element name of the list.
    pub(crate) name: &'a str,
    /// Start tag attributes, with a leading space, if the list must be created.
    pub(crate) attributes: &'a str,
    /// Elements that follow it, if the list must be created.
    pub(crate) followers: &'a [&'a str],
}

impl XmlList<'_> {
    /// Edit that appends the lines of `entry` to the list; `None` if the file has no suitable position for the list.
    pub(crate) fn append(&self, entry: &[String]) -> Option<(TextRange, String)> {
        match self.parent.child(&[self.name]) {
            Some(list) => Some(self.with_entry(list, entry)),
            None => self.with_list(entry),
        }
    }

    fn with_entry(&self, list: XmlElement<'_>, entry: &[String]) -> (TextRange, String) {
        let tag = list.tag_range();
        let outer = self.indentation(tag.start());
        let slot = list.elements().last().map(|last| last.view().range());
        if let Some(last) = slot {
            let inner = self.indentation(last.start()).or(outer.map(|_| "")).map(str::to_owned);
            return (TextRange::empty(last.end()), self.lines(entry, inner.as_deref()));
        }
        let inner = outer.map(|outer| format!("{outer}{LEVEL}"));
        let entry = self.lines(entry, inner.as_deref());
        let end = outer.map_or_else(String::new, |outer| format!("{}{outer}", self.line_end()));
        let start = self.slice(tag);
        if let Some(start) = start.strip_suffix("/>") {
            return (tag, format!("{}>{entry}{end}</{}>", start.trim_end(), self.name));
        }
        let has_line = self.text.get(usize::from(tag.end())..).is_some_and(|rest| rest.starts_with(['\r', '\n']));
        (TextRange::empty(tag.end()), entry + if has_line { "" } else { &end })
    }

    /// Creates the list before the first follower, otherwise as the last element.
    fn with_list(&self, entry: &[String]) -> Option<(TextRange, String)> {
        let follower = self.parent.elements().find(|element| self.followers.contains(&element.name()));
        let sibling = follower.or_else(|| self.parent.elements().last())?;
        let range = sibling.view().range();
        let outer = self.indentation(range.start());
        let inner = outer.map(|outer| format!("{outer}{LEVEL}"));
        let entry = self.lines(entry, inner.as_deref());
        let end = outer.map_or_else(String::new, |outer| format!("{}{outer}", self.line_end()));
        let (name, attributes) = (self.name, self.attributes);
        let list = format!("<{name}{attributes}>{entry}{end}</{name}>");
        Some(match follower {
            Some(_) => (TextRange::empty(range.start()), list + &end),
            None => (TextRange::empty(range.end()), end + &list),
        })
    }

    /// Element text, on separate lines if the list uses separate lines.
    fn lines(&self, entry: &[String], indentation: Option<&str>) -> String {
        match indentation {
            Some(blanks) => entry.iter().map(|line| format!("{}{blanks}{line}", self.line_end())).collect(),
            None => entry.iter().map(|line| line.trim()).collect(),
        }
    }

    fn indentation(&self, at: TextSize) -> Option<&str> {
        indentation(self.text, at)
    }

    fn line_end(&self) -> &'static str {
        line_end(self.text)
    }

    fn slice(&self, range: TextRange) -> &str {
        self.text.part(usize::from(range.start())..usize::from(range.end()))
    }
}

#[cfg(test)]
mod tests {
    use val3_analysis::xml::root;

    use super::*;

    fn check(text: &str, expected: &str) {
        let parse = val3_syntax::parse(text);
        let parent = root(parse.view()).unwrap();
        let list = XmlList { text, parent, name: "L", attributes: " a=\"1\"", followers: &["C"] };
        let (range, new) = list.append(&["<e>".to_owned(), "</e>".to_owned()]).unwrap();
        let mut changed = text.to_owned();
        changed.replace_range(std::ops::Range::<usize>::from(range), &new);
        assert_eq!(changed, expected);
    }

    #[test]
    fn an_entry_follows_the_last_one() {
        check("<P>\n  <L>\n    <e/>\n  </L>\n</P>", "<P>\n  <L>\n    <e/>\n    <e>\n    </e>\n  </L>\n</P>");
        check("<P>\r\n<L>\r\n <e/>\r\n</L></P>", "<P>\r\n<L>\r\n <e/>\r\n <e>\r\n </e>\r\n</L></P>");
        check("<P><L><e/></L></P>", "<P><L><e/><e></e></L></P>");
    }

    #[test]
    fn an_entry_is_added_to_an_empty_list() {
        check("<P>\n  <L b='2' />\n</P>", "<P>\n  <L b='2'>\n    <e>\n    </e>\n  </L>\n</P>");
        check("<P>\n  <L></L>\n</P>", "<P>\n  <L>\n    <e>\n    </e>\n  </L>\n</P>");
        check("<P>\n  <L>\n  </L>\n</P>", "<P>\n  <L>\n    <e>\n    </e>\n  </L>\n</P>");
        check("<P><L/></P>", "<P><L><e></e></L></P>");
    }

    #[test]
    fn a_missing_list_is_created() {
        check("<P>\n  <C/>\n</P>", "<P>\n  <L a=\"1\">\n    <e>\n    </e>\n  </L>\n  <C/>\n</P>");
        check("<P><C/></P>", "<P><L a=\"1\"><e></e></L><C/></P>");
        check(
            "<P>\r\n  <B>\r\n  </B>\r\n</P>",
            "<P>\r\n  <B>\r\n  </B>\r\n  <L a=\"1\">\r\n    <e>\r\n    </e>\r\n  </L>\r\n</P>",
        );
    }
}
