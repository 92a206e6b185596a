//! Pseudo terminals and commands in them.

use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};

/// Timeout for expected output, after which the test fails.
const TIMEOUT: Duration = Duration::from_secs(20);

/// A terminal with a running command.
pub(crate) struct Terminal {
    keyboard: File,
    /// Screen output. Another thread reads it, because reading blocks while the line is open.
    picture: Receiver<String>,
    /// The command's end of the terminal, kept to check its modes.
    pub(crate) line: File,
    pub(crate) child: Child,
    seen: String,
}

impl Terminal {
    /// Runs a command.
    pub(crate) fn with(mut command: Command) -> Self {
        let (keyboard, name) = pair();
        let line = OpenOptions::new().read(true).write(true).open(name).unwrap();
        tcsetwinsize(&keyboard, Winsize { ws_row: 24, ws_col: 80, ws_xpixel: 0, ws_ypixel: 0 }).unwrap();
        command.stdin(line.try_clone().unwrap()).stdout(line.try_clone().unwrap()).env("TERM", "xterm");
        let child = command.spawn().unwrap();
        let picture = pictures(keyboard.try_clone().unwrap());
        Self { keyboard, picture, line, child, seen: String::new() }
    }

    /// Reads until the output contains a text after the text of the previous call.
    pub(crate) fn wait_for(&mut self, text: &str) {
        while !self.seen.contains(text) {
            match self.picture.recv_timeout(TIMEOUT) {
                Ok(part) => self.seen += &part,
                Err(_) => panic!("{text} is not in {:?}; {:?}", self.seen, self.child.try_wait()),
            }
        }
        self.seen = self.seen.split_once(text).map(|(_, behind)| behind.to_owned()).unwrap_or_default();
    }

    pub(crate) fn press(&mut self, keys: &[u8]) {
        self.keyboard.write_all(keys).unwrap();
    }
}

impl Drop for Terminal {
    /// Kills the command, also if the test has failed.
    fn drop(&mut self) {
        let _ = self.child.kill();
    }
}

/// Runs a command to its end with both outputs on a terminal, and returns the terminal's output.
pub(crate) fn output_on_terminal(mut command: Command) -> String {
    let (mut screen, name) = pair();
    let line = OpenOptions::new().read(true).write(true).open(name).unwrap();
    command.stdin(Stdio::null()).stdout(line.try_clone().unwrap()).stderr(line).env("TERM", "xterm");
    let mut child = command.spawn().unwrap();
    // The command holds handles of the terminal, whose other end is closed with the last handle.
    drop(command);
    let mut received = Vec::new();
    let mut bytes = [0; 4096];
    while let Ok(count @ 1..) = screen.read(&mut bytes) {
        received.extend_from_slice(&bytes[..count]);
    }
    child.wait().unwrap();
    String::from_utf8_lossy(&received).into_owned()
}

/// Terminal output in parts.
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

/// Opens a pseudo terminal: the user's end, and the name of the command's end.
pub(crate) fn pair() -> (File, String) {
    let other = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&other).unwrap();
    unlockpt(&other).unwrap();
    let name = ptsname(&other, Vec::new()).unwrap().into_string().unwrap();
    (File::from(other), name)
}
