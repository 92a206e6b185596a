//! `val3 test`: recorded screens and printed lines.

use expect_test::expect;

use crate::support::{CommandOutput, Folder};

const CODE: &str = "program start()\nbegin\n  userPage()\n  cls()\n  title(\"Cell\")\n  put(\"State running \")\n  ? \"one\"\n  \
                    delay(0.1)\n  ? \"two\"\nend\nprogram stop()\nbegin\nend\n";

const FILES: &str = "[expect]\nscreen_file = \"golden/end.txt\"\nprint_file = \"golden/lines.txt\"\n";

fn cell(code: &str) -> Folder {
    let folder = Folder::with(code);
    folder.write("tests/cell.toml", &format!("application = \"../usrapp/main\"\n{FILES}"));
    folder
}

fn change(folder: &Folder, from: &str, to: &str) {
    let program = folder.read("usrapp/main/start.pgx");
    assert!(program.contains(from), "{program}");
    folder.write("usrapp/main/start.pgx", &program.replace(from, to));
}

fn tested(folder: &Folder, args: &[&str]) -> CommandOutput {
    folder.val3(&[&["test", "."], args].concat())
}

#[test]
fn screens_and_prints_are_recorded_and_compared() {
    let folder = cell(CODE);
    let run = tested(&folder, &[]);
    assert!(
        run.code == 1 && run.stdout.contains("there is no recorded screen `golden/end.txt`: record it with"),
        "{run:?}"
    );
    let run = tested(&folder, &["--update"]);
    assert_eq!(run.stderr, "recorded: tests/golden/end.txt\nrecorded: tests/golden/lines.txt\n");
    assert_eq!(folder.read("tests/golden/end.txt"), "# Screen at the end of a test\nCell\nState running\n");
    assert_eq!(folder.read("tests/golden/lines.txt"), "# Printed lines of a test\none\ntwo\n");
    assert_eq!(tested(&folder, &[]).code, 0);
    assert_eq!(
        tested(&folder, &["--update"]).stderr,
        "unchanged: tests/golden/end.txt\nunchanged: tests/golden/lines.txt\n"
    );
    change(&folder, "running", "stopped");
    change(&folder, "\"two\"", "\"2\"");
    expect![[r#"
        main
          FAIL  cell (0.108 s)
                the screen is not that of `golden/end.txt`, from line 3
                  actual    "State stopped"
                  expected  "State running"
                at expect.screen_file (tests/cell.toml:3)
                    3 │ screen_file = "golden/end.txt"
                the printed text is not that of `golden/lines.txt`, from line 3
                  actual    "2"
                  expected  "two"
                at expect.print_file (tests/cell.toml:4)
                    4 │ print_file = "golden/lines.txt"
                | one
                | 2
        0 passed, 1 failed
    "#]]
    .assert_eq(&tested(&folder, &[]).stdout);
    let run = tested(&folder, &["--update"]);
    assert_eq!(
        (run.code, run.stderr.as_str()),
        (0, "changed: tests/golden/end.txt\nchanged: tests/golden/lines.txt\n")
    );
}

#[test]
fn nothing_else_is_recorded() {
    // An empty page would prove nothing.
    let folder = cell("program start()\nbegin\n  ? \"one\"\nend\nprogram stop()\nbegin\nend\n");
    let run = tested(&folder, &["--update"]);
    assert!(run.code == 1 && run.stdout.contains("the screen is empty, so there is nothing to compare"), "{run:?}");
    assert!(!folder.path().join("tests/golden/end.txt").exists());
    // A file of another kind is not replaced.
    let folder = cell(CODE);
    folder.write("tests/golden/end.txt", "mine\n");
    let run = tested(&folder, &["--update"]);
    assert!(run.code == 2 && run.stdout.contains("it exists and is no recorded text"), "{run:?}");
    assert_eq!(folder.read("tests/golden/end.txt"), "mine\n");
    // A file outside of the cell is not written.
    let folder = cell(CODE);
    let outside = FILES.replace("golden/end.txt", "../../../end.txt");
    folder.write("tests/cell.toml", &format!("application = \"../usrapp/main\"\n{outside}"));
    let run = tested(&folder, &["--update"]);
    assert!(run.code == 2 && run.stdout.contains("outside of the cell"), "{run:?}");
}

/// Scenarios that cannot be executed or judged.
const UNUSABLE: [&str; 7] = [
    "application = \"../usrapp/main\"\nprint_fil = 1\n[expect]\n",
    "application = \"../usrapp/none\"\n[expect]\n",
    "application = \"../../../none\"\n[expect]\n",
    "application = \"../usrapp/main\"\ncell = \"none.toml\"\n[expect]\n",
    "application = \"../usrapp/main\"\n[replace]\nio = \"../../../none\"\n",
    "application = \"../usrapp/main\"\nknown_failure = \"x\"\n[expect]\nprint_file = \"../../../outside.txt\"\n",
    "application = \"../usrapp/main\"\n[expect]\ntrace = \"../../../outside.csv\"\n",
];

#[test]
fn an_unusable_scenario_fails_alone_and_all_reports_are_written() {
    for scenario in UNUSABLE {
        let folder = cell(CODE);
        tested(&folder, &["--update"]);
        folder.write("tests/bad.toml", scenario);
        let run = tested(&folder, &["--jobs", "1", "--output", "junit=none/j.xml", "--output", "json=r.json"]);
        assert!(run.code == 2 && run.stderr.contains("none/j.xml"), "a report cannot be written: {run:?}");
        assert!(run.stdout.ends_with("1 passed, 1 failed\n"), "{scenario}: {run:?}");
        let report: serde_json::Value = serde_json::from_str(&folder.read("r.json")).unwrap();
        assert_eq!((&report["passed"], &report["failed"]), (&1.into(), &1.into()), "{scenario}: {report}");
        let run = tested(&folder, &["--output", "junit=j.xml"]);
        assert_eq!(run.code, 2, "{scenario}: {run:?}");
        assert!(folder.read("j.xml").contains("</testsuites>"), "{scenario}");
    }
}
