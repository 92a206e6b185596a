//! Grammar of files: XML outside, code inside.

mod blocks;
mod control;
mod expressions;
mod operands;
mod program;
mod rest_of_line;
mod statements;
mod switch;
mod tags;
mod tasks;
mod xml;

pub(crate) use xml::file;
