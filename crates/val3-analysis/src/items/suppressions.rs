//! Comments that control the tools: `//val3: allow(V0302, no-effect) reason` suppresses findings,
//! `//val3: no-coverage reason` omits code from coverage reports.

use memchr::memmem;
use rowan::NodeOrToken;
use smol_str::SmolStr;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, TextRange, TextSize, TextSlice, text_size};

use super::parse;
use crate::db::{Db, File};

/// Prefix of such a comment after its `//`.
const MARK: &str = "val3:";

/// Keyword that omits code from coverage reports.
const NO_COVERAGE: &str = "no-coverage";

/// A comment that begins with `val3:`, except comments about coverage.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Suppression {
    /// Range of the comment.
    pub comment: TextRange,
    /// Extent of the suppression.
    pub scope: SuppressionExtent,
    /// Rule codes and names in the comment.
    pub rules: Vec<SuppressedRule>,
}

/// Extent of a suppression.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SuppressionExtent {
    /// `allow(…)`: findings that start in the next line that is neither blank nor a comment.
    Line(TextRange),
    /// `allow-program(…)` before the first line of code: all findings of the file.
    Program,
    /// `allow-program(…)` after the first line of code: no finding.
    Misplaced,
    /// Neither of the two forms.
    Unreadable,
}

/// A rule code or name as written in a comment.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SuppressedRule {
    /// Code or name.
    pub name: SmolStr,
    /// Range of the word.
    pub range: TextRange,
}

impl Suppression {
    /// Whether the suppression applies to a finding that starts at `at`.
    pub fn covers(&self, at: TextSize) -> bool {
        match self.scope {
            SuppressionExtent::Line(line) => line.contains_inclusive(at),
            SuppressionExtent::Program => true,
            SuppressionExtent::Misplaced | SuppressionExtent::Unreadable => false,
        }
    }
}

/// Returns the suppressions in the code of `file`, in order.
#[salsa::tracked]
pub fn suppressions(db: &dyn Db, file: File) -> Vec<Suppression> {
    orders(db, file).0
}

/// Returns the code of `file` that coverage reports omit: the line after each comment `//val3: no-coverage` with the
/// block that it opens, or the entire file if the comment is before the first line of code.
#[salsa::tracked]
pub fn uncovered(db: &dyn Db, file: File) -> Vec<TextRange> {
    let lines = orders(db, file).1;
    if lines.is_empty() {
        return Vec::new();
    }
    let parse = parse(db, file);
    lines.into_iter().map(|line| with_block(parse.view(), line)).collect()
}

/// Returns the suppressions, and the ranges that coverage comments omit: lines, or the entire file.
fn orders(db: &dyn Db, file: File) -> (Vec<Suppression>, Vec<TextRange>) {
    let text = file.text(db);
    if memmem::find(text.as_bytes(), MARK.as_bytes()).is_none() {
        return Default::default();
    }
    let mut reader = SuppressionReader { text, in_head: true, found: Vec::new(), uncovered: Vec::new() };
    reader.elements(parse(db, file).view());
    (reader.found, reader.uncovered)
}

/// Extends a line to the end of the outermost statement or clause that starts in it.
fn with_block(root: View<'_>, line: TextRange) -> TextRange {
    let starts_in_line = |node: &View<'_>| (line.start()..line.end()).contains(&node.range().start());
    let mut node = root;
    while node.kind() == SyntaxKind::BLOCK || !starts_in_line(&node) {
        let reaching = |child: &View<'_>| child.range().end() > line.start() && child.range().start() < line.end();
        let Some(child) = node.children().find(reaching) else { return line };
        node = child;
    }
    line.cover(node.range())
}

struct SuppressionReader<'t> {
    text: &'t str,
    /// Whether no line of code has been read yet.
    in_head: bool,
    found: Vec<Suppression>,
    uncovered: Vec<TextRange>,
}

