//! Laws of fixes, for the `Bad` example of every rule that has a fix, in both dialects.

use val3_check::fix::{FixSafety, fix_offer};
use val3_check::rule::Rule;
use val3_check::rules;
use val3_check::testing::{CheckedFinding, OF_WHOLE_PROJECTS, OfferedFix, check_files, fixed_files, offered_fixes};
use val3_lang::page;
use val3_test::{Fixture, ROOT};
use val3_tests::cell;
use val3_tests::fixing::{errors_of_fix, errors_of_fixes};

type Files = Vec<(String, Vec<u8>)>;

/// Returns the files of the listings below `## Bad`: unchanged, and with the code escaped as in the old dialect.
fn bad_examples(rule: &Rule) -> Vec<Files> {
    let section = format!("{}\n", page::section(rule.page, "Bad"));
    let listings = page::examples(&section);
    listings.iter().flat_map(|listing| [files(listing, str::to_owned), files(listing, escaped)]).collect()
}

fn files(listing: &str, change: fn(&str) -> String) -> Files {
    let fixture = Fixture::parse(listing);
    fixture.files.iter().map(|(path, text)| (format!("{ROOT}/{path}"), change(text).into_bytes())).collect()
}

/// Returns the text with all CDATA content as escaped text.
fn escaped(text: &str) -> String {
    let mut parts = text.split("<![CDATA[");
    let mut whole = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (code, rest) = part.split_once("]]>").unwrap_or((part, ""));
        whole += &code.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
        whole += rest;
    }
    whole
}

