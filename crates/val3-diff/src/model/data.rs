//! Differences of global data.

use serde::Serialize;

use super::change::{Change, Pair};
use super::class::Class;

/// Global data that differ.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DataChange {
    /// The name.
    pub name: String,
    /// The name in the old tree, if it was another one.
    pub renamed_from: Option<String>,
    /// What happened to it.
    pub change: Change,
    /// The part of the report that it belongs to.
    pub class: Class,
    /// The type, in the new tree if it is there.
    #[serde(rename = "type")]
    pub type_name: String,
    /// The declaration without the access: `num nA[3]`, in the new tree if it is there.
    pub declaration: String,
    /// The value of added or removed data with one element; `None` if it is the default.
    pub value: Option<String>,
    /// `public` or `private`, if it differs.
    pub access: Option<Pair<String>>,
    /// The types, if they differ.
    pub types: Option<Pair<String>>,
    /// The sizes, if they differ: `3`, `3 x 4`, `collection`.
    pub sizes: Option<Pair<String>>,
    /// The data are public in the old tree, in the new tree.
    #[serde(skip)]
    pub public: Pair<bool>,
    /// Elements that have another index because of removed or inserted elements.
    pub renumbering: Option<Renumbering>,
    /// The values that differ. Of added or removed data with several elements, those that the file writes.
    pub values: Vec<ValueChange>,
}

impl DataChange {
    /// Whether nothing of data of both trees differs.
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

/// Elements of an array that have another index in the new tree, with the same content or a changed one.
///
/// The removed elements are among the values under their old index, inserted and changed ones under their new index.
/// Programs address elements by index, so each program that uses such an index uses another element.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Renumbering {
    /// Runs of elements that moved by the same number of indexes, in order.
    pub runs: Vec<Run>,
    /// Number of indexes whose element differs, as programs see the array.
    pub differing_indexes: usize,
    /// Greatest distance in `world` between the old and the new position of one index, in millimetres; `None` if the elements are no
    /// points or their fathers do not lead to `world`.
    pub greatest_distance_mm: Option<f64>,
}

/// Elements that moved by the same number of indexes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Run {
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
    /// The place as programs write it: `pPick[3]`, `tSlot["a"].pPick`.
    pub path: String,
    /// What happened to it. An element is added by another size or a new key.
    pub change: Change,
    /// The part of the report that it belongs to.
    pub class: Class,
    /// The type.
    #[serde(rename = "type")]
    pub type_name: String,
    /// The whole value of an added or removed element.
    pub value: Option<String>,
    /// The fields that differ. The field without a name is the value itself.
    pub fields: Vec<FieldChange>,
    /// How far a position has moved.
    pub movement: Option<Movement>,
    /// Greatest change of a linear and of a rotary axis of a joint position. A full turn of an axis is a change.
    pub axes: Option<Displacement>,
    /// Positions that this frame or tool has moved, because they depend on it. Each is listed at the nearest changed father.
    pub dependents: Vec<Dependent>,
}

/// A field that differs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FieldChange {
    /// The field as programs write it (`trsf.x`, `config.shoulder`, `tvel`), `father`, or nothing for the value itself.
    pub field: String,
    /// The old value; `None` if the file does not write it and the type decides.
    pub old: Option<String>,
    /// The new value; `None` if the file does not write it and the type decides.
    pub new: Option<String>,
}

impl FieldChange {
    /// Whether the field is a number of a transformation or of a joint position.
    pub(crate) fn is_of_pose(&self) -> bool {
        const NUMBERS: [&str; 12] = ["x", "y", "z", "rx", "ry", "rz", "j1", "j2", "j3", "j4", "j5", "j6"];
        NUMBERS.contains(&self.field.as_str())
    }
}

/// How far a position has moved.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Movement {
    /// In the father; `None` if the father is another one.
    pub in_father: Option<Displacement>,
    /// Translation and rotation along the axes of the father; `None` if the father is another one.
    pub shift: Option<Shift>,
    /// In `world`, for a tool on the flange; `None` if the fathers do not lead there, and for a transformation.
    pub in_world: Option<Displacement>,
}

/// A translation and a rotation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Shift {
    /// Millimetres along x, y and z.
    pub translation_mm: [f64; 3],
    /// Rotation vector: its direction is the axis, its length the angle in degrees.
    pub rotation_deg: [f64; 3],
}

/// A distance and an angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Displacement {
    /// Millimetres between the origins.
    pub distance_mm: f64,
    /// Degrees between the orientations, at most 180.
    pub angle_deg: f64,
}

/// A position that moved because a frame or tool moved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Dependent {
    /// The place as programs write it.
    pub path: String,
    /// The type.
    #[serde(rename = "type")]
    pub type_name: String,
    /// The movement in `world`, for a tool on the flange; `None` if the fathers do not lead there.
    pub in_world: Option<Displacement>,
}
