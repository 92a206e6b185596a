//! `val3 explain`.

use crate::support::Folder;

fn page(word: &str) -> String {
    let run = Folder::empty().val3(&["explain", word]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{word}: {run:?}");
    run.stdout
}

#[test]
fn a_rule_is_found_by_code_and_name() {
    let page_by_code = page("V0203");
    assert!(page_by_code.starts_with("V0203 argument-type"), "{page_by_code}");
    assert_eq!(page("v0203"), page_by_code);
    assert_eq!(page("argument-type"), page_by_code);
}

#[test]
fn an_instruction_is_explained() {
    let page = page("movej");
    assert!(page.contains("movej(") && page.contains("mdesc"), "{page}");
}

#[test]
fn a_statement_is_explained() {
    assert!(page("while").contains("endWhile"));
}

#[test]
fn types_fields_operators_and_words_are_explained() {
    for (word, parts) in [
        ("trsf", ["rx", "interpolateL"]),
        ("mdesc", ["99999", "movel"]),
        ("leave", ["reach", "mm or inches"]),
        ("fatherId", ["world[0]", "link"]),
        ("<=", ["`num <= num`", "bool"]),
        ("father", ["flange", "world"]),
        ("Disk://", ["usrapp", "USB0"]),
        ("config", ["(type, manual 9.7)", "(instruction, manual 9.7.6)"]),
        ("tool centre point", ["TCP", "tvel"]),
    ] {
        let page = page(word);
        assert!(parts.iter().all(|part| page.contains(part)), "{word}: {page}");
    }
}

#[test]
fn several_words_and_unknown_ones_are_searched() {
    let run = Folder::empty().val3(&["explain", "straight", "line"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    assert!(run.stdout.starts_with("Pages with the words straight, line:\n\nmovel (instruction)\n"), "{run:?}");
    let one = page("posture of the arm");
    assert!(one.contains("configuration (word)"), "{one}");
    let one = page("valve");
    assert!(one.starts_with("No page has the name `valve`.") && one.contains("gripper (field)"), "{one}");
}

#[test]
fn a_run_time_error_is_explained() {
    assert!(page("100").contains("100"));
}

#[test]
fn everything_has_its_line_in_the_list() {
    let run = Folder::empty().val3(&["explain"]);
    assert_eq!(run.code, 0, "{run:?}");
    for word in ["V0203 argument-type", "movej", "while", "Run-time errors", "Instructions: Motion", "mdesc", "leave"] {
        assert!(run.stdout.contains(word), "{word}: {run:?}");
    }
}

#[test]
fn an_unknown_word_gets_a_proposal() {
    let run = Folder::empty().val3(&["explain", "movje"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
    assert!(run.stderr.contains("did you mean") && run.stderr.contains("`movej`"), "{run:?}");
}

#[test]
fn pages_are_one_json_document() {
    let rule = pages(&["V0203"]);
    assert_eq!(rule.len(), 1);
    assert!(rule[0]["names"].as_array().unwrap().contains(&"argument-type".into()), "{rule:?}");
    assert!(rule[0]["page"].as_str().unwrap().contains("## Why"), "{rule:?}");
    assert_eq!(rule[0]["excerpt"], serde_json::Value::Null);
    assert_eq!(pages(&["123"])[0]["kind"], "run-time error");
    let kinds: Vec<_> = pages(&["config"]).iter().map(|page| page["kind"].clone()).collect();
    assert!(["type", "instruction", "field"].iter().all(|kind| kinds.contains(&(*kind).into())), "{kinds:?}");
    let hits = pages(&["straight", "line"]);
    assert!(hits[0]["names"][0] == "movel" && hits[0]["excerpt"].is_string(), "{hits:?}");
    let all = pages(&[]);
    assert!(all.len() > 300 && all.iter().all(|page| page["summary"] != ""), "{}", all.len());
}

/// Pages of `val3 explain --format json`.
fn pages(words: &[&str]) -> Vec<serde_json::Value> {
    let run = Folder::empty().val3(&[&["explain", "--format", "json"], words].concat());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{words:?}: {run:?}");
    let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(document["version"], 1);
    document["pages"].as_array().unwrap().clone()
}
