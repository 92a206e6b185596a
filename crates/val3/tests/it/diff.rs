//! `val3 diff` on folders and files.

use crate::support::{CLEAN, CommandOutput, Folder, copy_folder, run};

const MOVED: &str = "point pPick\nnum nCount = 1\nnCount=2\n";

/// A folder with two backups, `old` and `new`.
fn backups(old: &str, new: &str) -> Folder {
    let folder = Folder::empty();
    for (name, listing) in [("old", old), ("new", new)] {
        for (path, text) in val3_test::Fixture::parse(listing).files {
            folder.write(&format!("{name}/usr/{path}"), &text);
        }
    }
    folder
}

fn check(run: &CommandOutput, code: i32, words: &[&str]) {
    assert_eq!((run.code, run.stderr.as_str()), (code, ""), "{run:?}");
    words.iter().for_each(|word| assert!(run.stdout.contains(word), "no `{word}`: {run:?}"));
}

#[test]
fn the_exit_code_says_whether_something_differs() {
    let folder = backups(MOVED, &MOVED.replace("= 1", "= 5"));
    check(&folder.val3(&["diff", "old", "new"]), 1, &["nCount  1 → 5", "1 application differs: 1 value"]);
    check(&folder.val3(&["diff", "new", "new"]), 0, &["no differences in 1 application"]);
}

#[test]
fn roots_may_be_cells_applications_and_project_files() {
    let folder = backups(MOVED, &MOVED.replace("= 1", "= 5"));
    let new = ["new", "new/usr", "new/usr/usrapp", "new/usr/usrapp/main", "new/usr/usrapp/main/main.pjx"];
    for new in new {
        let run = folder.val3(&["diff", "old", new]);
        check(&run, 1, &["nCount  1 → 5"]);
        assert!(!run.stdout.contains("Programs"), "{new} {run:?}");
    }
    let projects = ["diff", "old/usr/usrapp/main/main.pjx", "new/usr/usrapp/main/main.pjx"];
    check(&folder.val3(&projects), 1, &["nCount  1 → 5"]);
}

#[test]
fn single_files_and_absent_ones_are_compared() {
    let folder = backups(MOVED, &MOVED.replace("= 1", "= 5"));
    let (old, new) = ("old/usr/usrapp/main/main.dtx", "new/usr/usrapp/main/main.dtx");
    check(&folder.val3(&["diff", old, new]), 1, &["nCount  1 → 5"]);
    check(&folder.val3(&["diff", "/dev/null", new]), 1, &["+ num nCount = 5"]);
    check(&folder.val3(&["diff", new, "/dev/null"]), 1, &["- num nCount = 5"]);
    check(&folder.val3(&["diff", new, new]), 0, &["no differences"]);
    folder.write("temporary.1", &folder.read(old));
    check(&folder.val3(&["diff", "temporary.1", new]), 1, &["nCount  1 → 5"]);
}

#[test]
fn parts_can_be_asked_for_alone() {
    let folder = backups(MOVED, "point pNew\nnum nCount = 5\nnCount=3\n");
    let run = folder.val3(&["diff", "--only", "programs", "old", "new"]);
    check(&run, 1, &["nCount=3"]);
    assert!(!run.stdout.contains("pNew") && !run.stdout.contains("1 → 5"), "{run:?}");
    check(&folder.val3(&["diff", "--only", "points,data", "old", "new"]), 1, &["pNew", "1 → 5"]);
    check(&folder.val3(&["diff", "--only", "libraries", "old", "new"]), 0, &["no differences"]);
}

