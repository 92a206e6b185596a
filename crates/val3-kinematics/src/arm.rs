//! Arm model.

use std::fmt;

use val3_geometry::{IsometryMatrix3, Trsf};

use crate::dh::Dh;
use crate::scara::Scara;
use crate::shapes::LinkCapsule;
use crate::six_axis::SixAxis;
use crate::{ArmError, Configuration, DhError, Joints, data};

/// Smallest absolute value that means "the arm type's own limit" in `arm.cfx` and `cell.cfx`, in degrees or mm.
const LIMIT_OF_TYPE: f64 = 99_999.0;

/// Nominal load if the arm's file contains none, in kg (model choice).
const USUAL_LOAD: f64 = 5.0;

/// An arm: geometry in mm, axis limits and calibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    pub(crate) name: String,
    pub(crate) geometry: Geometry,
    pub(crate) axes: Vec<AxisLimits>,
    pub(crate) payload: Payload,
    pub(crate) height: f64,
    pub(crate) sources: Vec<String>,
    pub(crate) model_choices: Vec<String>,
    pub(crate) has_measured_times: bool,
    pub(crate) calibration: Option<Box<Dh>>,
    pub(crate) shapes: Vec<Vec<LinkCapsule>>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Geometry {
    SixAxis(SixAxis),
    Scara(Scara),
}

/// Axis limits, in degrees; for a SCARA arm's stroke in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisLimits {
    /// Lowest position.
    pub min: f64,
    /// Highest position.
    pub max: f64,
    /// Speed at `vel` = 100 in a motion descriptor, per second.
    pub nominal_speed: f64,
    /// Highest speed, per second.
    pub maximum_speed: f64,
    /// Acceleration at `accel` = 100, per second².
    pub acceleration: f64,
    /// Deceleration at `decel` = 100, per second².
    pub deceleration: f64,
    /// Largest torque in Nm, or force of a stroke in N; `None` if unknown.
    pub maximum_effort: Option<f64>,
}

/// Loads at the flange, in kg; `None` if unknown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Payload {
    /// Largest load at nominal speed.
    pub nominal: Option<f64>,
    /// Largest load at reduced speed.
    pub maximum: Option<f64>,
}

/// An axis outside its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation {
    /// Axis number, from 1.
    pub axis: usize,
    /// Position.
    pub position: f64,
    /// Lowest allowed position.
    pub min: f64,
    /// Highest allowed position.
    pub max: f64,
    /// Unit of the positions: `degrees` or `mm`.
    pub unit: &'static str,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { axis, position, min, max, unit } = self;
        write!(f, "axis {axis} would be at {position:.3}, outside its range from {min} to {max} {unit}")
    }
}

impl Arm {
    /// Reads an arm from a file in the format of `arms/`.
    ///
    /// Without `nominal_speed` the speeds are 0.66 times `maximum_speed`, without `acceleration` the arm reaches its
    /// nominal speed in 0.2 s, and without `deceleration` the deceleration equals the acceleration.
    pub fn from_toml(text: &str) -> Result<Self, ArmError> {
        data::parse(text)
    }

    /// Returns the name of the type, for example `TX2-60L`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the entries of the arm's file that are choices of this model, because no public source contains them.
    #[must_use]
    pub fn model_choices(&self) -> &[String] {
        &self.model_choices
    }

    /// Returns the sources of the values in the arm's file: sentences or names.
    #[must_use]
    pub fn sources(&self) -> &[String] {
        &self.sources
    }

    /// Whether nominal speeds, accelerations and decelerations were measured on a real arm (`times = "measured"`).
    /// Otherwise cycle times are model values.
    #[must_use]
    pub const fn has_measured_times(&self) -> bool {
        self.has_measured_times
    }

    /// Returns the number of axes: 6, or 4 for a SCARA arm.
    #[must_use]
    pub const fn axes(&self) -> usize {
        match self.geometry {
            Geometry::SixAxis(_) => 6,
            Geometry::Scara(_) => 4,
        }
    }

    /// Whether the arm is a SCARA arm, with parallel axes and a vertical stroke.
    #[must_use]
    pub const fn is_scara(&self) -> bool {
        matches!(self.geometry, Geometry::Scara(_))
    }

    /// Whether an axis (from 0) moves along a line. Its positions are in mm.
    #[must_use]
    pub const fn is_stroke(&self, axis: usize) -> bool {
        self.is_scara() && axis == 2
    }

