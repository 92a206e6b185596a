//! A message for pages.

use serde_json::Value;

/// A message for pages.
#[derive(Debug, Clone, PartialEq)]
pub enum ViewerMessage {
    /// A JSON object; `kind` is its type.
    Object(Value),
    /// A batch of arm samples.
    Samples(Vec<u8>),
}
