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
use tokio::time::timeout;

use super::access::{Grant, Resource};
use super::page::{not_found, protective_headers};
use super::shared::Shared;
use super::viewer;
use crate::http::{self, ConnectionLimits};

/// Accepts connections until the server ends, then waits while the viewers read the remaining messages.
pub(super) async fn accept(listener: StdListener, shared: Arc<Shared>) -> io::Result<()> {
    let router = Router::new().fallback(answer).with_state(Arc::clone(&shared));
    let limits = ConnectionLimits {
        connections: shared.limits.connections,
        header_time: shared.limits.header_time,
        connection_time: shared.limits.request_time,
        last_request_time: Duration::ZERO,
    };
    http::accept(listener, router, limits, shared.is_over.clone()).await?;
    let all = u32::try_from(shared.limits.viewers).unwrap_or(u32::MAX);
    // Viewers that do not read are disconnected.
    let _ = timeout(shared.limits.farewell_time, shared.places.acquire_many(all)).await;
    Ok(())
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
