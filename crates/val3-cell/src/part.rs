//! Parts, which grippers can carry.

use std::sync::Arc;

use val3_collision::Shape;
use val3_geometry::IsometryMatrix3;

use crate::carriers::Carrier;
use crate::solids::Solid;

/// A part.
#[derive(Debug, Clone)]
pub struct Part {
    /// Name in messages, with an index if there are copies: `carton[0]`.
    pub name: String,
    /// Carrier at the start: `world` or a frame.
    pub carrier: Carrier,
    /// Pose in this carrier of the frame that the key `in` names, for example of an object.
    pub origin: IsometryMatrix3<f64>,
    /// Pose of the part in this carrier.
    pub pose: IsometryMatrix3<f64>,
    /// Whether the part is outside of the cell at the start and arrives on a conveyor.
    pub is_outside: bool,
    /// Shapes, shared by all copies.
    pub solids: Arc<Vec<Solid>>,
    /// Overlap depth in mm up to which nothing is a contact.
    pub touch: f64,
    /// Distance in mm below which something is too near to this part.
    pub clearance: Option<f64>,
    /// Colour as `#rrggbb`.
    pub colour: Option<String>,
}

impl Part {
    /// Returns the shapes, smaller by [`Self::touch`] on each side, with their poses in the part's frame.
    pub(crate) fn cores(&self) -> Vec<(Shape, IsometryMatrix3<f64>)> {
        self.solids.iter().map(|solid| (solid.core(self.touch), solid.pose)).collect()
    }
}

/// Holder and pose of a part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartPlace {
    /// Holder.
    pub holder: PartHolder,
    /// Pose of the part in the holder's frame.
    pub pose: IsometryMatrix3<f64>,
}

/// Holder of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartHolder {
    /// `world`: the part is stationary.
    World,
    /// The frame with this index in [`crate::Scene::data`]: the part moves only with the frame.
    Frame(usize),
    /// The gripper with this index. The pose is relative to `flange`.
    Gripper(usize),
    /// No holder: the part was removed or has not arrived.
    Gone,
}
