//! The built-in types: their names in code and in files, fields, units and defaults.
//!
//! Manual 2.3, 3, 4.2, 9 and 10.5; files: s5 to s8.

mod attributes;
mod fields;
mod length_unit;
mod names;

pub use attributes::{AttributeValue, ValueAttribute, attribute, attribute_named_elsewhere, attributes};
pub use fields::{DefaultValue, Field, NumberUnit, field, fields};
pub use length_unit::LengthUnit;

/// Kind of an arm's kinematics. Positions for one kind have no meaning for another kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Arm {
    /// Six axes (RX, TX): `jointRx`, `pointRx`, `configRx`; add-on tables `anthro`.
    SixAxis,
    /// Four axes (RS, TS): `jointRs`, `pointRs`, `configRs`; add-on tables `scara`.
    Scara,
    /// Any other arm: `jointVrb`, `pointVrb`, `configVrb`; add-on tables `vrb`.
    Vrb,
}

/// A built-in type, without its container.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum BaseType {
    /// Logical value (3.1).
    Bool,
    /// Number, an IEEE double (3.2).
    Num,
    /// Text of at most 128 bytes (3.4).
    String,
    /// Digital input or output (3.5).
    Dio,
    /// Numerical input or output (3.6).
    Aio,
    /// Serial line or socket (3.7).
    Sio,
    /// Page of the pendant (4.2).
    Screen,
    /// Geometrical transformation (9.3).
    Trsf,
    /// Reference frame (9.4).
    Frame,
    /// Tool on the arm (9.5).
    Tool,
    /// Cartesian position of a tool (9.6).
    Point,
    /// Joint position: one number per axis (9.2).
    Joint,
    /// Arm configuration (9.7).
    Config,
    /// Motion descriptor (10.5).
    Mdesc,
    /// Field type of `mdesc.blend`: `off`, `joint`, `Cartesian`.
    Blend,
    /// Field type of `config.shoulder`.
    Shoulder,
    /// Field type of `config.elbow`.
    Elbow,
    /// Field type of `config.wrist`.
    Wrist,
}

/// Container kind of a variable (2.3.4).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Container {
    /// A single value.
    Element,
    /// Elements with 1, 2 or 3 indexes, from 0.
    Array {
        /// Number of dimensions, 1 to 3.
        dims: u8,
    },
    /// Elements with string keys.
    Collection,
}

impl BaseType {
    /// Types that a variable can have, in the manual's order. The field types of `mdesc` and `config` are not included.
    pub const DECLARABLE: [Self; 14] = [
        Self::Bool,
        Self::Num,
        Self::String,
        Self::Dio,
        Self::Aio,
        Self::Sio,
        Self::Screen,
        Self::Trsf,
        Self::Frame,
        Self::Tool,
        Self::Point,
        Self::Joint,
        Self::Config,
        Self::Mdesc,
    ];

    /// Whether it is a field type whose values are names: `blend`, `shoulder`, `elbow`, `wrist`.
    #[must_use]
    pub fn is_enumeration(self) -> bool {
        matches!(self, Self::Blend | Self::Shoulder | Self::Elbow | Self::Wrist)
    }

    /// Whether variables of the type are linked to a physical input, output or line: `dio`, `aio`, `sio` (3.5 to 3.7).
    #[must_use]
    pub fn is_linkable(self) -> bool {
        matches!(self, Self::Dio | Self::Aio | Self::Sio)
    }

    /// Whether values of the type are relative to another variable: `frame` and `point` to a frame, `tool` to a tool
    /// (9.4 to 9.6).
    #[must_use]
    pub fn has_father(self) -> bool {
        self.father().is_some()
    }

    /// Father type of this type's values.
    #[must_use]
    pub fn father(self) -> Option<Self> {
        match self {
            Self::Frame | Self::Point => Some(Self::Frame),
            Self::Tool => Some(Self::Tool),
            _ => None,
        }
    }

    /// Whether values of the type depend on the arm: `joint`, `point`, `config`.
    #[must_use]
    pub fn depends_on_arm(self) -> bool {
        matches!(self, Self::Joint | Self::Point | Self::Config)
    }

    /// Whether the type has fields (2.3.3), so that its value can be written `{…}`.
    #[must_use]
    pub fn is_structured(self) -> bool {
        !fields(self, None).is_empty()
    }
}
