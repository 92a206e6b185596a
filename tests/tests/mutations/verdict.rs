//! Compares the findings in a cell with a slip with the expected ones.

use std::fmt;

use val3_tests::Finding;
use val3_tests::cell::Cell;

use crate::mutations::edit::apply;
use crate::mutations::mutation::Mutation;

/// Result of the check for a slip.
#[derive(Debug)]
pub(crate) struct Verdict {
    pub(crate) name: &'static str,
    pub(crate) code: &'static str,
    /// Whether the finding has the right code and is on the right line.
    pub(crate) found: bool,
    /// Unexpected findings: neither in the original cell nor caused by the slip as intended.
    pub(crate) others: Vec<Finding>,
    expected: Vec<(String, usize)>,
}

impl Verdict {
    pub(crate) fn is_good(&self) -> bool {
        self.found && self.others.is_empty()
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let places: Vec<String> = self.expected.iter().map(|(file, line)| format!("{file}:{line}")).collect();
        let found = if self.found { "found" } else { "MISSED" };
        write!(f, "{}: {} {found} at {}", self.name, self.code, places.join(" or "))?;
        for other in &self.others {
            write!(f, "\n    also {} {}:{} {}", other.code, other.file, other.line, other.message)?;
        }
        Ok(())
    }
}

/// Applies the slip and compares the findings of `check`; `known` are the findings in the original cell.
pub(crate) fn judge(
    mutation: &Mutation,
    cell: &Cell,
    known: &[Finding],
    check: impl Fn(&Cell) -> Vec<Finding>,
) -> Result<Verdict, String> {
    let mutated = apply(mutation, cell)?;
    let mut others = without(check(&mutated.cell), known);
    let is_expected = |finding: &Finding| {
        let place = mutated.expected.iter().any(|(file, line)| (&finding.file, finding.line) == (file, *line));
        finding.code == mutation.code && place
    };
    let hit = others.iter().position(is_expected);
    if let Some(hit) = hit {
        others.remove(hit);
    }
    let second = others.iter().position(|finding| Some(finding.code.as_str()) == mutation.also);
    if let Some(second) = second.filter(|_| hit.is_some()) {
        others.remove(second);
    }
    let expected = mutated.expected;
    Ok(Verdict { name: mutation.name, code: mutation.code, found: hit.is_some(), others, expected })
}

/// Formats the number of found slips, and the faults of all others.
pub(crate) fn report(verdicts: &[Verdict]) -> String {
    let found = verdicts.iter().filter(|verdict| verdict.found).count();
    let mut lines = vec![format!("{found} of {} slips found", verdicts.len())];
    lines.extend(verdicts.iter().filter(|verdict| !verdict.is_good()).map(Verdict::to_string));
    lines.join("\n")
}

/// Returns `findings` without the findings in `known`, even if these moved to other lines.
fn without(mut findings: Vec<Finding>, known: &[Finding]) -> Vec<Finding> {
    let mut known: Vec<&Finding> = known.iter().collect();
    findings.retain(|finding| {
        let index = known.iter().position(|other| finding.is_like(other));
        index.map(|index| known.swap_remove(index)).is_none()
    });
    findings
}
