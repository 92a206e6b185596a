//! Spelling of values in files: the attributes of a `Value` element (s7, s8).
//!
//! The attributes of a structured type are its innermost fields: a point has `x` for `trsf.x` and `shoulder` for
//! `config.shoulder`. A file omits an attribute with its default value.

use super::{Arm, BaseType, DefaultValue};

/// An attribute of a `Value` element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attribute {
    /// Name in the file: `tmax`, `ioLink`.
    pub name: &'static str,
    /// Field that the attribute sets, as written in code after the variable: `tvel`, `trsf.x`. Empty if the attribute
    /// sets the value itself or its father.
    pub field: &'static str,
    /// Content.
    pub value: AttributeValue,
    /// Meaning if the attribute is missing.
    pub default: DefaultValue,
}

/// Attribute content.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AttributeValue {
    /// `true` or `false`.
    Truth,
    /// A decimal number.
    Number,
    /// Any text.
    Text,
    /// The path of a physical input, output or line: `BasicIO-1\%I0`.
    Link,
    /// An enumerator of the type in file spelling: `cartesian`.
    Choice(BaseType),
    /// The father of the value: a variable of this type, with an index or key: `fTray[0]`.
    Father(BaseType),
}

impl Attribute {
    /// Name in files of s5 and s6.
    #[must_use]
    pub fn old_name(&self) -> &'static str {
        match self.name {
            "ioOpen" => "open",
            "ioClose" => "close",
            name => name,
        }
    }

    const fn number(name: &'static str, field: &'static str, default: f64) -> Self {
        Self { name, field, value: AttributeValue::Number, default: DefaultValue::Number(default) }
    }

    const fn choice(name: &'static str, field: &'static str, ty: BaseType, default: &'static str) -> Self {
        Self { name, field, value: AttributeValue::Choice(ty), default: DefaultValue::Enumerator(default) }
    }

    const fn link(name: &'static str, field: &'static str) -> Self {
        Self { name, field, value: AttributeValue::Link, default: DefaultValue::Unlinked }
    }

    const fn father(ty: BaseType) -> Self {
        Self { name: "fatherId", field: "", value: AttributeValue::Father(ty), default: DefaultValue::Unlinked }
    }

    const fn itself(value: AttributeValue, default: DefaultValue) -> Self {
        Self { name: "value", field: "", value, default }
    }
}

/// The six numbers of a transformation, followed by other attributes.
macro_rules! place {
    ($prefix:literal $(, $rest:expr)*) => {
        [
            Attribute::number("x", concat!($prefix, "x"), 0.0),
            Attribute::number("y", concat!($prefix, "y"), 0.0),
            Attribute::number("z", concat!($prefix, "z"), 0.0),
            Attribute::number("rx", concat!($prefix, "rx"), 0.0),
            Attribute::number("ry", concat!($prefix, "ry"), 0.0),
            Attribute::number("rz", concat!($prefix, "rz"), 0.0),
            $($rest),*
        ]
    };
}

static BOOL: [Attribute; 1] = [Attribute::itself(AttributeValue::Truth, DefaultValue::False)];
static NUM: [Attribute; 1] = [Attribute::itself(AttributeValue::Number, DefaultValue::Number(0.0))];
static STRING: [Attribute; 1] = [Attribute::itself(AttributeValue::Text, DefaultValue::EmptyText)];
static LINKABLE: [Attribute; 1] = [Attribute::link("link", "")];
static TRSF: [Attribute; 6] = place!("");
static FRAME: [Attribute; 7] = place!("trsf.", Attribute::father(BaseType::Frame));
static TOOL: [Attribute; 10] = place!(
    "trsf.",
    Attribute::father(BaseType::Tool),
    Attribute::link("ioLink", "gripper"),
    Attribute::number("ioOpen", "otime", 0.0),
    Attribute::number("ioClose", "ctime", 0.0)
);
static POINT_SIX_AXIS: [Attribute; 10] = place!(
    "trsf.",
    Attribute::choice("shoulder", "config.shoulder", BaseType::Shoulder, "ssame"),
    Attribute::choice("elbow", "config.elbow", BaseType::Elbow, "esame"),
    Attribute::choice("wrist", "config.wrist", BaseType::Wrist, "wsame"),
    Attribute::father(BaseType::Frame)
);
static POINT_SCARA: [Attribute; 8] = place!(
    "trsf.",
    Attribute::choice("shoulder", "config.shoulder", BaseType::Shoulder, "ssame"),
    Attribute::father(BaseType::Frame)
);
static JOINT_SIX_AXIS: [Attribute; 6] = [
    Attribute::number("j1", "j1", 0.0),
    Attribute::number("j2", "j2", 0.0),
    Attribute::number("j3", "j3", 0.0),
    Attribute::number("j4", "j4", 0.0),
    Attribute::number("j5", "j5", 0.0),
    Attribute::number("j6", "j6", 0.0),
];
static JOINT_SCARA: [Attribute; 4] = [
    Attribute::number("j1", "j1", 0.0),
    Attribute::number("j2", "j2", 0.0),
    Attribute::number("j3", "j3", 0.0),
    Attribute::number("j4", "j4", 0.0),
];
static CONFIG_SIX_AXIS: [Attribute; 3] = [
    Attribute::choice("shoulder", "shoulder", BaseType::Shoulder, "ssame"),
    Attribute::choice("elbow", "elbow", BaseType::Elbow, "esame"),
    Attribute::choice("wrist", "wrist", BaseType::Wrist, "wsame"),
];
static CONFIG_SCARA: [Attribute; 1] = [Attribute::choice("shoulder", "shoulder", BaseType::Shoulder, "ssame")];
static MDESC: [Attribute; 8] = [
    Attribute::number("accel", "accel", 100.0),
    Attribute::number("vel", "vel", 100.0),
    Attribute::number("decel", "decel", 100.0),
    Attribute::number("tmax", "tvel", 99999.0),
    Attribute::number("rmax", "rvel", 99999.0),
    Attribute::choice("blend", "blend", BaseType::Blend, "joint"),
    Attribute::number("leave", "leave", 50.0),
    Attribute::number("reach", "reach", 50.0),
];

