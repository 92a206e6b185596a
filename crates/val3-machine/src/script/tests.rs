use expect_test::{Expect, expect};

use super::*;

#[track_caller]
fn check_error(text: &str, expected: Expect) {
    expected.assert_eq(&Script::parse(text).unwrap_err().to_string());
}

#[test]
fn the_form_of_the_page_is_read() {
    let page = include_str!("../script.rs");
    let lines = page.lines().filter_map(|line| line.strip_prefix("//! "));
    let example: Vec<&str> =
        lines.skip_while(|line| *line != "```toml").skip(1).take_while(|line| *line != "```").collect();
    let script = Script::parse(&example.join("\n")).unwrap();
    assert_eq!(script.next_due(), Some(1_500_000_000));
    let entry = &script.entries[0];
    assert_eq!(entry.io.len(), 2);
    assert_eq!(entry.keys, Some(Keys(vec![49, 50, 46, 53])));
    assert!(entry.stop && entry.power == Some(true) && entry.set.len() == 2);
}

#[test]
fn entries_happen_in_the_order_of_their_times() {
    let mut script =
        Script::parse("[[at]]\nt = 2\nkey = 97\n[[at]]\nt = 1.5\nkey = 98\n[[at]]\nt = 2\nkey = 99").unwrap();
    assert_eq!(script.take_due(1_499_999_999), None);
    let keys = std::iter::from_fn(|| script.take_due(2_000_000_000)).map(|entry| entry.key.unwrap().0);
    assert_eq!(keys.collect::<Vec<_>>(), [98, 97, 99]);
    assert_eq!(Script::parse("").unwrap(), Script::default());
}

#[test]
fn faults_are_shown_with_their_position() {
    check_error(
        "[[at]]\nt = \"1.5\"",
        expect![[r#"
        TOML parse error at line 2, column 5
          |
        2 | t = "1.5"
          |     ^^^^^
        write a number"#]],
    );
    check_error(
        "[[at]]\nt = 1\nky = 270",
        expect![[r#"
            TOML parse error at line 3, column 1
              |
            3 | ky = 270
              | ^^
            unknown field `ky`, expected one of `t`, `io`, `lock`, `unlock`, `simulate`, `protect`, `fault`, `set`, `power`, `estop`, `safety_fault`, `calibrated`, `mode`, `monitor_speed`, `move`, `joints`, `jog`, `force`, `connect`, `key`, `keys`, `stop`"#]],
    );
    check_error(
        "[[at]]\nkey = 270",
        expect![[r#"
        TOML parse error at line 1, column 1
          |
        1 | [[at]]
          | ^^^^^^
        missing field `t`"#]],
    );
    check_error(
        "[[at]]\nt = -1",
        expect![[r#"
            TOML parse error at line 2, column 5
              |
            2 | t = -1
              |     ^^
            -1 is not a time: write seconds since the start"#]],
    );
    check_error(
        "[[at]]\nt = 1\nkey = \"Enter\"",
        expect![[r#"
            TOML parse error at line 3, column 7
              |
            3 | key = "Enter"
              |       ^^^^^^^
            `Enter` is not a key: write a code such as 97 for `a`, or a name such as Return, Esc or F1"#]],
    );
    check_error(
        "[[at]]\nt = 1\nmode = 7",
        expect![[r#"
        TOML parse error at line 3, column 8
          |
        3 | mode = 7
          |        ^
        no such mode: write manual (1), test (2), local (3) or remote (4)"#]],
    );
    check_error(
        "[[at]]\nt = 1\nmonitor_speed = 120",
        expect![[r#"
        TOML parse error at line 3, column 17
          |
        3 | monitor_speed = 120
          |                 ^^^
        the monitor speed is 0 to 100 %, not 120"#]],
    );
    check_error(
        "[[at]]\nt = 1\nio = { x = \"on\" }",
        expect![[r#"
        TOML parse error at line 3, column 12
          |
        3 | io = { x = "on" }
          |            ^^^^
        an input or output is true, false or a number"#]],
    );
    check_error(
        "[[at]]\nt = 1\nlock = 3",
        expect![[r#"
        TOML parse error at line 3, column 8
          |
        3 | lock = 3
          |        ^
        write the path of an input or output, a list of such paths, or a table of paths and values"#]],
    );
    check_error(
        "[[at]]\nt = 1\nfault = { link = \"x\" }",
        expect![[r#"
        TOML parse error at line 3, column 9
          |
        3 | fault = { link = "x" }
          |         ^^^^^^^^^^^^^^
        missing field `code`"#]],
    );
    check_error(
        "[[at]]\nt = ?",
        expect![[r#"
            TOML parse error at line 2, column 5
              |
            2 | t = ?
              |     ^
            string values must be quoted, expected literal string"#]],
    );
}
