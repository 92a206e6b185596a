//! Random project files and programs.

use std::collections::BTreeSet;

use proptest::prelude::*;
use val3_merge::MergedKind;

use crate::checked;

fn items(text: &dyn Fn(&u8) -> String, set: &BTreeSet<u8>) -> Vec<String> {
    set.iter().map(|at| format!("    <{} />\n", text(at))).collect()
}

fn list(name: &str, items: Vec<String>) -> String {
    match items.is_empty() {
        true => format!("  <{name} />\n"),
        false => format!("  <{name}>\n{}  </{name}>\n", items.concat()),
    }
}

fn project(programs: &BTreeSet<u8>, libraries: &BTreeSet<u8>, is_old: bool) -> String {
    match is_old {
        false => format!(
            "<Project>\n{}{}</Project>",
            list("Programs", items(&|at| format!("Program file=\"p{at}.pgx\""), programs)),
            list("Libraries", items(&|at| format!("Library alias=\"l{at}\" path=\"Disk://l{at}\""), libraries)),
        ),
        true => format!(
            "<project>\n{}{}</project>",
            list("programSection", items(&|at| format!("program file=\"p{at}.pgx\""), programs)),
            list("aliasSection", items(&|at| format!("alias name=\"l{at}\" interface=\"l{at}\""), libraries)),
        ),
    }
}

/// Merges sets: the result contains common elements and elements that one side has added.
fn merged_set(base: &BTreeSet<u8>, ours: &BTreeSet<u8>, theirs: &BTreeSet<u8>) -> BTreeSet<u8> {
    let items = (0..20).filter(|at| match [base, ours, theirs].map(|set| set.contains(at)) {
        [true, ours, theirs] => ours && theirs,
        [false, ours, theirs] => ours || theirs,
    });
    items.collect()
}

fn numbers(text: &str, before: &str) -> BTreeSet<u8> {
    let digits = |rest: &str| rest.chars().take_while(char::is_ascii_digit).collect::<String>().parse().unwrap();
    text.split(before).skip(1).map(digits).collect()
}

fn program(locals: &BTreeSet<u8>, lines: &[String], is_old: bool) -> String {
    let locals = locals.iter().map(|at| match is_old {
        false => format!("      <Local name=\"l_{at}\" type=\"num\" xsi:type=\"array\" size=\"1\" />\n"),
        true => format!("      <local name=\"l_{at}\" type=\"num\" size=\"1\" />\n"),
    });
    let locals: String = locals.collect();
    let code = lines.join("\r\n");
    match is_old {
        false => format!(
            "<Programs>\n  <Program name=\"p\">\n    <Locals>\n{locals}    </Locals>\n    <Code><![CDATA[begin\r\n{code}\r\nend]]></Code>\n  </Program>\n</Programs>"
        ),
        true => format!(
            "<programList>\n  <program name=\"p\">\n    <localSection>\n{locals}    </localSection>\n    <source>\n      <code>begin\r\n{}\r\nend</code>\n    </source>\n  </program>\n</programList>",
            code.replace('<', "&lt;")
        ),
    }
}

/// Replaces, removes or inserts lines.
fn edited(base: &[String], changes: &[(usize, u8)], side: &str) -> Vec<String> {
    let mut lines = base.to_vec();
    for (number, (at, change)) in changes.iter().enumerate() {
        let at = at % lines.len().max(1);
        let line = format!("  if {side}{number}<1");
        match change % 3 {
            0 if at < lines.len() => lines[at] = line,
            1 if at < lines.len() => _ = lines.remove(at),
            _ => lines.insert(at.min(lines.len()), line),
        }
    }
    lines
}

fn set() -> impl Strategy<Value = BTreeSet<u8>> {
    proptest::collection::btree_set(0..20u8, 0..8)
}

/// Returns a set that differs in these numbers.
fn toggled(base: &BTreeSet<u8>, numbers: &[u8]) -> BTreeSet<u8> {
    let numbers: BTreeSet<u8> = numbers.iter().copied().collect();
    base.symmetric_difference(&numbers).copied().collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn lists_of_projects_are_sets(
        base in (set(), set()),
        ours in (proptest::collection::vec(0..20u8, 0..3), proptest::collection::vec(0..20u8, 0..3)),
        theirs in (proptest::collection::vec(0..20u8, 0..3), proptest::collection::vec(0..20u8, 0..3)),
        is_old in any::<bool>(),
    ) {
        let sides = [&ours, &theirs].map(|side| (toggled(&base.0, &side.0), toggled(&base.1, &side.1)));
        let [ours, theirs] = &sides;
        let texts = [&base, ours, theirs].map(|(programs, libraries)| project(programs, libraries, is_old));
        let merged = checked(MergedKind::Project, texts.each_ref().map(String::as_str));
        prop_assert!(merged.is_clean());
        let library = if is_old { "alias name=\"l" } else { "alias=\"l" };
        prop_assert_eq!(numbers(&merged.text, "file=\"p"), merged_set(&base.0, &ours.0, &theirs.0));
        prop_assert_eq!(numbers(&merged.text, library), merged_set(&base.1, &ours.1, &theirs.1));
    }

    #[test]
    fn programs_keep_the_lines_of_both(
        base in (set(), 1..8usize),
        ours in (proptest::collection::vec(0..20u8, 0..3), proptest::collection::vec((0..8usize, any::<u8>()), 0..3)),
        theirs in (proptest::collection::vec(0..20u8, 0..3), proptest::collection::vec((0..8usize, any::<u8>()), 0..3)),
        is_old in any::<bool>(),
    ) {
        let lines: Vec<String> = (0..base.1).map(|at| format!("  n{at}=1<2")).collect();
        let [(our_locals, our_lines), (their_locals, their_lines)] = [(&ours, "ours"), (&theirs, "theirs")]
            .map(|(side, name)| (toggled(&base.0, &side.0), edited(&lines, &side.1, name)));
        let versions = [(&base.0, &lines), (&our_locals, &our_lines), (&their_locals, &their_lines)];
        let texts = versions.map(|(locals, lines)| program(locals, lines, is_old));
        let merged = checked(MergedKind::Program, texts.each_ref().map(String::as_str));
        prop_assert_eq!(numbers(&merged.text, "name=\"l_"), merged_set(&base.0, &our_locals, &their_locals));
        let text = merged.text.replace("&lt;", "<");
        for line in our_lines.iter().chain(&their_lines) {
            let is_removed = lines.contains(line) && !(our_lines.contains(line) && their_lines.contains(line));
            prop_assert!(is_removed || text.contains(line.as_str()), "{} is lost\n{}", line, text);
            prop_assert!(!(is_removed && merged.is_clean() && text.contains(line.as_str())), "{} is left\n{}", line, text);
        }
    }
}
