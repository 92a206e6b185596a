//! `--watch` repeats the check when a file changes.

use std::process::{Child, Command, Stdio};

use crate::support::{CLEAN, FAULTY, Folder};
#[cfg(unix)]
use crate::terminal::Terminal;
use crate::waiting::OutputLines;

/// A command with `--watch`, killed on drop.
pub(crate) struct Watching {
    child: Child,
    lines: OutputLines,
}

impl Watching {
    fn start(folder: &Folder, arguments: &[&str]) -> Self {
        let mut command = folder.command(&[&["check", "--watch"], arguments].concat());
        command.stdout(Stdio::null());
        Self::of(command)
    }

    /// Starts a command whose error output is read.
    pub(crate) fn of(mut command: Command) -> Self {
        let mut child = command.stdin(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        let lines = OutputLines::of(child.stderr.take().unwrap());
        Self { child, lines }
    }

    /// Waits for a line with `text`.
    #[track_caller]
    pub(crate) fn wait_for(&self, text: &str) {
        self.lines.wait_for(text);
    }

    /// Waits for the end of a round with these counts.
    #[track_caller]
    fn round(&self, counts: &str) {
        self.wait_for(counts);
        self.wait_for("Waiting for changes");
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

const PROGRAM: &str = "usrapp/main/start.pgx";

#[test]
fn a_change_is_checked() {
    let folder = Folder::with(CLEAN);
    let good = folder.read(PROGRAM);
    let watching = Watching::start(&folder, &[]);
    watching.round("no findings");
    folder.write(PROGRAM, &Folder::with(FAULTY).read(PROGRAM));
    watching.wait_for("start.pgx was changed");
    watching.round("1 error");
    folder.write(PROGRAM, &good);
    watching.round("no findings");
}

#[test]
fn libraries_outside_the_given_folder_are_watched() {
    let folder = Folder::with("library part \"Disk://part/part.pjx\"\n\npart:nA=1\n\n--- part\npublic num nA\n");
    let watching = Watching::start(&folder, &["usrapp/main"]);
    watching.round("no findings");
    let data = folder.read("usrapp/part/part.dtx");
    folder.write("usrapp/part/part.dtx", &data.replace("nA", "nB"));
    watching.round("1 error");
}

#[test]
fn a_temporarily_missing_folder_does_not_end_the_watch() {
    let folder = Folder::with(CLEAN);
    let watching = Watching::start(&folder, &[]);
    watching.round("no findings");
    let names = ["main.pjx", "main.dtx", "start.pgx", "stop.pgx"].map(|name| format!("usrapp/main/{name}"));
    let texts = names.clone().map(|name| folder.read(&name));
    names.iter().for_each(|name| std::fs::remove_file(folder.path().join(name)).unwrap());
    watching.round("error: ");
    names.iter().zip(&texts).for_each(|(name, text)| folder.write(name, text));
    watching.round("no findings");
}

#[test]
fn saving_a_file_rewrites_no_other() {
    let folder = Folder::with("num nCount\nIF nCount==1\ncls()\nendIf\n");
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--watch", "--fix"]);
    assert_eq!((run.code, folder.read(PROGRAM)), (2, before), "{run:?}");
    assert!(run.stderr.contains("--watch cannot be used with --fix"), "{run:?}");
}

#[cfg(unix)]
#[test]
fn the_screen_is_cleared_and_new_findings_are_marked() {
    let folder = Folder::with(FAULTY);
    let mut terminal = Terminal::with(folder.command(&["check", "--watch"]));
    terminal.wait_for("\u{1b}[2J");
    terminal.wait_for("V0101");
    folder.write(PROGRAM, &Folder::with("num nCount\nnCuont=1\nnOther=1\n").read(PROGRAM));
    terminal.wait_for("\u{1b}[2J");
    terminal.wait_for("nOther");
    terminal.wait_for("(new)");
}
