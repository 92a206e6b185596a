//! Step mode: after each path piece, the arm waits for a release (manual 10.2.2).

use val3_geometry::IsometryMatrix3;
use val3_kinematics::Joints;

use super::Motion;
use crate::model::Model;
use crate::span::{SAME, SpanPart};
use crate::timeline::TimedSpan;

/// Transition mode from one path piece to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MotionMode {
    /// The arm does not stop before the end of the determined path.
    #[default]
    Continuous,
    /// After each piece, the arm comes to rest and waits for a release. The path is the same as in continuous mode.
    Step,
}

/// Path piece: the nominal part of a move, or the blend around a destination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPiece {
    /// Serial number of the move; in a blend, of the move before the corner.
    pub serial: u64,
    /// Id of this move.
    pub id: f64,
    /// Part of the move.
    pub kind: PieceKind,
    /// Kind of point at which the piece ends.
    pub end: PieceEnd,
    /// Commanded joint position at the end, in degrees (linear axes: mm), without a deviation by `alter`.
    pub joints: Joints,
    /// Tool centre point at the end, in `world`; lengths in mm.
    pub pose: IsometryMatrix3<f64>,
}

/// Part of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PieceKind {
    /// The move's own path, from the reach point or the destination of the previous move.
    Nominal,
    /// Blend around the destination, from the leave point to the reach point.
    Blend,
}

impl PieceKind {
    /// Name in messages and protocols.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Nominal => "nominal",
            Self::Blend => "blend",
        }
    }
}

/// Kind of point at which a piece ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PieceEnd {
    /// Leave point, where the blend begins.
    Leave,
    /// Reach point, on the path of the next move.
    Reach,
    /// Destination of the move.
    Target,
    /// Last reachable point before a fault of the path.
    Fault,
}

impl PieceEnd {
    /// Name in messages and protocols.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Leave => "leave",
            Self::Reach => "reach",
            Self::Target => "target",
            Self::Fault => "fault",
        }
    }
}

/// Step mode.
impl Motion {
    /// Current motion mode.
    #[must_use]
    pub const fn mode(&self) -> MotionMode {
        self.mode
    }

    /// Sets the mode, also while the arm moves.
    ///
    /// In step mode, the arm then finishes the current piece, or the next piece if it cannot stop at the end of the
    /// current piece. In continuous mode, all pending pieces are released.
    pub fn set_mode(&mut self, mode: MotionMode) {
        if std::mem::replace(&mut self.mode, mode) != mode {
            match mode {
                MotionMode::Continuous => self.timeline.open_gates(),
                MotionMode::Step => self.timeline.close_gates(),
            }
        }
    }

    /// Releases an arm that waits in step mode to the end of the next piece. Returns whether the arm has waited.
    ///
    /// Has no effect while the arm moves to the end of a piece, or if no further piece is determined.
    pub fn release_piece(&mut self) -> bool {
        self.timeline.open_gate()
    }

    /// Releases the arm to the present end of the determined path.
    pub fn release_determined(&mut self) {
        self.timeline.open_gates();
    }

    /// Whether the arm waits in step mode before a determined piece.
    #[must_use]
    pub fn waits_for_release(&self) -> bool {
        self.timeline.waits_at_gate()
    }

    /// Whether the arm has reached the end of the released pieces or of the determined path.
    #[must_use]
    pub fn has_arrived(&self) -> bool {
        !self.is_moving() && (self.timeline.is_at_end() || self.waits_for_release())
    }

    /// Counter that increases when a move is recorded or more of the path is determined.
    #[must_use]
    pub const fn revision(&self) -> u64 {
        self.revision
    }

    /// Current piece, or the piece at whose end the arm waits; `None` if the arm has begun no piece since the last
    /// reset or displacement.
    #[must_use]
    pub fn piece(&self) -> Option<PathPiece> {
        (self.timeline.next_piece() != Some(0)).then(|| self.piece_from(0)).flatten()
    }

