//! Placement of labels: labels never overlap, and they avoid the path if there is space next to it.

use std::collections::BTreeSet;

/// Height of a label, and width of a letter, in pixels.
const HEIGHT: f64 = 13.0;
const LETTER: f64 = 6.6;

/// Directions and distances from the point, in the order in which they are tried.
const DIRECTIONS: [[f64; 2]; 8] =
    [[1.0, -0.6], [1.0, 0.9], [-1.0, -0.6], [-1.0, 0.9], [0.2, -1.3], [0.2, 1.6], [1.0, 0.1], [-1.0, 0.1]];
const DISTANCES: [f64; 7] = [9.0, 18.0, 30.0, 45.0, 65.0, 90.0, 120.0];

/// Number of distances at which a place off the path is preferred. At larger distances, a near place on the path is
/// better.
const NEAR: usize = 4;

/// A rectangle: left, top, right, bottom.
type Area = [f64; 4];

/// Maximum distance of a label from its point.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum LabelDistance {
    /// Next to the point.
    Near,
    /// Anywhere around the point, with a line to it.
    Far,
}

/// Labels within a panel.
pub(crate) struct Labels {
    panel: Area,
    taken: Vec<Area>,
    /// Cells of [`CELL`] pixels that the path crosses.
    path: BTreeSet<[i64; 2]>,
}

/// Size of a cell in pixels.
const CELL: f64 = 4.0;

/// Place of a label: the beginning of the base line, and the start of the leader line to the point.
pub(crate) struct LabelPosition {
    pub(crate) at: [f64; 2],
    pub(crate) anchor: Option<[f64; 2]>,
}

impl Labels {
    pub(crate) fn within(panel: Area) -> Self {
        Self { panel, taken: Vec::new(), path: BTreeSet::new() }
    }

    /// Reserves the area around a point.
    pub(crate) fn avoid(&mut self, [x, y]: [f64; 2]) {
        self.taken.push([x - 4.0, y - 4.0, x + 4.0, y + 4.0]);
    }

    /// Marks a line of the path, which labels avoid if there is space next to it.
    pub(crate) fn avoid_line(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        let steps = (libm::hypot(x2 - x1, y2 - y1) / CELL).ceil().max(1.0) as usize;
        let at = |step: usize| step as f64 / steps as f64;
        self.path.extend((0..=steps).map(|step| cell([x1 + (x2 - x1) * at(step), y1 + (y2 - y1) * at(step)])));
    }

    /// Returns a free place near a point for a text; `None` if no place is free.
    pub(crate) fn place(&mut self, point: [f64; 2], text: &str, reach: LabelDistance) -> Option<LabelPosition> {
        let width = LETTER * text.chars().count() as f64;
        let beside = candidates(point, width, NEAR).find(|(area, _)| self.is_free(area) && !self.is_on_path(area));
        let count = if reach == LabelDistance::Far { DISTANCES.len() } else { NEAR };
        let (area, place) = beside.or_else(|| candidates(point, width, count).find(|(area, _)| self.is_free(area)))?;
        self.taken.push(area);
        Some(place)
    }

    fn is_on_path(&self, [left, top, right, bottom]: &Area) -> bool {
        let ([first, low], [last, high]) = (cell([*left, *top]), cell([*right, *bottom]));
        (first..=last).any(|column| self.path.range([column, low]..=[column, high]).next().is_some())
    }

    fn is_free(&self, [left, top, right, bottom]: &Area) -> bool {
        let [panel_left, panel_top, panel_right, panel_bottom] = self.panel;
        let is_inside = *left > panel_left && *right < panel_right && *top > panel_top && *bottom < panel_bottom;
        let meets = |[l, t, r, b]: &Area| left < r && l < right && top < b && t < bottom;
        is_inside && !self.taken.iter().any(meets)
    }
}

fn cell(point: [f64; 2]) -> [i64; 2] {
    point.map(|coordinate| (coordinate / CELL).floor() as i64)
}

/// Returns the areas and places of a text at the first `count` distances from a point, the preferred one first.
fn candidates(point: [f64; 2], width: f64, count: usize) -> impl Iterator<Item = (Area, LabelPosition)> {
    let distances = DISTANCES.into_iter().take(count);
    distances.flat_map(move |distance| DIRECTIONS.map(|direction| candidate(point, direction, distance, width)))
}

/// Returns the area and the place of a text in a direction from a point.
fn candidate([x, y]: [f64; 2], [right, down]: [f64; 2], distance: f64, width: f64) -> (Area, LabelPosition) {
    let (near_x, near_y) = (x + right * distance, y + down * distance);
    let left = if right < 0.0 { near_x - width } else { near_x };
    let area = [left, near_y - HEIGHT / 2.0, left + width, near_y + HEIGHT / 2.0];
    let anchor = (distance > 20.0).then_some([near_x, near_y]);
    (area, LabelPosition { at: [left, near_y + 4.0], anchor })
}

#[cfg(test)]
mod tests {
    use super::{LabelDistance, Labels};

    #[test]
    fn labels_of_one_point_lie_apart() {
        let mut labels = Labels::within([0.0, 0.0, 200.0, 200.0]);
        let places: Vec<_> = (0..12)
            .filter_map(|_| labels.place([100.0, 100.0], "start:12", LabelDistance::Far))
            .map(|place| place.at)
            .collect();
        assert!(places.len() > 6);
        for (index, [x, y]) in places.iter().enumerate() {
            assert!(
                places[..index]
                    .iter()
                    .all(|[other_x, other_y]| (x - other_x).abs() > 50.0 || (y - other_y).abs() >= 12.9)
            );
        }
    }

    #[test]
    fn labels_lie_beside_the_path_where_there_is_room() {
        let mut labels = Labels::within([0.0, 0.0, 200.0, 200.0]);
        labels.avoid_line([100.0, 90.0], [200.0, 90.0]);
        let place = labels.place([100.0, 95.0], "start:12", LabelDistance::Far).unwrap();
        assert!(place.at[1] > 100.0, "{:?}", place.at);
    }

    #[test]
    fn a_label_that_must_be_near_has_no_place_in_a_crowd() {
        let mut labels = Labels::within([0.0, 0.0, 400.0, 400.0]);
        while labels.place([200.0, 200.0], "start:12", LabelDistance::Near).is_some() {}
        let place = labels.place([200.0, 200.0], "start:12", LabelDistance::Far).unwrap();
        assert!(place.anchor.is_some());
    }
}
