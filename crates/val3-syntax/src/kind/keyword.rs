//! Keywords: their spelling, and the lookup of a word.

use super::SyntaxKind::{self, *};

/// Keywords in their canonical spelling, in the order of the kinds.
pub const KEYWORDS: &[(SyntaxKind, &str)] = &[
    (BEGIN_KW, "begin"),
    (END_KW, "end"),
    (CALL_KW, "call"),
    (RETURN_KW, "return"),
    (IF_KW, "if"),
    (ELSE_IF_KW, "elseIf"),
    (ELSE_KW, "else"),
    (END_IF_KW, "endIf"),
    (WHILE_KW, "while"),
    (END_WHILE_KW, "endWhile"),
    (DO_KW, "do"),
    (UNTIL_KW, "until"),
    (FOR_KW, "for"),
    (TO_KW, "to"),
    (STEP_KW, "step"),
    (END_FOR_KW, "endFor"),
    (SWITCH_KW, "switch"),
    (CASE_KW, "case"),
    (BREAK_KW, "break"),
    (DEFAULT_KW, "default"),
    (END_SWITCH_KW, "endSwitch"),
    (AND_KW, "and"),
    (OR_KW, "or"),
    (XOR_KW, "xor"),
    (TRUE_KW, "true"),
    (FALSE_KW, "false"),
    (TASK_CREATE_KW, "taskCreate"),
    (TASK_CREATE_SYNC_KW, "taskCreateSync"),
];

impl SyntaxKind {
    /// Whether it is a keyword of the code.
    pub fn is_keyword(self) -> bool {
        (BEGIN_KW..=TASK_CREATE_SYNC_KW).contains(&self)
    }

    /// Returns the canonical spelling of a keyword.
    pub fn keyword_text(self) -> Option<&'static str> {
        let index = (self as usize).checked_sub(BEGIN_KW as usize)?;
        KEYWORDS.get(index).map(|(_, text)| *text)
    }

    /// Returns the keyword with this spelling in any letter case.
    pub fn from_keyword(text: &str) -> Option<Self> {
        let (kind, keyword) = (*SLOTS.get(slot(text.as_bytes()))?)?;
        keyword.eq_ignore_ascii_case(text).then_some(kind)
    }
}

/// Hash table of the keywords by length, first and last letter, so that one comparison distinguishes a name from a
/// keyword. No two keywords share a slot.
static SLOTS: [Option<(SyntaxKind, &str)>; SLOT_COUNT] = slots();

const SLOT_COUNT: usize = 64;

/// Returns the slot of a word in any letter case.
const fn slot(word: &[u8]) -> usize {
    let (Some(first), Some(last)) = (word.first(), word.last()) else { return 0 };
    let (first, last) = (first.to_ascii_lowercase() as usize, last.to_ascii_lowercase() as usize);
    (2 * first + 5 * last + 11 * word.len()) % SLOT_COUNT
}

#[allow(clippy::indexing_slicing, reason = "evaluated by the compiler, which refuses an index out of bounds")]
const fn slots() -> [Option<(SyntaxKind, &'static str)>; SLOT_COUNT] {
    let mut slots = [None; SLOT_COUNT];
    let mut at = 0;
    while at < KEYWORDS.len() {
        slots[slot(KEYWORDS[at].1.as_bytes())] = Some(KEYWORDS[at]);
        at += 1;
    }
    slots
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_keyword_is_found_in_any_letter_case() {
        for &(kind, text) in KEYWORDS {
            assert_eq!(SyntaxKind::from_keyword(text), Some(kind), "{text}");
            assert_eq!(SyntaxKind::from_keyword(&text.to_uppercase()), Some(kind), "{text}");
            assert_eq!(kind.keyword_text(), Some(text));
            assert!(kind.is_keyword());
        }
    }

    #[test]
    fn names_are_no_keywords() {
        for name in ["", "b", "beginn", "endif_", "ifs", "tasks", "doo", "end_", "é", "taskCreateSyncs"] {
            assert_eq!(SyntaxKind::from_keyword(name), None, "{name}");
        }
    }
}