impl SuppressionReader<'_> {
    fn elements(&mut self, node: View<'_>) {
        for child in node.children() {
            match child.kind() {
                SyntaxKind::CODE => {
                    self.in_head = true;
                    self.code(child);
                }
                SyntaxKind::ELEMENT => self.elements(child),
                _ => {}
            }
        }
    }

    fn code(&mut self, node: View<'_>) {
        for child in node.children_with_tokens() {
            match child {
                NodeOrToken::Node(node) => self.code(node),
                NodeOrToken::Token(token) if token.kind() == SyntaxKind::COMMENT => self.comment(token),
                NodeOrToken::Token(token) => {
                    self.in_head &= token.kind().is_trivia() || token.kind() == SyntaxKind::BEGIN_KW;
                }
            }
        }
    }

    fn comment(&mut self, token: TokenView<'_>) {
        let Some(order) = token.text().trim_start_matches('/').trim_start().strip_prefix(MARK) else { return };
        let range = token.range();
        if is_about_coverage(order) {
            let whole = || range_of(0, self.text.len());
            self.uncovered.push(if self.in_head { whole() } else { self.next_code(range.end()) });
            return;
        }
        let suppression = match read(order) {
            None => Suppression { comment: range, scope: SuppressionExtent::Unreadable, rules: Vec::new() },
            Some((reach, words)) => {
                let rules = words.into_iter().map(|(from_end, word)| named(word, range.end() - from_end)).collect();
                Suppression { comment: range, scope: self.scope(reach, range), rules }
            }
        };
        self.found.push(suppression);
    }

    /// Returns the next line of code without its indentation.
    fn next_code(&self, from: TextSize) -> TextRange {
        let line = next_line(self.text, from);
        let blanks =
            self.text.get(line.start().into()..line.end().into()).map(|text| text.len() - text.trim_start().len());
        TextRange::new(range_of(0, usize::from(line.start()) + blanks.unwrap_or_default()).end(), line.end())
    }

    fn scope(&self, reach: AllowKeyword, comment: TextRange) -> SuppressionExtent {
        match reach {
            AllowKeyword::Line => SuppressionExtent::Line(next_line(self.text, comment.end())),
            AllowKeyword::Program if self.in_head => SuppressionExtent::Program,
            AllowKeyword::Program => SuppressionExtent::Misplaced,
        }
    }
}

/// Whether the comment is `no-coverage`, with or without a reason.
fn is_about_coverage(order: &str) -> bool {
    order.trim_start().strip_prefix(NO_COVERAGE).is_some_and(|rest| rest.is_empty() || rest.starts_with([' ', '\t']))
}

