//! The arm is moved by hand.

use nalgebra::Translation3;
use val3_geometry::{IsometryMatrix3, Rotation3, Vector3, rotation};
use val3_kinematics::Joints;

use super::Motion;
use crate::fault::Cause;
use crate::model::{Axes, Model};
use crate::units::Seconds;

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
        self.displace(axes.into());
        Ok(())
    }
}
