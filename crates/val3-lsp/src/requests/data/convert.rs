//! Conversion of feature tables to messages of the data editor.

use tower_lsp::lsp_types::DiagnosticSeverity;
use val3_ide as ide;
use val3_lang::types;

use super::messages::*;
use crate::convert::diagnostic;
use crate::lines::PositionConverter;
use crate::snapshot::Snapshot;

/// Dialect of a file.
pub(super) fn dialect(dialect: ide::Dialect) -> Dialect {
    match dialect {
        ide::Dialect::Old => Dialect::Old,
        ide::Dialect::New => Dialect::New,
    }
}

/// Types with their columns.
pub(super) fn data_types(types: Vec<ide::DataType>) -> Vec<DataType> {
    types.into_iter().map(data_type).collect()
}

/// Variables of a file.
pub(super) fn data(lines: &PositionConverter<'_>, data: Vec<ide::TableVariable>) -> Vec<Datum> {
    data.into_iter().map(|data| datum(lines, data)).collect()
}

/// Reason as a sentence with its line number.
pub(super) fn in_words(lines: &PositionConverter<'_>, problem: &ide::DataProblem) -> String {
    match problem.range {
        Some(range) => format!("{} (line {})", problem.reason, lines.position(range.start()).line + 1),
        None => problem.reason.clone(),
    }
}

fn data_type(ty: ide::DataType) -> DataType {
    let containers = [(ty.has_arrays, Container::Array), (ty.has_collections, Container::Collection)];
    let fields = ty.fields.into_iter().map(|field| FieldType {
        name: field.name,
        type_name: field.type_name,
        container: container(field.container),
        size: field.sizes,
    });
    DataType {
        name: ty.name,
        columns: ty.columns.into_iter().map(column).collect(),
        fields: fields.collect(),
        containers: containers.into_iter().filter(|(allowed, _)| *allowed).map(|(_, container)| container).collect(),
    }
}

fn column(column: ide::DataColumn) -> Column {
    let kind = match column.kind {
        ide::ColumnKind::Number => ColumnKind::Number,
        ide::ColumnKind::Text => ColumnKind::Text,
        ide::ColumnKind::Truth => ColumnKind::Bool,
        ide::ColumnKind::Choice => ColumnKind::Choice,
        ide::ColumnKind::Father => ColumnKind::Father,
        ide::ColumnKind::Link => ColumnKind::Link,
    };
    Column {
        id: column.id.to_owned(),
        title: column.title.to_owned(),
        unit: column.unit.map(str::to_owned),
        kind,
        choices: column.choices,
        default: column.default,
    }
}

fn container(container: types::Container) -> Container {
    match container {
        types::Container::Collection => Container::Collection,
        types::Container::Array { .. } | types::Container::Element => Container::Array,
    }
}

fn datum(lines: &PositionConverter<'_>, data: ide::TableVariable) -> Datum {
    Datum {
        name: data.name.to_string(),
        access: if data.public { Access::Public } else { Access::Private },
        type_name: data.type_name.to_string(),
        container: container(data.container),
        size: data.sizes,
        range: lines.range(data.range),
        values: data.values.into_iter().map(value).collect(),
    }
}

fn value(value: ide::DatumValue) -> TableElement {
    TableElement { key: value.key, texts: value.texts, fields: value.fields.into_iter().map(field).collect() }
}

fn field(data: ide::TableVariable) -> FieldContent {
    FieldContent {
        name: data.name.to_string(),
        type_name: data.type_name.to_string(),
        container: container(data.container),
        size: data.sizes,
        values: data.values.into_iter().map(value).collect(),
    }
}

/// Findings by table cell.
pub(super) fn findings(snapshot: &Snapshot, findings: Vec<ide::DataFinding>) -> Vec<DataFinding> {
    findings.into_iter().map(|found| finding(snapshot, found)).collect()
}

fn finding(snapshot: &Snapshot, found: ide::DataFinding) -> DataFinding {
    let shown = diagnostic(snapshot, &found.diagnostic);
    let severity = match shown.severity {
        Some(DiagnosticSeverity::ERROR) | None => DataSeverity::Error,
        Some(DiagnosticSeverity::WARNING) => DataSeverity::Warning,
        Some(DiagnosticSeverity::INFORMATION) => DataSeverity::Information,
        Some(_) => DataSeverity::Hint,
    };
    DataFinding {
        place: place(found.place),
        column: found.column,
        severity,
        code: found.diagnostic.rule.code.to_owned(),
        message: shown.message,
    }
}

fn place(place: ide::DataPlace) -> DataLocation {
    let within = place.within.into_iter().map(|step| PathStep { name: step.name, key: step.key }).collect();
    DataLocation { name: place.name, key: place.key, within }
}

/// Pose of a value.
pub(super) fn pose(found: ide::DataPose) -> DataPose {
    let DataLocation { name, key, within } = place(found.place);
    DataPose {
        name,
        key: key.unwrap_or_default(),
        within,
        world: found.pose,
        chain: found.chain.join(" on "),
        reach: found.reach.map(|reach| match reach {
            val3_ide::PoseReach::Reachable => PoseReach::Reachable,
            val3_ide::PoseReach::OutOfReach => PoseReach::OutOfReach,
            val3_ide::PoseReach::NoArm => PoseReach::NoArm,
        }),
        why: found.remark,
        joints: found.joints,
    }
}
