use expect_test::{Expect, expect};

use super::*;
use crate::{Level, Licence, Profile};

const FULL: &str = r#"
version = "s8.12"
arm = "tx2-60l"
disk = "usr/usrapp"
roots = { USB0 = "usb" }
add-ons = ["tables/val3.file.anthro.cfx"]
exclude = ["old/**", "**/backup"]
baseline = "val3-baseline.json"

[rules]
V0301 = "off"
argument-range = "error"

[lint]
line-length = 120

[lint.prefixes]
num = "n"

[run]
lines = { 'Socket\host' = "server:2000" }
line-cost = 0.5
monitor-speed = 40
start = [0, 0, 90.5, 0, 90, 0]
power = true
profile = "operator"
profiles.operator = { password = "1234", controls-speed = true }
licences = { alter = "demo" }

[test]
applications = ["**/checks/*"]
limit = 30
replace = { feeder = "stubs/feeder" }
"#;

fn parse(text: &str) -> Result<ConfigFile, ConfigError> {
    ConfigFile::parse(Utf8Path::new("cell/val3.toml"), text)
}

#[track_caller]
fn refused(text: &str, expected: Expect) {
    expected.assert_eq(&format!("{}\n", parse(text).unwrap_err()));
}

#[test]
fn every_setting_is_read() {
    let file = parse(FULL).unwrap();
    assert_eq!(file.config.version.map(|version| version.to_string()).as_deref(), Some("s8.12"));
    assert_eq!(file.config.rules.get("V0301"), Some(&Level::Off));
    assert_eq!((file.config.lint.line_length, file.config.lint.complexity), (120, 20));
    let run = &file.config.run;
    assert_eq!((run.line_cost, run.monitor_speed, run.network), (Some(0.5), Some(40), false));
    assert_eq!((run.start.as_slice(), run.power), ([0.0, 0.0, 90.5, 0.0, 90.0, 0.0].as_slice(), true));
    assert_eq!(run.profiles["operator"], Profile { password: "1234".to_owned(), controls_speed: true });
    assert_eq!(run.licences["alter"], Licence::Demo);
    assert_eq!((file.line(r"run.lines.Socket\host"), file.line("run.line-cost")), (Some(21), Some(22)));
    assert_eq!(parse("run.line-cost = 3").unwrap().config.run.line_cost, Some(3.0));
    let tests = &file.config.test;
    assert_eq!((tests.limit, tests.replace["feeder"].as_str()), (Some(30.0), "stubs/feeder"));
    assert_eq!(file.line("test.replace.feeder"), Some(33));
    assert!(file.lists_tests_in(Utf8Path::new("cell/usr/checks/app")));
    assert!(
        !file.lists_tests_in(Utf8Path::new("cell/usr/checks")) && !file.lists_tests_in(Utf8Path::new("checks/app"))
    );
    assert!(file.excludes(Utf8Path::new("cell/old/app/app.pjx")));
    assert!(!file.excludes(Utf8Path::new("old/app/app.pjx")));
    assert_eq!(
        (file.line("version"), file.line("rules.V0301"), file.line("lint.complexity")),
        (Some(2), Some(11), None)
    );
    assert_eq!((file.line("roots.USB0"), file.line("lint.prefixes.num")), (Some(5), Some(18)));
}

#[test]
fn an_empty_file_sets_nothing() {
    assert_eq!(parse("").unwrap().config, Config::default());
}

#[test]
fn unknown_keys_are_reported() {
    refused(
        "verison = \"s8\"\n",
        expect![[r#"
            there is no setting `verison`
             --> cell/val3.toml:1
              |
            1 | verison = "s8"
              | ^^^^^^^
              help: did you mean `version`?
        "#]],
    );
    refused(
        "[lint]\nline_length = 100\n",
        expect![[r#"
            there is no setting `lint.line_length`
             --> cell/val3.toml:2
              |
            2 | line_length = 100
              | ^^^^^^^^^^^
              help: did you mean `line-length`?
        "#]],
    );
    refused(
        "[lint.naming]\nnum = \"n\"\n",
        expect![[r#"
            there is no setting `lint.naming`
             --> cell/val3.toml:1
              |
            1 | [lint.naming]
              |       ^^^^^^
              help: known settings: complexity, entry-points, entry-prefixes, line-length, local-prefix, motion, parameter-prefix, parameters, prefixes, target-version, task-words
        "#]],
    );
}

#[test]
fn wrong_types_are_reported() {
    refused(
        "version = 8.12\n",
        expect![[r#"
            `version` must be a text in quotes, and this is a number with a fraction
             --> cell/val3.toml:1
              |
            1 | version = 8.12
              |           ^^^^
        "#]],
    );
    refused(
        "add-ons = \"a.cfx\"\n",
        expect![[r#"
            `add-ons` must be a list in square brackets, and this is a text in quotes
             --> cell/val3.toml:1
              |
            1 | add-ons = "a.cfx"
              |           ^^^^^^^
        "#]],
    );
    refused(
        "exclude = [1]\n",
        expect![[r#"
            each entry of `exclude` must be a text in quotes, and this is a whole number
             --> cell/val3.toml:1
              |
            1 | exclude = [1]
              |            ^
        "#]],
    );
    refused(
        "[lint]\ncomplexity = -3\n",
        expect![[r#"
            `lint.complexity` cannot be negative
             --> cell/val3.toml:2
              |
            2 | complexity = -3
              |              ^^
        "#]],
    );
    refused(
        "rules = \"off\"\n",
        expect![[r#"
            `rules` must be a table, and this is a text in quotes
             --> cell/val3.toml:1
              |
            1 | rules = "off"
              |         ^^^^^
        "#]],
    );
}

#[test]
fn wrong_words_are_reported() {
    refused(
        "[rules]\nV0301 = \"eror\"\n",
        expect![[r#"
            `rules.V0301` must be one of off, on, info, warning, error, default, not "eror"
             --> cell/val3.toml:2
              |
            2 | V0301 = "eror"
              |         ^^^^^^
              help: did you mean `error`?
        "#]],
    );
    refused(
        "version = \"8.12\"\n",
        expect![[r#"
            `8.12` is not a version of VAL 3 from s5 to s8; write it like "s7.11"
             --> cell/val3.toml:1
              |
            1 | version = "8.12"
              |           ^^^^^^
        "#]],
    );
    refused(
        "arm = \"kr210\"\n",
        expect![[r#"
            `kr210` is not an arm; write "six-axis", "scara", "other", a model such as "tx2-60l", or the path of a file such as "cell/my-arm.toml"
             --> cell/val3.toml:1
              |
            1 | arm = "kr210"
              |       ^^^^^^^
        "#]],
    );
    refused(
        "exclude = [\"a[\"]\n",
        expect![[r#"
            the pattern `a[` cannot be read: `[` has no `]`
             --> cell/val3.toml:1
              |
            1 | exclude = ["a["]
              |           ^^^^^^
        "#]],
    );
}

#[test]
fn text_that_is_not_toml_is_reported() {
    refused(
        "version = s8.12\n",
        expect![[r#"
            this is not TOML: string values must be quoted, expected literal string
             --> cell/val3.toml:1
              |
            1 | version = s8.12
              |           ^^^^^
        "#]],
    );
    refused(
        "disk = 'a'\ndisk = 'b'\n",
        expect![[r#"
            this is not TOML: duplicate key
             --> cell/val3.toml:2
              |
            2 | disk = 'b'
              | ^^^^
        "#]],
    );
}
