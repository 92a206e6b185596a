//! Random data files of both dialects.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use proptest::prelude::*;
use val3_merge::MergedKind;
use val3_syntax::xml::{self, XmlElement};

use crate::checked;

/// Variables of type `num` with their values.
type Model = BTreeMap<String, Vec<u32>>;

/// Dialect of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Dialect {
    /// s7 and s8; values of 0 are omitted.
    New,
    /// s5 and s6.
    Old,
}

/// A change on one side. Numbers are taken modulo the number of existing items.
#[derive(Debug, Clone)]
enum Change {
    Set(usize, usize),
    /// Appends an element with the default value or another value.
    Append(usize, bool),
    Truncate(usize),
    RemoveElement(usize, usize),
    Remove(usize),
    Add(usize),
}

fn change() -> impl Strategy<Value = Change> {
    prop_oneof![
        6 => (0..6usize, 0..6usize).prop_map(|(datum, index)| Change::Set(datum, index)),
        6 => (0..6usize, any::<bool>()).prop_map(|(datum, is_default)| Change::Append(datum, is_default)),
        1 => (0..6usize).prop_map(Change::Truncate),
        1 => (0..6usize, 0..6usize).prop_map(|(datum, index)| Change::RemoveElement(datum, index)),
        1 => (0..6usize).prop_map(Change::Remove),
        2 => (0..3usize).prop_map(Change::Add),
    ]
}

/// Returns the model after changes. New values are numbered from `next`.
fn changed(base: &Model, changes: &[Change], next: u32) -> Model {
    let mut fresh = next..;
    let mut model = base.clone();
    for change in changes {
        let names: Vec<String> = model.keys().cloned().collect();
        let name = |at: &usize| names.get(at % names.len().max(1)).cloned().unwrap_or_default();
        match change {
            Change::Set(datum, index) => {
                if let Some(values) = model.get_mut(&name(datum)) {
                    let index = index % values.len();
                    values[index] = fresh.next().unwrap();
                }
            }
            Change::Append(datum, is_default) => {
                if let Some(values) = model.get_mut(&name(datum)) {
                    values.push(if *is_default { 0 } else { fresh.next().unwrap() });
                }
            }
            Change::Truncate(datum) => {
                if let Some(values) = model.get_mut(&name(datum)).filter(|values| values.len() > 1) {
                    values.pop();
                }
            }
            Change::RemoveElement(datum, index) => {
                if let Some(values) = model.get_mut(&name(datum)).filter(|values| values.len() > 1) {
                    values.remove(index % values.len());
                }
            }
            Change::Remove(datum) => _ = model.remove(&name(datum)),
            Change::Add(at) => {
                let value = fresh.next().unwrap();
                model.entry(format!("nNew{at}")).or_insert_with(|| vec![value]);
            }
        }
    }
    model
}

fn file(model: &Model, dialect: Dialect) -> String {
    let mut out = String::new();
    match dialect {
        Dialect::New => {
            out.push_str("\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\" ?>\r\n<Database>\r\n  <Datas>\r\n");
            for (name, values) in model {
                let size = values.len();
                write!(
                    out,
                    "    <Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"{size}\""
                )
                .unwrap();
                let written: Vec<_> = values.iter().enumerate().filter(|(_, value)| **value != 0).collect();
                out.push_str(if written.is_empty() { " />\r\n" } else { ">\r\n" });
                for (index, value) in &written {
                    write!(out, "      <Value key=\"{index}\" value=\"{value}\" />\r\n").unwrap();
                }
                if !written.is_empty() {
                    out.push_str("    </Data>\r\n");
                }
            }
            out.push_str("  </Datas>\r\n</Database>");
        }
        Dialect::Old => {
            out.push_str("<dataList>\n  <numSection>\n");
            for (name, values) in model {
                writeln!(out, "    <num name=\"{name}\" public=\"false\">").unwrap();
                for (index, value) in values.iter().enumerate() {
                    writeln!(out, "      <valueNum index=\"{index}\" value=\"{value}\" />").unwrap();
                }
                out.push_str("    </num>\n");
            }
            out.push_str("  </numSection>\n  <stringSection>\n  </stringSection>\n</dataList>\n");
        }
    }
    out
}

