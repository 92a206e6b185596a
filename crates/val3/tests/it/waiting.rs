//! Waits for a command under test. Each wait has a limit, and its failure lists the awaited and the received items.

use std::io::{BufRead as _, BufReader, Read};
use std::process::{Child, ExitStatus};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Limit of a wait, far above the duration on any machine.
pub(crate) const LIMIT: Duration = Duration::from_secs(60);

/// Wait with a limit, for one item among others, such as a message of a certain kind.
pub(crate) struct Wait {
    awaited: String,
    begun: Instant,
    seen: Vec<String>,
}

impl Wait {
    pub(crate) fn new(awaited: impl Into<String>) -> Self {
        Self { awaited: awaited.into(), begun: Instant::now(), seen: Vec::new() }
    }

    /// Records a received item that is not the awaited one.
    #[track_caller]
    pub(crate) fn saw(&mut self, other: impl Into<String>) {
        self.seen.push(other.into());
        if self.begun.elapsed() > LIMIT {
            self.fail("too late");
        }
    }

    fn remaining(&self) -> Duration {
        LIMIT.saturating_sub(self.begun.elapsed())
    }

    #[track_caller]
    fn fail(&self, reason: &str) -> ! {
        panic!("no {} within {LIMIT:?} ({reason}); there was {:#?}", self.awaited, self.seen);
    }
}

/// Lines of an output. A thread reads them, because reading blocks while the output is open.
pub(crate) struct OutputLines(Receiver<String>);

impl OutputLines {
    pub(crate) fn of(output: impl Read + Send + 'static) -> Self {
        let (sender, receiver) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines().map_while(Result::ok) {
                if sender.send(line).is_err() {
                    return;
                }
            }
        });
        Self(receiver)
    }

    /// Waits for a line that contains a text, and returns it.
    #[track_caller]
    pub(crate) fn wait_for(&self, text: &str) -> String {
        let mut wait = Wait::new(format!("line with `{text}`"));
        loop {
            match self.0.recv_timeout(wait.remaining()) {
                Ok(line) if line.contains(text) => return line,
                Ok(line) => wait.saw(line),
                Err(error) => wait.fail(&error.to_string()),
            }
        }
    }

    /// Waits until the output is closed, and returns its remaining lines.
    #[track_caller]
    pub(crate) fn rest(&self) -> String {
        let mut wait = Wait::new("end of the output");
        loop {
            match self.0.recv_timeout(wait.remaining()) {
                Ok(line) => wait.saw(line),
                Err(RecvTimeoutError::Disconnected) => return wait.seen.join("\n"),
                Err(error) => wait.fail(&error.to_string()),
            }
        }
    }
}

/// Waits for the end of a process.
#[track_caller]
pub(crate) fn ended(process: &mut Child) -> ExitStatus {
    let begun = Instant::now();
    loop {
        if let Some(status) = process.try_wait().unwrap() {
            return status;
        }
        if begun.elapsed() > LIMIT {
            let _ = process.kill();
            panic!("the process {} has not ended within {LIMIT:?}", process.id());
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn lines_and_the_rest_of_an_output_are_found() {
    let lines = OutputLines::of("one\ntwo\nthree\nfour\n".as_bytes());
    assert_eq!(lines.wait_for("tw"), "two");
    assert_eq!(lines.rest(), "three\nfour");
}

#[test]
#[should_panic(expected = "no line with `three`")]
fn a_missing_line_is_reported() {
    OutputLines::of("one\ntwo\n".as_bytes()).wait_for("three");
}
