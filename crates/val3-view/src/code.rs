//! Code in the text of a program's file: lines without XML, in parts that have a colour.

use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, decode_entities, parse, xml};

use crate::wire::{CodeClass, CodePart};

/// Code of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Code {
    /// Line of the file with the first line of the code, from 1.
    pub(crate) line: u32,
    pub(crate) lines: Vec<Vec<CodePart>>,
}

impl Code {
    /// Whether a line of the file, from 1, contains a part of the code.
    pub(crate) fn contains(&self, line: u32) -> bool {
        line.checked_sub(self.line).is_some_and(|index| (index as usize) < self.lines.len())
    }

    /// Replaces the code at a line of the file. A line outside of the code has no effect.
    pub(crate) fn replace(&mut self, line: u32, code: &str) {
        let index = line.checked_sub(self.line).and_then(|index| usize::try_from(index).ok());
        if let Some(replaced) = index.and_then(|index| self.lines.get_mut(index)) {
            let program = codes(&format!("<Program><Code>begin\n{}\nend</Code></Program>", xml::escaped(code)));
            *replaced =
                program.into_iter().next().and_then(|program| program.lines.into_iter().nth(1)).unwrap_or_default();
        }
    }
}

/// Returns the code of all programs in a file, in their order.
pub(crate) fn codes(text: &str) -> Vec<Code> {
    let mut found = Vec::new();
    collect(parse(text).view(), text, &mut found);
    found
}

fn collect(node: View<'_>, text: &str, found: &mut Vec<Code>) {
    for child in node.children() {
        match child.kind() {
            SyntaxKind::CODE => found.push(code(child, text)),
            SyntaxKind::ELEMENT => collect(child, text, found),
            _ => {}
        }
    }
}

fn code(node: View<'_>, text: &str) -> Code {
    let mut lines = CodeLines { is_escaped: true, first: None, lines: vec![Vec::new()] };
    lines.walk(node);
    let start = lines.first.unwrap_or_else(|| node.range().start().into());
    let before = text.bytes().take(start).filter(|byte| *byte == b'\n').count();
    while lines.lines.last().is_some_and(|line| line.iter().all(|(_, text)| text.trim().is_empty())) {
        lines.lines.pop();
    }
    Code { line: u32::try_from(before).map_or(u32::MAX, |before| before.saturating_add(1)), lines: lines.lines }
}

/// Lines of a code while its tokens are read.
struct CodeLines {
    /// Whether the code is escaped text, so that it contains entity references.
    is_escaped: bool,
    /// Offset of the first token of the code.
    first: Option<usize>,
    lines: Vec<Vec<CodePart>>,
}

impl CodeLines {
    fn walk(&mut self, node: View<'_>) {
        for child in node.children_with_tokens() {
            child.as_node().into_iter().for_each(|node| self.walk(*node));
            child.as_token().into_iter().for_each(|token| self.token(*token));
        }
    }

    fn token(&mut self, token: TokenView<'_>) {
        match token.kind() {
            SyntaxKind::CDATA_OPEN => self.is_escaped = false,
            SyntaxKind::CDATA_CLOSE => {}
            SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE if self.first.is_none() => {}
            kind => {
                self.first.get_or_insert_with(|| token.range().start().into());
                self.add(class(kind), token.text());
            }
        }
    }

    fn add(&mut self, class: CodeClass, text: &str) {
        for (number, piece) in text.split('\n').enumerate() {
            if number > 0 {
                self.lines.push(Vec::new());
            }
            let piece = piece.trim_end_matches('\r');
            if !piece.is_empty() {
                self.add_to_line(class, piece);
            }
        }
    }

    fn add_to_line(&mut self, class: CodeClass, piece: &str) {
        // An escaped line end is no line of the file.
        let decoded =
            if self.is_escaped { decode_entities(piece).replace(['\n', '\r'], " ") } else { piece.to_owned() };
        let Some(line) = self.lines.last_mut() else { return };
        match line.last_mut() {
            Some((last, text)) if *last == class => text.push_str(&decoded),
            _ => line.push((class, decoded)),
        }
    }
}

fn class(kind: SyntaxKind) -> CodeClass {
    match kind {
        SyntaxKind::COMMENT => CodeClass::Comment,
        SyntaxKind::STRING => CodeClass::String,
        SyntaxKind::NUMBER => CodeClass::Number,
        kind if kind.is_keyword() || kind == SyntaxKind::QUESTION => CodeClass::Keyword,
        _ => CodeClass::Text,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;

    /// Compares the lines of all codes, with the class of each part that has a colour.
    #[track_caller]
    fn check(text: &str, expected: &Expect) {
        let part = |(class, text): &CodePart| match class {
            CodeClass::Text => text.clone(),
            class => format!("<{class:?} {text}>"),
        };
        let mut shown = String::new();
        for Code { line, lines } in codes(text) {
            for (number, parts) in (line..).zip(&lines) {
                shown += format!("{number}: {}", parts.iter().map(part).collect::<String>()).trim_end();
                shown.push('\n');
            }
        }
        expected.assert_eq(&shown);
    }

    #[test]
    fn code_has_the_line_numbers_of_its_file() {
        check(
            "<Programs>\n<Program name=\"start\">\r\n<Code><![CDATA[begin\r\n  // a <b>\r\n\r\n  if nA[1]==2.5 // c\r\n    \
             ?\"x&amp;\"\r\n  endIf\r\nend\r\n]]></Code></Program>\n<Program name=\"stop\"><Code><![CDATA[\n\nbegin\nend]]></Code>\n\
             </Program></Programs>",
            &expect![[r#"
                3: <Keyword begin>
                4:   <Comment // a <b>>
                5:
                6:   <Keyword if> nA[<Number 1>]==<Number 2.5> <Comment // c>
                7:     <Keyword ?><String "x&amp;">
                8:   <Keyword endIf>
                9: <Keyword end>
                13: <Keyword begin>
                14: <Keyword end>
            "#]],
        );
    }

    #[test]
    fn escaped_code_is_decoded() {
        check(
            "<Programs><Program name=\"start\"><Code>begin\n  nA=nB&lt;2\n  sA=&quot;&lt;b&gt;&#10;&quot;\nend</Code></Program></Programs>",
            &expect![[r#"
                1: <Keyword begin>
                2:   nA=nB<<Number 2>
                3:   sA=<String "<b> ">
                4: <Keyword end>
            "#]],
        );
    }

    #[test]
    fn a_file_without_code_has_none() {
        check("<Programs><Program name=\"start\"></Program></Programs>", &expect![[""]]);
        check("", &expect![[""]]);
    }
}
