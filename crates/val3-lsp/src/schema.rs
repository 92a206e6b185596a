//! Schemas of the requests `val3/…`.

pub(crate) mod protocol;

use schemars::JsonSchema;
use tower_lsp::lsp_types::request::Request;
use val3_schema::{RequestSchema, RequestWords};

/// Words of the Language Server Protocol.
pub(crate) const WORDS: RequestWords = RequestWords {
    requests: "ServerRequests",
    received: "params",
    sent: "result",
    description: "Parameters and results of the requests `val3/…`, by method.",
};

/// Returns the schema of a request whose types have schemas.
pub(crate) fn of<R: Request<Params: JsonSchema, Result: JsonSchema>>() -> RequestSchema {
    described::<R, R::Params, R::Result>()
}

/// Returns the schema of a request whose parameters and result are described by other types.
pub(crate) fn described<R: Request, P: JsonSchema, B: JsonSchema>() -> RequestSchema {
    RequestSchema::of::<P, B>(R::METHOD)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::requests::server_requests_schema;

    #[test]
    fn each_request_outside_the_protocol_has_a_schema() {
        let schema = server_requests_schema().unwrap();
        let routes = crate::requests::routes();
        let own: Vec<&str> = routes.methods().filter(|method| method.starts_with("val3/")).collect();
        let described = schema["$defs"][WORDS.requests]["properties"].as_object().unwrap();
        assert_eq!(own.len(), described.len());
        assert!(own.iter().all(|method| described.contains_key(*method)), "{own:?}");
    }
}
