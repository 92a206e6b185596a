//! Jogging: the arm is moved by hand.

use nalgebra::Translation3;
use val3_geometry::{IsometryMatrix3, Rotation3, Vector3, rotation};
use val3_kinematics::Joints;
use val3_moves::{MillimetresPerSecond, Seconds};

use super::Motion;
use crate::fault::Cause;
use crate::model::{Axes, Model};

/// Iterations that shorten a jog step to the speed limit.
const ROUNDS: usize = 3;

/// Movement requested by the keys of the pendant (manual 8.1, working modes).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Jog {
    /// Axis speeds, in degrees or mm per second.
    Joints(Joints),
    /// Translation of the tool centre point along Cartesian axes, and rotation around them.
    Cartesian {
        /// Pose of the tool on the flange.
        tool: IsometryMatrix3<f64>,
        /// Directions of the axes in `world`; `None` for the axes of the tool.
        frame: Option<Rotation3<f64>>,
        /// Translation speed, in mm per second.
        translation: Vector3<f64>,
        /// Rotation speed around the tool centre point, in degrees per second.
        rotation: Vector3<f64>,
    },
}

impl Motion {
    /// Jogs the arm for a duration, away from its path as [`Motion::displace`] does.
    ///
    /// # Errors
    /// Returns the cause, without moving the arm, if an axis would leave its limits or if the position cannot be
    /// reached in this configuration.
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

    /// Shortens the step from `present` to `axes` to the distance that [`Motion::limit_tool_speed`] permits in a
    /// duration.
    fn slowed(&self, present: &Axes, axes: Axes, duration: Seconds) -> Axes {
        let Some(MillimetresPerSecond(most)) = self.tool_speed else { return axes };
        let [flange, tip] = self.flange_and_tip(present);
        // The distance is almost proportional to the step, so further iterations only correct a small remainder.
        (0..ROUNDS).fold(axes, |axes, _| {
            let [next_flange, next_tip] = self.flange_and_tip(&axes);
            let way = (next_flange - flange).norm().max((next_tip - tip).norm());
            if way > most * duration.0 { present + (axes - present) * (most * duration.0 / way) } else { axes }
        })
    }

    /// Positions of the flange and the tool centre point in `world`, in mm.
    fn flange_and_tip(&self, axes: &Axes) -> [Vector3<f64>; 2] {
        let flange = Model(&self.arm).flange(axes);
        [flange.translation.vector, (flange * self.tool).translation.vector]
    }
}
