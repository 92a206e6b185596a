//! Trees of programs, data and projects.

use val3_syntax::encoding::decode;
use val3_syntax::{SyntaxNode, TextSize};

/// Parses `bytes` as a file: no text is lost, and every fault is inside the text.
pub fn parse(bytes: &[u8]) {
    let text = decode(bytes.to_vec()).text;
    let parse = val3_syntax::parse(&text);
    let root = parse.root();
    assert_eq!(root.to_string(), text, "the tree lost some text");
    let end = TextSize::of(text.as_str());
    for error in parse.errors() {
        let ranges = std::iter::once(error.range).chain(error.related);
        ranges.for_each(|range| assert!(range.end() <= end, "{error:?} lies outside the text"));
    }
    touching(&root);
}

/// Checks that siblings touch: no byte is between two elements of a node.
fn touching(root: &SyntaxNode) {
    for node in root.descendants() {
        let mut at = node.text_range().start();
        for child in node.children_with_tokens() {
            assert_eq!(child.text_range().start(), at, "a gap in {node:?}");
            at = child.text_range().end();
        }
    }
}
