//! `val3 test`: data fields in scripts and expectations.

use crate::support::{CommandOutput, Folder};

const FIELDS: &str = r#"
type Tray "Disk://Tray/Tray.pjx"
Tray tA[2]
point pPick[2]
joint jHome
program start()
begin
  tA[1].nDone[2]=7
  pPick[1].trsf.x=120.5
  jHome.j3=90
  wait(tA[0].sName=="go")
  delay(0.1)
  tA[0].sName="done"
end
program stop()
begin
end
--- Tray
public num nDone[3]
public string sName
"#;

fn tested(scenario: &str) -> CommandOutput {
    let folder = Folder::with(FIELDS);
    folder.write("tests/cell.toml", &format!("application = \"../usrapp/main\"\nlimit = 5\n{scenario}"));
    folder.val3(&["test", "."])
}

#[test]
fn fields_are_set_and_expected() {
    let run = tested(
        "[[at]]\nt = 1\nset = { \"tA[0].sName\" = \"go\" }\n[expect]\n\
         data = { \"tA[1].nDone[2]\" = 7, \"pPick[1].trsf.x\" = { above = 120, below = 121 }, \"jHome.j3\" = 90, \
         \"tA.sName\" = \"done\" }\n",
    );
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
}

#[test]
fn fields_that_do_not_exist_are_refused() {
    for (path, message) in [
        ("tA[1].nDon", "there is no variable `tA[1].nDon`; did you mean `nDone`?"),
        ("tA[1].nDone[3]", "`tA[1].nDone` does not have this index"),
        ("tA[2].nDone[0]", "`tA` does not have this index"),
        ("pPick.trsf.w", "there is no variable `pPick.trsf.w`"),
        ("tA[1]", "`tA` is of type a user type and does not take this value"),
        ("tB.nDone", "there is no variable `tB.nDone`; did you mean `tA`?"),
    ] {
        let run = tested(&format!("[expect]\ndata = {{ '{path}' = 1 }}\n"));
        assert!(run.code == 2 && run.stdout.contains(message), "{path}: {run:?}");
    }
}
