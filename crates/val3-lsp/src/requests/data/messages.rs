//! Messages of the data editor.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::{Range, Url, WorkspaceEdit};

use crate::schema::protocol;

/// Data file of a request.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct DataParams {
    /// URI of the `.dtx`.
    #[schemars(with = "String")]
    pub(super) uri: Url,
    /// Earlier result that the client has; only the changes since then are sent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) previous_result_id: Option<String>,
    /// Whether the client keeps its findings, so that the response does not wait for a check.
    #[serde(default)]
    pub(super) without_findings: bool,
}

/// Tables, or their changes since an earlier result.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub(crate) enum DataResult {
    Tables(DataTables),
    Changes(DataChanges),
}

/// Difference between two results.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct DataChanges {
    pub(super) result_id: String,
    pub(super) version: Option<i32>,
    pub(super) problem: Option<String>,
    pub(super) data: Replacement<Datum>,
    /// `null` if the data contain all their values. Otherwise the only new datum contains some of its values, which
    /// replace these values of the earlier datum.
    pub(super) values: Option<ReplacedValues>,
    /// Line offset for the data after the replaced items.
    pub(super) line_shift: i64,
    /// `null` if the findings of the earlier result are unchanged.
    pub(super) findings: Option<Replacement<DataFinding>>,
}

/// New items that replace a range of a list.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
#[schemars(rename = "Replaced{T}")]
pub(super) struct Replacement<T> {
    pub(super) start: usize,
    pub(super) delete_count: usize,
    pub(super) items: Vec<T>,
}

/// Range of the earlier datum's values that is replaced.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) struct ReplacedValues {
    pub(super) start: usize,
    pub(super) delete_count: usize,
}

/// A data file as tables.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct DataTables {
    pub(super) result_id: String,
    /// Version of the open document on which the tables are based.
    pub(super) version: Option<i32>,
    pub(super) dialect: Dialect,
    /// Reason why the file cannot be edited as tables.
    pub(super) problem: Option<String>,
    pub(super) types: Vec<DataType>,
    pub(super) data: Vec<Datum>,
    pub(super) findings: Vec<DataFinding>,
}

/// Dialect of a data file: `old` is that of s5 and s6.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) enum Dialect {
    Old,
    New,
}

/// Type of data, with its columns or fields.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(super) struct DataType {
    pub(super) name: String,
    pub(super) columns: Vec<Column>,
    /// Fields of a user type, which has no columns.
    pub(super) fields: Vec<FieldType>,
    /// Containers in which the type can be declared.
    pub(super) containers: Vec<Container>,
}

/// Field of a user type.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(super) struct FieldType {
    pub(super) name: String,
    #[serde(rename = "type")]
    pub(super) type_name: String,
    pub(super) container: Container,
    pub(super) size: Vec<u32>,
}

/// Container of data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) enum Container {
    Array,
    Collection,
}

/// Column of a table.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(super) struct Column {
    pub(super) id: String,
    pub(super) title: String,
    pub(super) unit: Option<String>,
    pub(super) kind: ColumnKind,
    /// Strings that fit the project.
    pub(super) choices: Vec<String>,
    /// Meaning of `null`.
    pub(super) default: String,
}

/// Kind of a column's cells.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) enum ColumnKind {
    Number,
    Text,
    Bool,
    Choice,
    Father,
    Link,
}

/// Access to data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) enum Access {
    Public,
    Private,
}

/// A variable.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(super) struct Datum {
    pub(super) name: String,
    pub(super) access: Access,
    #[serde(rename = "type")]
    pub(super) type_name: String,
    pub(super) container: Container,
    /// Array size, by dimension; for a collection the number of keys.
    pub(super) size: Vec<u32>,
    /// Range of the name in the file.
    #[schemars(with = "protocol::RangeSchema")]
    pub(super) range: Range,
    /// Values that the file contains; complete for a collection.
    pub(super) values: Vec<TableElement>,
}

/// Field of a value of a user type.
#[derive(Debug, Hash, Serialize, Deserialize, JsonSchema)]
pub(super) struct FieldContent {
    pub(super) name: String,
    #[serde(rename = "type")]
    pub(super) type_name: String,
    pub(super) container: Container,
    /// Array size, by dimension; for a collection the number of keys.
    pub(super) size: Vec<u32>,
    /// Values that the file contains; complete for a collection.
    pub(super) values: Vec<TableElement>,
}

