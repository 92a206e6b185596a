//! The physical inputs, outputs and lines that data can be linked to.

use val3_analysis::db::{Db, Project};
use val3_lang::types::BaseType;

/// An input, output or line of the cell.
pub(crate) struct IoLink {
    /// `BasicIO-1\%Q0`
    pub(crate) path: String,
    /// Values of the type are usually linked to such ones.
    pub(crate) is_usual: bool,
}

/// The type of what a value of type `ty` is linked to. A tool opens with an output.
pub(crate) fn linked_type(ty: BaseType) -> BaseType {
    if ty == BaseType::Tool { BaseType::Dio } else { ty }
}

/// The inputs and outputs of the cell that values of type `ty` can be linked to.
pub(crate) fn io_links(db: &dyn Db, project: Project, ty: BaseType) -> Vec<IoLink> {
    let Some(cell) = project.cell(db) else { return Vec::new() };
    let (wanted, is_tool) = (linked_type(ty), ty == BaseType::Tool);
    let devices = cell.config(db).io.devices.iter();
    let links = devices.flat_map(|(device, channels)| channels.iter().map(move |(name, kind)| (device, name, kind)));
    let links = links.filter(|(_, _, kind)| **kind == wanted);
    links
        .map(|(device, name, _)| IoLink {
            path: format!("{device}\\{name}"),
            is_usual: !(is_tool && name.starts_with("%I")),
        })
        .collect()
}
