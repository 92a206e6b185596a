//! Containment of panics: a bug in the server ends only the current work.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use tower_lsp::jsonrpc::{Error, ErrorCode};

/// Executes `work`. If it panics, returns the panic message.
pub(crate) fn contained<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|payload| reason(&*payload))
}

fn reason(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(|text| (*text).to_owned());
    let text = text.or_else(|| payload.downcast_ref::<String>().cloned());
    text.unwrap_or_else(|| "no reason is known".to_owned())
}

/// Error response for a request that panicked.
pub(crate) fn internal_error(method: &str, reason: &str) -> Error {
    let message = format!("`{method}` failed because of a fault in the language server: {reason}");
    Error { code: ErrorCode::InternalError, message: message.into(), data: None }
}

/// Error response for a request that was dropped.
pub(crate) fn lost() -> Error {
    Error { code: ErrorCode::InternalError, message: "the server ends".into(), data: None }
}
