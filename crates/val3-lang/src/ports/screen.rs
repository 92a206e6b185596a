//! The pendant: user pages, keys and messages (4).

use crate::fault::Result;
use crate::keys;
use crate::memory::Place;

/// The number of the page that instructions without a screen use; it always exists (4.2.1).
pub const DEFAULT_PAGE: u32 = 0;

/// The kind of input that the operator is asked for.
#[derive(Debug, Clone, PartialEq)]
pub enum InputKind {
    /// Any key; it is not shown.
    Key,
    /// Return or a menu key for yes, Esc for no; other keys do nothing (`userPageConfirm`).
    Confirmation,
    /// A text, at first this one, which is shown at the cursor.
    Text(String),
    /// A number, at first this one.
    Number {
        /// Its value.
        value: f64,
        /// The value as `put` shows it.
        shown: String,
    },
}

/// How a `get` ended.
#[derive(Debug, Clone, PartialEq)]
pub struct InputResult {
    /// The code of the key that ended it: the result of `get`.
    pub key: u16,
    /// The new value of the variable.
    pub entry: OperatorInput,
}

impl InputResult {
    /// The operator has accepted: any key but Esc has ended it.
    #[must_use]
    pub fn is_accepted(&self) -> bool {
        self.key != keys::ESC
    }
}

/// The input of the operator.
#[derive(Debug, Clone, PartialEq)]
pub enum OperatorInput {
    /// The variable keeps its value: Esc, or no variable, or a text that is no number.
    Unchanged,
    /// The text accepted with Return or a menu key.
    Text(String),
    /// The number accepted with Return or a menu key.
    Number(f64),
}

/// The pendant. Pages go by their numbers: [`DEFAULT_PAGE`], or what [`create_page`](Self::create_page) gives.
pub trait Screen {
    /// Shows a line of text that `?` prints.
    fn print(&mut self, text: &str);

    /// A new page, for the `screen` variable at this place.
    fn create_page(&mut self, variable: Place) -> u32;

    /// Shows a page (`userPage`).
    fn show_page(&mut self, page: u32);

    /// Keeps the operator on the user pages, or no longer (`userPage`).
    fn fix_page(&mut self, fixed: bool);

    /// Moves the cursor of a page, modulo 40 and 14 (`gotoxy`).
    fn go_to(&mut self, page: u32, x: f64, y: f64);

    /// Empties a page (`cls`).
    fn clear(&mut self, page: u32);

    /// Chooses how text that follows looks (`setTextMode`).
    ///
    /// # Errors
    /// 70 for a number that is no mode.
    fn set_text_mode(&mut self, page: u32, mode: f64) -> Result<()>;

    /// Writes text at the cursor, and goes to the next line if `ends_line` (`put`, `putln`).
    fn put(&mut self, page: u32, text: &str, ends_line: bool);

    /// Changes the title of a page (`title`).
    fn set_title(&mut self, page: u32, text: &str);

    /// Shows a message until the operator confirms it; `level` is its kind, 1 to 3 (`popUpMsg`).
    fn pop_up(&mut self, text: &str, level: f64);

    /// Begins to ask the operator on a page for the task that runs (`get`); what it was asking for before is given up.
    fn begin_reading(&mut self, page: u32, asked: InputKind);

    /// Begins to ask the operator a question above the pages for the task that runs (`userPageConfirm`,
    /// `userPagePrompt`); what it was asking for before is given up.
    fn begin_question(&mut self, text: &str, asked: InputKind);

    /// The answer to what the task that runs has asked; `None` while the operator has not ended it.
    fn take_answer(&mut self) -> Option<InputResult>;

    /// The last key that was pressed while the page was shown, since the call before (`getKey`).
    fn take_key(&mut self, page: u32) -> Option<u16>;

    /// A key is held down, and the page is shown (`isKeyPressed`).
    fn is_key_pressed(&mut self, page: u32, code: f64) -> bool;

    /// The columns that a text takes (`getDisplayLen`).
    fn display_columns(&mut self, text: &str) -> usize;

    /// Shows a page made with HTML; the result of `userPage` (s8).
    fn show_html(&mut self, page: &str) -> i8;

    /// Changes a property of an element of a page made with HTML (`userPageSet`).
    fn set_html(&mut self, page: &str, id: &str, attribute: &str, value: &str);
}