/// Reads the variables of a file.
fn read(text: &str) -> Model {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view()).unwrap();
    let number = |element: XmlElement<'_>, name: &str| element.value(name).map(|text| text.parse::<usize>().unwrap());
    let data = root.elements().flat_map(XmlElement::elements);
    let read = data.map(|data| {
        let values: Vec<_> = data
            .elements()
            .map(|value| {
                let index = number(value, "key").or_else(|| number(value, "index")).unwrap();
                (index, u32::try_from(number(value, "value").unwrap()).unwrap())
            })
            .collect();
        let size = number(data, "size").unwrap_or(values.len());
        let mut all = vec![0; size];
        let mut seen = BTreeSet::new();
        for (index, value) in values {
            assert!(index < size && seen.insert(index), "{text}");
            all[index] = value;
        }
        (data.value("name").unwrap().into_owned(), all)
    });
    let mut model = Model::new();
    read.for_each(|(name, values)| assert!(model.insert(name, values).is_none(), "{text}"));
    model
}

/// Merges the model directly; `None` for a conflict.
fn expected(base: &Model, ours: &Model, theirs: &Model) -> Option<Model> {
    let names: BTreeSet<&String> = base.keys().chain(ours.keys()).chain(theirs.keys()).collect();
    let mut merged = Model::new();
    for name in names {
        let versions = [base.get(name), ours.get(name), theirs.get(name)];
        let result = match versions {
            [b, o, t] if o == b || o == t => t.cloned(),
            [b, o, t] if t == b => o.cloned(),
            [Some(b), Some(o), Some(t)] => Some(values(b, o, t)?),
            _ => return None,
        };
        merged.extend(result.map(|values| (name.clone(), values)));
    }
    Some(merged)
}

fn values(base: &[u32], ours: &[u32], theirs: &[u32]) -> Option<Vec<u32>> {
    let size = base.len();
    if ours.len() < size || theirs.len() < size {
        return None;
    }
    let mut merged = Vec::new();
    for index in 0..size {
        merged.push(match [base[index], ours[index], theirs[index]] {
            [b, o, t] if o == b || o == t => t,
            [b, o, t] if t == b => o,
            _ => return None,
        });
    }
    merged.extend(&ours[size..]);
    if ours[size..] != theirs[size..] {
        merged.extend(&theirs[size..]);
    }
    Some(merged)
}

/// Checks one merge. Returns whether it is clean.
fn check(base: &Model, ours: &Model, theirs: &Model, dialect: Dialect) -> bool {
    let texts = [base, ours, theirs].map(|model| file(model, dialect));
    let merged = checked(MergedKind::Data, texts.each_ref().map(String::as_str));
    let expected = expected(base, ours, theirs);
    if merged.is_clean() {
        match &expected {
            Some(expected) => assert_eq!(&read(&merged.text), expected, "{}", merged.text),
            // The model never removes elements, but the merge does if no following element has changed.
            None => assert!(has_shorter_array(ours, base) || has_shorter_array(theirs, base), "{}", merged.text),
        }
    }
    // The file contains every value that one side has written and no side has removed.
    let [b, o, t] = [base, ours, theirs].map(written_values);
    let kept = o.intersection(&t).chain(o.difference(&b)).chain(t.difference(&b));
    for value in kept {
        assert!(merged.text.contains(&format!("value=\"{value}\"")), "{value} is lost\n{}", merged.text);
    }
    merged.is_clean()
}

/// Returns the values that differ from the default.
fn written_values(model: &Model) -> BTreeSet<u32> {
    model.values().flatten().copied().filter(|value| *value != 0).collect()
}

/// Whether an array of `base` has fewer elements on the side.
fn has_shorter_array(side: &Model, base: &Model) -> bool {
    side.iter().any(|(name, values)| base.get(name).is_some_and(|base| base.len() > values.len()))
}

/// Generates different values; every third element has the default value.
fn base() -> impl Strategy<Value = Model> {
    proptest::collection::vec(1..5usize, 1..5).prop_map(|sizes| {
        let mut model = Model::new();
        let mut fresh = 1001..;
        for (at, size) in sizes.into_iter().enumerate() {
            let numbers = fresh.by_ref().take(size).enumerate();
            let values = numbers.map(|(index, number)| if index % 3 == 2 { 0 } else { number });
            model.insert(format!("nA{at}"), values.collect());
        }
        model
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn data_are_merged_or_a_conflict(
        base in base(),
        ours in proptest::collection::vec(change(), 0..4),
        theirs in proptest::collection::vec(change(), 0..4),
    ) {
        let [ours, theirs] = [(ours, 2000), (theirs, 3000)].map(|(changes, next)| changed(&base, &changes, next));
        for dialect in [Dialect::New, Dialect::Old] {
            check(&base, &ours, &theirs, dialect);
        }
    }
}
