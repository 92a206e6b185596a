//! Notation of programs, trees and errors in the tests.

use std::fmt::Write;

use rowan::NodeOrToken;
use val3_syntax::error::SyntaxError;
use val3_syntax::view::View;
use val3_syntax::{Parse, SyntaxKind, SyntaxNode, TextRange, parse};

/// Returns a program file of the new dialect with `code`, which starts with `begin`.
pub(crate) fn program(code: &str) -> String {
    format!("<Programs><Program name=\"p\"><Code><![CDATA[{code}]]></Code></Program></Programs>")
}

/// Returns a program whose body is `lines`.
pub(crate) fn body(lines: &str) -> String {
    program(&format!("begin\n{lines}\nend"))
}

/// Parses a text, whose tree must have the same text.
pub(crate) fn parsed(text: &str) -> Parse {
    let parse = parse(text);
    assert_eq!(parse.root().text().to_string(), text);
    assert_same(&parse.root(), parse.view());
    for error in parse.errors() {
        for range in [Some(error.range), error.related].into_iter().flatten() {
            assert!(text.get(std::ops::Range::<usize>::from(range)).is_some(), "{error:?}");
        }
    }
    parse
}

/// Checks that the rowan tree and the views have the same nodes and tokens.
fn assert_same(node: &SyntaxNode, view: View<'_>) {
    assert_eq!((node.kind(), node.text_range()), (view.kind(), view.range()));
    let (nodes, views): (Vec<_>, Vec<_>) =
        (node.children_with_tokens().collect(), view.children_with_tokens().collect());
    assert_eq!(nodes.len(), views.len());
    for pair in nodes.iter().zip(views) {
        match pair {
            (NodeOrToken::Node(node), NodeOrToken::Node(view)) => assert_same(node, view),
            (NodeOrToken::Token(token), NodeOrToken::Token(view)) => {
                assert_eq!((token.kind(), token.text_range()), (view.kind(), view.range()));
                assert_eq!(token.text(), view.text());
            }
            (element, view) => assert_eq!(element.kind().is_node(), matches!(view, NodeOrToken::Node(_))),
        }
    }
}

/// Shows the body of a program as nested expressions, without trivia.
pub(crate) fn tree(lines: &str) -> String {
    let text = body(lines);
    let parse = parsed(&text);
    assert!(parse.errors().is_empty(), "{}", faults_of(&text, &parse));
    tree_of_body(&parse)
}

/// Like [`tree`], for a program with errors.
pub(crate) fn broken_tree(lines: &str) -> String {
    tree_of_body(&parsed(&body(lines)))
}

fn tree_of_body(parse: &Parse) -> String {
    let root = parse.root();
    let code = root.descendants().find(|node| node.kind() == SyntaxKind::CODE).unwrap();
    let block = code.children().find(|node| node.kind() == SyntaxKind::BLOCK).unwrap();
    let mut out = String::new();
    for statement in block.children() {
        show(&statement, 0, &mut out);
        out.push('\n');
    }
    out
}

/// Shows `(KIND children)`: tokens as text, statements and clauses on separate lines.
fn show(node: &SyntaxNode, indent: usize, out: &mut String) {
    write!(out, "({:?}", node.kind()).unwrap();
    for child in node.children_with_tokens() {
        if let Some(token) = child.as_token() {
            if !token.kind().is_trivia() {
                write!(out, " {}", token.text()).unwrap();
            }
        } else if let Some(child) = child.as_node() {
            let own_line = node.kind() == SyntaxKind::BLOCK
                || matches!(
                    child.kind(),
                    SyntaxKind::BLOCK
                        | SyntaxKind::ELSE_CLAUSE
                        | SyntaxKind::ELSE_IF_CLAUSE
                        | SyntaxKind::CASE_CLAUSE
                        | SyntaxKind::DEFAULT_CLAUSE
                );
            if own_line {
                write!(out, "\n{:1$}", "", 2 * (indent + 1)).unwrap();
                show(child, indent + 1, out);
            } else {
                out.push(' ');
                show(child, indent, out);
            }
        }
    }
    out.push(')');
}

/// Shows the errors of a body, one on each line; line 1 is the first line of the body.
pub(crate) fn faults(lines: &str) -> String {
    faults_in(&body(lines))
}

/// Shows the errors of a file, one on each line; the line with `begin` is line 0.
pub(crate) fn faults_in(text: &str) -> String {
    faults_of(text, &parsed(text))
}

fn faults_of(text: &str, parse: &Parse) -> String {
    parse.errors().iter().map(|error| line(text, error)).collect()
}

/// Shows an error: its location, kind and related location.
pub(crate) fn line(text: &str, error: &SyntaxError) -> String {
    let related = error.related.map(|range| format!(" <- {}", place(text, range))).unwrap_or_default();
    format!("{} {:?}{related}\n", place(text, error.range), error.kind)
}

/// Formats `line:column "text"`, both from 1. Lines count from the line after `begin`, if the file has one.
fn place(text: &str, range: TextRange) -> String {
    let start = usize::from(range.start());
    let line_start = text[..start].rfind('\n').map_or(0, |end| end + 1);
    let line = text[..start].matches('\n').count();
    let column = text[line_start..start].chars().count() + 1;
    format!("{line}:{column} {:?}", &text[range])
}
