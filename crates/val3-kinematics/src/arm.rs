//! The model of an arm.

use std::fmt;

use val3_geometry::{IsometryMatrix3, Trsf};

use crate::dh::Dh;
use crate::scara::Scara;
use crate::six_axis::SixAxis;
use crate::{ArmError, Configuration, DhError, Joints, data};

/// `arm.cfx` and `cell.cfx` write this value or more, with either sign, for a limit of the type of arm.
const LIMIT_OF_TYPE: f64 = 99_999.0;

/// Nominal load of an arm where it is not known, in kg (model choice).
const USUAL_LOAD: f64 = 5.0;

/// An arm: geometry in mm, limits of its axes, and the parameters of its calibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    pub(crate) name: String,
    pub(crate) geometry: Geometry,
    pub(crate) axes: Vec<Axis>,
    pub(crate) payload: Payload,
    pub(crate) height: f64,
    pub(crate) sources: Vec<String>,
    pub(crate) model_choices: Vec<String>,
    pub(crate) has_measured_times: bool,
    pub(crate) calibration: Option<Box<Dh>>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Geometry {
    SixAxis(SixAxis),
    Scara(Scara),
}

/// The limits of one axis, in degrees. The stroke of a SCARA arm is in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Lowest position.
    pub min: f64,
    /// Highest position.
    pub max: f64,
    /// Speed at `vel` = 100 of a motion descriptor, per second.
    pub nominal_speed: f64,
    /// Greatest speed, per second.
    pub maximum_speed: f64,
    /// Acceleration at `accel` = 100, per second².
    pub acceleration: f64,
    /// Deceleration at `decel` = 100, per second².
    pub deceleration: f64,
    /// Greatest torque in Nm (force of a stroke in N), where known.
    pub maximum_effort: Option<f64>,
}

/// The load at the flange, in kg, where known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Payload {
    /// At nominal speed.
    pub nominal: Option<f64>,
    /// At reduced speed.
    pub maximum: Option<f64>,
}

/// An axis outside of its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation {
    /// The axis, counted from 1.
    pub axis: usize,
    /// Its position.
    pub position: f64,
    /// Its lowest position.
    pub min: f64,
    /// Its highest position.
    pub max: f64,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { axis, position, min, max } = self;
        write!(f, "axis {axis} would be at {position:.3}, outside its range from {min} to {max}")
    }
}

impl Arm {
    /// An arm from the text of a file such as those in `arms/`.
    ///
    /// Without `nominal_speed` the speeds are 0.66 times `maximum_speed`, without `acceleration` the arm takes 0.2 s to
    /// reach its nominal speed, and without `deceleration` it brakes as it accelerates.
    pub fn from_toml(text: &str) -> Result<Self, ArmError> {
        data::parse(text)
    }

    /// The name of the type, such as `TX2-60L`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Entries of the arm's file that are choices of this model, because no public source has them.
    #[must_use]
    pub fn model_choices(&self) -> &[String] {
        &self.model_choices
    }

    /// Sources of the values in the arm's file, one sentence or name an entry.
    #[must_use]
    pub fn sources(&self) -> &[String] {
        &self.sources
    }

    /// Whether nominal speeds, accelerations and decelerations were measured on a real arm (`times = "measured"`). Else
    /// cycle times are those of a model.
    #[must_use]
    pub const fn has_measured_times(&self) -> bool {
        self.has_measured_times
    }

    /// The number of axes: 6, or 4 for a SCARA arm.
    #[must_use]
    pub const fn axes(&self) -> usize {
        match self.geometry {
            Geometry::SixAxis(_) => 6,
            Geometry::Scara(_) => 4,
        }
    }

    /// True for an arm with parallel axes and a vertical stroke.
    #[must_use]
    pub const fn is_scara(&self) -> bool {
        matches!(self.geometry, Geometry::Scara(_))
    }

    /// True for an axis (counted from 0) that moves along a line. Its positions are in mm.
    #[must_use]
    pub const fn is_stroke(&self, axis: usize) -> bool {
        self.is_scara() && axis == 2
    }