/// Element of a variable, with one string per column.
#[derive(Debug, Hash, Serialize, Deserialize, JsonSchema)]
pub(super) struct TableElement {
    pub(super) key: String,
    /// Strings by column; `null` for the default.
    pub(super) texts: Vec<Option<String>>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) fields: Vec<FieldContent>,
}

/// A variable, an element, or a value within the fields of an element.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
pub(super) struct DataLocation {
    pub(super) name: String,
    /// Element index or key; missing for the container.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub(super) key: Option<String>,
    /// Path to a value within the fields of a user type.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) within: Vec<PathStep>,
}

/// Field on the path to a value.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
pub(super) struct PathStep {
    pub(super) name: String,
    /// Index or key in the field; empty or missing for the field itself.
    #[serde(default)]
    #[schemars(skip_serializing_if = "String::is_empty")]
    pub(super) key: String,
}

/// Finding in a table cell.
#[derive(Debug, Hash, Serialize, Deserialize, JsonSchema)]
pub(super) struct DataFinding {
    pub(super) place: DataLocation,
    pub(super) column: Option<String>,
    pub(super) severity: DataSeverity,
    pub(super) code: String,
    pub(super) message: String,
}

/// Severity of a finding.
#[derive(Debug, Clone, Copy, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) enum DataSeverity {
    Error,
    Warning,
    Information,
    Hint,
}

/// Edits of a data file.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct EditDataParams {
    /// URI of the `.dtx`.
    #[schemars(with = "String")]
    pub(super) uri: Url,
    /// Document version that the client shows; `null` for a file that is not open.
    pub(super) version: Option<i32>,
    /// Edits in order; each edit applies to the result of the previous ones.
    pub(super) edits: Vec<DataEdit>,
    /// Whether to return the findings that the edits would add.
    #[serde(default)]
    pub(super) check: bool,
}

/// Edit of the tables.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "camelCase")]
pub(super) enum DataEdit {
    Set {
        cells: Vec<CellChange>,
    },
    Add {
        name: String,
        #[serde(rename = "type")]
        type_name: String,
        access: Access,
        container: Container,
        #[serde(default)]
        size: Vec<u32>,
        after: Option<String>,
    },
    Duplicate {
        name: String,
        #[serde(rename = "as")]
        new_name: String,
    },
    Delete {
        names: Vec<String>,
    },
    Access {
        names: Vec<String>,
        access: Access,
    },
    Resize {
        place: DataLocation,
        size: Vec<u32>,
    },
    AddKey {
        place: DataLocation,
        key: String,
    },
    RemoveKey {
        place: DataLocation,
        keys: Vec<String>,
    },
    RenameKey {
        place: DataLocation,
        key: String,
        #[serde(rename = "as")]
        new_key: String,
    },
}

/// New string of a cell.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(super) struct CellChange {
    pub(super) place: DataLocation,
    pub(super) column: String,
    /// `null` for the default.
    pub(super) text: Option<String>,
}

/// Text edit of the file, or the reason why there is none.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
pub(crate) struct EditDataResult {
    /// `null` if the edit is rejected or has no effect.
    #[schemars(with = "Option<protocol::WorkspaceEditSchema>")]
    pub(super) edit: Option<WorkspaceEdit>,
    /// Reason as a sentence for users.
    pub(super) refused: Option<String>,
    /// Findings that the edit adds to the file.
    pub(super) findings: Vec<DataFinding>,
}

/// Points, frames and tools whose poses are requested.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct DataPosesParams {
    /// URI of the `.dtx`.
    #[schemars(with = "String")]
    pub(super) uri: Url,
    pub(super) names: Vec<String>,
}

/// Pose of a value.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct DataPose {
    pub(super) name: String,
    pub(super) key: String,
    /// Path to a value within the fields of a user type.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) within: Vec<PathStep>,
    /// x, y, z in mm and rx, ry, rz in degrees, relative to `world` (tools: to the flange); `null` if unknown.
    pub(super) world: Option<[f64; 6]>,
    /// The value and its fathers, joined by ` on `; empty for joints.
    pub(super) chain: String,
    pub(super) reach: Option<PoseReach>,
    /// Reason why the pose is unknown or out of reach, or the tool with which it is reached.
    pub(super) why: Option<String>,
    /// Joint position in which the arm reaches the pose.
    pub(super) joints: Option<Vec<f64>>,
}

/// Whether the arm reaches a pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(super) enum PoseReach {
    Reachable,
    OutOfReach,
    /// No file names the arm.
    NoArm,
}
