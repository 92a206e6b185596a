//! Folding ranges: blocks, comments, and the XML around the code.

use rowan::NodeOrToken;
use val3_analysis::db::{Db, File};
use val3_analysis::items::parse;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, TextRange, TextSize};

/// A folding range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fold {
    /// From the end of the visible line to the end of the hidden text.
    pub range: TextRange,
    /// Kind.
    pub kind: FoldKind,
}

/// Kinds of folding ranges.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoldKind {
    /// A block of code.
    Block,
    /// Comment lines.
    Comment,
    /// XML before or after the code, or a data element.
    Xml,
}

/// All folding ranges of a file that span more than one line.
pub fn folds(db: &dyn Db, file: File) -> Vec<Fold> {
    let text: &str = file.text(db);
    let mut folds = Vec::new();
    let parse = parse(db, file);
    let root = parse.view();
    if let Some(code) = find_code(root) {
        envelope(root, code, &mut folds);
    }
    walk(root, &mut folds);
    let mut comments = Comments::default();
    comments.walk(root, &mut folds);
    comments.end(&mut folds);
    folds.retain(|fold| text.get(std::ops::Range::<usize>::from(fold.range)).is_some_and(|text| text.contains('\n')));
    folds.sort_by_key(|fold| (fold.range.start(), fold.range.end()));
    folds
}

