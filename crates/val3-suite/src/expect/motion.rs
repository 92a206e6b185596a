//! Expectations about motion; only the tool centre point is compared:
//!
//! ```toml
//! [expect]
//! trace = "golden/cycle.csv"       # the recorded motion; `{ file = "…", mm = 0.5, degrees = 0.5, time = 5 }`
//!
//! [[expect.speed]]
//! below = 250                      # mm/s, everywhere or in a box
//! box = { min = [0, -500, 0], max = [800, 500, 1200] }
//!
//! [[expect.inside]]                # never outside of the box
//! box = { min = [0, -500, 0], max = [800, 500, 1200], frame = "fCell" }
//!
//! [[expect.clear]]
//! distance = 50                    # mm to the box
//! box = { min = [300, 0, 0], max = [400, 100, 200] }
//! ```

use val3_geometry::IsometryMatrix3;
use val3_machine::controller::Controller;
use val3_machine::event::seconds;
use val3_trace::{
    Limit, MotionRecorder, MotionRecording, PictureObserver, TraceFile, Zone, ZoneSetting, describe_violation,
};

use super::Expectations;
use super::occurrence::CycleState;
use crate::failure::{Failure, FailureLocation};
use crate::recorded::{AT_REST, RecordedMotion, place_of};
use crate::source::ExpectationSource;

/// Motion of a test during its execution.
#[derive(Default)]
pub(super) struct MotionExpectation {
    /// Records from the first cycle on, if there are expectations.
    recorder: Option<MotionRecorder>,
    /// Records from the first cycle on, if a picture may be drawn.
    picture: Option<PictureObserver>,
}

impl MotionExpectation {
    pub(super) fn see(&mut self, CycleState { start, controller, .. }: CycleState<'_>, expectations: &Expectations) {
        let Expectations { trace, speed, inside, clear, .. } = expectations;
        if trace.is_some() {
            let picture = self.picture.get_or_insert_with(|| PictureObserver::new(controller));
            picture.see(seconds(start), controller);
        } else if speed.is_empty() && inside.is_empty() && clear.is_empty() {
            return;
        }
        self.recorder.get_or_insert_with(|| MotionRecorder::new(controller)).see(start, controller);
    }

    /// Exceeded limits.
    pub(super) fn failures(
        &self,
        expectations: &Expectations,
        controller: &Controller,
        source: &ExpectationSource,
    ) -> Vec<Failure> {
        let Some(recording) = self.recorder.as_ref().map(MotionRecorder::recording) else { return Vec::new() };
        // The position is also checked if the arm has not moved. Its speed would prove nothing.
        let at_rest = recording.is_empty().then(|| MotionRecording::at_rest(controller));
        let found = limits(expectations, controller, source).into_iter().filter_map(|(limit, place)| match limit {
            Ok(Limit::Speed { .. }) if at_rest.is_some() => {
                Some(Failure { message: format!("{AT_REST}, so no speed was compared"), places: vec![place] })
            }
            Ok(limit) => failure(&limit, at_rest.as_ref().unwrap_or(recording), place),
            Err(message) => Some(Failure { message, places: vec![place] }),
        });
        found.collect()
    }

    /// Motion to compare with a recorded motion, if expected.
    pub(super) fn recorded(
        self,
        expectations: &Expectations,
        source: &ExpectationSource,
    ) -> Option<Box<RecordedMotion>> {
        let trace = expectations.trace.as_ref()?;
        let (recorder, picture) = self.recorder.zip(self.picture)?;
        let (file, place): (TraceFile, _) = (trace.get_ref().clone(), source.place("expect.trace", trace.span()));
        Some(Box::new(RecordedMotion { recording: recorder.finish(), picture: picture.finish(), file, place }))
    }
}

/// Limits with their places in the file, or errors in their boxes.
fn limits(
    expectations: &Expectations,
    controller: &Controller,
    source: &ExpectationSource,
) -> Vec<(Result<Limit, String>, FailureLocation)> {
    let Expectations { speed, inside, clear, .. } = expectations;
    let zone = |setting: &ZoneSetting| zone(setting, controller);
    let speeds = speed.iter().map(|speed| {
        let area = speed.get_ref().zone.as_ref().map(zone).transpose();
        let limit = area.map(|zone| Limit::Speed { most: speed.get_ref().below.0, zone });
        (limit, source.place("expect.speed", speed.span()))
    });
    let insides = inside
        .iter()
        .map(|inside| (zone(&inside.get_ref().zone).map(Limit::Inside), source.place("expect.inside", inside.span())));
    let clears = clear.iter().map(|clear| {
        let limit = zone(&clear.get_ref().zone).map(|zone| Limit::Clear { zone, least: clear.get_ref().distance.0 });
        (limit, source.place("expect.clear", clear.span()))
    });
    speeds.chain(insides).chain(clears).collect()
}

fn failure(limit: &Limit, recording: &MotionRecording, place: FailureLocation) -> Option<Failure> {
    let rows = &recording.trace.rows;
    let violation = limit.violation(rows, 0..rows.len())?;
    let finding = describe_violation(limit, &violation, recording);
    let of_move = finding.source.map(place_of);
    Some(Failure { message: finding.message, places: of_move.into_iter().chain([place]).collect() })
}

/// Converts a box. Its frame has the pose at the end of the test.
fn zone(ZoneSetting { min, max, frame }: &ZoneSetting, controller: &Controller) -> Result<Zone, String> {
    let frame = match frame {
        None => IsometryMatrix3::identity(),
        Some(name) => controller.frame_in_world(name).ok_or_else(|| {
            format!("the box has no place: there is no frame `{name}` in the application, or it has no reference")
        })?,
    };
    Ok(Zone::new(*min, *max, &frame))
}
