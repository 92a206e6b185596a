//! `val3 run --interactive` in a pseudo terminal.

use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::process::Child;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use rustix::process::{Pid, Signal, kill_process};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcgetattr, tcsetwinsize};

use crate::support::Folder;

/// How long a picture may take; a test that waits in vain ends.
const PATIENCE: Duration = Duration::from_secs(20);

/// A terminal with a command in it.
struct Terminal {
    keyboard: File,
    /// What comes onto the screen. It is read aside: a read has no end while the line is open.
    picture: Receiver<String>,
    /// The end of the command, kept to look at its modes.
    line: File,
    child: Child,
    seen: String,
}

impl Terminal {
    /// Runs the application of a folder.
    fn run(folder: &Folder) -> Self {
        let other = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&other).unwrap();
        unlockpt(&other).unwrap();
        tcsetwinsize(&other, Winsize { ws_row: 24, ws_col: 80, ws_xpixel: 0, ws_ypixel: 0 }).unwrap();
        let name = ptsname(&other, Vec::new()).unwrap().into_string().unwrap();
        let line = OpenOptions::new().read(true).write(true).open(name).unwrap();
        let mut command = folder.command(&["run", "--interactive", "--until", "30", "usrapp/main"]);
        command.stdin(line.try_clone().unwrap()).stdout(line.try_clone().unwrap()).env("TERM", "xterm");
        let child = command.spawn().unwrap();
        let keyboard = File::from(other);
        let picture = pictures(keyboard.try_clone().unwrap());
        Self { keyboard, picture, line, child, seen: String::new() }
    }

    /// Reads on until the picture holds a text behind the one that was waited for before.
    fn wait_for(&mut self, text: &str) {
        while !self.seen.contains(text) {
            match self.picture.recv_timeout(PATIENCE) {
                Ok(part) => self.seen += &part,
                Err(_) => panic!("{text} is not in {:?}; {:?}", self.seen, self.child.try_wait()),
            }
        }
        self.seen = self.seen.split_once(text).map(|(_, behind)| behind.to_owned()).unwrap_or_default();
    }

    fn press(&mut self, keys: &[u8]) {
        self.keyboard.write_all(keys).unwrap();
    }
}

/// What a terminal shows, as it comes.
fn pictures(mut terminal: File) -> Receiver<String> {
    let (to, pictures) = channel();
    std::thread::spawn(move || {
        let mut bytes = [0; 4096];
        while let Ok(count @ 1..) = terminal.read(&mut bytes) {
            if to.send(String::from_utf8_lossy(&bytes[..count]).into_owned()).is_err() {
                return;
            }
        }
    });
    pictures
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
    let run = Folder::with("?1\n").val3(&["run", "--interactive", "usrapp/main"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""));
    assert!(run.stderr.contains("--interactive needs a terminal"), "{}", run.stderr);
}

#[test]
fn a_signal_leaves_the_terminal_as_it_was() {
    let folder = Folder::with("putln(\"ready\")\nget()\n");
    for (signal, code) in [(Signal::TERM, 143), (Signal::HUP, 129), (Signal::INT, 130)] {
        let mut terminal = Terminal::run(&folder);
        let before = tcgetattr(&terminal.line).unwrap().local_modes;
        terminal.wait_for("ready");
        kill_process(Pid::from_child(&terminal.child), signal).unwrap();
        terminal.wait_for("\x1b[?1049l");
        assert_eq!(terminal.child.wait().unwrap().code(), Some(code));
        assert_eq!(tcgetattr(&terminal.line).unwrap().local_modes, before);
    }
}

/// A run that somebody ends from outside has written everything down, and how it ended.
#[test]
fn a_signal_leaves_a_whole_record() {
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

/// Whoever reads the events of a run in real time sees them as they happen.
#[test]
fn events_can_be_followed() {
    let folder = Folder::with("?1\ndelay(3600)\n");
    let mut command = folder.command(&["run", "--time", "real", "--events", "-", "usrapp/main"]);
    let mut child = command.stdout(std::process::Stdio::piped()).spawn().unwrap();
    let events = std::io::BufReader::new(child.stdout.take().unwrap());
    let printed = std::io::BufRead::lines(events).map(Result::unwrap).find(|line| line.contains(r#""print""#));
    assert!(printed.is_some());
    child.kill().unwrap();
    child.wait().unwrap();
}