#[test]
fn differences_can_be_left_out_and_are_counted() {
    let old = "point pPick\nnum nCount = 1\nnum nOther = 1\nnCount=2\n";
    let folder = backups(old, &old.replace("= 1", "= 5").replace("nCount=2", "  nCount = 2"));
    let data = folder.read("new/usr/usrapp/main/main.dtx");
    let point = "name=\"pPick\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"1\">";
    assert!(data.contains(point), "{data}");
    for (version, x) in [("old", 0.0), ("new", 0.001)] {
        let path = format!("{version}/usr/usrapp/main/main.dtx");
        let text = folder.read(&path);
        let start = text.find(point).unwrap() + point.len();
        let value = text[start..].find("<Value").unwrap() + start;
        let end = text[value..].find("/>").unwrap() + value + 2;
        let moved = format!("<Value key=\"0\" x=\"{x}\" fatherId=\"world[0]\" />");
        folder.write(&path, &(text[..value].to_owned() + &moved + &text[end..]));
    }
    let all =
        ["--tolerance", "0.01mm,0.01deg", "--ignore-data", "n*Count", "--ignore-data", "nO?her", "--ignore", "layout"];
    let left_out = "1 position within 0.01 mm and 0.01°, 2 values named n*Count or nO?her, 1 program in another layout";
    check(&folder.val3(&[&["diff", "old", "new"], &all[..]].concat()), 0, &["no differences", left_out]);
    check(&folder.val3(&[&["diff", "old", "new"], &all[..4]].concat()), 1, &["nOther  1 → 5", "1 value named n*Count"]);
    let markdown = folder.val3(&[&["diff", "old", "new", "--format", "markdown"], &all[..]].concat());
    check(&markdown, 0, &["no differences in 1 application; ignored: 1 position"]);
    let json = folder.val3(&[&["diff", "old", "new", "--format", "json", "--stat"], &all[..2]].concat());
    let json: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(
        (&json["ignored"]["within_tolerance"], &json["statistics"][0]["counts"]["data"]),
        (&1.into(), &2.into())
    );
    check(
        &folder.val3(&["diff", "old", "new", "--stat"]),
        1,
        &["Application  Positions  Values  Programs  Greatest", "pPick"],
    );
}

#[test]
fn every_format_has_its_form() {
    let folder = backups(MOVED, &MOVED.replace("= 1", "= 5"));
    let format = |format: &str| folder.val3(&["diff", "old", "new", "--format", format]);
    check(&format("markdown"), 1, &["# `old` → `new`", "- **changed** `nCount` 1 → 5"]);
    check(&format("html"), 1, &["<!DOCTYPE html>", "<code>nCount</code> 1 → 5"]);
    let json: serde_json::Value = serde_json::from_str(&format("json").stdout).unwrap();
    assert_eq!((&json["version"], &json["different"], &json["old"]), (&1.into(), &true.into(), &"old".into()));
    assert_eq!(json["applications"][0]["data"][0]["values"][0]["fields"][0]["new"], "5");
    check(&folder.val3(&["diff", "old", "new", "--color", "always"]), 1, &["\u{1b}["]);
}

#[test]
fn one_file_is_printed_for_git() {
    let folder = backups(CLEAN, CLEAN);
    let run = folder.val3(&["diff", "--textconv", "old/usr/usrapp/main/start.pgx"]);
    check(&run, 0, &["private program start()\nbegin\n", "nCount=nCount+1"]);
    check(&folder.val3(&["diff", "--textconv", "old/usr/usrapp/main/main.dtx"]), 0, &["num nCount\n"]);
}

#[test]
fn wrong_usage_is_refused() {
    let folder = backups(CLEAN, CLEAN);
    folder.write("empty/notes.txt", "none");
    for (arguments, word) in [
        (&["diff"][..], "val3 diff OLD NEW"),
        (&["diff", "old"], "two versions"),
        (&["diff", "old", "new", "old"], "3 are given"),
        (&["diff", "old", "nwe"], "`nwe`"),
        (&["diff", "old", "empty"], "no VAL 3 files"),
        (&["diff", "old", "empty/notes.txt"], "a file cannot be compared with a folder"),
        (&["diff", "empty/notes.txt", "empty/notes.txt"], "not a VAL 3 file"),
        (&["diff", "--only", "pionts", "old", "new"], "points"),
        (&["diff", "--tolerance", "0.01", "old", "new"], "`0.01` has no unit: write a distance in mm"),
        (&["diff", "--ignore-data", "n[", "old", "new"], "the pattern `n[` cannot be read"),
        (&["diff", "--ignore", "comments", "old", "new"], "layout"),
        (&["diff", "--textconv", "nothing.dtx"], "nothing.dtx"),
        (&["diff", "--git", "HEAD", "--textconv", "old"], "--textconv"),
    ] {
        let run = folder.val3(arguments);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{arguments:?} {run:?}");
        assert!(run.stderr.contains(word), "{arguments:?} {run:?}");
    }
}

