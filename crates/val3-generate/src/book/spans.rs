//! Links from code spans and error numbers to their pages.

use pulldown_cmark::{Event, Parser, Tag, TagEnd};
use val3_check::topics::TopicKind;
use val3_lang::instructions;

use crate::book::links::{options, replaced};
use crate::book::names::{PageNames, runtime_error};
use crate::book::page::BookPage;

/// Adds links to a page where it names other pages.
pub(crate) fn linked(page: &BookPage, names: &PageNames) -> String {
    let mut edits = Vec::new();
    // Headings, links, and the HTML of coloured code remain unchanged.
    let mut inside = 0_usize;
    let mut numbers = ErrorNumbers::new(page);
    for (event, range) in Parser::new_ext(&page.text, options()).into_offset_iter() {
        match event {
            Event::Start(
                Tag::Link { .. } | Tag::Image { .. } | Tag::Heading { .. } | Tag::CodeBlock(_) | Tag::HtmlBlock,
            ) => {
                inside += 1;
            }
            Event::End(TagEnd::Link | TagEnd::Image | TagEnd::Heading(_) | TagEnd::CodeBlock | TagEnd::HtmlBlock) => {
                inside = inside.saturating_sub(1);
            }
            Event::End(TagEnd::Item | TagEnd::Paragraph | TagEnd::TableCell) => numbers.end(),
            Event::Code(span) if inside == 0 => {
                numbers.interrupt();
                if let Some(path) = names.meant_on(page, &span) {
                    let source = page.text.get(range.clone()).unwrap_or_default();
                    edits.push((range, format!("[{source}]({})", page.link_to(path))));
                }
            }
            Event::Text(text)
                if inside == 0 && page.text.get(range.clone()) == Some(&*text) && page.subject.is_some() =>
            {
                for (at, number, path) in numbers.read(&text) {
                    let start = range.start + at;
                    edits.push((start..start + number.len(), format!("[{number}]({})", page.link_to(&path))));
                }
            }
            _ => {}
        }
    }
    replaced(&page.text, edits)
}

/// Finds run-time error numbers: after the word "error", and in the item `Errors:` of an instruction.
struct ErrorNumbers {
    /// Errors of the instruction that is the page's subject.
    of_instruction: &'static [u16],
    state: SpanState,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum SpanState {
    /// No number is expected.
    Text,
    /// After "error", or after such a number and "to", "and" or "or".
    Number,
    /// In the item `Errors:`.
    Item,
}

impl ErrorNumbers {
    fn new(page: &BookPage) -> Self {
        let subject = page.subject.as_ref().filter(|subject| subject.kind == TopicKind::Instruction);
        let row = subject.and_then(|subject| instructions::find(&subject.name));
        Self { of_instruction: row.map_or(&[], |row| row.errors), state: SpanState::Text }
    }

    fn end(&mut self) {
        self.state = SpanState::Text;
    }

    fn interrupt(&mut self) {
        if self.state == SpanState::Number {
            self.state = SpanState::Text;
        }
    }

    /// Returns the error numbers in a text: offset, digits, and path of the error's page.
    fn read<'t>(&mut self, text: &'t str) -> Vec<(usize, &'t str, String)> {
        let mut found = Vec::new();
        let mut at = 0;
        for word in text.split_inclusive(' ') {
            let number = word.trim_matches(|letter: char| !letter.is_ascii_digit());
            let place = at + word.find(number).unwrap_or(0);
            at += word.len();
            if let Some(path) = self.page(word, number) {
                found.push((place, number, path));
            }
        }
        found
    }

    fn page(&mut self, word: &str, number: &str) -> Option<String> {
        let plain = word.trim_matches(|letter: char| !letter.is_alphanumeric());
        if !number.is_empty() && plain == number {
            let is_of_instruction = || number.parse().is_ok_and(|number| self.of_instruction.contains(&number));
            let is_meant = self.state == SpanState::Number || self.state == SpanState::Item && is_of_instruction();
            return runtime_error(number).filter(|_| is_meant);
        }
        self.state = match (self.state, plain) {
            (SpanState::Item, _) => SpanState::Item,
            _ if word.starts_with("Errors:") => SpanState::Item,
            (_, "error" | "errors" | "Error" | "Errors") => SpanState::Number,
            (SpanState::Number, "to" | "and" | "or") => SpanState::Number,
            _ => SpanState::Text,
        };
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::book::page::Subject;

    fn page(kind: TopicKind, name: &str, text: &str) -> BookPage {
        let subject = Subject { kind, name: name.to_owned() };
        BookPage { path: format!("{}/{name}.md", kind.folder()), subject: Some(subject), text: text.to_owned() }
    }

    #[test]
    fn names_are_links_but_not_to_their_own_page() {
        let names = PageNames::new(&["commands/arm-list.md".to_owned()]);
        let text = linked(&BookPage::plain("check.md", "`val3 arm list --color never` `val3 arm`"), &names);
        assert_eq!(text, "[`val3 arm list --color never`](commands/arm-list.md) `val3 arm`");
        let text =
            linked(&page(TopicKind::Instruction, "movej", "`movej` with `mdesc`, see `V0203` and [`dio`](x)."), &names);
        assert_eq!(text, "`movej` with [`mdesc`](../types/mdesc.md), see [`V0203`](../rules/V0203.md) and [`dio`](x).");
        let text = linked(&BookPage::plain("check.md", "`limit` and `getMoveId()` of `movej`"), &names);
        assert_eq!(text, "`limit` and [`getMoveId()`](instructions/getMoveId.md) of [`movej`](instructions/movej.md)");
    }

    #[test]
    fn a_name_of_several_pages_means_the_own_field_first() {
        let names = PageNames::new(&[]);
        let text = linked(&page(TopicKind::Type, "point", "`config` `link`"), &names);
        assert_eq!(text, "[`config`](../fields/config.md) [`link`](../instructions/link.md)");
        let text = linked(&page(TopicKind::Type, "dio", "`link`"), &names);
        assert_eq!(text, "[`link`](../fields/link.md)");
    }

    #[test]
    fn numbers_of_errors_are_links() {
        let names = PageNames::new(&[]);
        let text = linked(
            &page(TopicKind::Instruction, "movej", "- Errors: 81 a target, 100 to 106 a value of 20.\n\nAnd 81."),
            &names,
        );
        let error = |number: u16| format!("[{number}](../errors/{number}.md)");
        assert_eq!(
            text,
            format!("- Errors: {} a target, {} to {} a value of 20.\n\nAnd 81.", error(81), error(100), error(106))
        );
        let text = linked(&page(TopicKind::Type, "num", "Raises error 20 or 21, not 10."), &names);
        assert_eq!(text, format!("Raises error {} or {}, not 10.", error(20), error(21)));
    }
}
