//! Spelling of values in files: the attributes of a `Value` element (s7, s8).
//!
//! The attributes of a structured type are its innermost fields: a point has `x` for `trsf.x` and `shoulder` for
//! `config.shoulder`. A file omits an attribute with its default value.

use super::{Arm, BaseType, DefaultValue};

/// An attribute of a `Value` element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValueAttribute {
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

impl ValueAttribute {
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
            ValueAttribute::number("x", concat!($prefix, "x"), 0.0),
            ValueAttribute::number("y", concat!($prefix, "y"), 0.0),
            ValueAttribute::number("z", concat!($prefix, "z"), 0.0),
            ValueAttribute::number("rx", concat!($prefix, "rx"), 0.0),
            ValueAttribute::number("ry", concat!($prefix, "ry"), 0.0),
            ValueAttribute::number("rz", concat!($prefix, "rz"), 0.0),
            $($rest),*
        ]
    };
}

static BOOL: [ValueAttribute; 1] = [ValueAttribute::itself(AttributeValue::Truth, DefaultValue::False)];
static NUM: [ValueAttribute; 1] = [ValueAttribute::itself(AttributeValue::Number, DefaultValue::Number(0.0))];
static STRING: [ValueAttribute; 1] = [ValueAttribute::itself(AttributeValue::Text, DefaultValue::EmptyText)];
static LINKABLE: [ValueAttribute; 1] = [ValueAttribute::link("link", "")];
static TRSF: [ValueAttribute; 6] = place!("");
static FRAME: [ValueAttribute; 7] = place!("trsf.", ValueAttribute::father(BaseType::Frame));
static TOOL: [ValueAttribute; 10] = place!(
    "trsf.",
    ValueAttribute::father(BaseType::Tool),
    ValueAttribute::link("ioLink", "gripper"),
    ValueAttribute::number("ioOpen", "otime", 0.0),
    ValueAttribute::number("ioClose", "ctime", 0.0)
);
static POINT_SIX_AXIS: [ValueAttribute; 10] = place!(
    "trsf.",
    ValueAttribute::choice("shoulder", "config.shoulder", BaseType::Shoulder, "ssame"),
    ValueAttribute::choice("elbow", "config.elbow", BaseType::Elbow, "esame"),
    ValueAttribute::choice("wrist", "config.wrist", BaseType::Wrist, "wsame"),
    ValueAttribute::father(BaseType::Frame)
);
static POINT_SCARA: [ValueAttribute; 8] = place!(
    "trsf.",
    ValueAttribute::choice("shoulder", "config.shoulder", BaseType::Shoulder, "ssame"),
    ValueAttribute::father(BaseType::Frame)
);
static JOINT_SIX_AXIS: [ValueAttribute; 6] = [
    ValueAttribute::number("j1", "j1", 0.0),
    ValueAttribute::number("j2", "j2", 0.0),
    ValueAttribute::number("j3", "j3", 0.0),
    ValueAttribute::number("j4", "j4", 0.0),
    ValueAttribute::number("j5", "j5", 0.0),
    ValueAttribute::number("j6", "j6", 0.0),
];
static JOINT_SCARA: [ValueAttribute; 4] = [
    ValueAttribute::number("j1", "j1", 0.0),
    ValueAttribute::number("j2", "j2", 0.0),
    ValueAttribute::number("j3", "j3", 0.0),
    ValueAttribute::number("j4", "j4", 0.0),
];
static CONFIG_SIX_AXIS: [ValueAttribute; 3] = [
    ValueAttribute::choice("shoulder", "shoulder", BaseType::Shoulder, "ssame"),
    ValueAttribute::choice("elbow", "elbow", BaseType::Elbow, "esame"),
    ValueAttribute::choice("wrist", "wrist", BaseType::Wrist, "wsame"),
];
static CONFIG_SCARA: [ValueAttribute; 1] =
    [ValueAttribute::choice("shoulder", "shoulder", BaseType::Shoulder, "ssame")];
static MDESC: [ValueAttribute; 8] = [
    ValueAttribute::number("accel", "accel", 100.0),
    ValueAttribute::number("vel", "vel", 100.0),
    ValueAttribute::number("decel", "decel", 100.0),
    ValueAttribute::number("tmax", "tvel", 99999.0),
    ValueAttribute::number("rmax", "rvel", 99999.0),
    ValueAttribute::choice("blend", "blend", BaseType::Blend, "joint"),
    ValueAttribute::number("leave", "leave", 50.0),
    ValueAttribute::number("reach", "reach", 50.0),
];

/// Attributes of a value with this type, in file order.
///
/// Empty for `screen`, which has no value in files, and for the field types. An unknown arm or an arm of another kind
/// counts as six-axis.
#[must_use]
pub fn attributes(ty: BaseType, arm: Option<Arm>) -> &'static [ValueAttribute] {
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
pub fn attribute(ty: BaseType, arm: Option<Arm>, name: &str) -> Option<&'static ValueAttribute> {
    attributes(ty, arm).iter().find(|attribute| attribute.name == name)
}

/// Finds an attribute of this type by the name that it has elsewhere: in code, or in files of s5 and s6.
#[must_use]
pub fn attribute_named_elsewhere(ty: BaseType, arm: Option<Arm>, name: &str) -> Option<&'static ValueAttribute> {
    attributes(ty, arm).iter().find(|attribute| attribute.field == name || attribute.old_name() == name)
}

#[cfg(test)]
mod tests {
    use super::{Arm, AttributeValue, BaseType, ValueAttribute, attribute, attribute_named_elsewhere, attributes};
    use crate::types::field;

    fn type_of(ty: BaseType, arm: Option<Arm>, path: &str) -> Option<BaseType> {
        path.split('.').try_fold(ty, |ty, name| field(ty, arm, name).map(|field| field.ty))
    }

    fn suits(attribute: &ValueAttribute, ty: BaseType) -> bool {
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
        let name = |ty, elsewhere| attribute_named_elsewhere(ty, None, elsewhere).map(|found| found.name);
        assert_eq!(name(BaseType::Mdesc, "tvel"), Some("tmax"));
        assert_eq!(name(BaseType::Tool, "gripper"), Some("ioLink"));
        assert_eq!(name(BaseType::Tool, "open"), Some("ioOpen"));
        assert_eq!(name(BaseType::Tool, "trsf"), None);
    }
}
