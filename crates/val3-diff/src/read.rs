//! Reading of a file, in either dialect, to plain declarations.

pub(crate) mod code;
pub(crate) mod contents;
pub(crate) mod data;
pub(crate) mod entries;
pub(crate) mod number;
pub(crate) mod program;
pub(crate) mod project;
pub(crate) mod settings;
pub(crate) mod value;
