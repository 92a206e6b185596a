//! `val3 test`: tests of private programs and data.

use crate::support::Folder;

const PRIVATE: &str = r#"
num nUnused
--- palTest
library pal "Disk://pal/pal.pjx"
program testNext()
  num l_nResult
begin
  call pal:next(l_nResult)
  ? l_nResult
  pal:nLast=20
  call pal:next(l_nResult)
  ? l_nResult
  if pal:nLast!=21
    ? pal:nMissing
  endIf
end
--- pal
num nLast
program next(num& x_nResult)
begin
  nLast=nLast+1
  x_nResult=nLast
end
"#;

#[test]
fn a_test_application_uses_private_items_of_what_it_tests() {
    let folder = Folder::with(&PRIVATE.replace("    ? pal:nMissing\n", "    stopMove()\n"));
    let checked = folder.val3(&["check", "."]);
    assert!(!checked.stdout.contains("V0602"), "{checked:?}");
    let run = folder.val3(&["test", ".", "--format", "json"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    let report: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(report["tests"][0]["prints"], serde_json::json!(["1", "21"]));
    // The debugger and `val3 run` execute the same code.
    let run = folder.val3(&["eval", "--app", "usrapp/palTest", "call pal:next(nUnused)"]);
    assert!(!run.stderr.contains("private"), "{run:?}");
}

#[test]
fn other_applications_do_not_and_items_that_do_not_exist_stay_errors() {
    let folder = Folder::with(&PRIVATE.replace("--- palTest", "--- other"));
    let checked = folder.val3(&["check", "."]);
    assert_eq!(checked.code, 1, "{checked:?}");
    assert_eq!(checked.stdout.matches("error[V0602]").count(), 2, "{checked:?}");
    let folder = Folder::with(PRIVATE);
    let run = folder.val3(&["test", "."]);
    assert!(run.code == 2 && run.stdout.contains("nMissing"), "{run:?}");
}
