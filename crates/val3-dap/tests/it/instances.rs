//! Every message that the schema allows is decoded and encoded without a loss.

use std::collections::{BTreeMap, BTreeSet};

use proptest::collection::{btree_map, vec};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::{Config, TestRunner};
use serde_json::{Map, Value, json};
use val3_dap::validate::{SCHEMA, SchemaValidator};
use val3_dap::{MessageContent, ProtocolMessage, Response, StandardEvent, StandardRequest};

/// Levels of objects below which optional properties are omitted. Some definitions contain themselves.
const DEPTH: usize = 5;

/// Returns the properties of an object and its base, and the names of required properties.
#[derive(Default)]
struct Object<'a> {
    properties: BTreeMap<&'a str, &'a Value>,
    required: BTreeSet<&'a str>,
}

struct Schema(Value);

impl Schema {
    fn resolve<'a>(&'a self, reference: &Value) -> &'a Value {
        self.0.pointer(reference.as_str().unwrap().trim_start_matches('#')).unwrap()
    }

    /// The names and definitions of all messages, without their envelopes.
    fn messages(&self) -> Vec<(&str, &Value)> {
        let definitions = self.0["definitions"].as_object().unwrap().iter();
        let messages = definitions.filter(|(name, definition)| {
            let base = definition["allOf"][0]["$ref"].as_str().and_then(|base| base.rsplit('/').next());
            *name != "ErrorResponse" && matches!(base, Some("Request" | "Response" | "Event"))
        });
        messages.map(|(name, definition)| (name.as_str(), definition)).collect()
    }

    fn object<'a>(&'a self, schema: &'a Value, object: &mut Object<'a>) {
        if let Some(reference) = schema.get("$ref") {
            self.object(self.resolve(reference), object);
            // The envelope allows any content, also for operations without one.
            if ["Request", "Response", "Event"].iter().any(|name| *reference == format!("#/definitions/{name}")) {
                object.properties.retain(|name, _| !["arguments", "body"].contains(name));
            }
        }
        for part in schema["allOf"].as_array().into_iter().flatten() {
            self.object(part, object);
        }
        let properties = schema["properties"].as_object().into_iter().flatten();
        object.properties.extend(properties.map(|(name, value)| (name.as_str(), value)));
        object.required.extend(schema["required"].as_array().into_iter().flatten().map(|name| name.as_str().unwrap()));
    }

    /// The schema declares some contents as optional "for historical reasons", although they have required properties.
    fn is_content_with_required_properties(&self, name: &str, schema: &Value) -> bool {
        let mut content = Object::default();
        self.object(schema, &mut content);
        ["arguments", "body"].contains(&name) && !content.required.is_empty()
    }

    fn instance(&self, schema: &Value, depth: usize) -> BoxedStrategy<Value> {
        if let Some(reference) = schema.get("$ref") {
            return self.instance(self.resolve(reference), depth);
        }
        if let Some(values) = schema["enum"].as_array() {
            return select(values.clone()).boxed();
        }
        if let Some(values) = schema["_enum"].as_array() {
            return prop_oneof![select(values.clone()), text()].boxed();
        }
        if let Some(choices) = schema["oneOf"].as_array() {
            return self.instance(&choices[0], depth);
        }
        if schema.get("allOf").is_some() {
            return self.object_instance(schema, depth);
        }
        match &schema["type"] {
            Value::Array(types) if types.len() == 2 => {
                select(types.clone()).prop_flat_map(|name| simple_instance(&json!({ "type": name }))).boxed()
            }
            // `null` is the same as a missing property.
            Value::Array(_) => prop_oneof![text(), Just(json!([1, { "a": null }])), Just(json!({ "b": true }))].boxed(),
            Value::String(name) if name == "array" && depth == 0 => Just(json!([])).boxed(),
            Value::String(name) if name == "array" => {
                vec(self.instance(&schema["items"], depth - 1), 0..3).prop_map(Value::Array).boxed()
            }
            Value::String(name) if name == "object" => self.object_instance(schema, depth),
            _ => simple_instance(schema),
        }
    }

    fn object_instance(&self, schema: &Value, depth: usize) -> BoxedStrategy<Value> {
        let values = match &schema["additionalProperties"] {
            Value::Null => None,
            Value::Bool(_) => Some(text()),
            values => Some(self.instance(values, depth)),
        };
        if let Some(values) = values {
            let members = btree_map("[a-z]{1,3}", values, 0..3);
            return members.prop_map(|members| Value::Object(members.into_iter().collect())).boxed();
        }
        let mut object = Object::default();
        self.object(schema, &mut object);
        let fields = object.properties.into_iter().filter_map(|(name, schema)| {
            let name = name.to_owned();
            if object.required.contains(name.as_str()) || self.is_content_with_required_properties(&name, schema) {
                return Some(
                    self.instance(schema, depth.saturating_sub(1)).prop_map(move |v| Some((name.clone(), v))).boxed(),
                );
            }
            let value = (depth > 0).then(|| self.instance(schema, depth - 1))?;
            Some(proptest::option::of(value.prop_map(move |v| (name.clone(), v))).boxed())
        });
        let fields = fields.collect::<Vec<_>>();
        fields.prop_map(|fields| Value::Object(fields.into_iter().flatten().collect())).boxed()
    }
}

