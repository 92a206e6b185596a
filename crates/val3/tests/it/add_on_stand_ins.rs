//! Stand-in values for instructions of add-ons (`run.add-ons`).

use crate::support::Folder;

const PROGRAM: &str = "num nDelay\nbool bReady\nstring sName\n  nDelay=$getDelay()*2\n  bReady=$isReady(nDelay)\n  \
                       $setDelay(nDelay,true)\n  sName=$getName()\n  ? nDelay\n  ? bReady\n  ? sName\n";

const SETTINGS: &str =
    "[run.add-ons]\n'$getDelay' = 0.25\n'$isReady' = true\n'$setDelay' = 0\n'$getName' = \"stand-in\"\n";

#[test]
fn instructions_without_an_add_on_return_the_values_of_the_settings() {
    let folder = Folder::with(PROGRAM);
    assert!(folder.val3(&["run"]).stderr.contains("$getDelay"), "without a value the run ends at the line");
    folder.write("val3.toml", SETTINGS);
    let run = folder.val3(&["run"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "0.5\ntrue\nstand-in\n"), "{run:?}");
    assert!(folder.val3(&["check"]).stdout.contains("V0104"), "the controller still lacks the add-on");
}

#[test]
fn stand_ins_are_for_add_ons_only() {
    let folder = Folder::with(PROGRAM);
    folder.write("val3.toml", "[run.add-ons]\ngetDelay = 1\n");
    let run = folder.val3(&["run"]);
    assert!(run.code == 2 && run.stderr.contains("which begins with `$`"), "{run:?}");
}
