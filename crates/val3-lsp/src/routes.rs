//! Handlers by method.

use std::sync::{Arc, Mutex, PoisonError};

use rustc_hash::FxHashMap;
use serde::Serialize;
use serde_json::Value;
use tower_lsp::jsonrpc::{Error, ErrorCode, Result};

use crate::job::{Compute, Job, JobPart, OnEdit};
use crate::pool::Priority;
use crate::server_state::ServerState;
use crate::snapshot::{Refusal, Snapshot};

/// Parsed notification, to be executed by the main loop.
type NotificationHandler = Box<dyn FnOnce(&mut ServerState) + Send>;

/// Handler of a method; it parses the parameters of a message.
pub(crate) enum Route {
    /// Handler of a request.
    Request(Box<dyn Fn(Value) -> Result<Job> + Send>),
    /// Handler of a notification.
    Notification(Box<dyn Fn(Value) -> Result<NotificationHandler> + Send>),
}

/// Handlers by method.
#[derive(Default)]
pub(crate) struct Routes(FxHashMap<&'static str, Route>);

impl Routes {
    /// Adds a request that is computed on a snapshot.
    pub(crate) fn on<R>(
        &mut self,
        priority: Priority,
        on_edit: OnEdit,
        handler: fn(&Snapshot, &R::Params) -> std::result::Result<R::Result, Refusal>,
    ) where
        R: tower_lsp::lsp_types::request::Request,
        R::Params: Send + Sync + 'static,
        R::Result: 'static,
    {
        self.request::<R>(priority, on_edit, move |params| {
            Arc::new(move |snapshot: &Snapshot| answer(handler(snapshot, &params)).map(Some))
        });
    }

    /// Adds a request that is computed in parts, with a state that is passed from part to part.
    pub(crate) fn on_in_parts<R, S>(
        &mut self,
        priority: Priority,
        on_edit: OnEdit,
        handler: fn(&Snapshot, &R::Params, &mut S) -> JobPart<R::Result>,
    ) where
        R: tower_lsp::lsp_types::request::Request,
        R::Params: Send + Sync + 'static,
        R::Result: 'static,
        S: Default + Send + 'static,
    {
        self.request::<R>(priority, on_edit, move |params| {
            let state = Mutex::new(S::default());
            Arc::new(move |snapshot: &Snapshot| {
                let mut state = state.lock().unwrap_or_else(PoisonError::into_inner);
                match handler(snapshot, &params, &mut state) {
                    JobPart::Last(result) => answer(Ok(result)).map(Some),
                    JobPart::More => Ok(None),
                }
            })
        });
    }

    /// Adds a request; `compute` returns the computation for given parameters.
    fn request<R>(
        &mut self,
        priority: Priority,
        on_edit: OnEdit,
        compute: impl Fn(R::Params) -> Compute + Send + 'static,
    ) where
        R: tower_lsp::lsp_types::request::Request,
    {
        let route = Route::Request(Box::new(move |params| {
            Ok(Job { method: R::METHOD, priority, on_edit, compute: compute(read_params(params)?) })
        }));
        self.0.insert(R::METHOD, route);
    }

    /// Adds a notification that the main loop handles itself.
    pub(crate) fn notify<N>(&mut self, handler: fn(&mut ServerState, N::Params))
    where
        N: tower_lsp::lsp_types::notification::Notification,
        N::Params: Send + 'static,
    {
        let route = Route::Notification(Box::new(move |params| {
            let params: N::Params = read_params(params)?;
            Ok(Box::new(move |server: &mut ServerState| handler(server, params)))
        }));
        self.0.insert(N::METHOD, route);
    }

    /// Methods with a handler, in any order.
    #[cfg(test)]
    pub(crate) fn methods(&self) -> impl Iterator<Item = &'static str> {
        self.0.keys().copied()
    }

    /// Handler of a method.
    pub(crate) fn get(&self, method: &str) -> Option<&Route> {
        self.0.get(method)
    }
}

fn answer(result: std::result::Result<impl Serialize, Refusal>) -> Result<String> {
    match result {
        Ok(result) => serde_json::to_string(&result).map_err(|_| Error::internal_error()),
        Err(Refusal::Unknown) => Ok("null".to_owned()),
        Err(Refusal::Because(reason)) => Err(request_failed(reason)),
        Err(Refusal::Outdated) => Err(Error::content_modified()),
    }
}

fn read_params<P: serde::de::DeserializeOwned>(params: Value) -> Result<P> {
    serde_json::from_value(params).map_err(|error| Error::invalid_params(error.to_string()))
}

fn request_failed(reason: String) -> Error {
    Error { code: ErrorCode::ServerError(-32803), message: reason.into(), data: None }
}
