//! Report on mistakes, as text or as one JSON object.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use serde_json::{Value, json};

use super::original::Originals;
use super::trial::{MutantTrial, Verdict};
use crate::paths::Paths;
use crate::printable::one_line;

/// Maximum number of tests that the text names. Further tests are only counted.
const NAMED: usize = 3;

/// Maximum number of unused variables that the text names. Further variables are only counted.
const NAMED_VARIABLES: usize = 10;

/// Report on the tried mistakes.
pub(super) struct MutationReport<'r> {
    pub(super) originals: &'r Originals<'r>,
    pub(super) trials: &'r [MutantTrial<'r>],
    /// Variables that no test uses.
    pub(super) unused: &'r [String],
    pub(super) paths: &'r Paths,
    pub(super) seed: u64,
}

/// Numbers of mistakes by verdict.
struct MutantCounts {
    found: usize,
    survived: usize,
    not_compiled: usize,
}

impl MutationReport<'_> {
    fn counts(&self) -> MutantCounts {
        let count = |is: fn(&Verdict) -> bool| self.trials.iter().filter(|trial| is(&trial.verdict)).count();
        MutantCounts {
            found: count(|verdict| matches!(verdict, Verdict::Found(_))),
            survived: count(|verdict| matches!(verdict, Verdict::Survived(_))),
            not_compiled: count(|verdict| matches!(verdict, Verdict::NotCompiled)),
        }
    }

    /// Number of lines that no test has executed.
    fn not_covered(&self) -> u64 {
        let share = self.originals.coverage.line_share();
        share.total.saturating_sub(share.hit)
    }

    fn name(&self, number: usize) -> String {
        self.originals.tests.get(number).map_or_else(String::new, |test| test.name())
    }

    /// Writes each surviving mistake, and the numbers.
    pub(super) fn human(&self, out: &mut dyn WriteColor) -> io::Result<()> {
        for MutantTrial { mutant, verdict } in self.trials {
            let Verdict::Survived(difference) = verdict else { continue };
            let place = format!("{}:{}", self.paths.shown(mutant.file.as_str().into()), mutant.site.line);
            writeln!(out, "{place}: survived: {}", one_line(&mutant.site.change()))?;
            writeln!(out, "{:>5} │ {}", mutant.site.line, one_line(&mutant.source))?;
            let named: Vec<String> = mutant.tests.iter().take(NAMED).map(|number| self.name(*number)).collect();
            let more = match mutant.tests.len().saturating_sub(named.len()) {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            let verb = if mutant.site.path.is_some() { "used" } else { "executed" };
            writeln!(out, "        {verb} by {}{more}", named.join(", "))?;
            match difference {
                Some((number, difference)) => writeln!(
                    out,
                    "        {} at the end of {}: no assertion looks at it",
                    one_line(&difference.to_string()),
                    self.name(*number)
                )?,
                None => {
                    let other = if mutant.element.is_some() { "else " } else { "" };
                    writeln!(out, "        nothing {other}that can be asserted differs at the end of a test")?;
                }
            }
        }
        let MutantCounts { found, survived, not_compiled } = self.counts();
        let tried = found + survived;
        writeln!(out, "mutants: {tried}, found {found}, survived {survived}, not compiled {not_compiled}")?;
        match self.not_covered() {
            0 => {}
            1 => writeln!(out, "not covered: 1 line, which got no mistakes (`val3 test --coverage` shows it)")?,
            lines => {
                writeln!(out, "not covered: {lines} lines, which got no mistakes (`val3 test --coverage` shows them)")?;
            }
        }
        if !self.unused.is_empty() {
            let named: Vec<&str> = self.unused.iter().take(NAMED_VARIABLES).map(String::as_str).collect();
            let more = match self.unused.len().saturating_sub(named.len()) {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            writeln!(out, "not used: {}{more}, which got no mistakes", one_line(&named.join(", ")))?;
        }
        Ok(())
    }

    /// Writes a JSON object with all mistakes.
    pub(super) fn json(&self, out: &mut dyn WriteColor) -> io::Result<()> {
        let MutantCounts { found, survived, not_compiled } = self.counts();
        let mutants: Vec<Value> = self.trials.iter().map(|trial| self.described(trial)).collect();
        let object = json!({
            "version": 1,
            "seed": self.seed,
            "found": found,
            "survived": survived,
            "notCompiled": not_compiled,
            "notCovered": self.not_covered(),
            "notUsed": self.unused,
            "mutants": mutants,
        });
        writeln!(out, "{object:#}")
    }

    fn described(&self, MutantTrial { mutant, verdict }: &MutantTrial<'_>) -> Value {
        let (verdict, found_by, difference) = match verdict {
            Verdict::Found(number) => ("found", Some(self.name(*number)), None),
            Verdict::Survived(difference) => ("survived", None, difference.as_ref()),
            Verdict::NotCompiled => ("notCompiled", None, None),
        };
        let difference = difference.map(|(number, difference)| {
            json!({
                "test": self.name(*number),
                "name": difference.name,
                "value": difference.value,
                "insteadOf": difference.instead_of,
            })
        });
        let tests: Vec<String> = mutant.tests.iter().map(|number| self.name(*number)).collect();
        json!({
            "file": self.paths.to_open(mutant.file.as_str().into()),
            "line": mutant.site.line,
            "path": mutant.site.path,
            "source": mutant.source,
            "found": mutant.site.found,
            "replacement": mutant.site.replacement,
            "verdict": verdict,
            "tests": tests,
            "foundBy": found_by,
            "difference": difference,
        })
    }
}
