//! Keywords and other reserved words.
//!
//! Code may use upper and lower case; [`canonical`] is the spelling that controllers write.

use crate::{builtins, enumerations, instructions, types::BaseType};

/// Keywords in canonical spelling.
pub const KEYWORDS: [&str; 28] = [
    "begin",
    "end",
    "call",
    "return",
    "if",
    "elseIf",
    "else",
    "endIf",
    "while",
    "endWhile",
    "do",
    "until",
    "for",
    "to",
    "step",
    "endFor",
    "switch",
    "case",
    "break",
    "default",
    "endSwitch",
    "and",
    "or",
    "xor",
    "true",
    "false",
    TASK_CREATE,
    TASK_CREATE_SYNC,
];

const TASK_CREATE: &str = "taskCreate";
const TASK_CREATE_SYNC: &str = "taskCreateSync";

/// Canonical spelling of a keyword, given in upper or lower case.
#[must_use]
pub fn canonical(word: &str) -> Option<&'static str> {
    KEYWORDS.into_iter().find(|keyword| keyword.eq_ignore_ascii_case(word))
}

/// Whether the instruction creates a task; its arguments have no parentheses and end with the call of a program.
#[must_use]
pub fn is_task_creation(name: &str) -> bool {
    name.eq_ignore_ascii_case(TASK_CREATE) || name.eq_ignore_ascii_case(TASK_CREATE_SYNC)
}

/// Reason why a variable, program or library identifier cannot have a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reserved {
    /// A keyword, in upper or lower case.
    Keyword,
    /// The name of a built-in type.
    Type,
    /// A built-in variable: `world`, `flange`.
    Builtin,
    /// An enumeration value: `off`, `lefty`.
    Enumerator,
    /// A built-in instruction.
    Instruction,
}

/// Returns why `name` is reserved, if it is.
///
/// `joint` and `config` are reserved for several reasons. The first reason in the order of [`Reserved`] is returned.
#[must_use]
pub fn reserved(name: &str) -> Option<Reserved> {
    if canonical(name).is_some() {
        Some(Reserved::Keyword)
    } else if BaseType::from_name(name).is_some() {
        Some(Reserved::Type)
    } else if builtins::find(name).is_some() {
        Some(Reserved::Builtin)
    } else if enumerations::find(name).is_some() {
        Some(Reserved::Enumerator)
    } else {
        instructions::find(name).map(|_| Reserved::Instruction)
    }
}

/// Whether the text is an identifier: letters, digits and underscores, not starting with a digit (2.5.1).
#[must_use]
pub fn is_identifier(name: &str) -> bool {
    let starts_well = name.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_');
    starts_well && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
}

#[cfg(test)]
mod tests {
    use super::{Reserved, canonical, is_identifier, is_task_creation, reserved};

    #[test]
    fn keywords_have_one_spelling() {
        assert_eq!(canonical("ENDIF"), Some("endIf"));
        assert_eq!(canonical("taskcreatesync"), Some("taskCreateSync"));
        assert_eq!(canonical("then"), None);
        assert!(is_task_creation("taskCreate") && !is_task_creation("taskKill"));
    }

    #[test]
    fn words_of_the_language() {
        assert_eq!(reserved("endfor"), Some(Reserved::Keyword));
        assert_eq!(reserved("joint"), Some(Reserved::Type));
        assert_eq!(reserved("world"), Some(Reserved::Builtin));
        assert_eq!(reserved("wfree"), Some(Reserved::Enumerator));
        assert_eq!(reserved("movej"), Some(Reserved::Instruction));
        assert_eq!(reserved("Movej"), None);
        assert_eq!(reserved("nCount"), None);
    }

    #[test]
    fn identifiers() {
        assert!(is_identifier("nA_1") && is_identifier("_control"));
        assert!(!is_identifier("") && !is_identifier("1a") && !is_identifier("a-b") && !is_identifier("é"));
    }
}
