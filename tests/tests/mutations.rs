//! Typical faults of users: single edits in the palletiser cell, each of which must cause one finding.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::indexing_slicing,
    reason = "a slip that does not fit the cell fails the suite"
)]

mod application;
mod edit;
mod flow;
mod misuse;
mod mutation;
mod names;
mod projects;
mod syntax;
mod types;
mod verdict;

use std::collections::BTreeSet;

use mutation::{CELL, Mutation};
use rayon::iter::{ParallelBridge as _, ParallelIterator as _};
use val3_tests::Finding;
use val3_tests::cell::{self, Cell};
use val3_tests::fixing::errors_of_fixes;
use verdict::{Verdict, judge, report};

/// All slips, by family.
const ALL: &[&[Mutation]] = &[
    syntax::BLOCKS,
    syntax::LINES,
    syntax::XML,
    names::USES,
    names::DECLARATIONS,
    types::ARGUMENTS,
    types::INDEXES,
    types::EXPRESSIONS,
    projects::FILES,
    projects::VALUES,
    projects::LINKS,
    projects::LIBRARIES,
    misuse::ARGUMENTS,
    misuse::VALUES,
    misuse::DATA,
    misuse::TASKS,
    flow::ORDER,
    flow::WAITING,
    flow::POSITIONS,
    flow::MOVES,
    application::UNUSED,
    application::HIDDEN,
    application::TASKS,
    application::VERSIONS,
];

fn all() -> impl Iterator<Item = &'static Mutation> {
    ALL.iter().copied().flatten()
}

/// Returns the results of the check for every slip.
fn judge_all(check: impl Fn(&Cell) -> Vec<Finding>) -> Vec<Verdict> {
    let cell = cell::files(CELL);
    let known = check(&cell);
    all().map(|mutation| judge(mutation, &cell, &known, &check).expect(mutation.name)).collect()
}

#[test]
fn every_mistake_can_be_made_in_the_cell() {
    let cell = cell::files(CELL);
    let faults: Vec<String> = all()
        .filter_map(|mutation| edit::apply(mutation, &cell).err().map(|fault| format!("{}: {fault}", mutation.name)))
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn mistakes_have_different_names() {
    let names: BTreeSet<_> = all().map(|mutation| mutation.name).collect();
    assert_eq!(names.len(), all().count());
    assert!(names.len() >= 50, "{} slips", names.len());
}

#[test]
fn a_finding_on_another_line_and_a_second_finding_are_seen() {
    let cell = cell::files(CELL);
    let mutation = all().find(|mutation| mutation.name == "misspelt variable").unwrap();
    let at = |code: &str, line| Finding {
        code: code.to_owned(),
        file: "usr/usrapp/palletiser/pick.pgx".to_owned(),
        line,
        message: String::new(),
    };
    let judged = |findings: Vec<Finding>| judge(mutation, &cell, &[], |_| findings.clone()).unwrap();
    let line = judged(Vec::new());
    assert!(!line.found && line.others.is_empty() && line.to_string().contains("MISSED"));
    let line = edit::apply(mutation, &cell).unwrap().expected[0].1;
    assert!(judged(vec![at("V0101", line)]).is_good());
    assert!(!judged(vec![at("V0101", line + 1)]).found);
    let twice = judged(vec![at("V0101", line), at("V0202", line)]);
    assert!(twice.found && !twice.is_good());
}

#[test]
fn an_empty_check_misses_every_mistake() {
    let verdicts = judge_all(|_| Vec::new());
    let report = report(&verdicts);
    assert!(report.starts_with(&format!("0 of {} slips found", all().count())), "{report}");
    assert_eq!(report.matches("MISSED").count(), all().count());
}

#[test]
fn every_mistake_is_reported_alone_on_its_line() {
    let verdicts = judge_all(val3_tests::check);
    println!("{}", report(&verdicts));
    assert!(verdicts.iter().all(Verdict::is_good), "{}", report(&verdicts));
}

#[test]
fn fixes_of_mistakes_add_no_error() {
    let cell = cell::files(CELL);
    let added = |mutation: &&Mutation| {
        let errors = errors_of_fixes(&edit::apply(mutation, &cell).unwrap().cell);
        errors.into_iter().map(|error| format!("{}: {error}", mutation.name)).collect::<Vec<_>>()
    };
    // By far the slowest of these tests.
    let added: Vec<String> = all().par_bridge().flat_map_iter(|mutation| added(&mutation)).collect();
    assert!(added.is_empty(), "{}", added.join("\n"));
}
