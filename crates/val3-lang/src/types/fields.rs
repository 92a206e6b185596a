//! Fields of the structured types, in the order of the values in `{…}`.

use super::{Arm, BaseType};

/// A field of a structured type.
#[derive(Debug, PartialEq)]
pub struct Field {
    /// Name in code: `pA.trsf` has the field `trsf`.
    pub name: &'static str,
    /// Type.
    pub ty: BaseType,
    /// Unit of the numbers.
    pub unit: NumberUnit,
    /// Value in a variable that the program creates. The default in files may differ:
    /// [`ValueAttribute::default`](super::ValueAttribute::default).
    pub default: DefaultValue,
    /// Meaning, in one line.
    pub doc: &'static str,
}

/// The unit of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum NumberUnit {
    /// No number, or a number without a unit.
    None,
    /// Millimetres or inches, depending on the application's length unit (2.1.4.1).
    Length,
    /// Degrees.
    Degrees,
    /// Per cent of the arm's nominal value.
    Percent,
    /// Millimetres or inches per second.
    LengthPerSecond,
    /// Degrees per second.
    DegreesPerSecond,
    /// Seconds.
    Seconds,
}

/// The default value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DefaultValue {
    /// `false`.
    False,
    /// A number.
    Number(f64),
    /// The empty string.
    EmptyText,
    /// An enumerator, as spelled in code.
    Enumerator(&'static str),
    /// No link, or no father.
    Unlinked,
    /// Each field has its own default.
    OfFields,
}

const fn field_of(
    name: &'static str,
    ty: BaseType,
    unit: NumberUnit,
    default: DefaultValue,
    doc: &'static str,
) -> Field {
    Field { name, ty, unit, default, doc }
}

const fn number(name: &'static str, unit: NumberUnit, default: f64, doc: &'static str) -> Field {
    field_of(name, BaseType::Num, unit, DefaultValue::Number(default), doc)
}

const fn choice(name: &'static str, ty: BaseType, default: &'static str, doc: &'static str) -> Field {
    field_of(name, ty, NumberUnit::None, DefaultValue::Enumerator(default), doc)
}

const fn part(name: &'static str, ty: BaseType, doc: &'static str) -> Field {
    field_of(name, ty, NumberUnit::None, DefaultValue::OfFields, doc)
}

static TRSF: [Field; 6] = [
    number("x", NumberUnit::Length, 0.0, "Translation along x."),
    number("y", NumberUnit::Length, 0.0, "Translation along y."),
    number("z", NumberUnit::Length, 0.0, "Translation along z."),
    number("rx", NumberUnit::Degrees, 0.0, "First rotation, about x."),
    number("ry", NumberUnit::Degrees, 0.0, "Second rotation, about the y axis that the first one gives."),
    number("rz", NumberUnit::Degrees, 0.0, "Third rotation, about the z axis that the first two give."),
];

static FRAME: [Field; 1] = [part("trsf", BaseType::Trsf, "Position in the reference frame.")];

static TOOL: [Field; 4] = [
    part("trsf", BaseType::Trsf, "Position of the tool centre point in the reference tool."),
    field_of(
        "gripper",
        BaseType::Dio,
        NumberUnit::None,
        DefaultValue::Unlinked,
        "Output that opens and closes the tool; `valve1` unless another one is linked.",
    ),
    number("otime", NumberUnit::Seconds, 0.0, "Time the tool takes to open."),
    number("ctime", NumberUnit::Seconds, 0.0, "Time the tool takes to close."),
];

static POINT: [Field; 2] = [
    part("trsf", BaseType::Trsf, "Position in the reference frame."),
    part("config", BaseType::Config, "Arm configuration in which the position is to be reached."),
];

static JOINT_SIX_AXIS: [Field; 6] = [
    number("j1", NumberUnit::Degrees, 0.0, "Position of axis 1."),
    number("j2", NumberUnit::Degrees, 0.0, "Position of axis 2."),
    number("j3", NumberUnit::Degrees, 0.0, "Position of axis 3."),
    number("j4", NumberUnit::Degrees, 0.0, "Position of axis 4."),
    number("j5", NumberUnit::Degrees, 0.0, "Position of axis 5."),
    number("j6", NumberUnit::Degrees, 0.0, "Position of axis 6."),
];

