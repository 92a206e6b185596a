//! The events of the pendant, for a view and for the record.

use crate::controller_state::Severity;
use crate::screen::{PageId, Position};

/// A message above whatever the pendant shows (`popUpMsg`).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PopUp {
    /// The message.
    pub text: String,
    /// Its kind.
    pub severity: Severity,
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
        /// Where the text begins.
        at: Position,
        /// The text.
        text: String,
        /// The cursor went to the next line after it.
        ends_line: bool,
    },
    /// A page has another title.
    Title(PageId, String),
    /// A page was emptied.
    Cleared(PageId),
    /// A pop-up came up.
    PopUp(PopUp),
    /// The operator has confirmed the pop-up.
    PopUpConfirmed,
    /// A page made with HTML is shown (s8).
    HtmlShown(String),
    /// A property of an element of a page made with HTML has another value (s8).
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
    /// The operator is asked a question (s8).
    Question(String),
}
