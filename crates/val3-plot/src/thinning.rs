//! Thinning: fewer points for lines that look the same (Ramer, Douglas and Peucker).

/// Distance in pixels below which a point's deviation is invisible.
const UNSEEN: f64 = 0.2;

/// Returns the points that have a visible effect.
pub(crate) fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let kept = significant(points.len(), |place, from, to| excess(points, place, from, to));
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

/// Returns the distance of a point to the line between two other points, divided by the invisible distance.
fn excess(points: &[[f64; 2]], place: usize, from: usize, to: usize) -> f64 {
    let [Some(point), Some(from), Some(to)] = [place, from, to].map(|index| points.get(index)) else { return 0.0 };
    distance(point, from, to) / UNSEEN
}

/// Returns for each point of a line whether it must be kept. `excess` is the distance of a point to the line between
/// two other points, divided by the maximum distance. The first and the last point are always kept.
#[must_use]
pub fn significant(count: usize, excess: impl Fn(usize, usize, usize) -> f64) -> Vec<bool> {
    let mut kept = vec![false; count];
    let Some(last) = count.checked_sub(1) else { return kept };
    keep(&mut kept, 0);
    keep(&mut kept, last);
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let distances = (from + 1..to).map(|place| (place, excess(place, from, to)));
        let farthest = distances.max_by(|(_, left), (_, right)| left.total_cmp(right));
        if let Some((farthest, _)) = farthest.filter(|(_, excess)| *excess > 1.0) {
            keep(&mut kept, farthest);
            open.extend([(from, farthest), (farthest, to)]);
        }
    }
    kept
}

fn keep(kept: &mut [bool], place: usize) {
    if let Some(kept) = kept.get_mut(place) {
        *kept = true;
    }
}

/// Returns the distance of a point to the line segment between two other points.
fn distance([x, y]: &[f64; 2], [x1, y1]: &[f64; 2], [x2, y2]: &[f64; 2]) -> f64 {
    let (along_x, along_y) = (x2 - x1, y2 - y1);
    let square = along_x * along_x + along_y * along_y;
    let share = if square > 0.0 { (((x - x1) * along_x + (y - y1) * along_y) / square).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(x - x1 - share * along_x, y - y1 - share * along_y)
}

#[cfg(test)]
mod tests {
    use super::thinned;

    #[test]
    fn corners_stay() {
        let points: Vec<_> = (0..=100_i32).map(|x| [f64::from(x), f64::from((x - 50).abs())]).collect();
        assert_eq!(thinned(&points), [[0.0, 50.0], [50.0, 0.0], [100.0, 50.0]]);
        assert_eq!(thinned(&[]), [[0.0; 2]; 0]);
        assert_eq!(thinned(&[[1.0, 2.0]]), [[1.0, 2.0]]);
    }
}
