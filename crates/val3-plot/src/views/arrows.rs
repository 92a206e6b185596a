//! Arrows along the path. Further cycles on a path add arrows only where the first one has left a gap.

use super::names::SAME;

/// Distance of arrows along the path in pixels.
pub(super) const SPACING: f64 = 110.0;

/// An arrow of a later cycle is omitted if an earlier arrow is nearer than this share of [`SPACING`] on the same line,
/// and the cosine of the angle between both is larger than [`SAME_DIRECTION`].
const SAME_PIECE: f64 = 0.75;
const SAME_DIRECTION: f64 = 0.9;

/// Arrows of a view.
#[derive(Default)]
pub(super) struct Arrows(Vec<Arrow>);

impl Arrows {
    /// Adds an arrow with a direction of length 1. Returns `false` if the same piece of the path already has an arrow.
    pub(super) fn add(&mut self, at: [f64; 2], direction: [f64; 2]) -> bool {
        let arrow = Arrow { at, direction };
        let is_new = !self.0.iter().any(|earlier| earlier.covers(&arrow));
        if is_new {
            self.0.push(arrow);
        }
        is_new
    }
}

/// An arrow: its position in pixels, and its direction of length 1.
struct Arrow {
    at: [f64; 2],
    direction: [f64; 2],
}

impl Arrow {
    /// Whether another arrow would be on the same piece of the path, in the same direction.
    fn covers(&self, later: &Self) -> bool {
        let ([x, y], [along_x, along_y]) = (self.at, self.direction);
        let ([later_x, later_y], [later_along_x, later_along_y]) = (later.at, later.direction);
        let (way_x, way_y) = (later_x - x, later_y - y);
        let (along, across) = (way_x * along_x + way_y * along_y, way_x * along_y - way_y * along_x);
        let turn = along_x * later_along_x + along_y * later_along_y;
        turn > SAME_DIRECTION && along.abs() < SPACING * SAME_PIECE && across.abs() < SAME
    }
}
