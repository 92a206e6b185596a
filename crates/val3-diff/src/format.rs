//! The formats of a report, one a file.

mod escape;
pub mod html;
pub mod human;
pub mod json;
pub mod markdown;
