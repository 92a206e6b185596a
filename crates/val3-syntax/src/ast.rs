//! Typed access to the tree: one struct a node, made from `val3.ungram` by `cargo xtask codegen`.

pub mod support;

mod generated;

pub use generated::*;
pub use support::{AstChildren, AstNode};