/// Runs `law` for every `Bad` example and every fix that its rule offers.
fn for_each_fix(law: impl Fn(&Files, &OfferedFix) -> Result<(), String>) {
    let mut tried = 0;
    let mut faults = Vec::new();
    for rule in rules::all() {
        for files in bad_examples(rule) {
            for fix in offered_fixes(&files).iter().filter(|fix| fix.code == rule.code) {
                tried += 1;
                faults.extend(law(&files, fix).err().map(|fault| format!("{} {}: {fault}", rule.code, rule.name)));
            }
        }
    }
    assert!(tried > 20, "{tried} fixes are too few");
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

/// Returns the number of syntax faults in the files: findings of the family V00.
fn syntax_faults(files: &Files) -> usize {
    check_files(files).iter().filter(|finding| finding.code.starts_with("V00")).count()
}

fn shown(files: &Files) -> String {
    files.iter().map(|(path, bytes)| format!("{path}\n{}", String::from_utf8_lossy(bytes))).collect()
}

#[test]
fn pages_state_which_rules_have_fixes() {
    let mut faults = Vec::new();
    for rule in rules::all() {
        let offer = fix_offer(rule);
        let examples = bad_examples(rule);
        let fixes: Vec<OfferedFix> =
            examples.iter().flat_map(offered_fixes_of).filter(|fix| fix.code == rule.code).collect();
        let fits = |fix: &OfferedFix| match offer.map(|offer| offer.safety) {
            None => false,
            Some(FixSafety::Safe) => fix.safe,
            Some(FixSafety::Unsafe) => !fix.safe,
            Some(FixSafety::Either) => true,
        };
        let lacks = fixes.len() < examples.len() && offer.is_some_and(|offer| offer.every);
        if lacks || !fixes.iter().all(fits) {
            faults.push(format!("{} {}: {offer:?}, but {fixes:?}", rule.code, rule.name));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn offered_fixes_of(files: &Files) -> Vec<OfferedFix> {
    offered_fixes(files)
}

#[test]
fn a_fix_leaves_no_finding_of_its_rule() {
    for_each_fix(|files, fix| {
        let fixed = fixed_files(files);
        let left: Vec<_> = check_files(&fixed).into_iter().filter(|finding| finding.code == fix.code).collect();
        if left.is_empty() { Ok(()) } else { Err(format!("{left:#?}\n{}", shown(&fixed))) }
    });
}

#[test]
fn a_fix_adds_no_fault_of_the_text() {
    for_each_fix(|files, _| {
        let fixed = fixed_files(files);
        let (before, after) = (syntax_faults(files), syntax_faults(&fixed));
        if after <= before { Ok(()) } else { Err(format!("{before} faults, then {after}\n{}", shown(&fixed))) }
    });
}

#[test]
fn fixes_add_no_error() {
    let mut faults = Vec::new();
    for rule in rules::all() {
        for files in bad_examples(rule) {
            let with_carriage_returns: Files = files
                .iter()
                .map(|(path, bytes)| (path.clone(), String::from_utf8_lossy(bytes).replace('\n', "\r\n").into_bytes()))
                .collect();
            for files in [files, with_carriage_returns] {
                faults.extend(errors_of_fixes(&files).into_iter().map(|error| format!("{}: {error}", rule.code)));
                let mixed = fixed_files(&files).into_iter().filter(|(_, bytes)| has_mixed_line_ends(bytes));
                faults.extend(mixed.map(|(path, _)| format!("{}: line ends of {path}", rule.code)));
            }
        }
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

fn has_mixed_line_ends(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    let of_windows = text.matches("\r\n").count();
    of_windows > 0 && of_windows < text.matches('\n').count()
}

#[test]
fn a_fix_alone_adds_no_error() {
    let mut faults = Vec::new();
    let examples = rules::all().iter().flat_map(|rule| bad_examples(rule));
    for files in examples.chain(["faulty", "palletiser"].map(cell::files)) {
        for fix in offered_fixes(&files) {
            let added = errors_of_fix(&files, &fix);
            faults.extend(added.into_iter().map(|error| format!("{} ({}): {error}", fix.code, fix.title)));
        }
    }
    assert!(faults.is_empty(), "{} faults\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn fixes_of_the_example_cells_add_no_error() {
    for cell in ["faulty", "palletiser"] {
        assert_eq!(errors_of_fixes(&cell::files(cell)), Vec::<String>::new(), "{cell}");
    }
}

#[test]
fn a_safe_fix_adds_no_finding() {
    for_each_fix(|files, fix| {
        let fixed = fixed_files(files);
        let of_excerpts = |found: &CheckedFinding| found.code == fix.code || !OF_WHOLE_PROJECTS.contains(&found.code);
        let check = |files: &Files| check_files(files).into_iter().filter(of_excerpts).collect::<Vec<_>>();
        let (before, after) = (check(files), check(&fixed));
        let is_fine = !fix.safe || after.len() < before.len();
        if is_fine { Ok(()) } else { Err(format!("{after:#?}\n{}", shown(&fixed))) }
    });
}

#[test]
fn bytes_outside_the_edits_stay() {
    for_each_fix(|files, fix| {
        for ((path, before), (_, after)) in files.iter().zip(&fixed_files(files)) {
            let mut edits: Vec<_> = fix.edits.iter().filter(|(file, ..)| file == path).collect();
            edits.sort_by_key(|(_, range, _)| range.start);
            let mut rest = &after[..];
            let mut from = 0;
            for (_, range, text) in edits {
                let kept = [&before[from..range.start], text.as_bytes()].concat();
                rest = rest.strip_prefix(&kept[..]).ok_or_else(|| format!("{path} is changed outside {range:?}"))?;
                from = range.end;
            }
            if rest != &before[from..] {
                return Err(format!("{path} is changed behind the edits"));
            }
        }
        Ok(())
    });
}

#[test]
fn fixing_reaches_an_end() {
    for_each_fix(|files, _| {
        let mut fixed = fixed_files(files);
        // A second fix may repair a finding that results from the first fix.
        for _ in 0..4 {
            let again = fixed_files(&fixed);
            if again == fixed {
                return Ok(());
            }
            fixed = again;
        }
        Err(format!("it does not settle\n{}", shown(&fixed)))
    });
}

#[test]
fn every_edit_of_a_fix_lies_in_its_file() {
    for_each_fix(|files, fix| {
        for (path, range, _) in &fix.edits {
            let bytes = files.iter().find(|(known, _)| known == path).map(|(_, bytes)| bytes);
            let text = bytes.and_then(|bytes| str::from_utf8(bytes).ok()).ok_or("no such file")?;
            text.get(range.clone()).ok_or_else(|| format!("{range:?} is no range of {path}"))?;
        }
        Ok(())
    });
}
