//! Physical inputs, outputs and serial lines to which data can be linked.

use val3_analysis::db::{Db, Project};
use val3_lang::types::BaseType;

/// An input, output or serial line of the cell.
pub(crate) struct IoLink {
    /// Link, for example `BasicIO-1\%Q0`.
    pub(crate) path: String,
    /// Whether values of the type are usually linked to such a signal.
    pub(crate) is_usual: bool,
}

/// Type of the signal to which a value of type `ty` is linked. A tool is linked to the output that opens it.
pub(crate) fn linked_type(ty: BaseType) -> BaseType {
    if ty == BaseType::Tool { BaseType::Dio } else { ty }
}

/// Signals of the cell to which values of type `ty` can be linked.
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
