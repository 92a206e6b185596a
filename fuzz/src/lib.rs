//! The laws that hold for any input; a broken one is a panic.

use val3_check::testing::check_files;
use val3_syntax::encoding::decode;
use val3_syntax::{SyntaxNode, TextSize};

/// Parses `bytes` as a file: nothing is lost, and every fault lies inside the text.
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

/// Neighbours touch: no byte is between two elements of a node.
fn touching(root: &SyntaxNode) {
    for node in root.descendants() {
        let mut at = node.text_range().start();
        for child in node.children_with_tokens() {
            assert_eq!(child.text_range().start(), at, "a gap in {node:?}");
            at = child.text_range().end();
        }
    }
}

/// The files of the application that [`check`] makes.
const FILES: [&str; 3] =
    ["/cell/usr/usrapp/main/main.pjx", "/cell/usr/usrapp/main/main.dtx", "/cell/usr/usrapp/main/start.pgx"];

/// Checks an application: `bytes` hold its project, data and program, with a zero byte between them.
pub fn check(bytes: &[u8]) {
    let parts = bytes.splitn(FILES.len(), |byte| *byte == 0);
    let files: Vec<_> = FILES.iter().zip(parts).map(|(path, part)| ((*path).to_owned(), part.to_vec())).collect();
    for finding in check_files(&files) {
        let file = files.iter().find(|(path, _)| *path == finding.file);
        let lines = file.map_or(0, |(_, bytes)| bytes.split(|byte| *byte == b'\n').count());
        assert!(finding.line <= lines, "{finding:?} lies outside its file");
    }
}
