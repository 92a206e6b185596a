//! Answer of a tool.

use serde_json::Value;

use crate::cut::cut;

/// Answer of a tool: text for a language model, and for some tools the same facts as structured data.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Answer {
    /// Whether nothing is wrong with the files or the run.
    pub(crate) ok: bool,
    /// Compact Markdown.
    pub(crate) text: String,
    /// Counts and the result, for programs that use the client. The text is not repeated.
    pub(crate) data: Option<Value>,
    /// Whether the limit of the text is [`LONG`] instead of [`SHORT`].
    pub(crate) detail: bool,
}

/// Size limit for answers, in bytes.
pub(crate) const SHORT: usize = 8_000;

/// Size limit for answers with `detail`, in bytes.
pub(crate) const LONG: usize = 24_000;

impl Answer {
    pub(crate) fn new(ok: bool, text: impl Into<String>) -> Self {
        Self { ok, text: text.into(), data: None, detail: false }
    }

    pub(crate) fn with_data(self, data: Value) -> Self {
        Self { data: Some(data), ..self }
    }

    pub(crate) fn with_detail(self, detail: bool) -> Self {
        Self { detail, ..self }
    }

    /// Text of the answer, shortened to its limit: the verdict, followed by the text.
    pub(crate) fn limited_text(&self) -> String {
        let verdict = if self.ok { "ok" } else { "not ok" };
        let (limit, hint) = if self.detail {
            (LONG, "ask for a smaller part")
        } else {
            (SHORT, "ask for a smaller part, or for more with `detail`")
        };
        let separator = if self.text.starts_with('\n') { "" } else { " " };
        cut(&format!("{verdict}:{separator}{}", self.text.trim_end()), limit, hint)
    }
}
