//! Report formats, one in each file.

mod escape;
pub mod html;
pub mod human;
pub mod json;
pub mod markdown;
