//! `val3 run --interactive` in a pseudo terminal.

use std::io::Read;

use rustix::process::{Pid, Signal, kill_process};
use rustix::termios::tcgetattr;

use crate::support::Folder;
use crate::terminal::Terminal;

/// A terminal in which a folder's application runs.
fn run(folder: &Folder) -> Terminal {
    Terminal::with(folder.command(&["run", "--interactive", "--until", "30", "usrapp/main"]))
}

#[test]
fn the_keyboard_is_that_of_the_pendant() {
    let folder = Folder::with("num nKey\nputln(\"ready\")\nnKey=get()\nput(nKey)\n?nKey+1000\nnKey=get()\n");
    let mut terminal = run(&folder);
    let before = tcgetattr(&terminal.line).unwrap().local_modes;
    terminal.wait_for("ready");
    assert_ne!(tcgetattr(&terminal.line).unwrap().local_modes, before, "it reads key by key");
    terminal.press(b"\x1bOP");
    terminal.wait_for("1271");
    terminal.press(b"a");
    terminal.wait_for("\x1b[?1049l");
    terminal.wait_for("1271");
    assert_eq!(terminal.child.wait().unwrap().code(), Some(0));
    assert_eq!(tcgetattr(&terminal.line).unwrap().local_modes, before, "the terminal is as it was");
}

#[test]
fn ctrl_c_runs_stop_and_then_ends() {
    let folder = Folder::with(
        "program start()\nbegin\nputln(\"ready\")\nget()\nend\nprogram stop()\nbegin\nputln(\"stopped\")\nget()\nend\n",
    );
    let mut terminal = run(&folder);
    terminal.wait_for("ready");
    terminal.press(b"\x03");
    terminal.wait_for("stopped");
    terminal.press(b"\x03");
    terminal.wait_for("\x1b[?1049l");
    assert_eq!(terminal.child.wait().unwrap().code(), Some(130));
}

#[test]
fn a_missing_terminal_is_reported() {
    let run = Folder::with("?1\n").val3(&["run", "--interactive", "usrapp/main"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""));
    assert!(run.stderr.contains("--interactive needs a terminal"), "{}", run.stderr);
}

#[test]
fn a_signal_restores_the_terminal() {
    let folder = Folder::with("putln(\"ready\")\nget()\n");
    for (signal, code) in [(Signal::TERM, 143), (Signal::HUP, 129), (Signal::INT, 130)] {
        let mut terminal = run(&folder);
        let before = tcgetattr(&terminal.line).unwrap().local_modes;
        terminal.wait_for("ready");
        kill_process(Pid::from_child(&terminal.child), signal).unwrap();
        terminal.wait_for("\x1b[?1049l");
        assert_eq!(terminal.child.wait().unwrap().code(), Some(code));
        assert_eq!(tcgetattr(&terminal.line).unwrap().local_modes, before);
    }
}

/// Without a check, a loop of file accesses would not end its cycle for a long time. A signal ends the run after the
/// current access.
#[test]
fn a_signal_ends_a_loop_of_file_accesses() {
    let folder = Folder::with("  ? \"begun\"\n  while true\n    libSave()\n  endWhile\n");
    let mut command = folder.command(&["run", "--time", "real", "usrapp/main"]);
    let mut child = command.stdout(std::process::Stdio::piped()).spawn().unwrap();
    let mut first = [0; 6];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    assert_eq!(&first, b"begun\n");
    kill_process(Pid::from_child(&child), Signal::TERM).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(143));
}

/// After a signal, the event record is complete and contains the end.
#[test]
fn a_signal_leaves_a_complete_record() {
    let folder = Folder::with("while true\n?1\ndelay(3600)\nendWhile\n");
    let mut command = folder.command(&["run", "--time", "real", "--events", "events.jsonl", "usrapp/main"]);
    let mut child = command.stdout(std::process::Stdio::piped()).spawn().unwrap();
    let mut first = [0; 2];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    kill_process(Pid::from_child(&child), Signal::TERM).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(143));
    let events = folder.read("events.jsonl");
    assert!(events.contains(r#""kind":"print","text":"1""#), "{events}");
    assert!(events.ends_with("\"kind\":\"end\",\"reason\":\"stopped\"}\n"), "{events}");
}

/// The events of a run in real time are readable immediately.
#[test]
fn events_are_written_while_the_run_continues() {
    let folder = Folder::with("?1\ndelay(3600)\n");
    let mut command = folder.command(&["run", "--time", "real", "--events", "-", "usrapp/main"]);
    let mut child = command.stdout(std::process::Stdio::piped()).spawn().unwrap();
    let events = std::io::BufReader::new(child.stdout.take().unwrap());
    let printed = std::io::BufRead::lines(events).map(Result::unwrap).find(|line| line.contains(r#""print""#));
    assert!(printed.is_some());
    child.kill().unwrap();
    child.wait().unwrap();
}
