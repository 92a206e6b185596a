//! One comparison in every format.

use val3_diff::Comparison;
use val3_diff::format::{html, json, markdown};
use val3_diff::report::Detail;

use crate::support::{compared, human};

fn example_data(x: &str, link: &str) -> String {
    format!(
        "\n=== main/main.dtx\n<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>\
         <Data name=\"fTable\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\"><Value key=\"0\" x=\"{x}\" fatherId=\"world[0]\"/></Data>\
         <Data name=\"pPick\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"2\"><Value key=\"0\" fatherId=\"fTable[0]\"/>\
         <Value key=\"1\" x=\"5\" fatherId=\"fTable[0]\"/></Data>\
         <Data name=\"dIn\" access=\"private\" xsi:type=\"array\" type=\"dio\" size=\"1\"><Value key=\"0\" link=\"{link}\"/></Data>\
         </Datas></Database>"
    )
}

fn example() -> Comparison {
    let code = "cls()\nput(\"<b>|`x`\")\n";
    let old = code.to_owned() + &example_data("500", "BasicIO-1\\%I0");
    let new = code.replace("<b>", "<i>")
        + &example_data("512.5", "BasicIO-1\\%I1")
        + "\n=== /configs/arm.cfx\n<arm/>\n=== main/broken.pgx\n<Programs>";
    let mut comparison = compared(&old, &new);
    comparison.old = "before".to_owned();
    comparison.new = "after <1>".to_owned();
    comparison
}

#[test]
fn for_people() {
    insta::assert_snapshot!(human(&example()));
}

#[test]
fn as_json() {
    insta::assert_snapshot!(json::write(&example(), Detail::Full).unwrap());
}

#[test]
fn as_markdown() {
    insta::assert_snapshot!(markdown::write(&example(), Detail::Full));
}

#[test]
fn as_html() {
    insta::assert_snapshot!(html::write(&example(), Detail::Full));
}

#[test]
fn a_page_needs_no_scripts_and_no_other_files() {
    let page = html::write(&example(), Detail::Full);
    assert!(page.contains("prefers-color-scheme: dark") && page.contains("after &lt;1&gt;"));
    for word in ["<script", "http:", "https:", "src=", "<i>|"] {
        assert!(!page.contains(word), "{word}");
    }
}

/// Collects the names of all fields.
fn fields(value: &serde_json::Value, found: &mut std::collections::BTreeSet<String>) {
    match value {
        serde_json::Value::Object(members) => members.iter().for_each(|(name, value)| {
            found.insert(name.clone());
            fields(value, found);
        }),
        serde_json::Value::Array(elements) => elements.iter().for_each(|value| fields(value, found)),
        _ => {}
    }
}

#[test]
fn the_page_names_every_field_of_the_document() {
    let page = include_str!("../../../../docs/src/diff.md");
    let mut document: serde_json::Value =
        serde_json::from_str(&json::write(&example(), Detail::Full).unwrap()).unwrap();
    document.as_object_mut().unwrap().remove("summary");
    let mut found = std::collections::BTreeSet::new();
    fields(&document, &mut found);
    let missing: Vec<&String> = found.iter().filter(|name| !page.contains(&format!("{name}`"))).collect();
    assert!(found.len() > 40 && missing.is_empty(), "{missing:?}");
}
