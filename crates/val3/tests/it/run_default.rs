//! `val3 run` for a folder with several applications: the default run in its `val3.toml`.

use std::fs;
use std::path::Path;

use expect_test::expect;

use crate::support::{Folder, copy_folder};

/// Two applications with a `val3.toml`.
fn cell(settings: &str) -> Folder {
    let folder =
        Folder::with("? \"main\"\ndelay(5)\n? clock()\n--- other\nprogram start()\nbegin\n  ? \"other\"\nend\n");
    folder.write("val3.toml", settings);
    folder.write("day.toml", "at = []\n");
    folder
}

const DEFAULT: &str = "
[run.default]
application = \"usrapp/main\"
script = \"day.toml\"
until = 2
until-ok = true
plot = \"path.svg\"
export = \"run.html\"
";

#[test]
fn a_folder_runs_the_application_that_its_settings_name() {
    let folder = cell(DEFAULT);
    let run = folder.val3(&["run"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "main\n"), "{run:?}");
    expect![[r#"
        note: `[run.default]` in val3.toml names this run:
          val3 run usrapp/main --script day.toml --until 2 --until-ok --plot path.svg --export run.html
        note: the check has no findings in 4 files
        wrote path.svg
        wrote run.html
    "#]]
    .assert_eq(&run.stderr);
    assert!(folder.read("path.svg").starts_with("<svg") && folder.read("run.html").contains("recording"));
}

#[test]
fn arguments_replace_the_settings_of_a_default_run() {
    let folder = cell(DEFAULT);
    let run = folder.val3(&["run", "usrapp", "--until", "3", "--plot", "mine.svg"]);
    assert_eq!((run.code, run.stdout.as_str()), (3, "main\n"), "{run:?}");
    assert!(folder.path().join("mine.svg").exists() && !folder.path().join("path.svg").exists());
    assert!(
        run.stderr.contains("--until 3 --plot mine.svg --export run.html") && run.stderr.ends_with("wrote run.html\n")
    );
    // The settings do not apply to an application that an argument names.
    let run = folder.val3(&["run", "usrapp/main"]);
    assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "main\n5\n", ""), "{run:?}");
    assert_eq!(folder.val3(&["run", "usrapp/other"]).stdout, "other\n");
}

#[test]
fn several_applications_without_a_default_are_listed() {
    let run = cell("").val3(&["run"]);
    assert_eq!(run.code, 2);
    expect![[r#"
        error: `.` holds 2 applications
          help: name the folder of one of them: usrapp/main, usrapp/other; or set `[run.default] application` in val3.toml
    "#]].assert_eq(&run.stderr);
    // The default application is not in the named folder.
    let run = cell("[run.default]\napplication = \"elsewhere\"\n").val3(&["run", "usrapp"]);
    assert_eq!(run.code, 2);
    expect![[r#"
        error: `usrapp` holds 2 applications
          help: name the folder of one of them: main, other; or set `[run.default] application` in val3.toml
    "#]]
    .assert_eq(&run.stderr);
}

#[test]
fn a_cell_chooses_no_other_files_to_write() {
    expect![[r#"
        error: `run.default.plot` writes `.git/hooks.svg`: name a file below the folder of this file, without `..` and hidden folders
         --> val3.toml:3
          |
        3 | plot = ".git/hooks.svg"
          | ^^^^
    "#]].assert_eq(&setting_error("plot = \".git/hooks.svg\""));
    expect![[r#"
        error: `run.default.export` writes `../run.html`: name a file below the folder of this file, without `..` and hidden folders
         --> val3.toml:3
          |
        3 | export = "../run.html"
          | ^^^^^^
    "#]].assert_eq(&setting_error("export = \"../run.html\""));
}

/// Error of a default run with this setting.
fn setting_error(setting: &str) -> String {
    let folder = cell(&format!("[run.default]\napplication = \"usrapp/main\"\n{setting}\n"));
    fs::create_dir(folder.path().join(".git")).unwrap();
    let run = folder.val3(&["run"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
    run.stderr
}

#[cfg(unix)]
#[test]
fn a_default_run_writes_through_no_link() {
    let folder = cell(DEFAULT);
    folder.write("precious.txt", "kept");
    std::os::unix::fs::symlink("precious.txt", folder.path().join("run.html")).unwrap();
    let run = folder.val3(&["run"]);
    assert_eq!((run.code, folder.read("precious.txt").as_str()), (2, "kept"), "{run:?}");
    expect![[r#"
        error: `run.default.export` writes through a link, which could resolve to another file
         --> val3.toml:8
          |
        8 | export = "run.html"
          | ^^^^^^
          help: name a file that is not a link
    "#]]
    .assert_eq(&run.stderr);
}

/// The first command of the README.
#[test]
fn the_palletiser_runs_in_virtual_time() {
    let folder = Folder::empty();
    copy_folder(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/palletiser"),
        &folder.path().join("palletiser"),
    );
    let run = folder.val3(&["run", "palletiser"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, "log: USR loaded box from Disk://partBox\n"), "{run:?}");
    assert!(run.stderr.contains("times of 11.000 s") && !run.stderr.contains("real"), "{run:?}");
    assert!(run.stderr.ends_with("wrote palletiser/palletiser.svg\nwrote palletiser/palletiser.html\n"), "{run:?}");
}
