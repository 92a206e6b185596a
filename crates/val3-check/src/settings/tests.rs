use camino::Utf8Path;
use expect_test::{Expect, expect};

use super::*;
use crate::rules;

fn settings(text: &str, selection: &RuleSelection) -> Result<Settings, ConfigError> {
    let file = ConfigFile::parse(Utf8Path::new("val3.toml"), text).unwrap();
    Settings::new(Some(&file), selection)
}

/// Level of V0701, whose default is `info`.
fn level(text: &str) -> Option<Severity> {
    let rule = rules::find("V0701").unwrap();
    settings(text, &RuleSelection::default()).unwrap().severity(rule, rule.severity)
}

#[track_caller]
fn refused(text: &str, expected: Expect) {
    expected.assert_eq(&format!("{}\n", settings(text, &RuleSelection::default()).unwrap_err()));
}

#[test]
fn the_most_exact_key_counts() {
    assert_eq!(level(""), Some(Severity::Info));
    assert_eq!(level("[rules]\nall = \"error\"\n"), Some(Severity::Error));
    assert_eq!(level("[rules]\nV07 = \"off\"\nall = \"error\"\n"), None);
    assert_eq!(level("[rules]\nkeyword-spelling = \"warning\"\nV07 = \"off\"\n"), Some(Severity::Warning));
    assert_eq!(level("[rules]\nv0701 = \"default\"\nV07 = \"off\"\n"), Some(Severity::Info));
    assert_eq!(level("[rules]\nV070 = \"error\"\nV07 = \"off\"\n"), Some(Severity::Error));
}

#[test]
fn unknown_keys_are_reported() {
    refused(
        "[rules]\nkeyword-speling = \"off\"\n",
        expect![[r#"
        no rule has the code or name `keyword-speling`
         --> val3.toml:2
          |
        2 | keyword-speling = "off"
          | ^^^^^^^^^^^^^^^
          help: did you mean `keyword-spelling`?
    "#]],
    );
    refused(
        "[rules]\nsql = \"off\"\n",
        expect![[r#"
        no rule has the code or name `sql`
         --> val3.toml:2
          |
        2 | sql = "off"
          | ^^^
          help: write a code (V0203), a prefix of codes (V02), a name, or all; `val3 explain` lists them
    "#]],
    );
    refused(
        "[rules]\nV0701 = \"off\"\nkeyword-spelling = \"info\"\n",
        expect![[r#"
        `keyword-spelling` and `V0701` mean the same findings
         --> val3.toml:3
          |
        3 | keyword-spelling = "info"
          | ^^^^^^^^^^^^^^^^
          help: keep one of the two lines
    "#]],
    );
}

#[test]
fn the_command_line_wins() {
    let rule = rules::find("V0701").unwrap();
    let off = "[rules]\nV0701 = \"off\"\n";
    let only = RuleSelection { only: Some(["V0701"].into()), ..RuleSelection::default() };
    assert!(!settings(off, &only).unwrap().is_enabled(rule), "a family restricts");
    let named = RuleSelection { named: ["V0701"].into(), ..only.clone() };
    assert!(settings(off, &named).unwrap().is_enabled(rule), "a name turns the rule on");
    let never = RuleSelection { never: ["V0701"].into(), ..named };
    assert!(!settings("", &never).unwrap().is_enabled(rule));
    assert!(!settings("", &only).unwrap().is_enabled(rules::find("V0101").unwrap()));
}

#[test]
fn rules_that_are_off_must_be_configured() {
    let rule = Rule { on: false, ..*rules::find("V0701").unwrap() };
    let is_enabled = |text: &str| settings(text, &RuleSelection::default()).unwrap().is_enabled(&rule);
    assert!(!is_enabled("") && !is_enabled("[rules]\nall = \"default\"\n"));
    assert!(is_enabled("[rules]\nV0701 = \"on\"\n") && is_enabled("[rules]\nV07 = \"warning\"\n"));
}
