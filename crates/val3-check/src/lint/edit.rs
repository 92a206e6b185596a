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

    /// Code as the file spells it: with entity references where it is not in a CDATA section.
    pub(crate) fn spelt<'c>(&self, code: &'c str) -> Cow<'c, str> {
        if self.file.text(self.db).contains("<![CDATA[") || !code.contains(['<', '>', '&']) {
            return code.into();
        }
        code.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").into()
    }
}
