//! Results of instructions that a program should not ignore, and results that are rounded.

/// The meaning of a result that a program should not ignore, in a few words; `None` if the result can be ignored.
#[must_use]
pub fn result_meaning(instruction: &str) -> Option<&'static str> {
    TELLING.iter().find(|(name, _)| *name == instruction).map(|(_, result_meaning)| *result_meaning)
}

/// Whether the result is a number that is rounded after its fourteenth digit (3.2.1).
#[must_use]
pub fn is_rounded(instruction: &str) -> bool {
    ROUNDED.contains(&instruction)
}

/// Instructions whose result is the only sign of a failure (6.6, 6.7, 8.1, 9.2.3, 9.4.4, 9.6.3). `libSave` is not among
/// them: programs use it as a statement, since the application can do little about a full disk.
static TELLING: [(&str, &str); 5] = [
    ("libLoad", "0, or why the library is not loaded"),
    ("libDelete", "0, or why the library is not deleted"),
    ("setFrame", "0, or which point makes no frame"),
    ("pointToJoint", "`false` if the arm cannot reach the point"),
    ("getLatch", "`false` if there is no position"),
];

static ROUNDED: [&str; 13] =
    ["sin", "asin", "cos", "acos", "tan", "atan", "sqrt", "exp", "ln", "log", "distance", "clock", "getSpeed"];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::instructions;

    #[test]
    fn they_are_instructions_with_a_result() {
        for name in TELLING.iter().map(|(name, _)| name).chain(&ROUNDED) {
            let instruction = instructions::find(name).unwrap();
            assert!(instruction.overloads.iter().all(|form| form.result.is_some()), "{name}");
        }
    }

    #[test]
    fn an_angle_is_rounded_and_a_count_is_not() {
        assert!(is_rounded("cos") && !is_rounded("size"));
        assert!(
            result_meaning("setFrame").is_some()
                && result_meaning("movej").is_none()
                && result_meaning("libSave").is_none()
        );
    }
}
