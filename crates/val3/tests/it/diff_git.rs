//! `val3 diff` with git: revisions, textconv and difftool.

use std::path::Path;

use crate::git::{commit, git_ok as git};
use crate::support::{Folder, run};

const PROGRAM: &str = "usrapp/main/start.pgx";
const DATA: &str = "usrapp/main/main.dtx";

/// A repository with two commits: `nCount` is 1 and then 5. In the working tree it is 7.
fn repository() -> Folder {
    let folder = Folder::with("num nCount = 1\nnCount=2\n");
    git(&folder, &["init", "-q", "-b", "main"]);
    folder.write(".gitignore", "ignored/\n");
    commit(&folder, "first");
    set(&folder, "1", "5");
    folder.write("other/notes.txt", "none");
    commit(&folder, "second");
    set(&folder, "5", "7");
    folder.write("ignored/x.pgx", "not compared");
    folder
}

fn set(folder: &Folder, before: &str, after: &str) {
    let text = folder.read(DATA).replace(&format!("value=\"{before}\""), &format!("value=\"{after}\""));
    folder.write(DATA, &text);
}

#[track_caller]
fn check(folder: &Folder, arguments: &[&str], code: i32, words: &[&str]) {
    let run = folder.val3(&[&["diff"], arguments].concat());
    assert_eq!((run.code, run.stderr.as_str()), (code, ""), "{arguments:?} {run:?}");
    words.iter().for_each(|word| assert!(run.stdout.contains(word), "no `{word}`: {run:?}"));
}

#[test]
fn revisions_are_compared_with_each_other_and_with_the_working_tree() {
    let folder = repository();
    check(&folder, &["--git", "HEAD~1", "HEAD"], 1, &["nCount  1 → 5"]);
    check(&folder, &["--git", "HEAD"], 1, &["nCount  5 → 7"]);
    check(&folder, &["--git", "HEAD~1", "main", "usrapp"], 1, &["nCount  1 → 5"]);
    check(&folder, &["--git", "HEAD", "usrapp/main"], 1, &["nCount  5 → 7"]);
    check(&folder, &["--git", "HEAD", "usrapp/main/main.pjx"], 1, &["nCount  5 → 7"]);
    check(&folder, &["--git", "HEAD", "HEAD", DATA], 0, &["no differences"]);
    check(&folder, &["--git", "HEAD~1", "HEAD", DATA], 1, &["nCount  1 → 5"]);
    check(&folder, &["--git", "HEAD~1", "HEAD", "other"], 0, &["no differences"]);
    check(&folder, &["--format", "markdown", "--git", "HEAD"], 1, &["# `HEAD` → `working tree`"]);
}

#[test]
fn staged_files_are_compared_with_a_revision() {
    let folder = repository();
    check(&folder, &["--staged"], 0, &["no differences"]);
    git(&folder, &["add", "-A"]);
    set(&folder, "7", "9");
    check(&folder, &["--staged"], 1, &["nCount  5 → 7"]);
    check(&folder, &["--staged", "usrapp"], 1, &["nCount  5 → 7"]);
    check(&folder, &["--staged", "other"], 0, &["no differences"]);
    check(&folder, &["--git", "HEAD~1", "--staged"], 1, &["nCount  1 → 7"]);
    check(
        &folder,
        &["--git", "HEAD~1", "usrapp", "--staged", "--format", "markdown"],
        1,
        &["# `HEAD~1` → `staged files`"],
    );
    let refused = folder.val3(&["diff", "--git", "HEAD~1", "HEAD", "--staged"]);
    assert!(refused.code == 2 && refused.stderr.contains("two revisions are given"), "{refused:?}");
}

#[test]
fn files_with_conflicts_are_not_staged() {
    let folder = repository();
    git(&folder, &["checkout", "-q", "--", "."]);
    git(&folder, &["checkout", "-qb", "side", "HEAD~1"]);
    set(&folder, "1", "8");
    commit(&folder, "side");
    git(&folder, &["merge", "-q", "main"]);
    let refused = folder.val3(&["diff", "--staged"]);
    assert!(refused.code == 2 && refused.stderr.contains("`usrapp/main/main.dtx` has conflicts"), "{refused:?}");
}

