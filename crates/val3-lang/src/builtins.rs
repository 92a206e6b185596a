//! Names that are defined in every application without a declaration.

use crate::types::BaseType;

/// A built-in variable or constant.
#[derive(Debug, PartialEq, Eq)]
pub struct Builtin {
    /// Name in code.
    pub name: &'static str,
    /// Type.
    pub ty: BaseType,
    /// Whether it is a variable, which can be passed by reference and be the father of data. Otherwise it is a
    /// constant.
    pub is_variable: bool,
    /// Description, in one line.
    pub doc: &'static str,
}

/// Built-in names. Files of s5 and s6 also declare `world` and `flange`.
pub static BUILTINS: [Builtin; 4] = [
    Builtin {
        name: "world",
        ty: BaseType::Frame,
        is_variable: true,
        doc: "The frame from which every other one is reached; it must not be changed (run-time error 161).",
    },
    Builtin {
        name: "flange",
        ty: BaseType::Tool,
        is_variable: true,
        doc: "The mounting face of the arm, from which every tool is reached; it must not be changed (run-time \
              error 160).",
    },
    Builtin { name: "true", ty: BaseType::Bool, is_variable: false, doc: "The logical value true." },
    Builtin { name: "false", ty: BaseType::Bool, is_variable: false, doc: "The logical value false." },
];

/// Finds a built-in by name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Builtin> {
    BUILTINS.iter().find(|builtin| builtin.name == name)
}