fn text() -> BoxedStrategy<Value> {
    any::<String>().prop_map(Value::String).boxed()
}

fn simple_instance(schema: &Value) -> BoxedStrategy<Value> {
    let (least, most) = match schema["format"].as_str() {
        Some("int32") => (i64::from(i32::MIN), i64::from(i32::MAX)),
        Some("uint32") => (0, i64::from(u32::MAX)),
        Some("uint64") => (0, i64::MAX),
        _ => (i64::MIN, i64::MAX),
    };
    let least = schema["minimum"].as_i64().unwrap_or(least);
    let most = schema["maximum"].as_i64().unwrap_or(most);
    match schema["type"].as_str() {
        Some("string") => text(),
        Some("boolean") => any::<bool>().prop_map(Value::Bool).boxed(),
        Some("integer") => (least..=most).prop_map(Value::from).boxed(),
        Some("number") => (0..=100_u8).prop_map(|percent| json!(f64::from(percent))).boxed(),
        Some("null") => Just(Value::Null).boxed(),
        other => panic!("an instance of {other:?}"),
    }
}

/// Returns the content after decoding and encoding.
fn converted(content: MessageContent) -> MessageContent {
    match content {
        MessageContent::Request { command, arguments } => {
            MessageContent::request(&StandardRequest::parse(&command, arguments).unwrap())
        }
        MessageContent::Response { request_seq, command, body, .. } => {
            MessageContent::success(request_seq, &Response::decode(&command, body).unwrap().unwrap())
        }
        MessageContent::Event { event, body } => {
            MessageContent::event(&StandardEvent::decode(&event, body).unwrap().unwrap())
        }
    }
    .unwrap()
}

/// Replaces missing content by an empty object, because both are decoded alike.
fn with_content(mut content: MessageContent) -> MessageContent {
    let (MessageContent::Request { arguments: value, .. }
    | MessageContent::Response { body: value, .. }
    | MessageContent::Event { body: value, .. }) = &mut content;
    value.get_or_insert_with(|| Value::Object(Map::new()));
    content
}

#[test]
fn every_message_of_the_schema_keeps_its_content() {
    let schema = Schema(serde_json::from_str(SCHEMA).unwrap());
    let mut validator = SchemaValidator::new().unwrap();
    let messages = schema.messages();
    assert_eq!(messages.len(), 107);
    for (name, definition) in messages {
        let mut runner = TestRunner::new(Config { cases: 24, failure_persistence: None, ..Config::default() });
        let instances = schema.instance(definition, DEPTH);
        for _ in 0..24 {
            let mut instance = instances.new_tree(&mut runner).unwrap().current();
            let properties = instance.as_object_mut().unwrap();
            if let Some(command) = name.strip_suffix("Response") {
                // The schema allows any name in a response.
                let command = command[..1].to_ascii_lowercase() + &command[1..];
                properties.insert("command".into(), command.into());
                properties.insert("success".into(), Value::Bool(true));
                properties.remove("message");
            }
            validator.validate(&instance).unwrap();
            let message: ProtocolMessage = serde_json::from_value(instance.clone()).unwrap();
            let encoded = ProtocolMessage { seq: message.seq, content: converted(message.content.clone()) };
            validator.validate(&serde_json::to_value(&encoded).unwrap()).unwrap();
            assert_eq!(with_content(encoded.content), with_content(message.content), "{instance}");
        }
    }
}