#[test]
fn ranges_mean_the_same_as_in_git() {
    let folder = repository();
    check(&folder, &["--git", "HEAD~1..HEAD"], 1, &["nCount  1 → 5"]);
    check(&folder, &["--git", "HEAD~1.."], 1, &["nCount  1 → 5"]);
    check(&folder, &["--git", "..HEAD~1"], 1, &["nCount  5 → 1"]);
    check(&folder, &["--git", "HEAD~1..HEAD", "usrapp"], 1, &["nCount  1 → 5"]);
    check(&folder, &["--git", "HEAD~1..HEAD", "other"], 0, &["no differences"]);
    check(&folder, &["--format", "markdown", "--git", "HEAD~1..HEAD"], 1, &["# `HEAD~1` → `HEAD`"]);
    git(&folder, &["stash", "-q"]);
    git(&folder, &["checkout", "-qb", "side", "HEAD~1"]);
    set(&folder, "1", "8");
    commit(&folder, "side");
    check(&folder, &["--git", "main..side"], 1, &["nCount  5 → 8"]);
    check(&folder, &["--git", "main...side"], 1, &["nCount  1 → 8"]);
    check(&folder, &["--git", "side...main"], 1, &["nCount  1 → 5"]);
    git(&folder, &["checkout", "-q", "--orphan", "other"]);
    commit(&folder, "other");
    for (range, word) in [
        ("main...other", "have no common ancestor"),
        ("main..nothing", "there is no revision `nothing`"),
        ("nothing...main", "there is no revision `nothing`"),
    ] {
        let refused = folder.val3(&["diff", "--git", range]);
        assert!(refused.code == 2 && refused.stderr.contains(word), "{range} {refused:?}");
    }
}

#[test]
fn folders_below_the_root_and_removed_ones_are_found() {
    let folder = repository();
    git(&folder, &["rm", "-rqf", "usrapp"]);
    check(&folder, &["--git", "HEAD", "usrapp/main"], 1, &["removed: 1 program, 1 global variable"]);
    let sub = folder.path().join("other");
    std::fs::create_dir_all(&sub).unwrap();
    let mut command = folder.command(&["diff", "--git", "HEAD~1", "HEAD", "../usrapp"]);
    command.current_dir(sub);
    let run = run(command);
    assert!(run.code == 1 && run.stdout.contains("nCount  1 → 5"), "{run:?}");
}

#[test]
fn a_bare_repository_has_revisions() {
    let folder = repository();
    git(&folder, &["clone", "-q", "--bare", ".", "bare.git"]);
    let mut command = folder.command(&["diff", "--git", "HEAD~1", "HEAD"]);
    command.current_dir(folder.path().join("bare.git"));
    let found = run(command);
    assert!(found.code == 1 && found.stdout.contains("nCount  1 → 5"), "{found:?}");
    let mut command = folder.command(&["diff", "--git", "HEAD"]);
    command.current_dir(folder.path().join("bare.git"));
    let found = run(command);
    assert!(found.code == 2 && found.stderr.contains("name two revisions"), "{found:?}");
}

#[test]
fn wrong_revisions_and_folders_are_refused() {
    let folder = repository();
    let outside = Folder::empty();
    for (folder, arguments, word) in [
        (&folder, &["--git", "HEAD~9"][..], "there is no revision `HEAD~9`"),
        (&folder, &["--git", "HEAD", "nothing"], "there is no revision `nothing`"),
        (&folder, &["--git", "HEAD", "HEAD", "usrapp", "other"], "git compares one folder, and 2 are given"),
        (&outside, &["--git", "HEAD"], "not in a git repository"),
    ] {
        let run = folder.val3(&[&["diff"], arguments].concat());
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{arguments:?} {run:?}");
        assert!(run.stderr.contains(word), "{arguments:?} {run:?}");
    }
}

#[test]
fn missing_git_is_named() {
    let folder = repository();
    let mut command = folder.command(&["diff", "--git", "HEAD"]);
    command.env("PATH", folder.path());
    let found = run(command);
    assert_eq!(found.code, 2, "{found:?}");
    assert!(found.stderr.contains("cannot start git") && found.stderr.contains("install git"), "{found:?}");
}

/// The setup in docs/src/diff.md.
#[test]
fn git_shows_files_as_text_and_opens_the_tool() {
    let folder = repository();
    let binary = env!("CARGO_BIN_EXE_val3");
    assert!(Path::new(binary).is_absolute());
    folder.write(".gitattributes", "*.pgx diff=val3\n*.dtx diff=val3\n*.pjx diff=val3\n");
    git(&folder, &["config", "diff.val3.textconv", &format!("'{binary}' diff --textconv")]);
    git(&folder, &["config", "difftool.val3.cmd", &format!("'{binary}' diff \"$LOCAL\" \"$REMOTE\"")]);
    git(&folder, &["config", "difftool.prompt", "false"]);
    let text = folder.read(PROGRAM).replace("nCount=2", "nCount=3");
    folder.write(PROGRAM, &text);
    folder.write("usrapp/main/new.pgx", &text.replace("\"start\"", "\"new\""));
    git(&folder, &["add", "-N", "."]);
    let shown = git(&folder, &["diff"]).stdout;
    for word in ["-nCount=2\n+nCount=3\n", "-  nCount = 5\n+  nCount = 7\n", "+private program new()"] {
        assert!(shown.contains(word), "no `{word}`: {shown}");
    }
    let shown = git(&folder, &["difftool", "-t", "val3"]).stdout;
    for word in ["nCount  5 → 7", "- nCount=2", "+ nCount=3", "+ new()"] {
        assert!(shown.contains(word), "no `{word}`: {shown}");
    }
}
