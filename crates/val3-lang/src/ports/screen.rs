//! Pendant: user pages, keys and messages (4).

use crate::fault::Result;
use crate::keys;
use crate::memory::Place;

/// Number of the page for instructions without a `screen` argument; this page always exists (4.2.1).
pub const DEFAULT_PAGE: u32 = 0;

/// Kind of input requested from the operator.
#[derive(Debug, Clone, PartialEq)]
pub enum InputKind {
    /// Any key, which is not shown.
    Key,
    /// Return or a menu key for yes, Esc for no; other keys do nothing (`userPageConfirm`).
    Confirmation,
    /// Text with this initial value, shown at the cursor.
    Text(String),
    /// Number with an initial value.
    Number {
        /// Initial value.
        value: f64,
        /// Initial value as formatted by `put`.
        shown: String,
    },
}

/// Result of a `get`.
#[derive(Debug, Clone, PartialEq)]
pub struct InputResult {
    /// Code of the key that ended the input: the result of `get`.
    pub key: u16,
    /// New value of the variable.
    pub entry: OperatorInput,
}

impl InputResult {
    /// Whether the operator accepted the input: any key except Esc.
    #[must_use]
    pub fn is_accepted(&self) -> bool {
        self.key != keys::ESC
    }
}

/// Operator input.
#[derive(Debug, Clone, PartialEq)]
pub enum OperatorInput {
    /// The variable is unchanged: Esc, no variable, or a text that is not a number.
    Unchanged,
    /// Text accepted with Return or a menu key.
    Text(String),
    /// Number accepted with Return or a menu key.
    Number(f64),
}

/// Pendant. A page number is [`DEFAULT_PAGE`] or a result of [`create_page`](Self::create_page).
pub trait Screen {
    /// Shows a line that `?` prints.
    fn print(&mut self, text: &str);

    /// Creates a page for the `screen` variable at this place.
    fn create_page(&mut self, variable: Place) -> u32;

    /// Shows a page (`userPage`).
    fn show_page(&mut self, page: u32);

    /// Sets whether the operator cannot leave the user pages (`userPage`).
    fn fix_page(&mut self, fixed: bool);

    /// Moves a page's cursor, modulo 40 and 14 (`gotoxy`).
    fn go_to(&mut self, page: u32, x: f64, y: f64);

    /// Clears a page (`cls`).
    fn clear(&mut self, page: u32);

    /// Sets the style of subsequent text (`setTextMode`).
    ///
    /// # Errors
    /// 70 for an unknown mode.
    fn set_text_mode(&mut self, page: u32, mode: f64) -> Result<()>;

    /// Writes text at the cursor, and goes to the next line if `ends_line` (`put`, `putln`).
    fn put(&mut self, page: u32, text: &str, ends_line: bool);

    /// Sets a page's title (`title`).
    fn set_title(&mut self, page: u32, text: &str);

    /// Shows a message with level 1 to 3 until the operator confirms it (`popUpMsg`).
    fn pop_up(&mut self, text: &str, level: f64);

    /// Requests operator input on a page for the running task (`get`). Cancels the task's earlier request.
    fn begin_reading(&mut self, page: u32, asked: InputKind);

    /// Requests operator input above all pages for the running task (`userPageConfirm`, `userPagePrompt`). Cancels the
    /// task's earlier request.
    fn begin_question(&mut self, text: &str, asked: InputKind);

    /// Removes and returns the result of the running task's request; `None` until the operator ends the input.
    fn take_answer(&mut self) -> Option<InputResult>;

    /// Removes and returns the last key that was pressed while the page was shown, since the previous call (`getKey`).
    fn take_key(&mut self, page: u32) -> Option<u16>;

    /// Whether a key is held down while the page is shown (`isKeyPressed`).
    fn is_key_pressed(&mut self, page: u32, code: f64) -> bool;

    /// Returns a text's width in columns (`getDisplayLen`).
    fn display_columns(&mut self, text: &str) -> usize;

    /// Shows an HTML page and returns the result of `userPage` (s8).
    fn show_html(&mut self, page: &str) -> i8;

    /// Sets an element's property on an HTML page (`userPageSet`).
    fn set_html(&mut self, page: &str, id: &str, attribute: &str, value: &str);
}
