//! Deviation from an alterable path (manual 11.2, section (h) of the motion model).

use val3_geometry::{IsometryMatrix3, rotation};
use val3_kinematics::Configuration;
use val3_moves::{AlterReference, Seconds};

use crate::fault::Cause;
use crate::model::{Axes, Model};
use crate::request::SpeedLimits;

/// Factor by which speeds may exceed their limits because of rounding.
const ROUNDING: f64 = 1.001;

/// Longest time from an emergency stop to the end of the deviation, in seconds (manual 11.2.6).
const EMERGENCY: f64 = 0.5;

/// Alter request result (manual 11.2.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AlterStatus {
    /// The request is in effect.
    Done,
    /// The request waits for an alterable move, or for the end of a stop.
    Waiting,
    /// The request is ignored because the mode is already active, or not active.
    Ignored,
    /// The motion has a fault and requires a reset.
    Fault,
}

impl AlterStatus {
    /// Return value of the VAL 3 instruction.
    #[must_use]
    pub const fn code(self) -> i8 {
        match self {
            Self::Done => 1,
            Self::Waiting => 0,
            Self::Ignored => -1,
            Self::Fault => -3,
        }
    }
}

/// Current deviation.
#[derive(Clone, Debug)]
pub(crate) struct Alteration {
    reference: AlterReference,
    limits: SpeedLimits,
    /// Configuration of the path, which no deviation changes.
    branch: Configuration,
    wanted: IsometryMatrix3<f64>,
    applied: IsometryMatrix3<f64>,
    axes: Axes,
    /// Change of the axes per second in the last cycle.
    speed: Axes,
    /// Whether `alterEnd` has fixed the deviation for the rest of the path.
    pub(crate) is_ended: bool,
    /// Whether the deviation was impossible. The arm then holds its position until a reset.
    pub(crate) has_failed: bool,
    /// Seconds until a stop locks the deviation.
    pub(crate) locks_in: Option<f64>,
}

impl Alteration {
    /// Creates an alteration without a deviation. `axes` is the arm's position on the path.
    pub(crate) fn new(model: &Model<'_>, reference: AlterReference, limits: SpeedLimits, axes: Axes) -> Self {
        Self {
            reference,
            limits,
            branch: model.configuration(&axes),
            wanted: IsometryMatrix3::identity(),
            applied: IsometryMatrix3::identity(),
            axes,
            speed: Axes::zeros(),
            is_ended: false,
            has_failed: false,
            locks_in: None,
        }
    }

    /// Sets the deviation, effective from the next cycle on.
    pub(crate) fn set(&mut self, transformation: IsometryMatrix3<f64>) {
        self.wanted = transformation;
    }

    /// Commanded axes.
    pub(crate) fn axes(&self) -> Axes {
        self.axes
    }

    /// Whether a cycle would change the deviation even while the nominal motion rests.
    pub(crate) fn is_pending(&self) -> bool {
        self.wanted != self.applied || self.locks_in.is_some_and(|left| left > 0.0)
    }

    /// Advances by one cycle. `nominal` is the position at the end of the cycle without the deviation.
    pub(crate) fn advance(
        &mut self,
        model: &Model<'_>,
        nominal: &Axes,
        tool: &IsometryMatrix3<f64>,
        duration: Seconds,
    ) -> Result<(), Cause> {
        self.locks_in = self.locks_in.map(|left| (left - duration.0).max(0.0));
        let axes = self.deviated(model, &self.wanted, nominal, &self.axes)?;
        if duration.0 > 0.0 {
            self.check(model, &axes, tool, duration)?;
            self.speed = (axes - self.axes) / duration.0;
        }
        (self.applied, self.axes) = (self.wanted, axes);
        Ok(())
    }

    /// Applies the current deviation to axes on the path.
    pub(crate) fn applied_to(&self, model: &Model<'_>, nominal: &Axes, near: &Axes) -> Result<Axes, Cause> {
        self.deviated(model, &self.applied, nominal, near)
    }

    fn deviated(
        &self,
        model: &Model<'_>,
        deviation: &IsometryMatrix3<f64>,
        nominal: &Axes,
        near: &Axes,
    ) -> Result<Axes, Cause> {
        if *deviation == IsometryMatrix3::identity() {
            return Ok(*nominal);
        }
        let flange = model.flange(nominal);
        model.axes_near(self.branch, &self.flange(deviation, &flange), near)
    }

    /// Applies the current deviation to a flange pose on the path.
    pub(crate) fn applied_to_flange(&self, nominal: &IsometryMatrix3<f64>) -> IsometryMatrix3<f64> {
        self.flange(&self.applied, nominal)
    }

    fn flange(&self, deviation: &IsometryMatrix3<f64>, nominal: &IsometryMatrix3<f64>) -> IsometryMatrix3<f64> {
        match &self.reference {
            AlterReference::Frame(frame) => frame * deviation * frame.inverse() * nominal,
            AlterReference::Tool(tool) => nominal * tool * deviation * tool.inverse(),
        }
    }

    /// Checks that the speeds of a cycle are within the limits of `alterBegin`.
    fn check(
        &self,
        model: &Model<'_>,
        axes: &Axes,
        tool: &IsometryMatrix3<f64>,
        duration: Seconds,
    ) -> Result<(), Cause> {
        let seconds = duration.0 * ROUNDING;
        let is_too_fast =
            (axes - self.axes).iter().zip(self.limits.speed).any(|(way, limit)| way.abs() > limit * seconds);
        let [before, after] = [&self.axes, axes].map(|axes| model.flange(axes) * tool);
        let way = (after.translation.vector - before.translation.vector).norm();
        let turn = rotation::angle_between(&before.rotation, &after.rotation).to_degrees();
        let SpeedLimits { translation, rotation, .. } = self.limits;
        if is_too_fast || way > translation.0 * seconds || turn > rotation.0 * seconds {
            return Err(Cause::AlterSpeed);
        }
        Ok(())
    }

    /// Starts locking the deviation: it is locked after the braking time that results from the deceleration of
    /// `alterBegin`.
    pub(crate) fn stop(&mut self, is_emergency: bool) {
        let times = self.speed.iter().zip(self.limits.deceleration).filter(|(speed, _)| **speed != 0.0);
        let time = times.map(|(speed, limit)| speed.abs() / limit).fold(0.0, f64::max);
        let time = if is_emergency { time.min(EMERGENCY) } else { time };
        self.locks_in = Some(self.locks_in.map_or(time, |left| left.min(time)));
    }
}