static JOINT_SCARA: [Field; 4] = [
    number("j1", NumberUnit::Degrees, 0.0, "Position of axis 1."),
    number("j2", NumberUnit::Degrees, 0.0, "Position of axis 2."),
    number("j3", NumberUnit::Length, 0.0, "Position of axis 3, the linear one."),
    number("j4", NumberUnit::Degrees, 0.0, "Position of axis 4."),
];

static CONFIG_SIX_AXIS: [Field; 3] = [
    choice("shoulder", BaseType::Shoulder, "ssame", "Side on which the shoulder stands."),
    choice("elbow", BaseType::Elbow, "esame", "Sign of the elbow axis j3."),
    choice("wrist", BaseType::Wrist, "wsame", "Sign of the wrist axis j5."),
];

static CONFIG_SCARA: [Field; 1] = [choice("shoulder", BaseType::Shoulder, "ssame", "Side on which the arm stands.")];

static MDESC: [Field; 8] = [
    number("accel", NumberUnit::Percent, 100.0, "Highest joint acceleration."),
    number("vel", NumberUnit::Percent, 100.0, "Highest joint speed."),
    number("decel", NumberUnit::Percent, 100.0, "Highest joint deceleration."),
    number("tvel", NumberUnit::LengthPerSecond, 9999.0, "Highest speed of the tool centre point."),
    number("rvel", NumberUnit::DegreesPerSecond, 9999.0, "Highest turning speed of the tool centre point."),
    choice("blend", BaseType::Blend, "joint", "How the path is rounded at the target."),
    number("leave", NumberUnit::Length, 50.0, "Distance before the target at which blending starts."),
    number("reach", NumberUnit::Length, 50.0, "Distance after the target at which blending ends."),
];

/// Fields of a type, in the order of a `{…}` value; empty for a type without fields.
///
/// `joint` and `config` depend on the arm; an unknown arm or an arm of another kind counts as six-axis.
#[must_use]
pub fn fields(ty: BaseType, arm: Option<Arm>) -> &'static [Field] {
    match (ty, arm) {
        (BaseType::Trsf, _) => &TRSF,
        (BaseType::Frame, _) => &FRAME,
        (BaseType::Tool, _) => &TOOL,
        (BaseType::Point, _) => &POINT,
        (BaseType::Joint, Some(Arm::Scara)) => &JOINT_SCARA,
        (BaseType::Joint, _) => &JOINT_SIX_AXIS,
        (BaseType::Config, Some(Arm::Scara)) => &CONFIG_SCARA,
        (BaseType::Config, _) => &CONFIG_SIX_AXIS,
        (BaseType::Mdesc, _) => &MDESC,
        _ => &[],
    }
}

/// Finds a field of a type by name.
#[must_use]
pub fn field(ty: BaseType, arm: Option<Arm>, name: &str) -> Option<&'static Field> {
    fields(ty, arm).iter().find(|field| field.name == name)
}

#[cfg(test)]
mod tests {
    use super::{Arm, BaseType, DefaultValue, field, fields};
    use crate::enumerations;

    #[test]
    fn joints_depend_on_the_arm() {
        assert_eq!(fields(BaseType::Joint, None).len(), 6);
        assert_eq!(fields(BaseType::Joint, Some(Arm::Scara)).len(), 4);
        assert_eq!(fields(BaseType::Config, Some(Arm::Scara)).len(), 1);
        assert!(field(BaseType::Joint, Some(Arm::Scara), "j5").is_none());
        assert!(fields(BaseType::Num, None).is_empty());
    }

    #[test]
    fn defaults_of_choices_are_enumerators() {
        for ty in BaseType::DECLARABLE {
            for field in fields(ty, None) {
                if let DefaultValue::Enumerator(name) = field.default {
                    assert_eq!(enumerations::find(name).map(|found| found.ty), Some(field.ty));
                }
            }
        }
    }
}
