//! The arm is moved by hand.

use nalgebra::Translation3;
use val3_geometry::{IsometryMatrix3, Rotation3, Vector3, rotation};
use val3_kinematics::Joints;
use val3_moves::{MillimetresPerSecond, Seconds};

use super::Motion;
use crate::fault::Cause;
use crate::model::{Axes, Model};

/// Rounds in which a step by hand is shortened to the limit of speed.
const ROUNDS: usize = 3;

/// The movement that the keys of the pendant ask for (manual 8.1, working modes).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Jog {
    /// Speed of each axis, in degrees or mm per second.
    Joints(Joints),
    /// The tool centre point moves along axes and rotates around them.
    Cartesian {
        /// The pose of the tool on the flange.
        tool: IsometryMatrix3<f64>,
        /// The directions of the axes in world; those of the tool if there are none.
        frame: Option<Rotation3<f64>>,
        /// In mm per second.
        translation: Vector3<f64>,
        /// In degrees per second, around the tool centre point.
        rotation: Vector3<f64>,
    },
}

impl Motion {
    /// Moves the arm away from its path for a duration, as [`Motion::displace`] does.
    ///
    /// # Errors
    /// The arm stays where it is: an axis would leave its limits, or the position cannot be reached in this configuration.
    pub fn jog(&mut self, jog: &Jog, duration: Seconds) -> Result<(), Cause> {
        let (model, present) = (Model(&self.arm), self.commanded);
        let axes = match jog {
            Jog::Joints(speed) => model.in_range(&(present + Axes::from(*speed) * duration.0).into())?,
            Jog::Cartesian { tool, frame, translation, rotation } => {
                let tip = model.flange(&present) * tool;
                let frame = frame.unwrap_or(tip.rotation);
                let position = tip.translation.vector + frame * translation * duration.0;
                let turn = rotation::from_vector(&(frame * rotation * duration.0.to_radians()));
                let moved = IsometryMatrix3::from_parts(Translation3::from(position), turn * tip.rotation);
                model.axes_near(model.configuration(&present), &(moved * tool.inverse()), &present)?
            }
        };
        let axes = self.slowed(&present, axes, duration);
        self.displace(axes.into());
        Ok(())
    }

    /// The axes on the way to `axes` that the arm reaches within a duration at the limit of [`Motion::limit_tool_speed`].
    fn slowed(&self, present: &Axes, axes: Axes, duration: Seconds) -> Axes {
        let Some(MillimetresPerSecond(most)) = self.tool_speed else { return axes };
        let place = |axes: &Axes| {
            let flange = Model(&self.arm).flange(axes);
            [flange.translation.vector, (flange * self.tool).translation.vector]
        };
        let [flange, tip] = place(present);
        // The way is almost in proportion to the share, so the second round corrects what the first one leaves.
        (0..ROUNDS).fold(axes, |axes, _| {
            let [next_flange, next_tip] = place(&axes);
            let way = (next_flange - flange).norm().max((next_tip - tip).norm());
            if way > most * duration.0 { present + (axes - present) * (most * duration.0 / way) } else { axes }
        })
    }
}
