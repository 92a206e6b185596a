//! HTTP connections of the servers of a run, with limits on their number and time.

use std::io;
use std::net::TcpListener as StdListener;
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, watch};
use tokio::time::{sleep, timeout};

/// Maximum size of a request header, in bytes.
const HEADER_BYTES: usize = 16 << 10;

/// Pause after a failed `accept`, for example because the process temporarily has no free file handle.
const ACCEPT_PAUSE: Duration = Duration::from_millis(50);

/// Limits of connections.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ConnectionLimits {
    /// Maximum number of connections, without upgraded connections.
    pub(crate) connections: usize,
    /// Timeout for a request header.
    pub(crate) header_time: Duration,
    /// Time after which a connection accepts no further request.
    pub(crate) connection_time: Duration,
    /// Time for the last request after this time.
    pub(crate) last_request_time: Duration,
}

/// Accepts connections until the server ends.
///
/// # Errors
/// The listener cannot be used.
pub(crate) async fn accept(
    listener: StdListener,
    router: Router,
    limits: ConnectionLimits,
    mut is_over: watch::Receiver<bool>,
) -> io::Result<()> {
    let listener = TcpListener::from_std(listener)?;
    let connections = Arc::new(Semaphore::new(limits.connections));
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
        if let Ok(permit) = Arc::clone(&connections).try_acquire_owned() {
            let requests = serve(stream, router.clone(), limits);
            tokio::spawn(async move {
                requests.await;
                drop(permit);
            });
        }
    }
}

/// Serves the requests of a connection. An upgraded connection outlives this function.
async fn serve(stream: TcpStream, router: Router, limits: ConnectionLimits) {
    // Without this option, small messages wait until earlier messages are acknowledged.
    let _ = stream.set_nodelay(true);
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(limits.header_time)
        .max_buf_size(HEADER_BYTES)
        .serve_connection(TokioIo::new(stream), TowerToHyperService::new(router))
        .with_upgrades();
    let mut connection = pin!(connection);
    // After a disconnection or the last timeout nothing remains to be done.
    tokio::select! {
        _ = connection.as_mut() => {}
        () = sleep(limits.connection_time) => {
            connection.as_mut().graceful_shutdown();
            let _ = timeout(limits.last_request_time, connection).await;
        }
    }
}
