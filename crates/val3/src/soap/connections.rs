//! Requests of connections: from HTTP to a call of the service, and from its answer to HTTP.

use std::io;
use std::net::TcpListener;
use std::sync::mpsc::{SyncSender, TrySendError};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::extract::{Request, State};
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE, ORIGIN, X_CONTENT_TYPE_OPTIONS};
use axum::http::{Method, StatusCode};
use axum::response::{IntoResponse as _, Response};
use tokio::sync::{oneshot, watch};
use tokio::time::timeout;
use val3_service::{ServiceAnswer, ServiceCall};
use val3_soap::{Envelope, SessionHeader, SoapError, SoapFault, SoapRequest, SoapServer, SoapVersion, multipart};

use super::PendingCall;
use super::limits::SoapLimits;
use crate::http;
use crate::serve::quota::{Admission, Quota};

/// State shared by the connections of a server.
pub(super) struct SoapShared {
    /// Channel to the run loop.
    pub(super) calls: SyncSender<PendingCall>,
    pub(super) limits: SoapLimits,
    pub(super) quota: Mutex<Quota>,
}

/// Response without a SOAP message: the status and the reason.
type Rejection = (StatusCode, &'static str);

/// Accepts connections until the server ends.
pub(super) async fn accept(
    listener: TcpListener,
    shared: Arc<SoapShared>,
    is_over: watch::Receiver<bool>,
) -> io::Result<()> {
    let limits = shared.limits.connections;
    http::accept(listener, Router::new().fallback(respond).with_state(shared), limits, is_over).await
}

/// Responds to an HTTP request.
async fn respond(State(shared): State<Arc<SoapShared>>, request: Request) -> Response {
    let (status, content_type, text) = match shared.exchange(request).await {
        Ok(message) => {
            let status = if message.is_fault { StatusCode::INTERNAL_SERVER_ERROR } else { StatusCode::OK };
            (status, message.envelope.version.content_type(), message.envelope.write())
        }
        Err((status, reason)) => (status, "text/plain", format!("{reason}\n")),
    };
    let content_type = format!("{content_type}; charset=utf-8");
    let headers =
        [(CONTENT_TYPE, content_type.as_str()), (CACHE_CONTROL, "no-store"), (X_CONTENT_TYPE_OPTIONS, "nosniff")];
    (status, headers, text).into_response()
}

/// SOAP message as a response.
struct AnswerMessage {
    envelope: Envelope,
    is_fault: bool,
}

impl AnswerMessage {
    /// Message with a fault.
    fn fault(fault: &SoapFault, version: SoapVersion, session: Option<SessionHeader>) -> Self {
        Self { envelope: Envelope { version, session, body: fault.write(version) }, is_fault: true }
    }
}

impl SoapShared {
    /// Reads a request, executes it in the run loop, and returns the answer.
    async fn exchange(&self, request: Request) -> Result<AnswerMessage, Rejection> {
        // Only browsers send the header. A page of any server could otherwise operate the controller.
        if request.headers().contains_key(ORIGIN) {
            return Err((StatusCode::FORBIDDEN, "web pages have no access"));
        }
        let server = SoapServer::at_path(request.uri().path())
            .ok_or((StatusCode::NOT_FOUND, "the paths are /, /CS8ServerV1, /CS8ServerV2 and /CS8ServerV3"))?;
        if request.method() != Method::POST {
            return Err((StatusCode::METHOD_NOT_ALLOWED, "send SOAP requests with POST"));
        }
        let content_type = request.headers().get(CONTENT_TYPE).and_then(|value| value.to_str().ok());
        let content_type = content_type.unwrap_or_default().to_owned();
        let body = self.read_body(request.into_body()).await?;
        let envelope = match multipart::envelope(&content_type, &body) {
            Ok(envelope) => Envelope::read(envelope),
            Err(SoapError::Transport(reason)) => return Err((StatusCode::UNSUPPORTED_MEDIA_TYPE, reason)),
            Err(error) => Err(error),
        };
        let Envelope { version, session, body } = match envelope {
            Ok(envelope) => envelope,
            Err(error) => {
                return Ok(AnswerMessage::fault(&SoapFault::of_error(&error), version_of(&content_type), None));
            }
        };
        let session = session.map(|SessionHeader { id, .. }| SessionHeader { id, must_understand: false });
        let request = match SoapRequest::read(server, &body) {
            Ok(request) => request,
            Err(error) => return Ok(AnswerMessage::fault(&SoapFault::of_error(&error), version, session)),
        };
        let answer = self.call(ServiceCall { session: session.map(|header| header.id), request }).await?;
        let session = answer.session.map(|id| SessionHeader { id, must_understand: false });
        Ok(match answer.result {
            Ok(answer) => {
                AnswerMessage { envelope: Envelope { version, session, body: answer.write() }, is_fault: false }
            }
            Err(fault) => AnswerMessage::fault(&fault, version, session),
        })
    }

    async fn read_body(&self, body: Body) -> Result<axum::body::Bytes, Rejection> {
        match timeout(self.limits.body_time, to_bytes(body, self.limits.body_bytes)).await {
            Ok(Ok(body)) => Ok(body),
            Ok(Err(_)) => Err((StatusCode::PAYLOAD_TOO_LARGE, "a request has at most 1 MiB")),
            Err(_) => Err((StatusCode::REQUEST_TIMEOUT, "the body did not arrive in time")),
        }
    }

    /// Passes a call to the run loop, and waits for the answer.
    async fn call(&self, call: ServiceCall) -> Result<ServiceAnswer, Rejection> {
        let admission = self.quota.lock().unwrap_or_else(PoisonError::into_inner).admit(Instant::now());
        if admission != Admission::Granted {
            return Err((StatusCode::TOO_MANY_REQUESTS, "too many requests in a short time"));
        }
        let (sender, answer) = oneshot::channel();
        let end = Instant::now() + self.limits.answer_time;
        self.calls.try_send(PendingCall { call, answer: sender, end }).map_err(|error| match error {
            TrySendError::Full(_) => (StatusCode::SERVICE_UNAVAILABLE, "the run is busy"),
            TrySendError::Disconnected(_) => (StatusCode::SERVICE_UNAVAILABLE, "the run has ended"),
        })?;
        match timeout(self.limits.answer_time, answer).await {
            Ok(Ok(answer)) => Ok(answer),
            Ok(Err(_)) => Err((StatusCode::SERVICE_UNAVAILABLE, "the run has ended")),
            Err(_) => Err((StatusCode::GATEWAY_TIMEOUT, "the run is busy")),
        }
    }
}

/// SOAP version that belongs to a content type, for the answer to a message without a readable envelope.
fn version_of(content_type: &str) -> SoapVersion {
    let essence = content_type.split(';').next().unwrap_or_default().trim();
    match essence.eq_ignore_ascii_case(SoapVersion::V11.content_type()) {
        true => SoapVersion::V11,
        false => SoapVersion::V12,
    }
}
