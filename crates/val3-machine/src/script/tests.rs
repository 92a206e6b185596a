use expect_test::{Expect, expect};

use super::values::Keys;
use super::*;

#[track_caller]
fn check_error(text: &str, expected: Expect) {
    expected.assert_eq(&Script::parse(text).unwrap_err().to_string());
}

#[test]
fn the_form_of_the_page_is_read() {
    let page = include_str!("../script.rs");
    let mut in_example = false;
    let mut example = String::new();
    for line in page.lines().filter_map(|line| line.strip_prefix("//! ")) {
        match line {
            "```toml" => in_example = true,
            "```" => in_example = false,
            _ if in_example => example.extend([line, "\n"]),
            _ => {}
        }
    }
    let script = Script::parse(&example).unwrap();
    assert_eq!(script.next_due(), Some(1_500_000_000));
    let entry = &script.pending[0].entry;
    assert_eq!(entry.io.len(), 2);
    assert_eq!(entry.keys, Some(Keys(vec![49, 50, 46, 53])));
    assert!(entry.stop && entry.power == Some(true) && entry.set.len() == 2);
    let [reaction] = script.reactions.as_slice() else { panic!("{:?}", script.reactions) };
    assert_eq!(reaction.entries().count(), 2);
    let line = example.lines().position(|line| line == "[[when]]").unwrap() + 1;
    assert_eq!(reaction.place(), ScriptPlace::When(line));
}

#[test]
fn entries_happen_in_the_order_of_their_times() {
    let mut script =
        Script::parse("[[at]]\nt = 2\nkey = 97\n[[at]]\nt = 1.5\nkey = 98\n[[at]]\nt = 2\nkey = 99").unwrap();
    assert_eq!(script.take_due(1_499_999_999), None);
    let keys = std::iter::from_fn(|| script.take_due(2_000_000_000)).map(|pending| pending.entry.key.unwrap().0);
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
            unknown field `ky`, expected one of `t`, `after`, `io`, `lock`, `unlock`, `simulate`, `protect`, `fault`, `set`, `power`, `estop`, `safety_fault`, `calibrated`, `mode`, `monitor_speed`, `move`, `joints`, `jog`, `place`, `remove`, `force`, `connect`, `click`, `key`, `keys`, `stop`, `receive`"#]],
    );
    check_error(
        "[[at]]\nkey = 270",
        expect![[r#"
        TOML parse error at line 1, column 1
          |
        1 | [[at]]
          | ^^^^^^
        `[[at]]` has no time: write `t`, in seconds since the start"#]],
    );
    check_error(
        "[[at]]\nt = -1",
        expect![[r#"
            TOML parse error at line 2, column 5
              |
            2 | t = -1
              |     ^^
            -1 is not a time: write seconds, 0 or more"#]],
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

#[test]
fn faults_of_reactions_are_shown_with_their_position() {
    let then = "then = [{ key = 97 }]";
    check_error(
        "[[when]]\nthen = [{ key = 97 }]",
        expect![[r#"
            TOML parse error at line 1, column 1
              |
            1 | [[when]]
              | ^^^^^^^^
            a condition needs a signal in `io`, a variable in `data`, a sensor in `seen`, or a part in `held`"#]],
    );
    check_error(
        "[[when]]\ndata = { nState = 3 }",
        expect![[r#"
        TOML parse error at line 1, column 1
          |
        1 | [[when]]
          | ^^^^^^^^
        missing field `then`"#]],
    );
    check_error(
        "[[when]]\ndata = { nState = 3 }\nthen = []",
        expect![[r#"
        TOML parse error at line 1, column 1
          |
        1 | [[when]]
          | ^^^^^^^^
        `then` is empty: write the entries that happen, such as { after = 0.5, key = "F1" }"#]],
    );
    check_error(
        "[[when]]\ndata = { nState = 3 }\nthen = [{ t = 1, key = 97 }]",
        expect![[r#"
        TOML parse error at line 3, column 8
          |
        3 | then = [{ t = 1, key = 97 }]
          |        ^^^^^^^^^^^^^^^^^^^^^
        a reaction has no time of its own: write `after`, in seconds since its condition holds"#]],
    );
    check_error(
        "[[when]]\ndata = { nState = 3 }\nthen = [{ after = -1, key = 97 }]",
        expect![[r#"
        TOML parse error at line 3, column 19
          |
        3 | then = [{ after = -1, key = 97 }]
          |                   ^^
        -1 is not a time: write seconds, 0 or more"#]],
    );
    check_error(
        "[[at]]\nafter = 1\nkey = 97",
        expect![[r#"
        TOML parse error at line 1, column 1
          |
        1 | [[at]]
          | ^^^^^^
        `after` is for the `then` of a reaction: write `t`, in seconds since the start"#]],
    );
    check_error(
        &format!("[[when]]\ndata = {{ nState = [3] }}\n{then}"),
        expect![[r#"
        TOML parse error at line 2, column 19
          |
        2 | data = { nState = [3] }
          |                   ^^^
        a variable is compared with true, false, a number, a text or a range such as { above = 2, below = 5 }"#]],
    );
    check_error(
        &format!("[[when]]\ndata = {{ nState = {{ atLeast = 3 }} }}\n{then}"),
        expect![[r#"
        TOML parse error at line 2, column 19
          |
        2 | data = { nState = { atLeast = 3 } }
          |                   ^^^^^^^^^^^^^^^
        a variable is compared with true, false, a number, a text or a range such as { above = 2, below = 5 }"#]],
    );
    check_error(
        &format!("[[when]]\ndata = {{ nState = {{ }} }}\n{then}"),
        expect![[r#"
        TOML parse error at line 2, column 19
          |
        2 | data = { nState = { } }
          |                   ^^^
        a variable is compared with true, false, a number, a text or a range such as { above = 2, below = 5 }"#]],
    );
    check_error(
        &format!("[[when]]\nio = {{ valve = \"on\" }}\n{then}"),
        expect![[r#"
        TOML parse error at line 2, column 16
          |
        2 | io = { valve = "on" }
          |                ^^^^
        a signal is compared with true, false, a number or a range such as { above = 2, below = 5 }"#]],
    );
    check_error(
        &format!("[[when]]\nio = {{ valve = true }}\ntimes = 0\n{then}"),
        expect![[r#"
        TOML parse error at line 3, column 9
          |
        3 | times = 0
          |         ^
        0 is no number of times: write a whole number from 1"#]],
    );
    check_error(
        &format!("[[when]]\nio = {{ valve = true }}\ntimes = 1.5\n{then}"),
        expect![[r#"
        TOML parse error at line 3, column 9
          |
        3 | times = 1.5
          |         ^^^
        1.5 is no number of times: write a whole number from 1"#]],
    );
    check_error(
        &format!("[[when]]\nsignals = {{ valve = true }}\n{then}"),
        expect![[r#"
            TOML parse error at line 2, column 1
              |
            2 | signals = { valve = true }
              | ^^^^^^^
            unknown field `signals`, expected one of `io`, `data`, `seen`, `held`, `sent`, `then`, `times`"#]],
    );
}

#[test]
fn an_action_happens_at_once() {
    let action =
        |keys: &str| ScriptAction::from_json(serde_json::from_str(keys).unwrap()).map_err(|error| error.to_string());
    assert!(action(r#"{ "key": 97 }"#).is_ok());
    for time in ["t", "after"] {
        let refused = action(&format!(r#"{{ "key": 97, "{time}": 1 }}"#)).unwrap_err();
        assert_eq!(refused, "an action happens at once: it has neither `t` nor `after`");
    }
}