    /// Unit of the positions of an axis (counted from 0): `degrees` or `mm`.
    #[must_use]
    pub const fn unit(&self, axis: usize) -> &'static str {
        if self.is_stroke(axis) { "mm" } else { "degrees" }
    }

    /// The height of the origin of `world` above the mounting face, in mm. Only pictures need it.
    #[must_use]
    pub const fn height(&self) -> f64 {
        self.height
    }

    /// Greatest distance between the flange and axis 1 in mm, as data sheets state it: the sum of the lengths of the arm
    /// in its plane.
    #[must_use]
    pub const fn reach(&self) -> f64 {
        match &self.geometry {
            Geometry::SixAxis(SixAxis { a1, c2, c3, c4, .. }) => *a1 + *c2 + *c3 + *c4,
            Geometry::Scara(Scara { l1, l2, .. }) => *l1 + *l2,
        }
    }

    /// The load at the flange.
    #[must_use]
    pub const fn payload(&self) -> Payload {
        self.payload
    }

    /// The load at the flange that forces and torques are computed for, in kg: the nominal one, else the maximum one.
    #[must_use]
    pub fn nominal_load(&self) -> f64 {
        self.payload.nominal.or(self.payload.maximum).unwrap_or(USUAL_LOAD)
    }

    /// The limits of the axes, one entry an axis.
    #[must_use]
    pub fn limits(&self) -> &[Axis] {
        &self.axes
    }

    /// The speed of an axis (counted from 0) at `vel` = 100, in degrees/s or mm/s; 0 if the arm has no such axis.
    #[must_use]
    pub fn nominal_speed(&self, axis: usize) -> f64 {
        self.axes.get(axis).map_or(0.0, |axis| axis.nominal_speed)
    }

    /// The acceleration of an axis at `accel` = 100, in degrees/s² or mm/s²; 0 if the arm has no such axis.
    #[must_use]
    pub fn nominal_acceleration(&self, axis: usize) -> f64 {
        self.axes.get(axis).map_or(0.0, |axis| axis.acceleration)
    }

    /// The deceleration of an axis at `decel` = 100, in degrees/s² or mm/s²; 0 if the arm has no such axis.
    #[must_use]
    pub fn nominal_deceleration(&self, axis: usize) -> f64 {
        self.axes.get(axis).map_or(0.0, |axis| axis.deceleration)
    }

    /// This arm with narrower limits, as `arm.cfx` and `cell.cfx` give them for one unit. Values of ±99999 and beyond
    /// keep the limit of the type, and so do missing values.
    pub fn with_limits(mut self, min: &[f64], max: &[f64]) -> Result<Self, Violation> {
        let given = |value: Option<&f64>| value.copied().filter(|value| value.abs() < LIMIT_OF_TYPE);
        for (index, axis) in self.axes.iter_mut().enumerate() {
            let lower = given(min.get(index)).map_or(axis.min, |min| min.max(axis.min));
            let upper = given(max.get(index)).map_or(axis.max, |max| max.min(axis.max));
            if lower >= upper {
                return Err(Violation { axis: index + 1, position: lower, min: axis.min, max: axis.max });
            }
            (axis.min, axis.max) = (lower, upper);
        }
        Ok(self)
    }

    /// The pose of the flange in world.
    #[must_use]
    pub fn forward(&self, joints: &Joints) -> Trsf {
        self.flange(joints).into()
    }

    /// The pose of the flange in world, as matrices. Faster than [`Arm::forward`], which computes angles.
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

    /// The poses of the base and of the end of each link, in world: an entry more than axes. Entry `i` has axis `i + 1`
    /// as its z axis, and the last one is the flange.
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

    /// The configuration of a joint position (instruction `config`).
    #[must_use]
    pub fn configuration(&self, joints: &Joints) -> Configuration {
        match &self.geometry {
            Geometry::SixAxis(geometry) => geometry.configuration(joints),
            Geometry::Scara(_) => Scara::configuration(joints),
        }
    }

    /// True if no axis is outside of its limits (instruction `isInRange`).
    #[must_use]
    pub fn is_in_range(&self, joints: &Joints) -> bool {
        self.violations(joints).next().is_none()
    }

    /// The axes outside of their limits.
    pub fn violations(&self, joints: &Joints) -> impl Iterator<Item = Violation> {
        let axes = joints.iter().zip(&self.axes).enumerate();
        let violations = axes.map(|(index, (&position, &Axis { min, max, .. }))| {
            let inside = min <= position && position <= max;
            (!inside).then_some(Violation { axis: index + 1, position, min, max })
        });
        violations.flatten()
    }

    /// The degrees, a multiple of 360, to add to the last axis so that it is as near to `reference` as possible
    /// (instruction `resetTurn`).
    #[must_use]
    pub fn turn_shift(&self, joints: &Joints, reference: &Joints) -> f64 {
        let last = |joints: &Joints| joints.get(self.axes() - 1).copied().unwrap_or_default();
        ((last(reference) - last(joints)) / 360.0).round() * 360.0
    }

    /// The nominal geometric parameters of the type (instruction `getDefaultDH`).
    #[must_use]
    pub fn default_dh(&self) -> Dh {
        match &self.geometry {
            Geometry::SixAxis(geometry) => geometry.dh(),
            Geometry::Scara(geometry) => geometry.dh(),
        }
    }

    /// The geometric parameters of this arm (instruction `getDH`).
    #[must_use]
    pub fn dh(&self) -> Dh {
        self.calibration.as_deref().copied().unwrap_or_else(|| self.default_dh())
    }

    /// Sets measured geometric parameters (instruction `setDH`). The arm stays unchanged if they are too far from the
    /// nominal ones: more than 5 mm or 2 degrees, which is a choice of this model.
    pub fn set_dh(&mut self, dh: &Dh) -> Result<(), DhError> {
        let nominal = self.default_dh();
        dh.check(&nominal)?;
        self.calibration = (*dh != nominal).then(|| Box::new(*dh));
        Ok(())
    }

    /// True if the geometric parameters differ from the nominal ones.
    #[must_use]
    pub const fn is_calibrated(&self) -> bool {
        self.calibration.is_some()
    }
}