#[cfg(unix)]
#[test]
fn unreadable_files_are_named_and_a_closed_pipe_is_no_error() {
    let folder = backups(CLEAN, MOVED);
    let mut command = std::process::Command::new("sh");
    let script = format!("{} diff old new; echo $? > code", env!("CARGO_BIN_EXE_val3"));
    let output = command.arg("-c").arg(format!("({script}) | true")).current_dir(folder.path()).output().unwrap();
    assert!(output.stderr.is_empty(), "{output:?}");
    std::os::unix::fs::symlink("missing.pgx", folder.path().join("old/usr/usrapp/main/broken.pgx")).unwrap();
    std::os::unix::fs::symlink("..", folder.path().join("old/usr/usrapp/circle")).unwrap();
    let mut command = folder.command(&["diff", "old", "old"]);
    command.env("NO_COLOR", "1");
    assert_eq!(run(command).code, 0);
}

/// The example palletiser after a service visit.
#[test]
fn the_report_on_the_page_is_a_real_one() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = Folder::empty();
    for name in ["palletiser.pjx", "palletiser.dtx", "cycle.pgx"] {
        let path = root.join("examples/palletiser/usr/usrapp/palletiser").join(name);
        let text = std::fs::read_to_string(path).unwrap();
        folder.write(&format!("monday/palletiser/{name}"), &text);
        let text = text
            .replace("rz=\"90\" fatherId=\"fCell[0]\"", "rz=\"90.5\" fatherId=\"fCell[0]\"")
            .replace("z=\"950\" rx=\"180\" shoulder=\"lefty\"", "z=\"955\" rx=\"180\" shoulder=\"righty\"")
            .replace("value=\"stopped\"", "value=\"Stopped\"")
            .replace("  call pick(x_bOk)", "  call pick(x_bOk)\n  delay(0.5)");
        folder.write(&format!("friday/palletiser/{name}"), &text);
    }
    let page = std::fs::read_to_string(root.join("docs/src/diff.md")).unwrap();
    let shown = page.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    assert_eq!(folder.val3(&["diff", "monday", "friday"]).stdout, shown);
}

#[test]
fn other_files_of_applications_and_backups_are_compared() {
    let folder = backups(MOVED, MOVED);
    for version in ["old", "new"] {
        folder.write(&format!("{version}/usr/usrapp/main/.lock"), version);
        folder.write(&format!("{version}/usr/app/add.dll"), "same");
        folder.write(&format!("{version}/usr/usrapp/main/recipes/12.txt"), version);
    }
    let report = ["~ main/recipes/12.txt", "1 other file differs"];
    check(&folder.val3(&["diff", "old", "new"]), 1, &report);
    check(&folder.val3(&["diff", "old/usr", "new"]), 1, &report);
    check(&folder.val3(&["diff", "old/usr/usrapp/main", "new/usr/usrapp/main"]), 1, &["~ recipes/12.txt", report[1]]);
    check(&folder.val3(&["diff", "old/usr/usrapp", "new/usr/usrapp/main"]), 1, &["~ recipes/12.txt", report[1]]);
    check(&folder.val3(&["diff", "old", "new", "--only", "programs,files"]), 1, &report);
    check(&folder.val3(&["diff", "old", "new", "--only", "programs"]), 0, &[]);
    copy_folder(&folder.path().join("new/usr"), &folder.path().join("friday"));
    check(&folder.val3(&["diff", "old/usr", "friday"]), 1, &report);
    folder.write("new/usr/usrapp/main/recipes/12.txt", "old");
    check(&folder.val3(&["diff", "old", "new"]), 0, &["no differences in 1 application"]);
}

#[test]
fn a_folder_that_is_not_searched_is_an_error() {
    let folder = backups(MOVED, MOVED);
    folder.write(&format!("new/usr/{}x.txt", "deep/".repeat(33)), "");
    let run = folder.val3(&["diff", "old", "new"]);
    assert_eq!((run.code, run.stderr.contains("more than 32 folders deep")), (2, true), "{run:?}");
}

#[test]
fn archives_in_folders_are_compared_by_their_bytes() {
    let folder = backups(MOVED, MOVED);
    ["old", "new"].into_iter().for_each(|version| folder.write(&format!("{version}/usr/backup.zip"), version));
    check(&folder.val3(&["diff", "old", "new"]), 1, &["~ backup.zip", "1 other file differs"]);
}
