//! Results of instructions: those that a program should not ignore, the possible numbers, and rounded results.

use crate::library_errors::LIBRARY_ERRORS;

/// Meaning of a result that a program should not ignore, in a few words; `None` if the result can be ignored.
#[must_use]
pub fn result_meaning(instruction: &str) -> Option<&'static str> {
    MEANINGS.iter().find(|(name, _)| *name == instruction).map(|(_, result_meaning)| *result_meaning)
}

/// Numbers that an instruction can return, ascending; empty if the numbers are not listed. `taskStatus` also returns
/// numbers of run-time errors.
#[must_use]
pub fn result_codes(instruction: &str) -> Vec<i16> {
    if LIBRARY_CODES.contains(&instruction) {
        return LIBRARY_ERRORS.iter().filter_map(|row| row.number.try_into().ok()).collect();
    }
    let codes = CODES.iter().find(|(name, ..)| *name == instruction);
    codes.map(|(_, first, last)| (*first..=*last).collect()).unwrap_or_default()
}

/// Instructions that return a code of `library_errors` (6.6).
static LIBRARY_CODES: [&str; 3] = ["libLoad", "libSave", "libDelete"];

/// First and last result of instructions that return consecutive codes (3.5 to 3.7, 4.2, 5.10, 8.1, 9.4.4, 11.2).
static CODES: [(&str, i16, i16); 10] = [
    ("ioStatus", -3, 2),
    ("sioCtrl", -5, 0),
    ("setProfile", 0, 4),
    ("taskStatus", -1, 1),
    ("workingMode", 0, 4),
    ("esStatus", 0, 2),
    ("setMonitorSpeed", -3, 0),
    ("setFrame", -2, 0),
    ("alterBegin", -3, 1),
    ("alter", -3, 1),
];

/// Whether the result is rounded to fourteen digits (3.2.1).
#[must_use]
pub fn is_rounded(instruction: &str) -> bool {
    ROUNDED.contains(&instruction)
}

/// Instructions whose result is the only sign of a failure (6.6, 6.7, 8.1, 9.2.3, 9.4.4, 9.6.3). `libSave` is not
/// included, because programs use it as a statement: the application can do little about a full disk.
static MEANINGS: [(&str, &str); 5] = [
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
        let codes = CODES.iter().map(|(name, ..)| name).chain(&LIBRARY_CODES);
        for name in MEANINGS.iter().map(|(name, _)| name).chain(&ROUNDED).chain(codes) {
            let instruction = instructions::find(name).unwrap();
            assert!(instruction.overloads.iter().all(|form| form.result.is_some()), "{name}");
        }
    }

    #[test]
    fn codes_are_those_of_the_pages() {
        assert_eq!(result_codes("workingMode"), [0, 1, 2, 3, 4]);
        assert_eq!(result_codes("libLoad").len(), LIBRARY_ERRORS.len());
        assert!(result_codes("get").is_empty());
        for (name, first, last) in CODES {
            let page = instructions::find(name).unwrap().page;
            assert!(page.contains(&first.to_string()) && page.contains(&last.to_string()), "{name}");
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