    /// Returns the unit for positions of axis `axis` (from 0): `degrees` or `mm`.
    #[must_use]
    pub const fn unit(&self, axis: usize) -> &'static str {
        if self.is_stroke(axis) { "mm" } else { "degrees" }
    }

    /// Returns the height of the `world` origin above the mounting face, in mm. Only drawings need it.
    #[must_use]
    pub const fn height(&self) -> f64 {
        self.height
    }

    /// Returns the largest distance between the flange and axis 1 in mm, as in data sheets: the sum of the arm's
    /// lengths in its plane.
    #[must_use]
    pub const fn reach(&self) -> f64 {
        match &self.geometry {
            Geometry::SixAxis(SixAxis { a1, c2, c3, c4, .. }) => *a1 + *c2 + *c3 + *c4,
            Geometry::Scara(Scara { l1, l2, .. }) => *l1 + *l2,
        }
    }

    /// Returns the loads at the flange.
    #[must_use]
    pub const fn payload(&self) -> Payload {
        self.payload
    }

    /// Returns the load at the flange for which forces and torques are computed, in kg: the nominal load, otherwise the
    /// maximum load, otherwise a default.
    #[must_use]
    pub fn nominal_load(&self) -> f64 {
        self.payload.nominal.or(self.payload.maximum).unwrap_or(USUAL_LOAD)
    }

    /// Returns the limits of all axes.
    #[must_use]
    pub fn limits(&self) -> &[AxisLimits] {
        &self.axes
    }

    /// Returns the nominal speed of axis `axis` (from 0) at `vel` = 100, in degrees/s or mm/s; 0 if the arm has no such
    /// axis.
    #[must_use]
    pub fn nominal_speed(&self, axis: usize) -> f64 {
        self.axes.get(axis).map_or(0.0, |axis| axis.nominal_speed)
    }

    /// Returns the nominal acceleration of axis `axis` (from 0) at `accel` = 100, in degrees/s² or mm/s²; 0 if the arm
    /// has no such axis.
    #[must_use]
    pub fn nominal_acceleration(&self, axis: usize) -> f64 {
        self.axes.get(axis).map_or(0.0, |axis| axis.acceleration)
    }

    /// Returns the nominal deceleration of axis `axis` (from 0) at `decel` = 100, in degrees/s² or mm/s²; 0 if the arm
    /// has no such axis.
    #[must_use]
    pub fn nominal_deceleration(&self, axis: usize) -> f64 {
        self.axes.get(axis).map_or(0.0, |axis| axis.deceleration)
    }

    /// Returns the arm with the individual, narrower limits from `arm.cfx` and `cell.cfx`. Missing values, and absolute
    /// values from 99999 on, leave the type's limit unchanged.
    pub fn with_limits(mut self, min: &[f64], max: &[f64]) -> Result<Self, Violation> {
        let given = |value: Option<&f64>| value.copied().filter(|value| value.abs() < LIMIT_OF_TYPE);
        let units = std::array::from_fn::<_, 6, _>(|axis| self.unit(axis));
        for ((index, axis), unit) in self.axes.iter_mut().enumerate().zip(units) {
            let lower = given(min.get(index)).map_or(axis.min, |min| min.max(axis.min));
            let upper = given(max.get(index)).map_or(axis.max, |max| max.min(axis.max));
            if lower >= upper {
                return Err(Violation { axis: index + 1, position: lower, min: axis.min, max: axis.max, unit });
            }
            (axis.min, axis.max) = (lower, upper);
        }
        Ok(self)
    }

    /// Computes the flange pose in world.
    #[must_use]
    pub fn forward(&self, joints: &Joints) -> Trsf {
        self.flange(joints).into()
    }

    /// Computes the flange pose in world as matrices, which is faster than [`Arm::forward`] with its angles.
    #[must_use]
    pub fn flange(&self, joints: &Joints) -> IsometryMatrix3<f64> {
        if self.is_calibrated() {
            return self.links(joints).last().copied().unwrap_or_default();
        }
        match &self.geometry {
            Geometry::SixAxis(geometry) => geometry.forward(joints),
            Geometry::Scara(geometry) => geometry.forward(joints),
        }
    }

    /// Computes the poses of the base and of all link ends in world. The result has one more entry than the arm has
    /// axes: the z axis of entry `i` is axis `i + 1`, and the last entry is the flange.
    #[must_use]
    pub fn links(&self, joints: &Joints) -> Vec<IsometryMatrix3<f64>> {
        let dh = self.dh();
        let mut links = vec![IsometryMatrix3::identity()];
        let mut pose = IsometryMatrix3::identity();
        for (axis, joint) in joints.iter().enumerate().take(self.axes()) {
            pose *= dh.link(axis, *joint, self.is_stroke(axis));
            links.push(pose);
        }
        let flange = dh.d.get(self.axes()).copied().unwrap_or_default();
        if let Some(last) = links.last_mut() {
            *last *= Trsf::new([0.0, 0.0, flange], [0.0; 3]).isometry();
        }
        links
    }

    /// Computes the frames of the base and of all links in world, to which the shapes are relative. The result has one
    /// more entry than the arm has axes. The frame of a link has its own axis as z and moves with its joint.
    #[must_use]
    pub fn parts(&self, joints: &Joints) -> Vec<IsometryMatrix3<f64>> {
        let mut parts = vec![IsometryMatrix3::identity()];
        for (axis, (before, joint)) in self.links(joints).into_iter().zip(joints).enumerate().take(self.axes()) {
            let (stroke, angle) = if self.is_stroke(axis) { (*joint, 0.0) } else { (0.0, *joint) };
            parts.push(before * Trsf::new([0.0, 0.0, stroke], [0.0, 0.0, angle]).isometry());
        }
        parts
    }

    /// Returns the capsules around the base and around each link; empty if the arm's file has no `[shapes]`.
    #[must_use]
    pub fn shapes(&self) -> &[Vec<LinkCapsule>] {
        &self.shapes
    }

    /// Returns the configuration of a joint position (instruction `config`).
    #[must_use]
    pub fn configuration(&self, joints: &Joints) -> Configuration {
        match &self.geometry {
            Geometry::SixAxis(geometry) => geometry.configuration(joints),
            Geometry::Scara(_) => Scara::configuration(joints),
        }
    }

    /// Whether all axes are within their limits (instruction `isInRange`).
    #[must_use]
    pub fn is_in_range(&self, joints: &Joints) -> bool {
        self.violations(joints).next().is_none()
    }

    /// Returns the axes outside their limits.
    pub fn violations(&self, joints: &Joints) -> impl Iterator<Item = Violation> {
        let axes = joints.iter().zip(&self.axes).enumerate();
        let violations = axes.map(|(index, (&position, &AxisLimits { min, max, .. }))| {
            let inside = min <= position && position <= max;
            (!inside).then_some(Violation { axis: index + 1, position, min, max, unit: self.unit(index) })
        });
        violations.flatten()
    }

    /// Returns the multiple of 360 degrees to add to the last axis so that it is nearest to `reference` (instruction
    /// `resetTurn`).
    #[must_use]
    pub fn turn_shift(&self, joints: &Joints, reference: &Joints) -> f64 {
        let last = |joints: &Joints| joints.get(self.axes() - 1).copied().unwrap_or_default();
        ((last(reference) - last(joints)) / 360.0).round() * 360.0
    }

    /// Returns the nominal geometric parameters of the type (instruction `getDefaultDH`).
    #[must_use]
    pub fn default_dh(&self) -> Dh {
        match &self.geometry {
            Geometry::SixAxis(geometry) => geometry.dh(),
            Geometry::Scara(geometry) => geometry.dh(),
        }
    }

    /// Returns the geometric parameters of this arm (instruction `getDH`).
    #[must_use]
    pub fn dh(&self) -> Dh {
        self.calibration.as_deref().copied().unwrap_or_else(|| self.default_dh())
    }

    /// Sets measured geometric parameters (instruction `setDH`). The arm remains unchanged if they differ from the
    /// nominal ones by more than 5 mm or 2 degrees (model choice).
    pub fn set_dh(&mut self, dh: &Dh) -> Result<(), DhError> {
        let nominal = self.default_dh();
        dh.check(&nominal)?;
        self.calibration = (*dh != nominal).then(|| Box::new(*dh));
        Ok(())
    }

    /// Whether the geometric parameters differ from the nominal ones.
    #[must_use]
    pub const fn is_calibrated(&self) -> bool {
        self.calibration.is_some()
    }
}
