//! Run-time types: the type of a container's values, and their defaults.

use std::sync::Arc;

use super::{ContainerShape, Lanes, LinkPlace};
use crate::types::{Arm, BaseType, DefaultValue, Field, fields};
use crate::values::Text;
use crate::{enumerations, types};

/// A run-time type.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueType {
    /// Built-in or user type.
    pub base: KindBase,
    /// Lanes per value.
    pub size: Lanes,
    /// Fields of a user type, ordered like the parts.
    pub fields: Vec<FieldKind>,
    /// Default value for `insert`, `append`, `resize` and new locals.
    pub default: DetachedValue,
}

/// Built-in or user type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum KindBase {
    /// A built-in type; positions belong to an arm.
    Builtin(BaseType, Option<Arm>),
    /// A user type, by its name in the compiled project.
    User(String),
}

/// A field of a user type, which is a container (7.1).
#[derive(Debug, Clone, PartialEq)]
pub struct FieldKind {
    /// Name.
    pub name: String,
    /// Initial values.
    pub init: PartInit,
}

impl FieldKind {
    fn suits(&self, other: &Self) -> bool {
        let has_same_dims = match (&self.init.shape, &other.init.shape) {
            (ContainerShape::Array { dims, .. }, ContainerShape::Array { dims: others, .. }) => dims == others,
            (ContainerShape::Collection(_), ContainerShape::Collection(_)) => true,
            _ => false,
        };
        self.name == other.name && has_same_dims && self.init.kind.suits(&other.init.kind)
    }
}

/// Initial values of a container.
#[derive(Debug, Clone, PartialEq)]
pub struct PartInit {
    /// Type of the values.
    pub kind: Arc<ValueType>,
    /// Sizes, or keys in the order of the values.
    pub shape: ContainerShape,
    /// Values; missing values have the default of the type.
    pub values: Vec<Option<DetachedValue>>,
}

/// A value outside of a container.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DetachedValue {
    /// Numbers.
    pub nums: Vec<f64>,
    /// Strings.
    pub texts: Vec<Text>,
    /// Links.
    pub links: Vec<LinkPlace>,
    /// Inner containers, if the value has a user type and differs from the default.
    pub parts: Vec<PartInit>,
}

impl ValueType {
    /// Creates a built-in type.
    #[must_use]
    pub fn builtin(base: BaseType, arm: Option<Arm>) -> Self {
        let default = default_of(base, arm);
        Self { base: KindBase::Builtin(base, arm), size: lanes(base), fields: Vec::new(), default }
    }

    /// Creates a user type with these fields.
    #[must_use]
    pub fn user(name: String, fields: Vec<FieldKind>) -> Self {
        let parts: Vec<PartInit> = fields.iter().map(|field| field.init.clone()).collect();
        let size = Lanes { part: u32::try_from(fields.len()).unwrap_or(u32::MAX), ..Lanes::default() };
        Self { base: KindBase::User(name), size, fields, default: DetachedValue { parts, ..DetachedValue::default() } }
    }

    /// Whether a value of one type can be copied to a value of the other: both are the same built-in type, or user
    /// types with the same fields.
    ///
    /// An application and its library may use different names for a user type, so only the fields are compared.
    #[must_use]
    pub fn suits(&self, other: &Self) -> bool {
        match (&self.base, &other.base) {
            (KindBase::Builtin(base, arm), KindBase::Builtin(other, of)) => {
                base == other && arm.zip(*of).is_none_or(|(arm, of)| arm == of)
            }
            (KindBase::User(_), KindBase::User(_)) => {
                self.fields.len() == other.fields.len()
                    && self.fields.iter().zip(&other.fields).all(|(field, other)| field.suits(other))
            }
            _ => false,
        }
    }

    /// Built-in type; `None` for a user type.
    #[must_use]
    pub fn base_type(&self) -> Option<BaseType> {
        match self.base {
            KindBase::Builtin(base, _) => Some(base),
            KindBase::User(_) => None,
        }
    }
}

/// Lanes of a built-in type's value. A joint always has six numbers and a configuration three; the numbers of missing
/// axes stay 0.
const fn lanes(base: BaseType) -> Lanes {
    let (num, text, link) = match base {
        BaseType::Bool | BaseType::Num => (1, 0, 0),
        BaseType::Blend | BaseType::Shoulder | BaseType::Elbow | BaseType::Wrist => (1, 0, 0),
        BaseType::String => (0, 1, 0),
        BaseType::Dio | BaseType::Aio | BaseType::Sio | BaseType::Screen => (0, 0, 1),
        BaseType::Trsf | BaseType::Joint => (6, 0, 0),
        BaseType::Frame => (6, 0, 1),
        // Opening and closing times; links to the father tool and the gripper output.
        BaseType::Tool => (8, 0, 2),
        BaseType::Point => (9, 0, 1),
        BaseType::Config => (3, 0, 0),
        BaseType::Mdesc => (8, 0, 0),
    };
    Lanes { num, text, link, part: 0 }
}

