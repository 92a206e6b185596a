//! Names that are values: the enumerators of `mdesc.blend` and of the fields of `config` (9.7.2, 10.5.1).

use crate::types::BaseType;

/// One value of an enumeration.
#[derive(Debug, PartialEq, Eq)]
pub struct Enumerator {
    /// As code spells it.
    pub name: &'static str,
    /// As files spell it.
    pub file_name: &'static str,
    /// The field type it belongs to.
    pub ty: BaseType,
    /// Its meaning, in one line.
    pub doc: &'static str,
}

const fn row(name: &'static str, ty: BaseType, doc: &'static str) -> Enumerator {
    Enumerator { name, file_name: name, ty, doc }
}

/// Every enumerator. The first one of a type is its default.
pub static ENUMERATORS: [Enumerator; 15] = [
    row("joint", BaseType::Blend, "Rounds the corner with a joint move: fast, free in shape."),
    row("off", BaseType::Blend, "Stops at the target."),
    Enumerator {
        name: "Cartesian",
        file_name: "cartesian",
        ty: BaseType::Blend,
        doc: "Rounds the corner with a curve in space: controlled speed and shape.",
    },
    row("ssame", BaseType::Shoulder, "The shoulder stays on the side on which it starts."),
    row("sfree", BaseType::Shoulder, "The shoulder may end on either side."),
    row("lefty", BaseType::Shoulder, "The arm stands on the left of the point."),
    row("righty", BaseType::Shoulder, "The arm stands on the right of the point."),
    row("esame", BaseType::Elbow, "The elbow keeps the sign with which it starts."),
    row("efree", BaseType::Elbow, "The elbow may end with either sign."),
    row("epositive", BaseType::Elbow, "The elbow ends with j3 at 0 or above."),
    row("enegative", BaseType::Elbow, "The elbow ends with j3 below 0."),
    row("wsame", BaseType::Wrist, "The wrist keeps the sign with which it starts."),
    row("wfree", BaseType::Wrist, "The wrist may end with either sign."),
    row("wpositive", BaseType::Wrist, "The wrist ends with j5 at 0 or above."),
    row("wnegative", BaseType::Wrist, "The wrist ends with j5 below 0."),
];

/// The enumerator that code calls `name`. Code may also write `cartesian` as files do.
#[must_use]
pub fn find(name: &str) -> Option<&'static Enumerator> {
    ENUMERATORS.iter().find(|row| row.name == name || row.file_name == name)
}

/// The values of a field type, its default first.
pub fn values(ty: BaseType) -> impl Iterator<Item = &'static Enumerator> {
    ENUMERATORS.iter().filter(move |row| row.ty == ty)
}

/// The value of a field type that a file calls `name`, in any letter case.
#[must_use]
pub fn find_in_file(ty: BaseType, name: &str) -> Option<&'static Enumerator> {
    values(ty).find(|row| row.file_name.eq_ignore_ascii_case(name))
}

#[cfg(test)]
mod tests {
    use super::{BaseType, find, find_in_file, values};

    #[test]
    fn cartesian_has_two_spellings() {
        assert_eq!(find("Cartesian"), find("cartesian"));
        assert_eq!(find_in_file(BaseType::Blend, "cartesian").map(|row| row.name), Some("Cartesian"));
        assert_eq!(find_in_file(BaseType::Blend, "ssame"), None);
    }

    #[test]
    fn every_enumeration_has_values() {
        let count = |ty| values(ty).count();
        assert_eq!(count(BaseType::Blend), 3);
        assert!([BaseType::Shoulder, BaseType::Elbow, BaseType::Wrist].into_iter().all(|ty| count(ty) == 4));
        assert_eq!(count(BaseType::Num), 0);
    }
}
