//! Routes messages by method to their handlers, in the order in which they are read.

use std::convert::Infallible;
use std::panic::AssertUnwindSafe;
use std::task::{Context, Poll};

use futures::FutureExt as _;
use futures::future::{BoxFuture, ready};
use serde_json::Value;
use tokio::sync::mpsc::UnboundedSender;
use tower_lsp::jsonrpc::{Error, ErrorCode, Id, Request, Response};
use tower_lsp::{LanguageServer, LspService};
use tower_service::Service;

use crate::inbox::Inbox;
use crate::job::Job;
use crate::reply::Waiting;
use crate::requests;
use crate::routes::{Route, Routes};
use crate::transport::Pump;

/// Error code for a request before `initialize`.
const NOT_INITIALIZED: i64 = -32002;

/// Phase of the session.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum SessionPhase {
    Fresh,
    Running,
    Down,
}

/// Service that tower-lsp calls with each message, on the task that reads.
///
/// Messages are posted to the inbox in `call` itself, before the next message is read. Their order is therefore kept,
/// and no handler blocks the reader. Only `initialize` and `shutdown` reach tower-lsp's own service.
pub(crate) struct Router<S: LanguageServer> {
    lifecycle: LspService<S>,
    phase: SessionPhase,
    routes: Routes,
    waiting: Waiting,
    inbox: Inbox,
    pump: Pump,
    exit: UnboundedSender<bool>,
}

/// Future of a response; `None` if the router itself sends no response.
type ResponseFuture = BoxFuture<'static, Result<Option<Response>, Infallible>>;

impl<S: LanguageServer> Router<S> {
    /// Creates the router. When the client sends `exit`, the router sends to `exit` whether `shutdown` came before.
    pub(crate) fn new(
        lifecycle: LspService<S>,
        routes: Routes,
        inbox: Inbox,
        pump: Pump,
        exit: UnboundedSender<bool>,
    ) -> Self {
        Self { lifecycle, phase: SessionPhase::Fresh, routes, waiting: Waiting::default(), inbox, pump, exit }
    }

    fn dispatch(&mut self, request: Request) -> ResponseFuture {
        match (request.method(), self.phase) {
            ("exit", phase) => {
                // The receiver no longer exists if the process is already ending.
                let _ = self.exit.send(phase == SessionPhase::Down);
                nothing()
            }
            ("$/cancelRequest", _) => {
                request.params().and_then(|params| params.get("id")).into_iter().for_each(|id| self.cancel(id));
                nothing()
            }
            ("initialize", SessionPhase::Fresh) | ("shutdown", SessionPhase::Running) => self.pass_on(request),
            (_, SessionPhase::Fresh) => refuse(&request, not_initialized()),
            (_, SessionPhase::Down) | ("initialize", _) => refuse(&request, Error::invalid_request()),
            _ => self.route(request),
        }
    }

    /// Passes `initialize` or `shutdown` to tower-lsp. The first poll happens here, so the handler's code before its
    /// first wait is executed in message order.
    fn pass_on(&mut self, request: Request) -> ResponseFuture {
        let begins = request.method() == "initialize";
        let readable = !begins || request.params().is_none_or(Value::is_object);
        if request.id().is_some() && readable {
            self.phase = if begins { SessionPhase::Running } else { SessionPhase::Down };
        }
        let id = request.id().cloned();
        let mut answer =
            AssertUnwindSafe(self.lifecycle.call(readable_by_types(request))).catch_unwind().map(move |result| {
                Ok(match result {
                    // The service fails only after `exit`, which it does not receive.
                    Ok(response) => response.ok().flatten(),
                    Err(_) => id.map(|id| Response::from_error(id, Error::internal_error())),
                })
            });
        match (&mut answer).now_or_never() {
            Some(result) if begins => {
                if matches!(&result, Ok(Some(response)) if response.is_error()) {
                    self.phase = SessionPhase::Fresh;
                }
                ready(result.map(|response| response.map(complete))).boxed()
            }
            Some(result) => ready(result).boxed(),
            None => answer.boxed(),
        }
    }

