//! Height of a released part above the bodies below it.

use val3_collision::Bounds;

use super::{Handling, HandlingView};
use crate::scene::BodyCarrier;

/// Height in mm above which a released part hangs in the air.
const HANGS: f64 = 50.0;

impl Handling {
    /// Height of a part in mm above all stationary bodies below it, computed with bounding boxes, if the part hangs in
    /// the air; `None` if nothing is below it.
    pub(super) fn height_above(&self, part: usize, view: &HandlingView<'_>) -> Option<f64> {
        let bounds = self.bounds_of(view.scene.part_body(part), view)?;
        let others = (0..view.scene.bodies.len()).filter(|body| *body != view.scene.part_body(part));
        let standing = others.filter(|body| self.stands(*body, view)).filter_map(|body| self.bounds_of(body, view));
        let below = standing.filter(|other| shares_plan(&bounds, other) && other.min.z < bounds.min.z);
        // The bounding box of a part encloses its core, which is smaller by `touch` on each side.
        let touch = view.scene.cell().parts.get(part)?.touch;
        let height = below.map(|other| bounds.min.z - touch - other.max.z).reduce(f64::min)?;
        (height > HANGS).then_some(height)
    }

    fn stands(&self, body: usize, view: &HandlingView<'_>) -> bool {
        let is_part = |part: usize| !self.is_held(part);
        view.scene.bodies.get(body).is_some_and(|body| match body.carrier {
            BodyCarrier::World | BodyCarrier::Frame(_) => true,
            BodyCarrier::Part(part) => is_part(part),
            BodyCarrier::Link(_) | BodyCarrier::Flange | BodyCarrier::Tool(_) => false,
        })
    }

    /// Bounding box of a body; `None` if it has no pose.
    pub(super) fn bounds_of(&self, body: usize, view: &HandlingView<'_>) -> Option<Bounds> {
        let body = view.scene.bodies.get(body)?;
        let pose = view.body(body.carrier, &self.parts)?;
        let boxes = body.shapes.iter().map(|(shape, own)| shape.bounds(&(pose * own)));
        boxes.reduce(|all, next| Bounds { min: all.min.inf(&next.min), max: all.max.sup(&next.max) })
    }
}

/// Whether two boxes overlap in the top view.
fn shares_plan(first: &Bounds, second: &Bounds) -> bool {
    let overlaps = |low: f64, high: f64, from: f64, to: f64| low < to && from < high;
    overlaps(first.min.x, first.max.x, second.min.x, second.max.x)
        && overlaps(first.min.y, first.max.y, second.min.y, second.max.y)
}
