//! Names of types, in code and in files.

use super::{Arm, BaseType};

/// All base types with their names in code. Field types are named like their field.
const NAMES: [(&str, BaseType); 18] = [
    ("bool", BaseType::Bool),
    ("num", BaseType::Num),
    ("string", BaseType::String),
    ("dio", BaseType::Dio),
    ("aio", BaseType::Aio),
    ("sio", BaseType::Sio),
    ("screen", BaseType::Screen),
    ("trsf", BaseType::Trsf),
    ("frame", BaseType::Frame),
    ("tool", BaseType::Tool),
    ("point", BaseType::Point),
    ("joint", BaseType::Joint),
    ("config", BaseType::Config),
    ("mdesc", BaseType::Mdesc),
    ("blend", BaseType::Blend),
    ("shoulder", BaseType::Shoulder),
    ("elbow", BaseType::Elbow),
    ("wrist", BaseType::Wrist),
];

impl BaseType {
    /// Name in code: `num`, `joint`.
    #[must_use]
    pub fn name(self) -> &'static str {
        NAMES.iter().find(|(_, ty)| *ty == self).map_or("", |(name, _)| name)
    }

    /// Finds a type by its name in code, among types that a variable can have.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::named(name).filter(|ty| !ty.is_enumeration())
    }

    /// Finds a type by its [`name`](Self::name), among all types.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        NAMES.iter().find(|(known, _)| *known == name).map(|(_, ty)| *ty)
    }

    /// Finds a type by its name in files, with the arm in the name: `jointRx` is `(Joint, Some(SixAxis))`; the generic
    /// `joint` of parameters and locals is `(Joint, None)`.
    #[must_use]
    pub fn from_file_name(name: &str) -> Option<(Self, Option<Arm>)> {
        if let Some(ty) = Self::from_name(name) {
            return Some((ty, None));
        }
        Arm::ALL.into_iter().find_map(|arm| {
            let ty = Self::from_name(name.strip_suffix(arm.suffix())?)?;
            ty.depends_on_arm().then_some((ty, Some(arm)))
        })
    }

    /// Name in a data file of s7 and s8, where `joint`, `point` and `config` have the arm's suffix.
    #[must_use]
    pub fn file_name(self, arm: Arm) -> String {
        let suffix = if self.depends_on_arm() { arm.suffix() } else { "" };
        format!("{}{suffix}", self.name())
    }
}

impl Arm {
    /// All kinds of arms.
    pub const ALL: [Self; 3] = [Self::SixAxis, Self::Scara, Self::Vrb];

    /// Suffix of type names in files: `Rx`, `Rs`, `Vrb`.
    #[must_use]
    pub fn suffix(self) -> &'static str {
        match self {
            Self::SixAxis => "Rx",
            Self::Scara => "Rs",
            Self::Vrb => "Vrb",
        }
    }

    /// Word in the file names of add-on tables: `val3.Velocity.anthro.cfx`.
    #[must_use]
    pub fn table_word(self) -> &'static str {
        match self {
            Self::SixAxis => "anthro",
            Self::Scara => "scara",
            Self::Vrb => "vrb",
        }
    }

    /// Finds an arm by its word in the names of add-on tables, in upper or lower case.
    #[must_use]
    pub fn from_table_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|arm| arm.table_word().eq_ignore_ascii_case(word))
    }

    /// Arm kind by model name, as in `arm.cfx` and `getVersion("ArmType")`: `tx90-S1`, `rs60-S1-D20-L200`. A
    /// model of an unknown series belongs to [`Arm::Vrb`].
    #[must_use]
    pub fn from_model(model: &str) -> Self {
        match model.trim().get(..2).map(str::to_ascii_lowercase).as_deref() {
            Some("rx" | "tx") => Self::SixAxis,
            Some("rs" | "ts" | "tp") => Self::Scara,
            _ => Self::Vrb,
        }
    }

    /// Usual name of this arm kind.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::SixAxis => "six-axis arm",
            Self::Scara => "SCARA arm",
            Self::Vrb => "arm of another kind",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Arm, BaseType, NAMES};

    #[test]
    fn every_type_has_its_name() {
        for (name, ty) in NAMES {
            assert_eq!(ty.name(), name);
        }
        for ty in BaseType::DECLARABLE {
            assert_eq!(BaseType::from_name(ty.name()), Some(ty));
        }
    }

    #[test]
    fn models_have_a_kind_of_arm() {
        assert_eq!(Arm::from_model("tx200-S3"), Arm::SixAxis);
        assert_eq!(Arm::from_model("TS2-60"), Arm::Scara);
        assert_eq!(Arm::from_model("é"), Arm::Vrb);
    }

    #[test]
    fn file_names_carry_the_arm() {
        assert_eq!(BaseType::from_file_name("jointRx"), Some((BaseType::Joint, Some(Arm::SixAxis))));
        assert_eq!(BaseType::from_file_name("configVrb"), Some((BaseType::Config, Some(Arm::Vrb))));
        assert_eq!(BaseType::from_file_name("point"), Some((BaseType::Point, None)));
        assert_eq!(BaseType::from_file_name("numRx"), None);
        assert_eq!(BaseType::from_file_name("blend"), None);
        assert_eq!(BaseType::Point.file_name(Arm::Scara), "pointRs");
        assert_eq!(BaseType::Trsf.file_name(Arm::Scara), "trsf");
    }
}