    fn cancel(&self, id: &Value) {
        if let Ok(id) = serde_json::from_value::<Id>(id.clone()) {
            self.waiting.cancel(&id);
        }
    }

    fn route(&mut self, request: Request) -> ResponseFuture {
        let (method, id, params) = request.into_parts();
        let params = params.unwrap_or(Value::Null);
        match (self.routes.get(method.as_ref()), id) {
            (Some(Route::Request(read)), Some(id)) => match read(params) {
                Ok(job) => self.ask(id, job),
                Err(error) => ready(Ok(Some(Response::from_error(id, error)))).boxed(),
            },
            (Some(Route::Notification(read)), None) => {
                match read(params) {
                    Ok(notified) => self.inbox.post(notified),
                    Err(error) => self.inbox.post(move |server| server.log(&format!("{method}: {}", error.message))),
                }
                nothing()
            }
            (_, None) => nothing(),
            (_, Some(id)) => {
                let message = format!("this server does not know the request `{method}`");
                let error = Error { code: ErrorCode::MethodNotFound, message: message.into(), data: None };
                ready(Ok(Some(Response::from_error(id, error)))).boxed()
            }
        }
    }

    /// Posts the request to the main loop. The thread that computes the response also writes it.
    fn ask(&self, id: Id, job: Job) -> ResponseFuture {
        let reply = self.waiting.begin(id, &self.pump);
        self.inbox.post(move |server| server.compute(job, reply));
        nothing()
    }
}

/// Adds the capabilities that have no field in lsp-types to the response to `initialize`.
fn complete(response: Response) -> Response {
    let (id, result) = response.into_parts();
    let result = result.map(|mut answer| {
        if let Some(capabilities) = answer.get_mut("capabilities").and_then(Value::as_object_mut) {
            requests::add_capabilities_without_type(capabilities);
        }
        answer
    });
    Response::from_parts(id, result)
}

/// Rewrites a request that lsp-types or tower-lsp would reject. tower-lsp rejects parameters of `shutdown`, but many
/// clients send `null` or `{}`. lsp-types 0.94 uses another name than the protocol for the capability
/// `workspace.diagnostics`.
fn readable_by_types(request: Request) -> Request {
    match request.into_parts() {
        (method, Some(id), _) if method == "shutdown" => Request::build(method).id(id).finish(),
        (method, Some(id), None | Some(Value::Null)) => Request::build(method).id(id).finish(),
        (method, Some(id), Some(mut params)) => {
            if let Some(workspace) = params.pointer_mut("/capabilities/workspace").and_then(Value::as_object_mut)
                && let Some(diagnostics) = workspace.remove("diagnostics")
            {
                workspace.insert("diagnostic".to_owned(), diagnostics);
            }
            Request::build(method).id(id).params(params).finish()
        }
        (method, None, params) => Request::build(method).params(params.unwrap_or_default()).finish(),
    }
}

fn nothing() -> ResponseFuture {
    ready(Ok(None)).boxed()
}

fn refuse(request: &Request, error: Error) -> ResponseFuture {
    ready(Ok(request.id().cloned().map(|id| Response::from_error(id, error)))).boxed()
}

fn not_initialized() -> Error {
    Error {
        code: ErrorCode::ServerError(NOT_INITIALIZED),
        message: "the first request must be `initialize`".into(),
        data: None,
    }
}

impl<S: LanguageServer> Service<Request> for Router<S> {
    type Response = Option<Response>;
    type Error = Infallible;
    type Future = ResponseFuture;

    fn poll_ready(&mut self, _: &mut Context<'_>) -> Poll<Result<(), Infallible>> {
        Poll::Ready(Ok(()))
    }

    fn call(&mut self, request: Request) -> ResponseFuture {
        self.dispatch(request)
    }
}