/// Lanes before a field in a value of a built-in type.
///
/// The father of a frame, tool or point is its first link, so a tool's gripper is the second link.
#[must_use]
pub fn field_offset(base: BaseType, arm: Option<Arm>, name: &str) -> Option<Lanes> {
    let field = types::field(base, arm, name)?;
    let before = fields(base, arm).iter().take_while(|other| other.name != name);
    let mut offset = before.fold(Lanes::default(), |sum, field| Lanes { link: 0, ..sum + lanes(field.ty) });
    if base == BaseType::Tool && field.ty == BaseType::Dio {
        offset.link = 1;
    }
    Some(offset)
}

/// Lanes before the field at the end of a path such as `trsf.x`; zero for the empty path.
#[must_use]
pub fn path_offset(base: BaseType, arm: Option<Arm>, path: &str) -> Option<Lanes> {
    let mut names = path.split('.').filter(|name| !name.is_empty());
    let found = names.try_fold((base, Lanes::default()), |(base, offset), name| {
        Some((types::field(base, arm, name)?.ty, offset + field_offset(base, arm, name)?))
    });
    found.map(|(_, offset)| offset)
}

fn default_of(base: BaseType, arm: Option<Arm>) -> DetachedValue {
    let size = lanes(base);
    let mut nums = Vec::new();
    numbers(base, arm, &mut nums);
    nums.resize(size.num as usize, 0.0);
    DetachedValue {
        nums,
        texts: vec![Text::default(); size.text as usize],
        links: vec![LinkPlace::None; size.link as usize],
        parts: Vec::new(),
    }
}

fn numbers(base: BaseType, arm: Option<Arm>, nums: &mut Vec<f64>) {
    let fields: &[Field] = fields(base, arm);
    for field in fields {
        match field.default {
            DefaultValue::Number(number) => nums.push(number),
            DefaultValue::Enumerator(name) => nums.push(enumerator(name)),
            DefaultValue::OfFields => numbers(field.ty, arm, nums),
            DefaultValue::False => nums.push(0.0),
            DefaultValue::EmptyText | DefaultValue::Unlinked => {}
        }
    }
}

/// Enumerator number: its index in its type.
#[must_use]
pub fn enumerator(name: &str) -> f64 {
    let Some(found) = enumerations::find(name) else { return 0.0 };
    let mut values = enumerations::values(found.ty);
    values.position(|value| value == found).and_then(|at| u32::try_from(at).ok()).map_or(0.0, f64::from)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::{BaseType, FieldKind, PartInit, ValueType, enumerator, field_offset};
    use crate::memory::{ContainerShape, Lanes};
    use crate::types::Arm;

    #[test]
    fn defaults_are_those_of_the_manual() {
        let default = |base| ValueType::builtin(base, None).default.nums;
        assert_eq!(default(BaseType::Mdesc), [100.0, 100.0, 100.0, 9999.0, 9999.0, enumerator("joint"), 50.0, 50.0]);
        assert_eq!(default(BaseType::Point).len(), 9);
        assert_eq!(default(BaseType::Num), [0.0]);
    }

    #[test]
    fn fields_follow_each_other() {
        let offset = |base, name| field_offset(base, None, name);
        assert_eq!(offset(BaseType::Trsf, "rz"), Some(Lanes::nums(5)));
        assert_eq!(offset(BaseType::Point, "config"), Some(Lanes::nums(6)));
        assert_eq!(offset(BaseType::Tool, "otime"), Some(Lanes::nums(6)));
        assert_eq!(offset(BaseType::Tool, "gripper").map(|lanes| lanes.link), Some(1));
        assert_eq!(offset(BaseType::Trsf, "w"), None);
    }

    #[test]
    fn each_lane_has_a_default() {
        for base in BaseType::DECLARABLE {
            let kind = ValueType::builtin(base, None);
            assert_eq!(kind.default.nums.len(), kind.size.num as usize, "{base:?}");
        }
    }

    #[test]
    fn values_with_the_same_layout_can_be_copied() {
        let part = user("Part", "nCount", BaseType::Num, ContainerShape::array(1));
        assert!(part.suits(&user("bolt", "nCount", BaseType::Num, ContainerShape::array(5))));
        assert!(!part.suits(&user("Part", "nOther", BaseType::Num, ContainerShape::array(1))));
        assert!(!part.suits(&user("Part", "nCount", BaseType::Bool, ContainerShape::array(1))));
        assert!(!part.suits(&user("Part", "nCount", BaseType::Num, ContainerShape::Collection(Default::default()))));
        assert!(!part.suits(&ValueType::builtin(BaseType::Num, None)));
        let joint = |arm| ValueType::builtin(BaseType::Joint, arm);
        assert!(joint(None).suits(&joint(Some(Arm::Scara))));
        assert!(!joint(Some(Arm::SixAxis)).suits(&joint(Some(Arm::Scara))));
    }

    /// A user type with one field.
    fn user(name: &str, field: &str, base: BaseType, shape: ContainerShape) -> ValueType {
        let init = PartInit { kind: Arc::new(ValueType::builtin(base, None)), shape, values: Vec::new() };
        ValueType::user(name.to_owned(), vec![FieldKind { name: field.to_owned(), init }])
    }
}
