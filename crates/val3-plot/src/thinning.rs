//! Fewer points for lines that look the same (Ramer, Douglas and Peucker).

/// Points nearer than this to the line do not count, in pixels.
const UNSEEN: f64 = 0.2;

/// The points that can be seen.
pub(crate) fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut kept = vec![false; points.len()];
    if let (Some(first), Some(last)) = (0.into(), points.len().checked_sub(1)) {
        let mut open = vec![(first, last)];
        for end in [first, last] {
            keep(&mut kept, end);
        }
        while let Some((from, to)) = open.pop() {
            if let Some(farthest) = farthest(points, from, to) {
                keep(&mut kept, farthest);
                open.extend([(from, farthest), (farthest, to)]);
            }
        }
    }
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

fn keep(kept: &mut [bool], index: usize) {
    if let Some(kept) = kept.get_mut(index) {
        *kept = true;
    }
}

/// The point between two others that is farthest from their line, if it can be seen.
fn farthest(points: &[[f64; 2]], from: usize, to: usize) -> Option<usize> {
    let (start, end) = (points.get(from)?, points.get(to)?);
    let between = points.get(from + 1..to)?.iter().enumerate();
    let distances = between.map(|(index, point)| (from + 1 + index, distance(point, start, end)));
    let found = distances.max_by(|(_, left), (_, right)| left.total_cmp(right));
    found.filter(|(_, distance)| *distance > UNSEEN).map(|(index, _)| index)
}

/// The distance of a point to the piece of line between two others.
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
