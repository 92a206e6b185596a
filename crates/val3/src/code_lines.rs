//! Line numbers as the controller counts them: within the code of a program, `begin` being line 1.

use val3_analysis::items::faults::CodeRange;
use val3_lines::LineIndex;

/// Ranges of the programs' code in a file.
#[derive(Debug)]
pub(crate) struct CodeLines(Vec<CodeRange>);

impl CodeLines {
    /// Creates the code lines of a file from its code ranges.
    pub(crate) fn new(codes: &[CodeRange]) -> Self {
        Self(codes.to_vec())
    }

    /// Line number of `offset` within its code, from 1; `None` outside of code.
    pub(crate) fn line(&self, offset: usize, lines: &LineIndex) -> Option<usize> {
        let code = self.0.iter().find(|code| contains(code, offset))?;
        let before = lines.line(offset).checked_sub(lines.line(code.begin.into()))?;
        Some(before + 1)
    }
}

fn contains(code: &CodeRange, offset: usize) -> bool {
    usize::from(code.range.start()) <= offset && offset <= usize::from(code.range.end())
}

#[cfg(test)]
mod tests {
    use val3_syntax::{TextRange, TextSize};

    use super::*;

    const FILE: &str =
        "<Programs>\n<Program name=\"p\">\n<Code><![CDATA[\nbegin\n  x=1\nend\n]]></Code>\n</Program></Programs>\n";

    fn line_of(part: &str) -> Option<usize> {
        let at = |part: &str| TextSize::try_from(FILE.find(part).unwrap()).unwrap();
        let range = TextRange::new(at("<![CDATA["), at("</Code>"));
        let codes = CodeLines::new(&[CodeRange { range, begin: at("begin") }]);
        codes.line(FILE.find(part).unwrap(), &LineIndex::new(FILE))
    }

    #[test]
    fn begin_is_in_line_1() {
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