pub(crate) fn find_code(node: View<'_>) -> Option<View<'_>> {
    node.children().find_map(|child| match child.kind() {
        SyntaxKind::CODE => Some(child),
        SyntaxKind::ELEMENT => find_code(child),
        _ => None,
    })
}

/// Folds the XML before `begin` and after `end`.
fn envelope(root: View<'_>, code: View<'_>, folds: &mut Vec<Fold>) {
    let begin = code.token(SyntaxKind::BEGIN_KW).map_or(code.range().start(), |token| token.range().start());
    let end = code.token(SyntaxKind::END_KW).map_or(code.range().end(), |token| token.range().end());
    for range in [TextRange::new(root.range().start(), begin), TextRange::new(end, root.range().end())] {
        folds.push(Fold { range, kind: FoldKind::Xml });
    }
}

fn walk(node: View<'_>, folds: &mut Vec<Fold>) {
    for child in node.children() {
        match child.kind() {
            SyntaxKind::ELEMENT if find_code(child).is_none() => {
                folds.push(Fold { range: child.range(), kind: FoldKind::Xml });
            }
            SyntaxKind::IF_STMT => branches(child, folds),
            SyntaxKind::WHILE_STMT
            | SyntaxKind::DO_STMT
            | SyntaxKind::FOR_STMT
            | SyntaxKind::SWITCH_STMT
            | SyntaxKind::CASE_CLAUSE
            | SyntaxKind::DEFAULT_CLAUSE => folds.push(Fold { range: child.range(), kind: FoldKind::Block }),
            _ => {}
        }
        walk(child, folds);
    }
}

/// Folds each `if` branch up to the next branch, and the last one up to `endIf`.
fn branches(statement: View<'_>, folds: &mut Vec<Fold>) {
    let mut start = statement.range().start();
    let mut end = statement.child(SyntaxKind::BLOCK).map_or(start, |block| last_line(block));
    let parts = statement.children();
    for clause in parts.filter(|part| matches!(part.kind(), SyntaxKind::ELSE_IF_CLAUSE | SyntaxKind::ELSE_CLAUSE)) {
        folds.push(Fold { range: TextRange::new(start, end.max(start)), kind: FoldKind::Block });
        start = clause.range().start();
        end = clause.child(SyntaxKind::BLOCK).map_or(start, |block| last_line(block));
    }
    folds.push(Fold { range: TextRange::new(start, statement.range().end()), kind: FoldKind::Block });
}

/// End of the last token of a block that is no line end.
fn last_line(block: View<'_>) -> TextSize {
    let ends = block.children_with_tokens().filter_map(|child| match child {
        NodeOrToken::Node(node) => Some(node.range().end()),
        NodeOrToken::Token(token) => (token.kind() == SyntaxKind::COMMENT).then(|| token.range().end()),
    });
    ends.last().unwrap_or(block.range().start())
}

/// Collects consecutive comments, separated by single line ends.
#[derive(Default)]
struct Comments {
    run: Option<TextRange>,
}

impl Comments {
    fn walk(&mut self, node: View<'_>, folds: &mut Vec<Fold>) {
        for child in node.children_with_tokens() {
            match child {
                NodeOrToken::Node(node) => self.walk(node, folds),
                NodeOrToken::Token(token) if token.kind() == SyntaxKind::COMMENT => {
                    self.run = Some(self.run.map_or(token.range(), |run| run.cover(token.range())));
                }
                NodeOrToken::Token(token) if joins_comments(token) => {}
                NodeOrToken::Token(_) => self.end(folds),
            }
        }
    }

    fn end(&mut self, folds: &mut Vec<Fold>) {
        folds.extend(self.run.take().map(|range| Fold { range, kind: FoldKind::Comment }));
    }
}

fn joins_comments(token: TokenView<'_>) -> bool {
    match token.kind() {
        SyntaxKind::NEWLINE => token.text().matches('\n').count() <= 1,
        kind => kind == SyntaxKind::WHITESPACE,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::MarkedListing;

    /// First and last line by fold, from 1.
    fn check(listing: &str, expected: Expect) {
        let marked = MarkedListing::new(listing);
        let (db, file) = (marked.db(), marked.at().file);
        let text: &str = file.text(db);
        let line = |offset: TextSize| 1 + text[..usize::from(offset)].matches('\n').count();
        let shown = folds(db, file).into_iter().map(|fold| {
            let (first, last) = (line(fold.range.start()), line(fold.range.end()));
            format!("{:?} {first}-{last} {}\n", fold.kind, text.lines().nth(first - 1).unwrap_or("").trim())
        });
        expected.assert_eq(&shown.collect::<String>());
    }

    #[test]
    fn blocks_and_the_surrounding_xml_are_folded() {
        check(
            "num nA\nif nA==1\n  cls()$0\nelseIf nA==2\n  cls()\nelse\n  cls()\nendIf\nwhile nA<3\n  nA=nA+1\nendWhile\nswitch nA\n  case 1\n    cls()\n  break\nendSwitch",
            expect![[r#"
                Xml 1-4 <?xml version="1.0" encoding="utf-8"?>
                Block 5-6 if nA==1
                Block 7-8 elseIf nA==2
                Block 9-11 else
                Block 12-14 while nA<3
                Block 15-19 switch nA
                Block 16-18 case 1
                Xml 20-22 end]]></Code>
            "#]],
        );
    }

    #[test]
    fn comments_are_folded() {
        check(
            "cls()$0\n// one\n// two\n\n// alone\ncls()\n// three\n// four\n// five\ncls()",
            expect![[r#"
                Xml 1-4 <?xml version="1.0" encoding="utf-8"?>
                Comment 6-7 // one
                Comment 11-13 // three
                Xml 15-17 end]]></Code>
            "#]],
        );
    }

    #[test]
    fn a_block_without_its_end_folds_up_to_the_outer_end() {
        check(
            "num nA\nwhile nA<3\n  if nA==1\n    cls()$0\nendWhile\ncls()",
            expect![[r#"
            Xml 1-4 <?xml version="1.0" encoding="utf-8"?>
            Block 5-8 while nA<3
            Block 6-7 if nA==1
            Xml 10-12 end]]></Code>
        "#]],
        );
    }

    #[test]
    fn data_are_folded() {
        check(
            "cls()\n=== main/main.dtx\n<Database>\n  <Datas>$0\n    <Data name=\"nA\" type=\"num\">\n      <Value key=\"0\" value=\"1\" />\n    </Data>\n    <Data name=\"nB\" type=\"num\" />\n  </Datas>\n</Database>",
            expect![[r#"
                Xml 1-8 <Database>
                Xml 2-7 <Datas>
                Xml 3-5 <Data name="nA" type="num">
            "#]],
        );
    }
}
