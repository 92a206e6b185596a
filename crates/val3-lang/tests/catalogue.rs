//! Compares the catalogue with the signature table of the v7 manual: both are equal except for marked additions.

use std::collections::{BTreeMap, BTreeSet};

use val3_lang::{
    instruction::{ArgumentForm, Availability, Family, Instruction, InstructionParam, Overload},
    instructions, page,
    types::BaseType,
};

const TABLE: &str = include_str!("instructions.tsv");

/// A line of the table.
struct Row {
    section: &'static str,
    name: String,
    signature: String,
    blocking: bool,
    errors: BTreeSet<u16>,
}

fn rows() -> Vec<Row> {
    TABLE.lines().filter(|line| !line.starts_with('#')).filter_map(row).collect()
}

fn row(line: &'static str) -> Option<Row> {
    let mut cells = line.split('\t');
    let (section, signature) = (cells.next()?, cells.next()?);
    let (blocking, errors) = (cells.next()? == "y", cells.next()?);
    let call = signature.split(" string").next().filter(|_| signature.starts_with("task"));
    let head = call.or_else(|| signature.split('(').next())?;
    let name = head.rsplit([' ', ':']).next()?.to_owned();
    Some(Row { section, name, signature: canonical(signature), blocking, errors: numbers(errors) })
}

/// Normalises a signature: in the table, `&` marks a modified element, which the catalogue expresses by the argument
/// form.
fn canonical(signature: &str) -> String {
    signature.replace("T& variable", "T variable").replace("ident:", "library:").replace("prog(", "program(")
}

fn numbers(text: &str) -> BTreeSet<u16> {
    text.split(',').flat_map(range).collect()
}

fn range(text: &str) -> Vec<u16> {
    let ends: Vec<u16> = text.split('-').filter_map(|end| end.parse().ok()).collect();
    match ends[..] {
        [first, last] => (first..=last).collect(),
        _ => ends,
    }
}

fn signature(instruction: &Instruction, overload: &Overload) -> String {
    canonical(&overload.signature(instruction.name)).replace("[\"\"]", "")
}

fn is_of_manual(instruction: &Instruction, overload: &Overload) -> bool {
    instruction.availability == Availability::Manual && overload.since.is_none() && overload.is_printed
}

/// Forms in the manual as `name -> signatures`.
fn catalogue() -> BTreeSet<String> {
    let forms = instructions::all().iter().flat_map(|instruction| {
        let overloads = instruction.overloads.iter().filter(|form| is_of_manual(instruction, form));
        overloads.map(|form| signature(instruction, form))
    });
    forms.collect()
}

#[test]
fn every_signature_of_the_manual_and_no_other() {
    let manual: BTreeSet<String> = rows().into_iter().map(|row| row.signature).collect();
    let catalogue = catalogue();
    let missing: Vec<_> = manual.difference(&catalogue).collect();
    let unknown: Vec<_> = catalogue.difference(&manual).collect();
    assert!(missing.is_empty() && unknown.is_empty(), "missing: {missing:#?}\nunknown: {unknown:#?}");
    assert_eq!(rows().len(), 196);
}

#[test]
fn sections_blocking_and_errors_are_those_of_the_manual() {
    let mut by_name: BTreeMap<String, Vec<Row>> = BTreeMap::new();
    for row in rows() {
        by_name.entry(row.name.clone()).or_default().push(row);
    }
    for (name, rows) in by_name {
        let instruction = instructions::find(&name).expect("every name is in the catalogue");
        let sections: BTreeSet<&str> = rows.iter().map(|row| row.section).collect();
        assert_eq!(instruction.section.split(", ").collect::<BTreeSet<_>>(), sections, "{name}");
        assert_eq!(instruction.blocking, rows.iter().any(|row| row.blocking), "{name}");
        let errors: BTreeSet<u16> = rows.iter().flat_map(|row| row.errors.clone()).collect();
        assert_eq!(instruction.errors.iter().copied().collect::<BTreeSet<_>>(), errors, "{name}");
    }
}

#[test]
fn names_are_unique_and_found() {
    let names: BTreeSet<&str> = instructions::all().iter().map(|instruction| instruction.name).collect();
    assert_eq!(names.len(), instructions::all().len());
    for instruction in instructions::all() {
        assert!(instructions::find(instruction.name).is_some_and(|found| std::ptr::eq(found, *instruction)));
    }
    assert!(instructions::find("moveJ").is_none());
}

#[test]
fn additions_are_marked() {
    for instruction in instructions::all() {
        let is_added = instruction.section.is_empty();
        assert_eq!(is_added, instruction.availability != Availability::Manual, "{}", instruction.name);
        assert_eq!(is_added, matches!(instruction.family, Family::Additions | Family::AddOns), "{}", instruction.name);
        assert_eq!(instruction.add_on().is_some(), instruction.name.starts_with('$'), "{}", instruction.name);
    }
}

#[test]
fn every_page_has_its_sections() {
    for instruction in instructions::all() {
        let name = instruction.name;
        let (page, summary) = (page::text(instruction.page), page::summary(instruction.page));
        assert!(summary.ends_with('.') && summary.chars().next().is_some_and(char::is_uppercase), "{name}: {summary}");
        assert!(page.contains("## Example\n```val3\n"), "{name}");
        let examples = page::examples(instruction.page);
        assert!(examples.iter().any(|example| example.contains(name)), "{name}");
        for param in instruction.overloads.iter().flat_map(|form| form.params) {
            assert!(page.contains(&format!("`{}`", param.name)), "{name}: {}", param.name);
        }
        for error in instruction.errors {
            assert!(explains_error(&page, *error), "{name}: {error}");
        }
    }
}

/// Whether the page names the error directly or within `100 to 106`, or refers to another page.
fn explains_error(page: &str, error: u16) -> bool {
    let words: Vec<&str> = page.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    page.contains("- Errors: as for")
        || words.contains(&error.to_string().as_str())
        || words.windows(3).any(|window| is_within(error, window))
}

/// Whether three words are a range with the error, for example `100 to 106`.
fn is_within(error: u16, words: &[&str]) -> bool {
    let [first, "to", last] = words else { return false };
    first.parse().is_ok_and(|first| error >= first) && last.parse().is_ok_and(|last| error <= last)
}

#[test]
fn parameters_have_a_type_or_a_reason() {
    let untyped = |param: &&InstructionParam| param.ty.is_none() && param.shape == ArgumentForm::Value;
    for instruction in instructions::all() {
        let values = instruction.overloads.iter().flat_map(|form| form.params).filter(untyped).count();
        let expected = usize::from(matches!(instruction.name, "sioCtrl" | "userPageSet" | "$getName"));
        assert_eq!(values, expected, "{}", instruction.name);
    }
}

#[test]
fn nothing_takes_a_field_type() {
    let types = |form: &'static Overload| form.params.iter().filter_map(|param| param.ty).chain(form.result);
    let all: Vec<BaseType> =
        instructions::all().iter().flat_map(|instruction| instruction.overloads).flat_map(types).collect();
    assert!(all.iter().all(|ty| !ty.is_enumeration()));
}
