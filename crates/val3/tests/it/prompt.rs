//! `val3 eval` at a terminal.

use rustix::process::{Pid, Signal, kill_process};

use crate::support::Folder;
use crate::terminal::Terminal;

/// Escape sequence of the up arrow.
const UP: &[u8] = b"\x1b[A";

/// A prompt for the application in a folder.
fn prompt(folder: &Folder) -> Terminal {
    let mut terminal = Terminal::with(folder.command(&["eval", "--app", "usrapp/main", "--local", "num nOwn"]));
    terminal.wait_for("> ");
    terminal
}

/// A cell with names to complete and an endless program.
fn cell() -> Folder {
    Folder::with(
        "num nCountOfParts = 41\nprogram forEver()\nbegin\n?\"begun\"\nwhile true\nendWhile\nend\n\
         program tick()\nbegin\nwhile true\nnCountOfParts=nCountOfParts+1\ndelay(1)\nendWhile\nend\n",
    )
}

/// Sends Ctrl-C, as a terminal does to its command.
fn interrupt(terminal: &Terminal) {
    kill_process(Pid::from_child(&terminal.child), Signal::INT).unwrap();
}

#[test]
fn lines_have_a_history_and_are_completed() {
    let folder = cell();
    let mut terminal = prompt(&folder);
    terminal.press(b"nOwn=nCountOf\t+1\r");
    terminal.wait_for("nCountOfParts");
    terminal.wait_for("> ");
    terminal.press(b"nOwn\r");
    terminal.wait_for("\n42\r");
    terminal.press(b"toStr\t(\".1\",nOwn)\r");
    terminal.wait_for("\n\"42");
    terminal.press(&[UP, UP, b"*2\r"].concat());
    terminal.wait_for("\n84\r");
    terminal.press(b"2+\r");
    terminal.wait_for("error: a value is expected here");
    terminal.wait_for("> ");
    terminal.press(b"\x04");
    assert_eq!(terminal.child.wait().unwrap().code(), Some(0), "a prompt judges nothing");
}

#[test]
fn ctrl_c_ends_a_line_or_a_text_but_not_the_scope() {
    let folder = cell();
    let mut terminal = prompt(&folder);
    terminal.press(b"nOwn=7\r");
    terminal.wait_for("> ");
    terminal.press(b"nOwn=8\x03");
    terminal.wait_for("\n");
    terminal.wait_for("> ");
    for endless in ["call forEver()\r", "while true\r?\"begun\"\rendWhile\r"] {
        terminal.press(endless.as_bytes());
        terminal.wait_for("begun\r");
        interrupt(&terminal);
        terminal.wait_for("error: interrupted");
        terminal.wait_for("> ");
    }
    terminal.press(b"nOwn+1\r");
    terminal.wait_for("\n8\r");
    terminal.wait_for("> ");
    terminal.press(b"\x04");
    assert_eq!(terminal.child.wait().unwrap().code(), Some(0));
}

#[test]
fn tasks_continue_while_texts_are_evaluated() {
    let folder = cell();
    let mut terminal = prompt(&folder);
    for (text, answer) in [
        ("taskCreate \"t\",10,tick()", ""),
        ("delay(2.5)", ""),
        ("nCountOfParts", "\n44\r"),
        ("taskStatus(\"t\")", "\n1\r"),
        ("taskKill(\"t\")", ""),
        ("delay(5)", ""),
        ("nCountOfParts", "\n44\r"),
    ] {
        terminal.press(format!("{text}\r").as_bytes());
        terminal.wait_for(answer);
        terminal.wait_for("> ");
    }
    terminal.press(b"\x04");
    assert_eq!(terminal.child.wait().unwrap().code(), Some(0));
}

#[test]
fn later_changes_of_the_files_do_not_change_a_scope() {
    let folder = cell();
    let mut terminal = prompt(&folder);
    folder.write("usrapp/main/main.dtx", "<Database></Database>");
    terminal.press(b"nCountOfParts\r");
    terminal.wait_for("\n41\r");
    terminal.wait_for("> ");
    terminal.press(b"\x04");
    assert_eq!(terminal.child.wait().unwrap().code(), Some(0));
}
