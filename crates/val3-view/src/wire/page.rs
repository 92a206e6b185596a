//! Message `page`: the user page that the pendant shows.

use schemars::JsonSchema;
use serde::Serialize;

/// Number of columns with the same text mode, and the number of the mode (`setTextMode`).
pub type ModeRun = (usize, u8);

/// User page.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct PageMessage {
    /// Time in s.
    pub t: f64,
    /// Name of the screen variable.
    pub screen: String,
    /// Title.
    pub title: Option<String>,
    /// The 14 lines.
    pub lines: Vec<String>,
    /// Text modes by line.
    pub modes: Vec<Vec<ModeRun>>,
    /// Column and line of the cursor, from 0.
    pub cursor: Option<[usize; 2]>,
    /// Text of the pop-up.
    pub pop_up: Option<String>,
    /// HTML page.
    pub html: Option<HtmlPage>,
}

/// Bindings on the HTML page.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct HtmlPage {
    /// Page name.
    pub name: String,
    /// Values of elements.
    pub values: Vec<HtmlValue>,
    /// Programs that a click executes.
    pub clicks: Vec<HtmlClick>,
}

/// Element value.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct HtmlValue {
    /// Id of the element.
    pub id: String,
    /// Attribute, for example `innerHTML`.
    pub attribute: String,
    /// Value; `null` if the data does not exist.
    pub value: Option<String>,
}

/// Program that a click on an element executes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct HtmlClick {
    /// Id of the element.
    pub id: String,
    /// Program name.
    pub program: String,
}
