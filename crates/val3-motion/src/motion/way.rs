//! Remaining path of the tool centre point, for display.

use val3_geometry::Vector3;

use super::{Departure, Motion, MotionPhase};
use crate::model::Model;

/// Number of parts, equal in p, into which a piece is divided.
const PARTS: u32 = 16;

/// Piece of the remaining path.
#[derive(Clone, Debug, PartialEq)]
pub struct PieceAhead {
    /// Motion phase: [`MotionPhase::Nominal`], [`MotionPhase::Blend`] or [`MotionPhase::Connection`].
    pub phase: MotionPhase,
    /// Positions of the tool centre point in `world`, in mm. The last position is also the first position of the next
    /// piece.
    pub points: Vec<Vector3<f64>>,
}

impl PieceAhead {
    fn between([from, to]: [f64; 2], phase: MotionPhase, point: impl Fn(f64) -> Vector3<f64>) -> Self {
        let at = |part| from + (to - from) * f64::from(part) / f64::from(PARTS);
        Self { phase, points: (0..=PARTS).map(|part| point(at(part))).collect() }
    }
}

impl Motion {
    /// Returns the path of the tool centre point from the current position to the last destination, at most `count`
    /// pieces.
    ///
    /// Deferred moves are not included.
    #[must_use]
    pub fn way_ahead(&self, count: usize) -> Vec<PieceAhead> {
        let back = match &self.departure {
            Some(Departure::Connecting(motion)) => motion.pieces_of_timeline(MotionPhase::Connection).collect(),
            _ => Vec::new(),
        };
        let model = Model(&self.arm);
        let open = self.path.open_end().filter(|_| self.fault.is_none() && self.deferred.is_none());
        let open = open.map(|(segment, leave)| {
            PieceAhead::between([leave, 1.0], MotionPhase::Nominal, |sigma| {
                segment.pose_at(&model, sigma).translation.vector
            })
        });
        let on_path = self.pieces_of_timeline(MotionPhase::Nominal).filter(|_| !self.is_empty());
        back.into_iter().chain(on_path).chain(open).take(count).collect()
    }

    fn pieces_of_timeline(&self, nominal: MotionPhase) -> impl Iterator<Item = PieceAhead> {
        let present = self.timeline.p().unwrap_or_default();
        self.timeline.spans.iter().enumerate().filter(|(_, timed)| !timed.is_forgotten).map(move |(index, timed)| {
            let [from, to] = timed.span.range();
            let from = if index == 0 { present } else { from };
            let phase = if timed.span.is_blend() { MotionPhase::Blend } else { nominal };
            PieceAhead::between([from, to], phase, |p| timed.span.tip(&Model(&self.arm), p))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{CYCLE, START, fast, line, motion, moved, request};
    use super::*;
    use crate::{Blend, Millimetres, MovePath};

    fn distance(way: &[PieceAhead], point: &Vector3<f64>) -> f64 {
        let chords = way.iter().flat_map(|piece| piece.points.windows(2));
        chords.map(|chord| distance_to_chord(chord, point)).fold(f64::INFINITY, f64::min)
    }

    fn distance_to_chord(chord: &[Vector3<f64>], point: &Vector3<f64>) -> f64 {
        let along = chord[1] - chord[0];
        let share = (point - chord[0]).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE);
        (point - chord[0] - along * share.clamp(0.0, 1.0)).norm()
    }

    #[test]
    fn the_arm_moves_along_the_way() {
        let mut motion = motion();
        let rounded = Blend::Cartesian { leave: Millimetres(50.0), reach: Millimetres(30.0) };
        let turned = MovePath::Joint([40.0, 10.0, 80.0, 0.0, 90.0, 0.0]);
        let open = Blend::Joint { leave: Millimetres(40.0), reach: Millimetres(40.0) };
        let paths = [line(moved(0.0, 200.0, 0.0)), line(moved(0.0, 200.0, 150.0)), turned];
        for ((path, blend), id) in paths.into_iter().zip([rounded, rounded, open]).zip(0..) {
            motion.record(&request(path, fast(), blend, f64::from(id))).unwrap();
        }
        let way = motion.way_ahead(100);
        let mut phases: Vec<_> = way.iter().map(|piece| piece.phase.word()).collect();
        phases.dedup();
        assert_eq!(phases, ["nominal", "blend", "nominal", "blend", "nominal"]);
        assert!(way.windows(2).all(|pair| (pair[0].points[16] - pair[1].points[0]).norm() < 1e-6));
        let target = motion.moves().last().unwrap().target.translation.vector;
        assert!((way.last().unwrap().points[16] - target).norm() < 1e-6);
        motion.close().unwrap();
        while !motion.is_empty() {
            let away = distance(&way, &motion.advance(CYCLE).pose.translation.vector);
            assert!(away < 0.5, "{away} mm");
        }
        assert_eq!(motion.way_ahead(2), []);
    }

    #[test]
    fn the_way_back_to_the_path_comes_first() {
        let mut motion = motion();
        motion.record(&request(line(moved(0.0, 200.0, 0.0)), fast(), Blend::Off, 0.0)).unwrap();
        motion.stop();
        motion.displace([10.0, 0.0, 90.0, 0.0, 90.0, 0.0]);
        motion.connect().unwrap();
        let way = motion.way_ahead(10);
        assert_eq!(way.iter().map(|piece| piece.phase.word()).collect::<Vec<_>>(), ["connection", "nominal"]);
        let start = Model(&motion.arm).flange(&START.into()).translation.vector;
        assert!((way[0].points[16] - start).norm() < 1e-6 && way[0].points[0] != start);
    }
}
