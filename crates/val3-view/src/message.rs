//! A message for pages.

use serde_json::Value;

/// A message.
#[derive(Debug, Clone, PartialEq)]
pub enum Message {
    /// A JSON object; `kind` names it.
    Object(Value),
    /// A batch of samples of the arm.
    Samples(Vec<u8>),
}
