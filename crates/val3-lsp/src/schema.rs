//! JSON schema of the requests `val3/…`.

pub(crate) mod protocol;

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};
use tower_lsp::lsp_types::request::Request;

/// Definition with the parameters and results of all requests, by method.
const REQUESTS: &str = "ServerRequests";

/// Schema of a request of the language server.
pub(crate) struct MethodSchema {
    method: &'static str,
    params: Value,
    result: Value,
    /// Types to which the parameters and the result refer, by name. A name in both lists has the same schema.
    definitions: [Map<String, Value>; 2],
}

impl MethodSchema {
    /// Returns the schema of a request whose types have schemas.
    pub(crate) fn of<R: Request<Params: JsonSchema, Result: JsonSchema>>() -> Self {
        Self::described::<R, R::Params, R::Result>()
    }

    /// Returns the schema of a request whose parameters and result are described by other types.
    pub(crate) fn described<R: Request, P: JsonSchema, B: JsonSchema>() -> Self {
        let mut received = SchemaSettings::draft2020_12().for_deserialize().into_generator();
        let mut sent = SchemaSettings::draft2020_12().for_serialize().into_generator();
        let (params, result) = (received.subschema_for::<P>().to_value(), sent.subschema_for::<B>().to_value());
        let definitions = [received.take_definitions(true), sent.take_definitions(true)];
        Self { method: R::METHOD, params, result, definitions }
    }
}

/// Combines the schemas of requests. Its root is the object of all requests.
pub(crate) fn of_methods(requests: impl IntoIterator<Item = MethodSchema>) -> Value {
    let (mut definitions, mut methods) = (Map::new(), Map::new());
    for MethodSchema { method, params, result, definitions: types } in requests {
        definitions.extend(types.into_iter().flatten());
        let parts = json!({ "params": params, "result": result });
        methods.insert(method.to_owned(), object(parts, format!("Request `{method}`.")));
    }
    let all = object(Value::Object(methods), "Parameters and results of the requests `val3/…`, by method.".to_owned());
    definitions.insert(REQUESTS.to_owned(), all);
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$ref": format!("#/$defs/{REQUESTS}"),
        "$defs": definitions,
    })
}

/// Object with these properties, all of them required.
fn object(properties: Value, description: String) -> Value {
    let required: Vec<&String> = properties.as_object().into_iter().flat_map(Map::keys).collect();
    let required = json!(required);
    json!({ "type": "object", "description": description, "properties": properties, "required": required })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::requests::{server_request_schemas, server_requests_schema};

    #[test]
    fn each_name_has_one_definition() {
        let mut known = Map::new();
        for (name, schema) in server_request_schemas().into_iter().flat_map(|request| request.definitions).flatten() {
            let earlier = known.insert(name.clone(), schema.clone());
            assert!(earlier.is_none_or(|earlier| earlier == schema), "{name} has two definitions");
        }
    }

    #[test]
    fn each_reference_has_a_definition() {
        let schema = server_requests_schema();
        let definitions = schema["$defs"].as_object().unwrap();
        let text = schema.to_string();
        for name in text.split("#/$defs/").skip(1).map(|rest| rest.split('"').next().unwrap()) {
            assert!(definitions.contains_key(name), "{name}");
        }
    }

    #[test]
    fn each_request_outside_the_protocol_has_a_schema() {
        let schema = server_requests_schema();
        let routes = crate::requests::routes();
        let own: Vec<&str> = routes.methods().filter(|method| method.starts_with("val3/")).collect();
        let described = schema["$defs"][REQUESTS]["properties"].as_object().unwrap();
        assert_eq!(own.len(), described.len());
        assert!(own.iter().all(|method| described.contains_key(*method)), "{own:?}");
    }
}
