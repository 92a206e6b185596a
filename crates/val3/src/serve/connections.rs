//! Connections. Each connection has one request, and the response is the page, a socket, or 404.

use std::io;
use std::net::TcpListener as StdListener;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::extract::ws::WebSocketUpgrade;
use axum::extract::{FromRequestParts as _, Request, State};
use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Semaphore;
use tokio::time::{sleep, timeout};

use super::access::{Grant, Resource};
use super::page::{not_found, protective_headers};
use super::shared::Shared;
use super::viewer;

/// Maximum size of a request header, in bytes.
const HEADER_BYTES: usize = 16 << 10;

/// Pause after a failed `accept`, for example because the process temporarily has no free file handle.
const ACCEPT_PAUSE: Duration = Duration::from_millis(50);

/// Accepts connections until the server ends, then waits while the viewers read the remaining messages.
pub(super) async fn accept(listener: StdListener, shared: Arc<Shared>) -> io::Result<()> {
    let listener = TcpListener::from_std(listener)?;
    let router = Router::new().fallback(answer).with_state(Arc::clone(&shared));
    let connections = Arc::new(Semaphore::new(shared.limits.connections));
    let mut is_over = shared.is_over.clone();
    loop {
        let stream = tokio::select! {
            accepted = listener.accept() => accepted,
            _ = is_over.wait_for(|is_over| *is_over) => break,
        };
        let Ok((stream, _)) = stream else {
            sleep(ACCEPT_PAUSE).await;
            continue;
        };
        // Without a permit the connection is closed immediately.
        if let Ok(permit) = Arc::clone(&connections).try_acquire_owned() {
            let request = serve(stream, router.clone(), Arc::clone(&shared));
            tokio::spawn(async move {
                request.await;
                drop(permit);
            });
        }
    }
    let all = u32::try_from(shared.limits.viewers).unwrap_or(u32::MAX);
    // Viewers that do not read are disconnected.
    let _ = timeout(shared.limits.farewell_time, shared.places.acquire_many(all)).await;
    Ok(())
}

/// Serves a connection's only request. A socket outlives this function.
async fn serve(stream: TcpStream, router: Router, shared: Arc<Shared>) {
    // Without this option, small messages wait until earlier messages are acknowledged.
    let _ = stream.set_nodelay(true);
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(shared.limits.header_time)
        .max_buf_size(HEADER_BYTES)
        .serve_connection(TokioIo::new(stream), TowerToHyperService::new(router))
        .with_upgrades();
    // After a timeout or a disconnection nothing remains to be done.
    let _ = timeout(shared.limits.request_time, connection).await;
}

async fn answer(State(shared): State<Arc<Shared>>, request: Request) -> Response {
    match shared.access.grant(&request) {
        None => not_found(),
        Some(Grant { resource: Resource::Page, host, .. }) => shared.page.respond(&host),
        Some(grant) => open_socket(grant, shared, request).await,
    }
}

async fn open_socket(grant: Grant, shared: Arc<Shared>, request: Request) -> Response {
    let (mut parts, _) = request.into_parts();
    let Ok(upgrade) = WebSocketUpgrade::from_request_parts(&mut parts, &()).await else { return not_found() };
    let Ok(place) = Arc::clone(&shared.places).try_acquire_owned() else {
        return (StatusCode::SERVICE_UNAVAILABLE, protective_headers(), "too many viewers").into_response();
    };
    let most = shared.limits.message_bytes;
    upgrade.max_message_size(most).max_frame_size(most).on_upgrade(async move |socket| {
        viewer::attend(socket, grant.role, shared).await;
        drop(place);
    })
}
