//! Differences of global data.

use serde::Serialize;

use super::change::{Change, ValuePair};
use super::class::ReportClass;

/// Global data that differ.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DataChange {
    /// Data name.
    pub name: String,
    /// Name in the old tree, if it differs.
    pub renamed_from: Option<String>,
    /// Change of the data.
    pub change: Change,
    /// Part of the report.
    pub class: ReportClass,
    /// Type in the new tree; in the old tree if the data were removed.
    #[serde(rename = "type")]
    pub type_name: String,
    /// Declaration without the access, for example `num nA[3]`, in the new tree; in the old tree if the data were
    /// removed.
    pub declaration: String,
    /// Value of added or removed data with one element; `None` for the default value.
    pub value: Option<String>,
    /// Access `public` or `private`, if it differs.
    pub access: Option<ValuePair<String>>,
    /// Types, if they differ.
    pub types: Option<ValuePair<String>>,
    /// Sizes, if they differ, for example `3`, `3 x 4` or `collection`.
    pub sizes: Option<ValuePair<String>>,
    /// Whether the data are public in each tree.
    #[serde(skip)]
    pub public: ValuePair<bool>,
    /// Elements whose index differs because of removed or inserted elements.
    pub renumbering: Option<Renumbering>,
    /// Values that differ; for added or removed data with several elements, the values in the file.
    pub values: Vec<ValueChange>,
}

impl DataChange {
    /// Whether data in both trees have no difference.
    pub(crate) fn is_same(&self) -> bool {
        self.change == Change::Changed
            && self.renamed_from.is_none()
            && self.access.is_none()
            && self.types.is_none()
            && self.sizes.is_none()
            && self.renumbering.is_none()
            && self.values.is_empty()
    }
}

/// Array elements whose index differs in the new tree, with the same or changed content.
///
/// Removed elements are among the values with their old index, inserted and changed elements with their new index.
/// Programs address elements by index, so every program that uses such an index uses another element.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Renumbering {
    /// Runs of elements that moved by the same number of indexes, in order.
    pub runs: Vec<MovedElements>,
    /// Number of indexes whose element differs for a program.
    pub differing_indexes: usize,
    /// Maximum distance in `world` between the old and the new position at an index, in mm; `None` if the elements are
    /// no points or their fathers do not end at `world`.
    pub greatest_distance_mm: Option<f64>,
}

/// Consecutive elements that moved by the same number of indexes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct MovedElements {
    /// Old index of the first element.
    pub old: usize,
    /// New index of the first element.
    pub new: usize,
    /// Number of elements.
    pub count: usize,
}

/// A value that differs: an element of data, or a field of a user type.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ValueChange {
    /// Data path as in programs, for example `pPick[3]` or `tSlot["a"].pPick`.
    pub path: String,
    /// Change of the value. A larger size or a new key adds elements.
    pub change: Change,
    /// Part of the report.
    pub class: ReportClass,
    /// Type of the value.
    #[serde(rename = "type")]
    pub type_name: String,
    /// Entire value of the added or removed element.
    pub value: Option<String>,
    /// Fields that differ. The value itself is a field without a name.
    pub fields: Vec<FieldChange>,
    /// Movement of a position.
    pub movement: Option<Movement>,
    /// Maximum change of linear and of rotary axes of a joint position. A full turn is a change.
    pub axes: Option<Displacement>,
    /// Positions that moved because they depend on this frame or tool. Each position is listed at its nearest changed
    /// father.
    pub dependents: Vec<Dependent>,
}

/// A field that differs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FieldChange {
    /// Field as in programs (`trsf.x`, `config.shoulder`, `tvel`), or `father`; empty for the value itself.
    pub field: String,
    /// Old value; `None` if the file omits it and the type determines it.
    pub old: Option<String>,
    /// New value; `None` if the file omits it and the type determines it.
    pub new: Option<String>,
}

impl FieldChange {
    /// Whether the field is a number of a transformation or joint position.
    pub(crate) fn is_of_pose(&self) -> bool {
        const NUMBERS: [&str; 12] = ["x", "y", "z", "rx", "ry", "rz", "j1", "j2", "j3", "j4", "j5", "j6"];
        NUMBERS.contains(&self.field.as_str())
    }
}

/// Movement of a position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Movement {
    /// Displacement in the father; `None` if the father differs.
    pub in_father: Option<Displacement>,
    /// Translation and rotation along the axes of the father; `None` if the father differs.
    pub shift: Option<Shift>,
    /// Displacement in `world`, for a tool on the flange; `None` if the chain of fathers does not end there, and for a
    /// transformation.
    pub in_world: Option<Displacement>,
}

/// A translation and a rotation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Shift {
    /// Translation along x, y and z in mm.
    pub translation_mm: [f64; 3],
    /// Rotation vector: its direction is the axis, its length the angle in degrees.
    pub rotation_deg: [f64; 3],
}

/// A distance and an angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Displacement {
    /// Distance between the origins in mm.
    pub distance_mm: f64,
    /// Angle between the orientations in degrees, at most 180.
    pub angle_deg: f64,
}

/// A position that moved because its frame or tool moved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Dependent {
    /// Data path as in programs.
    pub path: String,
    /// Type of the position.
    #[serde(rename = "type")]
    pub type_name: String,
    /// Displacement in `world`, for a tool on the flange; `None` if the chain of fathers does not end there.
    pub in_world: Option<Displacement>,
}
