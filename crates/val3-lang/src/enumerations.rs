//! Names of enumeration values: the enumerators of `mdesc.blend` and of the `config` fields (9.7.2, 10.5.1).

use val3_moves::BlendKind;

use crate::types::BaseType;

/// An enumeration value.
#[derive(Debug, PartialEq, Eq)]
pub struct Enumerator {
    /// Spelling in code.
    pub name: &'static str,
    /// Spelling in files.
    pub file_name: &'static str,
    /// Field type of the value.
    pub ty: BaseType,
    /// Meaning, in one line.
    pub doc: &'static str,
}

const fn row(name: &'static str, ty: BaseType, doc: &'static str) -> Enumerator {
    Enumerator { name, file_name: name, ty, doc }
}

/// All enumerators. The first enumerator of a type is its default.
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

/// Finds an enumerator by its name in code. Code may also use the file spelling `cartesian`.
#[must_use]
pub fn find(name: &str) -> Option<&'static Enumerator> {
    ENUMERATORS.iter().find(|row| row.name == name || row.file_name == name)
}

/// Values of a field type, default first.
pub fn values(ty: BaseType) -> impl Iterator<Item = &'static Enumerator> {
    ENUMERATORS.iter().filter(move |row| row.ty == ty)
}

/// Finds the value of a field type by its name in files, in upper or lower case.
#[must_use]
pub fn find_in_file(ty: BaseType, name: &str) -> Option<&'static Enumerator> {
    values(ty).find(|row| row.file_name.eq_ignore_ascii_case(name))
}

/// Blend kind with this number in memory, which is the enumerator's position. Other numbers are the default.
#[must_use]
pub const fn blend_of(number: f64) -> BlendKind {
    match number {
        1.0 => BlendKind::Off,
        2.0 => BlendKind::Cartesian,
        _ => BlendKind::Joint,
    }
}

/// Number of a blend's kind in memory.
#[must_use]
pub const fn blend_number(kind: BlendKind) -> f64 {
    match kind {
        BlendKind::Joint => 0.0,
        BlendKind::Off => 1.0,
        BlendKind::Cartesian => 2.0,
    }
}

/// Name of a blend's kind in code.
#[must_use]
pub const fn blend_name(kind: BlendKind) -> &'static str {
    match kind {
        BlendKind::Joint => "joint",
        BlendKind::Off => "off",
        BlendKind::Cartesian => "Cartesian",
    }
}

#[cfg(test)]
mod tests {
    use super::{BaseType, BlendKind, blend_name, blend_number, blend_of, find, find_in_file, values};

    #[test]
    fn cartesian_has_two_spellings() {
        assert_eq!(find("Cartesian"), find("cartesian"));
        assert_eq!(find_in_file(BaseType::Blend, "cartesian").map(|row| row.name), Some("Cartesian"));
        assert_eq!(find_in_file(BaseType::Blend, "ssame"), None);
    }

    #[test]
    fn blends_have_the_numbers_and_names_of_their_enumerators() {
        let rows: Vec<&str> = values(BaseType::Blend).map(|row| row.name).collect();
        let kinds = [BlendKind::Joint, BlendKind::Off, BlendKind::Cartesian];
        assert_eq!(kinds.map(blend_name).to_vec(), rows);
        for (number, kind) in [0.0, 1.0, 2.0].into_iter().zip(kinds) {
            assert_eq!((blend_number(kind), blend_of(number)), (number, kind));
        }
        assert_eq!([-1.0, 0.5, 3.0, f64::NAN].map(blend_of), [BlendKind::Joint; 4]);
    }

    #[test]
    fn every_enumeration_has_values() {
        let count = |ty| values(ty).count();
        assert_eq!(count(BaseType::Blend), 3);
        assert!([BaseType::Shoulder, BaseType::Elbow, BaseType::Wrist].into_iter().all(|ty| count(ty) == 4));
        assert_eq!(count(BaseType::Num), 0);
    }
}
