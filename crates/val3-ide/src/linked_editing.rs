//! Linked editing of the names in a start tag and its end tag.

use val3_analysis::db::{Db, File};
use val3_analysis::items::parse;
use val3_syntax::ast::{AstNode as _, Element};
use val3_syntax::{SyntaxToken, TextRange, TextSize};

/// Names in the start and end tag of the element whose tag contains the position; `None` elsewhere, and if the names
/// differ.
pub fn linked_names(db: &dyn Db, file: File, offset: TextSize) -> Option<[TextRange; 2]> {
    let root = parse(db, file).root();
    if offset > root.text_range().end() {
        return None;
    }
    let tokens = root.token_at_offset(offset);
    tokens.into_iter().find_map(|token| {
        let element = token.parent()?.ancestors().find_map(Element::cast)?;
        let start = element.start_tag()?.name()?;
        let end = element.end_tag()?.name()?;
        let inside = |name: &SyntaxToken| name.text_range().contains_inclusive(offset);
        let same = start.text() == end.text() && (inside(&start) || inside(&end));
        same.then(|| [start.text_range(), end.text_range()])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::MarkedListing;

    fn linked(text: &str) -> Option<[String; 2]> {
        let marked = MarkedListing::new(&format!("num nZ\n=== main/main.dtx\n{text}\n"));
        let at = marked.at();
        let ranges = linked_names(marked.db(), at.file, at.offset)?;
        let text = at.file.text(marked.db());
        Some(ranges.map(|range| text[std::ops::Range::<usize>::from(range)].to_owned()))
    }

    #[test]
    fn both_tags_are_edited_together() {
        for text in
            ["<Data$0base><Datas/></Database>", "<Database><Datas/></Database$0>", "<$0Database a='1'></Database>"]
        {
            assert_eq!(linked(text), Some(["Database".to_owned(), "Database".to_owned()]), "{text}");
        }
    }

    #[test]
    fn other_positions_are_not_linked() {
        for text in [
            "<Database><Da$0tas/></Database>",
            "<Database a='D$0'></Database>",
            "<Data$0base></Databse>",
            "<a><$0Database></a>",
        ] {
            assert_eq!(linked(text), None, "{text}");
        }
    }
}
