//! `--statistics` counts instead of listing.

use crate::support::{FAULTY, Folder};

#[test]
fn rules_are_counted() {
    let folder = Folder::with(&format!("{FAULTY}\n--- part\n{FAULTY}IF nCount==1\nendIf\n"));
    let run = folder.val3(&["check", "--statistics"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.starts_with("2 ? V0101 error   unknown-name\n1 * V0701 info    keyword-spelling\n"), "{run:?}");
    assert!(run.stderr.contains("2 errors, 1 info in 2 of 8 files"), "{run:?}");
}

#[test]
fn counts_are_written_as_json() {
    let run = Folder::with(FAULTY).val3(&["check", "--statistics", "--format", "json"]);
    let counts: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!((&counts[0]["code"], &counts[0]["count"]), (&"V0101".into(), &1.into()), "{run:?}");
    assert_eq!(Folder::with(FAULTY).val3(&["check", "--statistics", "--format", "sarif"]).code, 2);
}
