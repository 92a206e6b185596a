//! What fixes need: where the parts of code stand, and how text is spelt in its file.

use std::borrow::Cow;

use val3_analysis::body::ExprId;
use val3_syntax::{TextRange, TextSize};

use super::Program;

impl Program<'_> {
    /// Where the operator `op` stands between two operands; `None` if it is spelt with entity references.
    pub(crate) fn operator(&self, left: ExprId, right: ExprId, op: &str) -> Option<TextRange> {
        let (start, end) = (self.range(left).end(), self.range(right).start());
        let between = self.file.text(self.db).get(usize::from(start)..usize::from(end))?;
        let at = TextSize::try_from(between.find(op)?).ok()?;
        Some(TextRange::at(start + at, TextSize::try_from(op.len()).ok()?))
    }

    /// Puts a line of its own before the line on which `range` starts, indented alike.
    pub(crate) fn line_before(&self, range: TextRange, code: &str) -> (TextRange, String) {
        let start = self.line_start(range.start());
        (TextRange::empty(start), format!("{}{}{}", self.indentation(start), self.spelt(code), self.line_end()))
    }

    /// Puts a line of its own behind a statement that ends with `range`, indented like the line it starts on.
    pub(crate) fn line_after(&self, range: TextRange, code: &str) -> (TextRange, String) {
        let start = self.line_start(range.start());
        (TextRange::empty(range.end()), format!("{}{}{}", self.line_end(), self.indentation(start), self.spelt(code)))
    }

    fn line_start(&self, at: TextSize) -> TextSize {
        let before = self.file.text(self.db).get(..usize::from(at)).unwrap_or("");
        TextSize::try_from(before.rfind('\n').map_or(0, |end| end + 1)).unwrap_or_default()
    }

    fn indentation(&self, line: TextSize) -> &str {
        let rest = self.file.text(self.db).get(usize::from(line)..).unwrap_or("");
        rest.get(..rest.find(|character| !matches!(character, ' ' | '\t')).unwrap_or(0)).unwrap_or("")
    }

    fn line_end(&self) -> &'static str {
        if self.file.text(self.db).contains("\r\n") { "\r\n" } else { "\n" }
    }

    /// Code as the file spells it: with entity references where it is not in a CDATA section.
    pub(crate) fn spelt<'c>(&self, code: &'c str) -> Cow<'c, str> {
        if self.file.text(self.db).contains("<![CDATA[") || !code.contains(['<', '>', '&']) {
            return code.into();
        }
        code.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").into()
    }
}
