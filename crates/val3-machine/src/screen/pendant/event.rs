//! Events of the pendant, for a view and for the record.

use crate::controller_state::MessageSeverity;
use crate::screen::{CursorCell, PageId};

/// Message above the displayed page (`popUpMsg`).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PopUp {
    /// The message.
    pub text: String,
    /// Kind of the message.
    pub severity: MessageSeverity,
}

/// An event of the pendant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ScreenEvent {
    /// Another page is shown.
    Shown(PageId),
    /// Text was written.
    Put {
        /// The page.
        page: PageId,
        /// Start position of the text.
        at: CursorCell,
        /// The text.
        text: String,
        /// Whether the cursor moved to the next line after it.
        ends_line: bool,
    },
    /// The title of a page has changed.
    Title(PageId, String),
    /// A page was emptied.
    Cleared(PageId),
    /// A pop-up is shown.
    PopUp(PopUp),
    /// The operator has confirmed the pop-up.
    PopUpConfirmed,
    /// An HTML page is shown (s8).
    HtmlShown(String),
    /// An element's property on an HTML page has changed (s8).
    HtmlSet {
        /// The page.
        page: String,
        /// The element.
        id: String,
        /// The property, such as `innerHTML`.
        attribute: String,
        /// The value as text.
        value: String,
    },
    /// A question to the operator is shown (s8).
    Question(String),
}
