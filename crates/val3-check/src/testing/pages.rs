//! Every VAL 3 example on the pages is checked.

use val3_lang::{glossary, instructions, page, statements};
use val3_test::{Fixture, ROOT};

use super::{CheckedFinding, OF_WHOLE_PROJECTS, check_selected};
use crate::rules;
use crate::settings::RuleSelection;

/// Returns the findings in a listing, without rules about complete projects. The rule `enabled` reports in any case.
fn check_for(enabled: Option<&'static str>, listing: &str) -> Vec<CheckedFinding> {
    let selection = RuleSelection { named: enabled.into_iter().collect(), ..RuleSelection::default() };
    let fixture = Fixture::parse(listing);
    let files = fixture.files.iter().map(|(path, text)| (format!("{ROOT}/{path}"), text.clone().into_bytes()));
    let mut found = check_selected(&files.collect::<Vec<_>>(), &selection);
    found.retain(|finding| enabled == Some(finding.code) || !OF_WHOLE_PROJECTS.contains(&finding.code));
    found
}

/// Returns the VAL 3 listings below a heading of a page.
fn listings_below(page: &str, heading: &str) -> Vec<String> {
    let text = page::text(page);
    let Some((_, section)) = text.split_once(heading) else { return Vec::new() };
    let section = section.split("\n## ").next().unwrap_or("");
    let blocks = section.split("```val3\n").skip(1);
    blocks.filter_map(|block| block.split("\n```").next()).map(str::to_owned).collect()
}

#[test]
fn the_bad_example_of_a_rule_shows_its_finding_alone() {
    let mut faults = Vec::new();
    for rule in rules::all() {
        for listing in listings_below(rule.page, "## Bad") {
            let found = check_for(Some(rule.code), &listing);
            if found.len() != 1 || found.iter().any(|finding| finding.code != rule.code) {
                faults.push(format!("{} {}: {found:#?}\n{listing}", rule.code, rule.name));
            }
        }
    }
    assert!(faults.is_empty(), "{} rules\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn the_good_example_of_a_rule_is_clean() {
    let mut faults = Vec::new();
    for rule in rules::all() {
        for listing in listings_below(rule.page, "## Good") {
            let found = check_for(Some(rule.code), &listing);
            if !found.is_empty() {
                faults.push(format!("{} {}: {found:#?}\n{listing}", rule.code, rule.name));
            }
        }
    }
    assert!(faults.is_empty(), "{} rules\n{}", faults.len(), faults.join("\n"));
}

/// Rules whose fault a listing cannot show: bytes in a wrong encoding, control characters, and files that cannot be
/// read, are outside the allowed folders, belong to no project, or are unread archives.
const WITHOUT_LISTING: [&str; 6] = ["V0005", "V0007", "V0502", "V0509", "V0543", "V0544"];

#[test]
fn every_rule_has_both_examples() {
    for rule in rules::all().iter().filter(|rule| !WITHOUT_LISTING.contains(&rule.code)) {
        assert!(!listings_below(rule.page, "## Bad").is_empty(), "{}", rule.code);
        assert!(!listings_below(rule.page, "## Good").is_empty(), "{}", rule.code);
    }
}

#[test]
fn the_examples_of_the_language_are_clean() {
    let mut faults = Vec::new();
    let instructions = instructions::all().iter().map(|instruction| (instruction.name, instruction.page));
    let statements = statements::STATEMENTS.iter().map(|statement| (statement.name, statement.page));
    let glossary = glossary::ENTRIES.iter().map(|entry| (entry.stem, entry.page));
    for (name, text) in instructions.chain(statements).chain(glossary) {
        for example in page::examples(text) {
            // The add-on's table is not part of the page.
            let found: Vec<_> =
                check_for(None, &example).into_iter().filter(|finding| finding.code != "V0104").collect();
            if !found.is_empty() {
                faults.push(format!("{name}: {found:#?}\n{example}"));
            }
        }
    }
    assert!(faults.is_empty(), "{} pages\n{}", faults.len(), faults.join("\n"));
}
