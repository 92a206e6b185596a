//! Height of a released part above the bodies below it.

use val3_collision::Bounds;

use super::{Handling, HandlingView};
use crate::scene::BodyCarrier;

/// Height in mm above which a released part hangs in the air.
const HANGS: f64 = 50.0;

impl Handling {
    /// Returns the height in mm of a part that hangs in the air above the stationary bodies below it, computed with
    /// bounding boxes; `None` if nothing is below it, or if the part does not hang.
    pub(super) fn height_above(&self, part: usize, view: &HandlingView<'_>) -> Option<f64> {
        let bounds = self.bounds_of(view.scene.part_body(part), view)?;
        let others = (0..view.scene.bodies.len()).filter(|body| *body != view.scene.part_body(part));
        let others = others.filter(|body| self.is_stationary(*body, view));
        let others = others.filter_map(|body| self.bounds_of(body, view));
        let below = others.filter(|other| shares_plan(&bounds, other) && other.min.z < bounds.min.z);
        // The bounding box of a part encloses its core, which is smaller by `touch` on each side.
        let touch = view.scene.cell().parts.get(part)?.touch;
        let height = below.map(|other| bounds.min.z - touch - other.max.z).reduce(f64::min)?;
        (height > HANGS).then_some(height)
    }

    fn is_stationary(&self, body: usize, view: &HandlingView<'_>) -> bool {
        view.scene.bodies.get(body).is_some_and(|body| match body.carrier {
            BodyCarrier::World | BodyCarrier::Frame(_) => true,
            BodyCarrier::Part(part) => !self.is_held(part),
            BodyCarrier::Link(_) | BodyCarrier::Flange | BodyCarrier::Tool(_) => false,
        })
    }

    /// Returns the bounding box of a body; `None` if the body has no pose.
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
