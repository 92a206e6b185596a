//! Connections of clients.

use std::io;
use std::net::TcpListener as StdListener;
use std::sync::Arc;
use std::time::Duration;

use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, watch};
use tokio::time::{sleep, timeout};
use val3_modbus::{Message, NotModbus, respond};

use super::shared::SharedImage;

/// Pause after a failed `accept`, for example because the process temporarily has no free file handle.
const ACCEPT_PAUSE: Duration = Duration::from_millis(50);

/// Limits that protect the run, and clients from each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct ConnectionLimits {
    /// Maximum number of simultaneous clients. Further connections are closed immediately.
    pub(super) clients: u16,
    /// Time without a request after which a connection is closed.
    pub(super) idle_time: Duration,
    /// Time in which the rest of an incomplete request must arrive.
    pub(super) message_time: Duration,
    /// Time in which a client must read a response.
    pub(super) send_time: Duration,
}

impl ConnectionLimits {
    /// Limits for this number of clients.
    pub(super) const fn for_clients(clients: u16) -> Self {
        Self {
            clients,
            idle_time: Duration::from_secs(600),
            message_time: Duration::from_secs(5),
            send_time: Duration::from_secs(5),
        }
    }
}

/// Accepts connections until the server ends, which closes them.
pub(super) async fn accept(
    listener: StdListener,
    image: Arc<SharedImage>,
    limits: ConnectionLimits,
    mut is_over: watch::Receiver<bool>,
) -> io::Result<()> {
    let listener = TcpListener::from_std(listener)?;
    let places = Arc::new(Semaphore::new(limits.clients.into()));
    loop {
        let stream = tokio::select! {
            accepted = listener.accept() => accepted,
            _ = is_over.wait_for(|is_over| *is_over) => return Ok(()),
        };
        let Ok((stream, _)) = stream else {
            sleep(ACCEPT_PAUSE).await;
            continue;
        };
        // Without a permit the connection is closed immediately.
        if let Ok(place) = Arc::clone(&places).try_acquire_owned() {
            let image = Arc::clone(&image);
            tokio::spawn(async move {
                // After a timeout, wrong bytes or a disconnection nothing remains to be done.
                let _ = serve(stream, &image, limits).await;
                drop(place);
            });
        }
    }
}

/// Responds to the requests of a client in their order, until the client disconnects.
async fn serve(mut stream: TcpStream, image: &SharedImage, limits: ConnectionLimits) -> io::Result<()> {
    // Without this option, responses wait until earlier responses are acknowledged.
    stream.set_nodelay(true)?;
    let mut received = Vec::with_capacity(2 * Message::MAX_BYTES);
    loop {
        while let Some(message) = Message::take(&mut received).map_err(|NotModbus| wrong("no Modbus message"))? {
            let response = respond(&message, &mut image.lock()).map_err(|error| wrong(&error.to_string()))?;
            timeout(limits.send_time, stream.write_all(&response)).await??;
        }
        let time = if received.is_empty() { limits.idle_time } else { limits.message_time };
        if timeout(time, stream.read_buf(&mut received)).await?? == 0 {
            return Ok(());
        }
    }
}

fn wrong(reason: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, reason)
}
