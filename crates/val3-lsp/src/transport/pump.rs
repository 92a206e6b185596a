//! The writing thread. Other threads queue their messages here, so that a slow client delays none of them.

use std::io::{self, Write};
use std::pin::Pin;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::task::{Context, Poll};
use std::thread;
use std::time::Duration;

use tokio::io::AsyncWrite;

/// Time limit at the end of the server for writing the last messages.
const FAREWELL: Duration = Duration::from_millis(300);

enum PumpCommand {
    Write(Vec<u8>),
    /// Signals the receiver when all earlier messages have been written.
    Flush(Sender<()>),
}

/// Sender to the writing thread.
#[derive(Clone)]
pub(crate) struct Pump(Sender<PumpCommand>);

impl Pump {
    /// Starts the thread; `closed` is called if the client no longer reads.
    pub(crate) fn start(
        output: impl Write + Send + 'static,
        closed: impl FnOnce() + Send + 'static,
    ) -> io::Result<Self> {
        let (sender, receiver) = channel();
        thread::Builder::new().name("output".to_owned()).spawn(move || {
            if pump(output, &receiver).is_err() {
                closed();
            }
        })?;
        Ok(Self(sender))
    }

    /// Queues complete frames.
    pub(crate) fn write(&self, frames: Vec<u8>) {
        // If the client has closed its side, the server ends, so the error is ignored.
        let _ = self.0.send(PumpCommand::Write(frames));
    }

    /// Waits until all queued frames are written, but only up to a time limit.
    pub(crate) fn finish(&self) {
        let (sender, done) = channel();
        if self.0.send(PumpCommand::Flush(sender)).is_ok() {
            let _ = done.recv_timeout(FAREWELL);
        }
    }
}

fn pump(mut output: impl Write, orders: &Receiver<PumpCommand>) -> io::Result<()> {
    for order in orders {
        match order {
            PumpCommand::Write(frames) => output.write_all(&frames).and_then(|()| output.flush())?,
            PumpCommand::Flush(done) => _ = done.send(()),
        }
    }
    Ok(())
}

/// The pump as an `AsyncWrite` for tower-lsp. It accepts each write completely, and tower-lsp writes complete frames.
pub(crate) struct PumpWriter(pub(crate) Pump);

impl AsyncWrite for PumpWriter {
    fn poll_write(self: Pin<&mut Self>, _: &mut Context<'_>, bytes: &[u8]) -> Poll<io::Result<usize>> {
        self.0.write(bytes.to_vec());
        Poll::Ready(Ok(bytes.len()))
    }

    fn poll_flush(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<io::Result<()>> {
        Poll::Ready(Ok(()))
    }

    fn poll_shutdown(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<io::Result<()>> {
        Poll::Ready(Ok(()))
    }
}
