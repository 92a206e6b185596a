//! Lines as the controller counts them: within the code of a program, the line of `begin` being 1.

use std::ops::Range;

use val3_syntax::SyntaxKind;
use val3_syntax::view::View;

use crate::line_index::LineIndex;

/// Where the code of each program of a file stands.
#[derive(Debug)]
pub(crate) struct CodeLines(Vec<Code>);

#[derive(Debug)]
struct Code {
    range: Range<usize>,
    /// The start of `begin`, or of the code where there is none.
    begin: usize,
}

impl CodeLines {
    /// Looks through the tree of a file.
    pub(crate) fn new(root: View<'_>) -> Self {
        let mut codes = Vec::new();
        collect(root, &mut codes);
        Self(codes)
    }

    /// The line within the code around `offset`, from 1; `None` outside of code.
    pub(crate) fn line(&self, offset: usize, lines: &LineIndex) -> Option<usize> {
        let around = |code: &&Code| code.range.start <= offset && offset <= code.range.end;
        let code = self.0.iter().find(around)?;
        let before = lines.line(offset).checked_sub(lines.line(code.begin))?;
        Some(before + 1)
    }
}

/// Gathers code from the elements below `parent`; a stack of its own keeps deep documents harmless.
fn collect(parent: View<'_>, codes: &mut Vec<Code>) {
    let mut open = vec![parent];
    while let Some(view) = open.pop() {
        for child in view.children() {
            match child.kind() {
                SyntaxKind::CODE => codes.push(code(child)),
                SyntaxKind::ELEMENT => open.push(child),
                _ => {}
            }
        }
    }
}

fn code(view: View<'_>) -> Code {
    let range = Range::<usize>::from(view.range());
    let begin = view.token(SyntaxKind::BEGIN_KW).map(|token| token.range().start().into());
    Code { begin: begin.unwrap_or(range.start), range }
}

#[cfg(test)]
mod tests {
    use val3_syntax::encoding::Encoding;
    use val3_syntax::parse;

    use super::*;

    const FILE: &str =
        "<Programs>\n<Program name=\"p\">\n<Code><![CDATA[\nbegin\n  x=1\nend\n]]></Code>\n</Program></Programs>\n";

    fn line_of(part: &str) -> Option<usize> {
        let parse = parse(FILE);
        let codes = CodeLines::new(View::root(parse.green()));
        codes.line(FILE.find(part).unwrap(), &LineIndex::new(FILE, Encoding::Utf8))
    }

    #[test]
    fn begin_stands_in_line_1() {
        assert_eq!(line_of("begin"), Some(1));
        assert_eq!(line_of("x=1"), Some(2));
        assert_eq!(line_of("end\n]"), Some(3));
    }

    #[test]
    fn outside_of_code_there_are_no_code_lines() {
        assert_eq!(line_of("name"), None);
        assert_eq!(line_of("</Program>"), None);
    }
}
