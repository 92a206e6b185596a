//! Table of the rules that offer a fix, for their pages. `tests/tests/fixes.rs` compares the table with the fixes of
//! the bad examples.

use crate::rule::Rule;

/// Fixes that a rule offers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Offer {
    /// Whether every finding has a fix, not only some.
    pub every: bool,
    /// Whether the fixes are safe.
    pub safety: FixSafety,
}

/// Whether fixes may be applied without confirmation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FixSafety {
    /// All fixes are safe.
    Safe,
    /// All fixes are guesses.
    Unsafe,
    /// It depends on the finding.
    Either,
}

/// Returns the offer of a rule; `None` if it has no fixes.
#[must_use]
pub fn fix_offer(rule: &Rule) -> Option<Offer> {
    let row = OFFERS.iter().find(|(code, ..)| *code == rule.code);
    row.map(|&(_, every, safety)| Offer { every, safety })
}

/// Code, whether every finding has a fix, its safety.
static OFFERS: &[(&str, bool, FixSafety)] = {
    use FixSafety::{Either, Safe, Unsafe};
    &[
        ("V0002", false, Safe),
        ("V0007", true, Unsafe),
        ("V0011", true, Unsafe),
        ("V0012", false, Unsafe),
        ("V0014", false, Unsafe),
        ("V0015", false, Unsafe),
        ("V0016", false, Safe),
        ("V0023", true, Either),
        ("V0024", false, Safe),
        ("V0026", false, Safe),
        ("V0028", false, Unsafe),
        ("V0101", false, Unsafe),
        ("V0102", false, Either),
        ("V0103", false, Either),
        ("V0105", false, Unsafe),
        ("V0106", false, Unsafe),
        ("V0107", false, Unsafe),
        ("V0113", false, Unsafe),
        ("V0115", true, Safe),
        ("V0118", true, Unsafe),
        ("V0119", true, Unsafe),
        ("V0202", false, Unsafe),
        ("V0203", false, Unsafe),
        ("V0204", false, Unsafe),
        ("V0207", false, Unsafe),
        ("V0220", false, Unsafe),
        ("V0229", false, Unsafe),
        ("V0232", false, Unsafe),
        ("V0234", true, Safe),
        ("V0240", true, Unsafe),
        ("V0303", false, Unsafe),
        ("V0308", false, Unsafe),
        ("V0309", false, Safe),
        ("V0323", false, Unsafe),
        ("V0326", true, Unsafe),
        ("V0328", true, Unsafe),
        ("V0333", false, Unsafe),
        ("V0406", true, Unsafe),
        ("V0408", true, Unsafe),
        ("V0417", true, Unsafe),
        ("V0503", false, Safe),
        ("V0505", false, Unsafe),
        ("V0508", false, Unsafe),
        ("V0511", false, Unsafe),
        ("V0515", false, Unsafe),
        ("V0520", false, Unsafe),
        ("V0525", false, Unsafe),
        ("V0531", false, Unsafe),
        ("V0535", false, Unsafe),
        ("V0537", true, Unsafe),
        ("V0538", true, Safe),
        ("V0601", false, Unsafe),
        ("V0608", false, Unsafe),
        ("V0701", true, Safe),
        ("V0702", true, Safe),
    ]
};