/// Attributes of a value with this type, in file order.
///
/// Empty for `screen`, which has no value in files, and for the field types. An unknown arm or an arm of another kind
/// counts as six-axis.
#[must_use]
pub fn attributes(ty: BaseType, arm: Option<Arm>) -> &'static [Attribute] {
    let scara = arm == Some(Arm::Scara);
    match ty {
        BaseType::Bool => &BOOL,
        BaseType::Num => &NUM,
        BaseType::String => &STRING,
        BaseType::Dio | BaseType::Aio | BaseType::Sio => &LINKABLE,
        BaseType::Trsf => &TRSF,
        BaseType::Frame => &FRAME,
        BaseType::Tool => &TOOL,
        BaseType::Point if scara => &POINT_SCARA,
        BaseType::Point => &POINT_SIX_AXIS,
        BaseType::Joint if scara => &JOINT_SCARA,
        BaseType::Joint => &JOINT_SIX_AXIS,
        BaseType::Config if scara => &CONFIG_SCARA,
        BaseType::Config => &CONFIG_SIX_AXIS,
        BaseType::Mdesc => &MDESC,
        BaseType::Screen | BaseType::Blend | BaseType::Shoulder | BaseType::Elbow | BaseType::Wrist => &[],
    }
}

/// Finds an attribute of this type by name.
#[must_use]
pub fn attribute(ty: BaseType, arm: Option<Arm>, name: &str) -> Option<&'static Attribute> {
    attributes(ty, arm).iter().find(|attribute| attribute.name == name)
}

#[cfg(test)]
mod tests {
    use super::{Arm, Attribute, AttributeValue, BaseType, attribute, attributes};
    use crate::types::field;

    fn type_of(ty: BaseType, arm: Option<Arm>, path: &str) -> Option<BaseType> {
        path.split('.').try_fold(ty, |ty, name| field(ty, arm, name).map(|field| field.ty))
    }

    fn suits(attribute: &Attribute, ty: BaseType) -> bool {
        match attribute.value {
            AttributeValue::Number => ty == BaseType::Num,
            AttributeValue::Choice(choice) => ty == choice,
            AttributeValue::Link => ty.is_linkable(),
            _ => false,
        }
    }

    #[test]
    fn every_path_leads_to_a_field_of_its_type() {
        for ty in BaseType::DECLARABLE {
            for arm in [None, Some(Arm::Scara)] {
                for attribute in attributes(ty, arm).iter().filter(|attribute| !attribute.field.is_empty()) {
                    let found = type_of(ty, arm, attribute.field);
                    assert!(found.is_some_and(|found| suits(attribute, found)), "{ty:?} {}", attribute.name);
                }
            }
        }
    }

    #[test]
    fn files_and_code_differ() {
        let field = |ty, name| attribute(ty, None, name).map(|found| found.field);
        assert_eq!(field(BaseType::Mdesc, "tmax"), Some("tvel"));
        assert_eq!(field(BaseType::Tool, "ioClose"), Some("ctime"));
        assert_eq!(field(BaseType::Point, "wrist"), Some("config.wrist"));
        assert_eq!(field(BaseType::Mdesc, "tvel"), None);
    }
}
