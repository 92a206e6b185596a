//! Pictures of runs.

use std::collections::BTreeMap;

use val3_geometry::rotation;
use val3_kinematics::{Arm, AxisLimits as ArmAxis, Joints};
use val3_lang::values::MdescValue;
use val3_machine::arm::MoveOrigin;
use val3_machine::controller::Controller;
use val3_machine::event::seconds;
use val3_motion::{MotionPhase, MoveStage, QueuedMove};
use val3_plot::{MoveLimits, MoveMark, Picture, PictureAxis, Sample};

use crate::row::TraceRow;

/// Collects the data of a run's picture.
#[derive(Debug)]
pub struct PictureObserver {
    picture: Picture,
    /// Indexes of the recorded moves in the picture, by move number.
    marks: BTreeMap<u64, usize>,
    /// Latest sample at rest, which is added to the picture if the arm moves again.
    resting: Option<Sample>,
    /// Time in seconds and joints in the previous cycle.
    last: Option<(f64, Joints)>,
}

impl PictureObserver {
    /// Creates an observer for a controller whose arm has not moved yet.
    #[must_use]
    pub fn new(controller: &Controller) -> Self {
        let arm = controller.arm().model();
        let picture = Picture {
            title: controller.name().to_owned(),
            arm: arm.name().to_owned(),
            axes: arm.limits().iter().enumerate().map(|(index, limits)| axis(arm, index, limits)).collect(),
            times_note: arm.times_note(),
            ..Picture::default()
        };
        Self { picture, marks: BTreeMap::new(), resting: None, last: None }
    }

    /// Adds the cycle that began at `t`, in seconds.
    pub fn see(&mut self, t: f64, controller: &Controller) {
        let arm = controller.arm();
        let seen = arm.sample();
        let position = seen.pose.translation.vector.into();
        let (joints, speed, phase) = (seen.joints, seen.speed.0, seen.phase);
        let rotation = if phase == MotionPhase::Waiting { 0.0 } else { self.rotation(arm.model(), t, &joints) };
        self.last = Some((t, joints));
        let sample = Sample { t, joints, position, speed, rotation, phase, limit: Some(arm.speed_limit()) };
        if phase != MotionPhase::Waiting {
            // The pose at rest belongs to the previous tool.
            self.picture
                .samples
                .extend(self.resting.take().map(|resting| Sample { position: sample.position, ..resting }));
            self.picture.samples.push(sample);
        } else if self.picture.samples.last().is_some_and(|last| last.phase != MotionPhase::Waiting) {
            self.picture.samples.push(sample);
        } else {
            self.resting = Some(sample);
        }
        self.mark(t, controller);
    }

    /// Returns the rotation speed of the tool since the previous cycle, in degrees per second. It is computed for the
    /// flange, because a program may select another tool.
    fn rotation(&self, arm: &Arm, t: f64, joints: &Joints) -> f64 {
        let Some((before, joints_before)) = &self.last else { return 0.0 };
        let [from, to] = [joints_before, joints].map(|joints| arm.flange(joints).rotation);
        rotation::angle_between(&from, &to).to_degrees() / (t - before)
    }

    fn mark(&mut self, t: f64, controller: &Controller) {
        let moves = &mut self.picture.moves;
        let mut marks = BTreeMap::new();
        for (queued, origin) in controller.arm().moves() {
            let place = self.marks.remove(&queued.serial).unwrap_or_else(|| {
                moves.push(new_mark(controller, queued, origin));
                moves.len() - 1
            });
            marks.insert(queued.serial, place);
            let Some(mark) = moves.get_mut(place) else { continue };
            mark.leave = queued.leave.map(|corner| corner.position.into());
            mark.reach = queued.leave.and(queued.reach).map(|corner| corner.position.into());
            // A cancelled blend is not drawn.
            let blend = queued.leave.map(|_| controller.devices.blend_of(queued, origin)).unwrap_or_default();
            (mark.note, mark.explanation) = (blend.short_note(), blend.note());
            if queued.stage >= MoveStage::Started {
                mark.started.get_or_insert(t);
            }
            if queued.stage >= MoveStage::Blending {
                mark.blended.get_or_insert(t);
            }
        }
        for place in std::mem::replace(&mut self.marks, marks).into_values() {
            if let Some(mark) = moves.get_mut(place) {
                mark.ended = Some(t);
            }
        }
    }

    /// Returns the picture.
    #[must_use]
    pub fn finish(self) -> Picture {
        self.picture
    }
}

fn axis(arm: &Arm, index: usize, limits: &ArmAxis) -> PictureAxis {
    PictureAxis {
        is_stroke: arm.is_stroke(index),
        min: limits.min,
        max: limits.max,
        nominal_speed: arm.nominal_speed(index),
        nominal_acceleration: arm.nominal_acceleration(index),
        nominal_deceleration: arm.nominal_deceleration(index),
    }
}

/// Creates the mark of a recorded move.
fn new_mark(controller: &Controller, queued: &QueuedMove, origin: Option<&MoveOrigin>) -> MoveMark {
    let (program, line, _) = origin.map(|origin| controller.devices.place_of_move(origin.at)).unwrap_or_default();
    MoveMark {
        program,
        line,
        target: queued.target.translation.vector.into(),
        intermediate: queued.intermediate.map(Into::into),
        limits: origin.map(|origin| limits(&origin.descriptor)),
        ..MoveMark::default()
    }
}

fn limits(descriptor: &MdescValue) -> MoveLimits {
    let MdescValue { vel, accel, decel, tvel, rvel, .. } = *descriptor;
    MoveLimits { joint_speed: vel, acceleration: accel, deceleration: decel, tool_speed: tvel, tool_rotation: rvel }
}

impl From<&TraceRow> for Sample {
    fn from(row: &TraceRow) -> Self {
        let TraceRow { joints, phase, speed, .. } = *row;
        let position = row.position().into();
        Self { t: seconds(row.time), joints, position, speed, rotation: 0.0, phase, limit: None }
    }
}
