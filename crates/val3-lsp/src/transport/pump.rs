//! The thread that writes. Other threads leave their messages here and continue, so that a slow client delays none of them.

use std::io::{self, Write};
use std::pin::Pin;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::task::{Context, Poll};
use std::thread;
use std::time::Duration;

use tokio::io::AsyncWrite;

/// How long the end of the server waits for a client to read the last messages.
const FAREWELL: Duration = Duration::from_millis(300);

enum Order {
    Write(Vec<u8>),
    /// Tells the other end when everything before it was written.
    Flush(Sender<()>),
}

/// The way to the thread that writes.
#[derive(Clone)]
pub(crate) struct Pump(Sender<Order>);

impl Pump {
    /// Starts the thread; `closed` is called if the client reads no more.
    pub(crate) fn start(
        output: impl Write + Send + 'static,
        closed: impl FnOnce() + Send + 'static,
    ) -> io::Result<Self> {
        let (sender, receiver) = channel();
        let work = move || {
            if pump(output, &receiver).is_err() {
                closed();
            }
        };
        thread::Builder::new().name("output".to_owned()).spawn(work)?;
        Ok(Self(sender))
    }

    /// Leaves whole frames to be written.
    pub(crate) fn write(&self, frames: Vec<u8>) {
        // A client that has closed its side reads nothing, and the server ends.
        let _ = self.0.send(Order::Write(frames));
    }

    /// Waits a moment until what was left is written.
    pub(crate) fn finish(&self) {
        let (sender, done) = channel();
        if self.0.send(Order::Flush(sender)).is_ok() {
            let _ = done.recv_timeout(FAREWELL);
        }
    }
}

fn pump(mut output: impl Write, orders: &Receiver<Order>) -> io::Result<()> {
    for order in orders {
        match order {
            Order::Write(frames) => output.write_all(&frames).and_then(|()| output.flush())?,
            Order::Flush(done) => _ = done.send(()),
        }
    }
    Ok(())
}

/// The pump as tower-lsp writes to it: it takes all that it is given, which are whole frames.
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
