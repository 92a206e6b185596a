//! Selection ranges: word, expression, statement, block, element, file.

use val3_analysis::db::Db;
use val3_analysis::items::parse;
use val3_syntax::{SyntaxKind, TextRange};

use crate::FilePosition;

/// Ranges around a position, from the innermost to the outermost; each contains the previous one.
pub fn selections(db: &dyn Db, at: FilePosition) -> Vec<TextRange> {
    let root = parse(db, at.file).root();
    if !root.text_range().contains_inclusive(at.offset) {
        return Vec::new();
    }
    let Some(token) = root.token_at_offset(at.offset).right_biased() else { return vec![root.text_range()] };
    let mut ranges = vec![token.text_range()];
    if token.kind() == SyntaxKind::XML_STRING || token.kind() == SyntaxKind::STRING {
        ranges.insert(0, within_quotes(token.text_range(), token.text()));
    }
    ranges.extend(token.parent_ancestors().map(|node| node.text_range()));
    ranges.dedup();
    ranges
}

/// Range between the quotes, which may be escaped.
fn within_quotes(range: TextRange, text: &str) -> TextRange {
    let quote = if text.starts_with("&quot;") { 6u32 } else { 1 };
    let closed = text.len() > 1 && (text.ends_with(['"', '\'']) || text.ends_with("&quot;"));
    let start = range.start() + rowan::TextSize::new(quote.min(u32::from(range.len())));
    let end = if closed { range.end() - rowan::TextSize::new(quote) } else { range.end() };
    if start <= end { TextRange::new(start, end) } else { range }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::MarkedListing;

    /// Checks the texts of the ranges, inner ones first; only the first line of a long text.
    fn check(listing: &str, expected: Expect) {
        let marked = MarkedListing::new(listing);
        let text: &str = marked.at().file.text(marked.db());
        let shown = selections(marked.db(), marked.at()).into_iter().map(|range| {
            let text = &text[std::ops::Range::<usize>::from(range)];
            let first = text.lines().next().unwrap_or("");
            format!("{first}{}\n", if text.contains('\n') { " …" } else { "" })
        });
        expected.assert_eq(&shown.collect::<String>());
    }

    #[test]
    fn the_selection_grows_from_word_to_block() {
        check(
            "num nA\nif nA==1\n  nA=2*(n$0A+3)\nendIf",
            expect![[r#"
            nA
            nA+3
            (nA+3)
            2*(nA+3)
            nA=2*(nA+3)
            if nA==1 …
            <![CDATA[begin …
            <Code><![CDATA[begin …
            <Program name="start"> …
            <Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2"> …
            <?xml version="1.0" encoding="utf-8"?> …
        "#]],
        );
    }

    #[test]
    fn strings_are_selected_without_and_with_quotes() {
        check(
            "putln(\"two wo$0rds\")",
            expect![[r#"
            two words
            "two words"
            ("two words")
            putln("two words")
            <![CDATA[begin …
            <Code><![CDATA[begin …
            <Program name="start"> …
            <Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2"> …
            <?xml version="1.0" encoding="utf-8"?> …
        "#]],
        );
        check(
            "putln(\"op$0en",
            expect![[r#"
            open
            "open
            ("open
            putln("open
            <![CDATA[begin …
            <Code><![CDATA[begin …
            <Program name="start"> …
            <Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2"> …
            <?xml version="1.0" encoding="utf-8"?> …
        "#]],
        );
    }

    #[test]
    fn attributes_are_selected() {
        check(
            "cls()\n=== main/main.dtx\n<Database><Datas><Data name=\"n$0A\" type=\"num\" /></Datas></Database>",
            expect![[r#"
                nA
                "nA"
                name="nA"
                <Data name="nA" type="num" />
                <Datas><Data name="nA" type="num" /></Datas>
                <Database><Datas><Data name="nA" type="num" /></Datas></Database>
            "#]],
        );
    }

    #[test]
    fn each_selection_contains_the_one_before() {
        let marked = MarkedListing::new("num nA\nif nA==1\n  nA=2*(n$0A+3)\nendIf");
        let ranges = selections(marked.db(), marked.at());
        assert!(ranges.windows(2).all(|pair| pair[1].contains_range(pair[0]) && pair[1] != pair[0]));
    }
}
