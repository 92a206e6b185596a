//! `val3 merge` as git's merge driver.

use crate::git::{commit, git, git_ok};
use crate::support::Folder;

const DATA: &str = "usrapp/main/main.dtx";
const PROJECT: &str = "usrapp/main/main.pjx";
const PROGRAM: &str = "usrapp/main/start.pgx";

const POINTS: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
    <Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n    \
    <Data name=\"pPts\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"3\">\n      \
    <Value key=\"0\" x=\"1\" fatherId=\"world[0]\" />\n      <Value key=\"1\" x=\"2\" fatherId=\"world[0]\" />\n      \
    <Value key=\"2\" x=\"3\" fatherId=\"world[0]\" />\n    </Data>\n  </Datas>\n</Database>\n";

/// A repository with one commit, in which git merges with `val3 merge`.
fn repository() -> Folder {
    let folder = Folder::with("num nCount\nnCount=1\nnCount=2\nnCount=3\nnCount=4\n");
    folder.write(DATA, POINTS);
    git_ok(&folder, &["init", "-q", "-b", "main"]);
    let run = folder.val3(&["merge", "--install"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    commit(&folder, "first");
    folder
}

/// Changes the files on two branches. Finally, `main` is checked out.
fn branches(folder: &Folder, ours: impl Fn(&Folder), theirs: impl Fn(&Folder)) {
    git_ok(folder, &["checkout", "-q", "-b", "other"]);
    theirs(folder);
    commit(folder, "theirs");
    git_ok(folder, &["checkout", "-q", "main"]);
    ours(folder);
    commit(folder, "ours");
}

fn replace(folder: &Folder, path: &str, edits: &[(&str, &str)]) {
    let text = edits.iter().fold(folder.read(path), |text, (from, to)| {
        assert!(text.contains(from), "{from}: {text}");
        text.replace(from, to)
    });
    folder.write(path, &text);
}

/// Appends a point, and adds a variable.
fn append(folder: &Folder, size: &str, values: &str, name: &str) {
    let data = format!(
        "\n    <Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n  </Datas>"
    );
    replace(
        folder,
        DATA,
        &[("size=\"3\"", size), ("\n    </Data>", &format!("{values}\n    </Data>")), ("\n  </Datas>", &data)],
    );
}

const LEFT: &str = "\n      <Value key=\"3\" x=\"100\" fatherId=\"world[0]\" />";
const RIGHT: &str = "\n      <Value key=\"3\" x=\"777\" fatherId=\"world[0]\" />";

#[track_caller]
fn check_merged(folder: &Folder, words: &[&str]) {
    let merged = folder.read(DATA);
    words.iter().for_each(|word| assert!(merged.contains(word), "no {word}: {merged}"));
    let run = folder.val3(&["check", "--format", "concise"]);
    assert!(!run.stdout.contains("V000"), "{run:?}");
}

#[test]
fn points_and_variables_of_both_branches_are_kept() {
    let folder = repository();
    branches(
        &folder,
        |folder| append(folder, "size=\"4\"", LEFT, "nOurs"),
        |folder| append(folder, "size=\"4\"", RIGHT, "nTheirs"),
    );
    let run = git(&folder, &["merge", "-q", "other"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.stderr.contains("main.dtx: `pPts`: index 3 of theirs became 4; check the programs"), "{run:?}");
    check_merged(&folder, &["size=\"5\"", "key=\"3\" x=\"100\"", "key=\"4\" x=\"777\"", "nOurs", "nTheirs"]);
}

#[test]
fn a_point_with_default_values_is_kept() {
    let folder = repository();
    let grow = |folder: &Folder| replace(folder, DATA, &[("size=\"3\"", "size=\"4\"")]);
    branches(&folder, grow, |folder| append(folder, "size=\"4\"", RIGHT, "nTheirs"));
    assert_eq!(git(&folder, &["merge", "-q", "other"]).code, 0);
    check_merged(&folder, &["size=\"5\"", "key=\"4\" x=\"777\""]);
}

#[test]
fn programs_of_both_branches_are_in_the_project() {
    let folder = repository();
    branches(&folder, |folder| add_program(folder, "left"), |folder| add_program(folder, "right"));
    assert_eq!(git(&folder, &["merge", "-q", "other"]).code, 0);
    let project = folder.read(PROJECT);
    assert!(project.contains("left.pgx") && project.contains("right.pgx"), "{project}");
    check_merged(&folder, &[]);
}

fn add_program(folder: &Folder, name: &str) {
    let entry = format!("    <Program file=\"{name}.pgx\" />\n  </Programs>");
    replace(folder, PROJECT, &[("  </Programs>", &entry)]);
    folder.write(&format!("usrapp/main/{name}.pgx"), &folder.read(PROGRAM).replace("start", name));
}

#[test]
fn a_rebase_merges_in_the_same_way() {
    let folder = repository();
    branches(
        &folder,
        |folder| append(folder, "size=\"4\"", LEFT, "nOurs"),
        |folder| append(folder, "size=\"4\"", RIGHT, "nTheirs"),
    );
    let run = git(&folder, &["rebase", "-q", "other"]);
    assert_eq!(run.code, 0, "{run:?}");
    // In a rebase, git calls the commits of the rebased branch "theirs".
    check_merged(&folder, &["size=\"5\"", "key=\"3\" x=\"777\"", "key=\"4\" x=\"100\""]);
}

#[test]
fn a_conflict_keeps_both_values_until_a_person_resolves_it() {
    let folder = repository();
    branches(&folder, |folder| change_values(folder, 20), |folder| change_values(folder, 30));
    let run = git(&folder, &["merge", "other"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(
        run.stderr.contains("main.dtx: conflict in `pPts[1]`: x is \"20\" in ours and \"30\" in theirs"),
        "{run:?}"
    );
    assert!(run.stdout.contains("CONFLICT (content): Merge conflict in usrapp/main/main.dtx"), "{run:?}");
    let (data, program) = (folder.read(DATA), folder.read(PROGRAM));
    assert!(
        data.contains("x=\"20\"")
            && data.contains("x=\"30\"")
            && program.contains("nCount=20")
            && program.contains("nCount=30")
    );
    let check = folder.val3(&["check", "--format", "concise"]);
    assert_eq!(check.stdout.matches("V0004").count(), 2, "{check:?}");
    let start = data.find("      <!-- <<<<<<<").unwrap();
    let end = start + data[start..].find("-->\n").unwrap() + 4;
    folder.write(DATA, &(data[..start].to_owned() + &data[end..]));
    assert_eq!(folder.val3(&["check", "--format", "concise"]).stdout.matches("V0004").count(), 1);
}

/// Replaces the value 2 in the data and in the program.
fn change_values(folder: &Folder, value: u32) {
    replace(folder, DATA, &[("x=\"2\"", &format!("x=\"{value}\""))]);
    replace(folder, PROGRAM, &[("nCount=2", &format!("nCount={value}"))]);
}

#[test]
fn a_driver_that_fails_stops_the_merge() {
    let folder = repository();
    branches(
        &folder,
        |folder| append(folder, "size=\"4\"", LEFT, "nOurs"),
        |folder| append(folder, "size=\"4\"", RIGHT, "nTheirs"),
    );
    git_ok(&folder, &["config", "merge.val3.driver", "val3 merge --path=%P %O %A absent"]);
    let head = || git_ok(&folder, &["rev-parse", "HEAD"]).stdout;
    let before = head();
    let run = git(&folder, &["merge", "other"]);
    assert!(run.code > 0, "{run:?}");
    assert_eq!(head(), before);
    // git 2.39 reports a conflict, later versions end the merge.
    let is_open = git(&folder, &["rev-parse", "--verify", "MERGE_HEAD"]).code == 0;
    assert_eq!(is_open, run.stdout.contains("CONFLICT"), "{run:?}");
}

#[test]
fn the_setup_is_written_once() {
    let folder = Folder::empty();
    let install = |folder: &Folder| folder.val3(&["merge", "--install"]);
    let outside = install(&folder);
    assert_eq!(outside.code, 2);
    assert!(outside.stderr.contains("not a git repository"), "{outside:?}");
    git_ok(&folder, &["init", "-q"]);
    folder.write(".gitattributes", "*.png binary\n*.pgx text merge=val3");
    let first = install(&folder);
    assert_eq!(
        first.stdout,
        ".gitattributes: *.dtx merge=val3\n.gitattributes: *.pjx merge=val3\n.gitattributes: *.cfx merge=val3\n\
         configuration of the repository: merge.val3.name = val3 merge\n\
         configuration of the repository: merge.val3.driver = val3 merge --path=%P %O %A %B\n"
    );
    let attributes = folder.read(".gitattributes");
    assert_eq!(
        attributes,
        "*.png binary\n*.pgx text merge=val3\n*.dtx merge=val3\n*.pjx merge=val3\n*.cfx merge=val3\n"
    );
    assert_eq!(install(&folder).stdout, "git merges the files of this repository with `val3 merge` already\n");
    assert_eq!(folder.read(".gitattributes"), attributes);
}