fn named(word: &str, start: TextSize) -> SuppressedRule {
    SuppressedRule { name: word.into(), range: TextRange::at(start, TextSize::of(word)) }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum AllowKeyword {
    Line,
    Program,
}

/// Reads the words after `val3:`, each with its distance from the end of the comment.
fn read(order: &str) -> Option<(AllowKeyword, Vec<(TextSize, &str)>)> {
    let (word, rest) = order.split_once('(')?;
    let (list, _reason) = rest.split_once(')')?;
    let reach = match word.trim() {
        "allow" => AllowKeyword::Line,
        "allow-program" => AllowKeyword::Program,
        _ => return None,
    };
    let mut from_end = TextSize::of(rest);
    let words = list.split(',').map(|part| {
        let word = (from_end - TextSize::of(part) + TextSize::of(part.trim_start()), part.trim());
        from_end -= TextSize::of(part) + TextSize::of(',');
        word
    });
    let words: Vec<_> = words.collect();
    words.iter().all(|(_, word)| !word.is_empty()).then_some((reach, words))
}

/// Returns the first line after `from` that is neither blank nor a comment; empty if no such line exists.
fn next_line(text: &str, from: TextSize) -> TextRange {
    let mut start = usize::from(from);
    let rest = text.part(start..);
    for line in rest.split_inclusive('\n') {
        let content = line.trim();
        if start > usize::from(from) && !content.is_empty() && !content.starts_with("//") {
            return range_of(start, start + line.trim_end_matches(['\n', '\r']).len());
        }
        start += line.len();
    }
    range_of(text.len(), text.len())
}

fn range_of(start: usize, end: usize) -> TextRange {
    TextRange::new(text_size(start), text_size(end))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use camino::Utf8PathBuf;
    use expect_test::{Expect, expect};
    use val3_syntax::encoding::Encoding;

    use super::*;
    use crate::db::{Database, FileStatus};

    #[track_caller]
    fn check(code: &str, expected: Expect) {
        let text = format!("<Program name=\"p\"><Code><![CDATA[\n{code}\n]]></Code></Program>");
        let db = Database::default();
        let status = FileStatus::Read { encoding: Encoding::Utf8, mismatch: None };
        let file = File::new(&db, Utf8PathBuf::from("p.pgx"), Arc::from(text.as_str()), status);
        let shown = suppressions(&db, file).iter().map(|found| {
            let rules: Vec<_> = found.rules.iter().map(|rule| (&text[rule.range], rule.name.as_str())).collect();
            assert!(rules.iter().all(|(there, name)| there == name));
            let scope = match found.scope {
                SuppressionExtent::Line(line) => format!("line `{}`", &text[line]),
                other => format!("{other:?}"),
            };
            let names: Vec<_> = rules.iter().map(|(_, name)| *name).collect();
            format!("{scope}: {}", names.join(", ")).trim_end().to_owned() + "\n"
        });
        expected.assert_eq(&shown.collect::<String>());
    }

    #[test]
    fn comments_for_a_line_and_a_program_are_read() {
        check(
            "begin\n  // val3: allow-program(V0701) old code\n  //val3: allow(V0302, no-effect) tested\n\n  // why\n  n=1\nend",
            expect![[r#"
                Program: V0701
                line `  n=1`: V0302, no-effect
            "#]],
        );
    }

    #[test]
    fn a_program_is_silenced_at_its_head() {
        check(
            "//val3: allow-program(a)\nbegin\n  n=1\n  //val3: allow-program(b)\nend",
            expect![[r#"
            Program: a
            Misplaced: b
        "#]],
        );
    }

    #[test]
    fn other_forms_are_reported() {
        check(
            "begin\n//val3: allow\n//val3: allow()\n//val3: alow(a)\n//val3: allow(a\n//val3 allow(a)\n// see val3: allow(a)\nend",
            expect![[r#"
                Unreadable:
                Unreadable:
                Unreadable:
                Unreadable:
            "#]],
        );
    }

    /// Checks the omitted code and the number of suppressions.
    #[track_caller]
    fn check_uncovered(code: &str, expected: Expect) {
        let text = format!("<Program name=\"p\"><Code><![CDATA[\n{code}\n]]></Code></Program>");
        let db = Database::default();
        let status = FileStatus::Read { encoding: Encoding::Utf8, mismatch: None };
        let file = File::new(&db, Utf8PathBuf::from("p.pgx"), Arc::from(text.as_str()), status);
        let whole = |range: &TextRange| usize::from(range.len()) == text.len();
        let shown = uncovered(&db, file)
            .iter()
            .map(|range| if whole(range) { "the file\n".to_owned() } else { format!("{}\n--\n", &text[*range]) });
        let unreadable = suppressions(&db, file).len();
        expected.assert_eq(&format!("{}{unreadable} suppressions", shown.collect::<String>()));
    }

    #[test]
    fn a_line_is_left_out_of_coverage_with_its_block() {
        check_uncovered(
            "begin\n  n=1\n  //val3: no-coverage\n  n=2\n  // val3: no-coverage never on the robot\n  while b\n    n=3\n  endWhile\n  n=4\nend",
            expect![[r#"
                n=2
                --
                while b
                    n=3
                  endWhile
                --
                0 suppressions"#]],
        );
    }

    #[test]
    fn clauses_are_left_out_of_coverage() {
        check_uncovered(
            "begin\n  if b\n    n=1\n  //val3: no-coverage\n  else\n    n=2\n  endIf\n  switch n\n    case 1\n      n=3\n    break\n    //val3: no-coverage\n    default\n      n=4\n    break\n  endSwitch\nend",
            expect![[r#"
                else
                    n=2
                --
                default
                      n=4
                    break
                --
                0 suppressions"#]],
        );
    }

    #[test]
    fn a_program_is_left_out_of_coverage_by_a_comment_at_its_head() {
        check_uncovered("//val3: no-coverage old\nbegin\n  n=1\nend", expect!["the file\n0 suppressions"]);
    }

    #[test]
    fn a_misspelt_comment_about_coverage_is_unreadable() {
        check_uncovered("begin\n  //val3: no-coverag\n  //val3: no-coverages\n  n=1\nend", expect!["2 suppressions"]);
    }

    #[test]
    fn comments_inside_of_blocks_are_read() {
        check(
            "begin\n  if b\n    //val3: allow(a)\n    n=1\n  endIf\nend",
            expect![[r#"
            line `    n=1`: a
        "#]],
        );
    }
}
