//! Values of the entries about parts: names and poses.

use serde::{Deserialize, Serialize};
use val3_geometry::{IsometryMatrix3, Trsf};

/// A name or a list of names.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(untagged, expecting = "write a name in quotes, or a list of names")]
pub(crate) enum Names {
    One(String),
    Several(Vec<String>),
}

impl Default for Names {
    fn default() -> Self {
        Self::Several(Vec::new())
    }
}

impl Names {
    pub(crate) fn all(&self) -> &[String] {
        match self {
            Self::One(name) => std::slice::from_ref(name),
            Self::Several(names) => names,
        }
    }
}

/// The pose of a part.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(
    untagged,
    expecting = "write a pose [x, y, z] or [x, y, z, rx, ry, rz], or { in = \"fPallet\", at = [x, y, z] }"
)]
pub(super) enum PartPose {
    /// In the frame of the part in the cell's file.
    Own(PoseNumbers),
    /// In another frame.
    In(FramedPose),
}

/// A pose in a frame.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FramedPose {
    #[serde(rename = "in")]
    pub(super) frame: String,
    pub(super) at: PoseNumbers,
}

/// Three or six numbers: mm, and degrees as in a trsf.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "Vec<f64>")]
pub struct PoseNumbers(Vec<f64>);

impl TryFrom<Vec<f64>> for PoseNumbers {
    type Error = String;

    fn try_from(numbers: Vec<f64>) -> Result<Self, String> {
        match numbers.len() {
            3 | 6 if numbers.iter().all(|number| number.abs() <= 1e6) => Ok(Self(numbers)),
            3 | 6 => Err("a number of this pose is too large".to_owned()),
            count => Err(format!("a pose has 3 or 6 numbers, and this has {count}")),
        }
    }
}

impl PoseNumbers {
    /// The pose.
    #[must_use]
    pub fn pose(&self) -> IsometryMatrix3<f64> {
        let number = |index: usize| self.0.get(index).copied().unwrap_or_default();
        Trsf::new([0, 1, 2].map(number), [3, 4, 5].map(number)).isometry()
    }

    /// Whether the pose has an orientation.
    #[must_use]
    pub fn has_orientation(&self) -> bool {
        self.0.len() > 3
    }
}
