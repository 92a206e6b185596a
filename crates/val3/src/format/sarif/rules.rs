//! Rule table of a SARIF log.

use std::collections::BTreeSet;

use val3_check::rule::Rule;
use val3_lang::page;

use super::log::{Help, Message, ReportingConfiguration, ReportingDescriptor};
use crate::report::CheckReport;

/// Rules with findings, sorted by code.
pub(super) struct Rules(Vec<&'static Rule>);

impl Rules {
    /// Collects the rules of a report.
    pub(super) fn of(report: &CheckReport) -> Self {
        let codes: BTreeSet<_> = report.findings.iter().map(|finding| finding.code).collect();
        Self(val3_check::rules::all().iter().copied().filter(|rule| codes.contains(rule.code)).collect())
    }

    /// Index of a rule in the table.
    pub(super) fn index(&self, code: &str) -> Option<usize> {
        self.0.iter().position(|rule| rule.code == code)
    }

    /// Converts the rules to the table.
    pub(super) fn descriptors(&self) -> Vec<ReportingDescriptor> {
        self.0.iter().map(|rule| descriptor(rule)).collect()
    }
}

fn descriptor(rule: &Rule) -> ReportingDescriptor {
    let text = page::text(rule.page);
    ReportingDescriptor {
        id: rule.code,
        name: rule.name,
        short_description: Message { text: page::summary(rule.page) },
        full_description: Message { text: page::section(rule.page, "Why") },
        help: Help { markdown: text.clone(), text },
        default_configuration: ReportingConfiguration { level: super::level(rule.severity.into()) },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::sample;

    #[test]
    fn every_finding_has_its_rule_in_the_table() {
        let report = sample::report();
        let rules = Rules::of(&report);
        let descriptors = rules.descriptors();
        for finding in &report.findings {
            assert_eq!(descriptors[rules.index(finding.code).unwrap()].id, finding.code);
        }
    }

    #[test]
    fn a_rule_is_described() {
        let table = Rules::of(&sample::report()).descriptors();
        assert_eq!(table[0].short_description.text, "A name is used that is not declared.");
        assert!(table[0].full_description.text.starts_with("A name in code means"));
        assert!(table[0].help.markdown.contains("\n## Bad\n"));
    }
}
