//! Blend distances, with the lines that shorten them.

use val3_lang::ports::CodePlace;
use val3_motion::{BlendCorner, Millimetres, MoveEvent, QueuedMove, Shortening};

use super::Devices;
use crate::arm::MoveOrigin;
use crate::blend_ends::{BlendCut, BlendDistance, BlendEnds, CutReason};

impl Devices {
    /// Requested and effective blend distances of a recorded move.
    #[must_use]
    pub fn blend_of(&self, queued: &QueuedMove, origin: Option<&MoveOrigin>) -> BlendEnds {
        self.blend_ends([queued.leave, queued.reach], queued.cancelled, origin)
    }

    /// Requested and effective blend distances of a move at an event.
    pub(super) fn blend_at(&self, event: &MoveEvent, origin: Option<&MoveOrigin>) -> BlendEnds {
        self.blend_ends([event.leave, event.reach], event.cancelled, origin)
    }

    fn blend_ends(
        &self,
        [leave, reach]: [Option<BlendCorner>; 2],
        cancelled: Option<[Millimetres; 2]>,
        origin: Option<&MoveOrigin>,
    ) -> BlendEnds {
        if let Some([leave, reach]) = cancelled {
            let cut = self.cut(CutReason::Cancelled, origin.and_then(|origin| origin.cancelled_by));
            let [leave, reach] = [leave, reach].map(|Millimetres(requested)| {
                (requested > 0.0).then(|| BlendDistance { requested, effective: 0.0, cut: Some(cut.clone()) })
            });
            return BlendEnds { leave, reach };
        }
        BlendEnds {
            leave: leave.map(|end| self.blend_distance(&end)),
            reach: reach.map(|end| self.blend_distance(&end)),
        }
    }

    fn blend_distance(&self, end: &BlendCorner) -> BlendDistance {
        let cut = end.shortening.map(|shortening| {
            let reason = match shortening {
                Shortening::SharedWithPrevious(_) => CutReason::SharedWithPrevious,
                Shortening::SharedWithNext(_) => CutReason::SharedWithNext,
                Shortening::ShortMove(_) => CutReason::ShortMove,
                Shortening::StopAtCorner => CutReason::StopAtTarget,
            };
            let cause = shortening.cause().and_then(|serial| self.state.arm.origin(serial));
            self.cut(reason, cause.and_then(|origin| origin.at))
        });
        BlendDistance { requested: end.requested.0, effective: end.effective().0, cut }
    }

    fn cut(&self, reason: CutReason, at: Option<CodePlace>) -> BlendCut {
        let place = at.map(|at| self.place(at));
        let (program, line) = place.map(|(program, line, _)| (program, line)).unzip();
        BlendCut { reason, program, line }
    }
}
