//! `val3 run --interactive` in a pseudo terminal.

use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::process::Child;

use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcgetattr, tcsetwinsize};

use crate::support::Folder;

/// A terminal with a command in it.
struct Terminal {
    keyboard_and_picture: File,
    /// The end of the command, kept to look at its modes.
    line: File,
    child: Child,
    seen: String,
}

impl Terminal {
    /// Runs the application of a folder; the time limit ends a test that waits in vain.
    fn run(folder: &Folder) -> Self {
        let other = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&other).unwrap();
        unlockpt(&other).unwrap();
        tcsetwinsize(&other, Winsize { ws_row: 24, ws_col: 80, ws_xpixel: 0, ws_ypixel: 0 }).unwrap();
        let name = ptsname(&other, Vec::new()).unwrap().into_string().unwrap();
        let line = OpenOptions::new().read(true).write(true).open(name).unwrap();
        let mut command = folder.command(&["run", "--interactive", "--until", "30", "main"]);
        command.stdin(line.try_clone().unwrap()).stdout(line.try_clone().unwrap()).env("TERM", "xterm");
        let child = command.spawn().unwrap();
        Self { keyboard_and_picture: other.into(), line, child, seen: String::new() }
    }

    /// Reads until the picture holds a text that was not seen before.
    fn wait_for(&mut self, text: &str) {
        let mut bytes = [0; 4096];
        while !self.seen.contains(text) {
            let count = self.keyboard_and_picture.read(&mut bytes).unwrap();
            self.seen += &String::from_utf8_lossy(&bytes[..count]);
            let ended = self.child.try_wait().unwrap();
            assert!(ended.is_none() || self.seen.contains(text), "{text} is not in {:?}", self.seen);
        }
        self.seen.clear();
    }

    fn press(&mut self, keys: &[u8]) {
        self.keyboard_and_picture.write_all(keys).unwrap();
    }
}

#[test]
fn the_keyboard_is_that_of_the_pendant() {
    let folder = Folder::with("num nKey\nputln(\"ready\")\nnKey=get()\nput(nKey)\n?nKey+1000\nnKey=get()\n");
    let mut terminal = Terminal::run(&folder);
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
fn ctrl_c_lets_stop_run_and_then_ends() {
    let folder = Folder::with(
        "program start()\nbegin\nputln(\"ready\")\nget()\nend\nprogram stop()\nbegin\nputln(\"stopped\")\nget()\nend\n",
    );
    let mut terminal = Terminal::run(&folder);
    terminal.wait_for("ready");
    terminal.press(b"\x03");
    terminal.wait_for("stopped");
    terminal.press(b"\x03");
    terminal.wait_for("\x1b[?1049l");
    assert_eq!(terminal.child.wait().unwrap().code(), Some(130));
}

#[test]
fn without_a_terminal_it_says_so() {
    let run = Folder::with("?1\n").val3(&["run", "--interactive", "main"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""));
    assert!(run.stderr.contains("--interactive needs a terminal"), "{}", run.stderr);
}