    /// Serial number of the current move.
    #[must_use]
    pub fn current(&self) -> Option<u64> {
        let front = self.timeline.spans.front().filter(|front| !front.is_forgotten)?;
        Some(match front.span.part {
            SpanPart::Nominal { serial, .. } => serial,
            SpanPart::Blend { from, .. } => from.serial,
        })
    }

    /// Next piece; `None` if it is not determined yet.
    #[must_use]
    pub fn next_piece(&self) -> Option<PathPiece> {
        self.piece_from(self.timeline.next_piece()?)
    }

    /// Determined pieces, from the current piece on.
    pub fn pieces(&self) -> impl Iterator<Item = PathPiece> {
        let mut index = 0;
        std::iter::from_fn(move || {
            let piece = self.piece_from(index)?;
            index += self.timeline.piece(index).count();
            Some(piece)
        })
    }

    fn piece_from(&self, index: usize) -> Option<PathPiece> {
        let last = self.timeline.piece(index).last().filter(|last| !last.is_forgotten)?;
        let p = last.points.last()?.p;
        let after = self.timeline.spans.get(index + self.timeline.piece(index).count());
        let (serial, id, kind, end) = match last.span.part {
            SpanPart::Nominal { serial, id } => {
                (serial, id, PieceKind::Nominal, self.end_of_nominal(serial, last, after))
            }
            SpanPart::Blend { from, .. } => {
                let end = if p > 1.0 - SAME { PieceEnd::Reach } else { PieceEnd::Fault };
                (from.serial, from.id, PieceKind::Blend, end)
            }
        };
        let (joints, pose) = self.place_on(last, p);
        Some(PathPiece { serial, id, kind, end, joints, pose })
    }

    fn end_of_nominal(&self, serial: u64, last: &TimedSpan, after: Option<&TimedSpan>) -> PieceEnd {
        let is_blended = after.is_some_and(|next| next.span.part.blend_of() == Some(serial));
        let [_, end] = last.span.range();
        let is_open = self.path.leave_of(serial).is_some_and(|leave| end > leave - SAME);
        match () {
            () if is_blended || is_open => PieceEnd::Leave,
            () if last.span.ends_its_move() => PieceEnd::Target,
            () => PieceEnd::Fault,
        }
    }

    /// Joints and tool centre point at the start of a move's blend; `None` if the point is not on the remaining path.
    #[must_use]
    pub fn leave_point(&self, serial: u64) -> Option<(Joints, IsometryMatrix3<f64>)> {
        let spans = || self.timeline.spans.iter();
        let nominal =
            spans().rfind(|timed| matches!(timed.span.part, SpanPart::Nominal { serial: own, .. } if own == serial));
        if let Some(nominal) = nominal {
            return self.end_of(nominal);
        }
        match spans().find(|timed| timed.span.part.blend_of() == Some(serial)) {
            Some(blend) => Some(self.place_on(blend, blend.points.first()?.p)),
            // The nominal part is empty, so the previous blend ends at the leave point.
            None => self.end_of(
                spans().rfind(|timed| matches!(timed.span.part, SpanPart::Blend { to, .. } if to.serial == serial))?,
            ),
        }
    }

    /// Joints and tool centre point at the end of a move's blend; `None` if the blend is not determined yet.
    #[must_use]
    pub fn reach_point(&self, serial: u64) -> Option<(Joints, IsometryMatrix3<f64>)> {
        self.end_of(self.timeline.spans.iter().rfind(|timed| timed.span.part.blend_of() == Some(serial))?)
    }

    fn end_of(&self, timed: &TimedSpan) -> Option<(Joints, IsometryMatrix3<f64>)> {
        Some(self.place_on(timed, timed.points.last()?.p))
    }

    fn place_on(&self, timed: &TimedSpan, p: f64) -> (Joints, IsometryMatrix3<f64>) {
        let axes = timed.span.axes(&Model(&self.arm), p);
        (axes.into(), Model(&self.arm).flange(&axes) * timed.span.tool)
    }
}
