//! Incremental parsing after an edit of lines without block keywords: only these lines are parsed.
//!
//! A statement ends with its line, and only block keywords affect other lines. Lines without them, parsed between a
//! separate `begin` and `end`, therefore have the same tree as in their program.

use std::ops::Range;
use std::sync::Arc;

use memchr::memmem;
use rowan::{TextRange, TextSize};

use super::reparse::depth_of;
use super::statement_run::{StatementRun, is_line_end, runs_around};
use super::{Parse, parse_within};
use crate::edit::Change;
use crate::kind::SyntaxKind;
use crate::never::text_at;
use crate::tree::{NodeRef, Splice, TreeEntry};

impl Parse {
    /// Parses `new_text`, the text of this parse after `change`; `None` if other lines must be parsed, too.
    pub(super) fn reparse_lines(&self, new_text: &Arc<str>, change: Change) -> Option<Parse> {
        if !self.has_line_faults_only() {
            return None;
        }
        let text = self.tree.text();
        let path: Vec<NodeRef<'_>> = self.tree.root().path_to(change.range).collect();
        let (run, lines) = runs_around(&path).find_map(|run| {
            let lines = run.lines_around(change.range)?;
            Some((run, lines))
        })?;
        let old = lines.range();
        if affects_other_lines(lines.entries()) {
            return None;
        }
        let new = TextRange::new(old.start(), change.moved(old.end()));
        let (head, tail) = around(text, run.around, old.start());
        let code = new_text.get(Range::<usize>::from(new)).filter(|code| !leaves_stretch(code, tail))?;
        let read = parse_within([head, code, tail].concat().into(), depth_of(run.around.len()));
        let path = read.path_to_code()?;
        let inside = StatementRun::all_in_last(&path).next()?;
        let is_whole = inside.range() == TextRange::at(TextSize::of(head), new.len());
        let is_alone = read.has_line_faults_only() && inside.affects_only_itself();
        if !is_whole || !is_alone || !starts_as_before(new_text, new.end()) {
            return None;
        }
        let place = |at: TextSize| at - TextSize::of(head) + old.start();
        let odd_keywords = self.spliced_keywords(old, change, &read, place).into();
        let errors = self.spliced_errors(old, change, &read, place).into();
        let new = run.with(lines, &inside)?;
        let splice = Splice { range: run.indexes(), new: &new.entries() };
        let tree = self.tree.spliced(Arc::clone(new_text), change, run.around, &splice);
        Some(Parse { tree: Arc::new(tree), errors, odd_keywords })
    }

    fn has_line_faults_only(&self) -> bool {
        self.errors.iter().all(|error| error.kind.is_local_to_line())
    }

    /// Returns the nodes from the root to the code of a text that is a single element.
    fn path_to_code(&self) -> Option<Vec<NodeRef<'_>>> {
        let root = self.tree.root();
        let element = root.children().find(|piece| piece.kind().is_node())?;
        let code = element.children().find(|piece| piece.kind() == SyntaxKind::CODE)?;
        (element.range() == root.range()).then(|| vec![root, element, code])
    }
}

/// Returns the text that is placed before and after lines of the same code section, so that they form a program.
fn around(text: &str, path: &[NodeRef<'_>], at: TextSize) -> (&'static str, &'static str) {
    let code = path.iter().rfind(|node| node.kind() == SyntaxKind::CODE);
    let start = code.map_or(at, |code| code.range().start());
    let before = text_at(text, TextRange::new(start, at)).as_bytes();
    match memmem::rfind(before, b"<![CDATA[") > memmem::rfind(before, b"]]>") {
        true => ("<Code><![CDATA[begin", "end]]></Code>"),
        false => ("<code>begin", "end</code>"),
    }
}

/// Whether the lines may contain the end of the code segment.
fn leaves_stretch(code: &str, tail: &str) -> bool {
    code.contains("]]>") || tail.starts_with("end<") && code.contains('<')
}

/// Whether the first token of the line at `at` is independent of the indentation: it is neither a blank nor a conflict
/// marker.
fn starts_as_before(text: &str, at: TextSize) -> bool {
    let next = text.as_bytes().get(usize::from(at));
    next.is_some_and(|byte| !byte.is_ascii_whitespace() && !b"<>|=&".contains(byte))
}

impl StatementRun<'_, '_> {
    /// Whether the run ends with a line and contains nothing that affects other lines.
    fn affects_only_itself(&self) -> bool {
        let ends_line = self.pieces().last().is_some_and(is_line_end);
        ends_line && !self.pieces().any(|piece| affects_other_lines(piece.entries()))
    }
}

/// Whether the entries contain a keyword or mark that affects other lines.
fn affects_other_lines(entries: &[TreeEntry]) -> bool {
    entries.iter().any(|entry| is_of_blocks(entry.kind))
}

fn is_of_blocks(kind: SyntaxKind) -> bool {
    use SyntaxKind::*;
    let is_word = matches!(kind, BEGIN_KW | END_KW | IF_KW | ELSE_IF_KW | ELSE_KW | END_IF_KW | BREAK_KW | DEFAULT_KW)
        || matches!(kind, WHILE_KW | END_WHILE_KW | DO_KW | UNTIL_KW | FOR_KW | END_FOR_KW)
        || matches!(kind, SWITCH_KW | CASE_KW | END_SWITCH_KW);
    is_word || matches!(kind, XML_COMMENT | CDATA_OPEN | CDATA_CLOSE | CONFLICT_MARKER)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::parse;

    const CDATA: &str = "<a>\n<Code><![CDATA[begin\n  x=1\n  if x==1\n    put(x)\n    // two\n    y=\n  else\n  endIf\n\n  z=3\nend]]></Code>\n</a>";

    /// Whether an edit from `old` to `new` requires parsing only its own lines.
    fn is_local(text: &str, old: &str, new: &str) -> bool {
        let new_text = text.replacen(old, new, 1);
        let start = TextSize::try_from(text.find(old).unwrap()).unwrap();
        let change = Change { range: TextRange::at(start, TextSize::of(old)), inserted: TextSize::of(new) };
        let again = parse(text).reparse_lines(&new_text.as_str().into(), change);
        assert!(again.as_ref().is_none_or(|again| *again == parse(&new_text)));
        again.is_some()
    }

    #[test]
    fn lines_without_blocks_are_parsed_alone() {
        let edits = [("x=1", "x=12"), ("  x=1\n", ""), ("  x=1", "  w=2\n  x=1"), ("z=3", "z=3\n\n"), ("two", "2")];
        for (old, new) in edits.into_iter().chain([("y=", "y=f(2"), ("put(x)", "put(x)\n    Call p()"), ("(x)", "(")]) {
            assert!(is_local(CDATA, old, new), "{old} {new}");
        }
    }

    #[test]
    fn lines_with_blocks_are_parsed_with_others() {
        for (old, new) in
            [("x==1", "x==2"), ("x=1", "endIf"), ("z=3", "]]>"), ("endIf", ""), ("begin", "begin "), ("z=3", "end if")]
        {
            assert!(!is_local(CDATA, old, new), "{old} {new}");
        }
    }

    #[test]
    fn lines_of_escaped_code_are_parsed_alone() {
        let text = "<a><code>begin\nx=1 &lt; 2\ny=2\nend</code></a>";
        assert!(is_local(text, "1 &lt;", "1 &gt;") && is_local(text, "y=2", "y=&quot;&quot;"));
        assert!(!is_local(text, "y=2", "y=1 < 2") && !is_local(text, "y=2", "</code>"));
    }
}
