//! Reads the JSON schema into the types to be written.
//!
//! Names are sorted, because the order of a JSON object depends on the enabled features of `serde_json`.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, bail};
use serde_json::Value;

/// Definitions of a message's envelope, which is written by hand.
const ENVELOPE: &[&str] = &["ProtocolMessage", "Request", "Response", "Event"];

/// Arguments to which an adapter adds its own.
const EXTENSIBLE: &[&str] = &["LaunchRequestArguments", "AttachRequestArguments"];

/// All definitions of the schema.
#[derive(Default)]
pub(super) struct Protocol {
    pub(super) requests: Vec<Operation>,
    pub(super) responses: Vec<Operation>,
    pub(super) events: Vec<Operation>,
    pub(super) types: BTreeMap<String, Definition>,
}

/// A request, response or event: its name in a message, and the type of its arguments or body.
pub(super) struct Operation {
    pub(super) name: String,
    pub(super) content: Option<String>,
}

/// A type to be written.
pub(super) struct Definition {
    pub(super) doc: String,
    pub(super) kind: Kind,
    pub(super) shape: Shape,
}

/// Kind of a definition, which selects its file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Arguments,
    Response,
    Event,
    Shared,
    Enumeration,
}

pub(super) enum Shape {
    Struct {
        fields: Vec<Field>,
        extensible: bool,
    },
    /// An enumeration. If it is open, other values than the listed ones are allowed.
    Enum {
        values: Vec<String>,
        open: bool,
    },
}

pub(super) struct Field {
    /// Name in a message.
    pub(super) name: String,
    pub(super) type_name: String,
    pub(super) required: bool,
}

/// The present definition.
struct Owner<'a> {
    name: &'a str,
    kind: Kind,
}

impl Protocol {
    pub(super) fn read(text: &str) -> anyhow::Result<Self> {
        let schema: Value = serde_json::from_str(text)?;
        let all = schema.get("definitions").and_then(Value::as_object).context("the schema has no definitions")?;
        let names = all.keys().filter(|name| !ENVELOPE.contains(&name.as_str())).collect::<BTreeSet<_>>();
        let mut protocol = Self::default();
        for name in names {
            let definition = all.get(name).context("a name has a definition")?;
            protocol.definition(name, definition, &schema).with_context(|| format!("in {name}"))?;
        }
        Ok(protocol)
    }

    fn definition(&mut self, name: &str, definition: &Value, schema: &Value) -> anyhow::Result<()> {
        match base(definition) {
            Some("Request") => {
                let operation = self.operation(name, Kind::Arguments, part(definition)?)?;
                self.requests.push(operation);
            }
            // The body of a failed request has no separate command.
            Some("Response") if name == "ErrorResponse" => {
                self.operation(name, Kind::Response, part(definition)?)?;
            }
            Some("Response") => {
                let operation = self.operation(name, Kind::Response, part(definition)?)?;
                self.responses.push(operation);
            }
            Some("Event") => {
                let operation = self.operation(name, Kind::Event, part(definition)?)?;
                self.events.push(operation);
            }
            _ => self.type_definition(name, definition, schema)?,
        }
        Ok(())
    }

    /// Adds an operation, whose name and content are properties of `part`.
    fn operation(&mut self, definition: &str, kind: Kind, part: &Value) -> anyhow::Result<Operation> {
        let name_property = if kind == Kind::Event { "event" } else { "command" };
        let content_property = if kind == Kind::Arguments { "arguments" } else { "body" };
        let property = |key| part.get("properties").and_then(|properties| properties.get(key));
        let declared = property(name_property).and_then(|name| name.get("enum")?.get(0)?.as_str()).map(str::to_owned);
        let name = declared.unwrap_or_else(|| lower_first(definition.strip_suffix("Response").unwrap_or(definition)));
        let content = match property(content_property) {
            None => None,
            Some(content) if content.get("$ref").is_some() => Some(reference(content)?),
            Some(content) => {
                let doc = match kind {
                    Kind::Event => format!("Body of the event `{name}`."),
                    _ => format!("Body of the response to `{name}`."),
                };
                self.structure(&Owner { name: definition, kind }, doc, &[content])?;
                Some(definition.to_owned())
            }
        };
        Ok(Operation { name, content })
    }

    fn type_definition(&mut self, name: &str, definition: &Value, schema: &Value) -> anyhow::Result<()> {
        let request = name.strip_suffix("Arguments").map(|name| name.strip_suffix("Request").unwrap_or(name));
        let owner = Owner { name, kind: if request.is_some() { Kind::Arguments } else { Kind::Shared } };
        let doc = match request {
            Some(request) => format!("Arguments of the request `{}`.", lower_first(request)),
            None => format!("`{name}` of the specification."),
        };
        if let Some((values, open)) = enumeration(definition)? {
            self.insert(name, Definition { doc, kind: Kind::Enumeration, shape: Shape::Enum { values, open } });
            return Ok(());
        }
        match base(definition) {
            None => self.structure(&owner, doc, &[definition]),
            Some(base) => {
                let base = schema.pointer(&format!("/definitions/{base}")).context("a base is defined")?;
                self.structure(&owner, doc, &[base, part(definition)?])
            }
        }
    }

    /// Adds a structure with the properties of all `parts`.
    fn structure(&mut self, owner: &Owner<'_>, doc: String, parts: &[&Value]) -> anyhow::Result<()> {
        let mut fields = Vec::new();
        for part in parts {
            let required = strings(part.get("required"))?;
            for (name, schema) in part.get("properties").and_then(Value::as_object).into_iter().flatten() {
                let type_name = self.type_name(owner, name, schema).with_context(|| format!("in {name}"))?;
                fields.push(Field { name: name.clone(), type_name, required: required.contains(name) });
            }
        }
        fields.sort_by(|a, b| (!a.required, &a.name).cmp(&(!b.required, &b.name)));
        let extensible = EXTENSIBLE.contains(&owner.name);
        self.insert(owner.name, Definition { doc, kind: owner.kind, shape: Shape::Struct { fields, extensible } });
        Ok(())
    }

    /// Returns the type of a property. An enumeration inside a property is named after its owner and the property.
    fn type_name(&mut self, owner: &Owner<'_>, field: &str, schema: &Value) -> anyhow::Result<String> {
        if schema.get("$ref").is_some() {
            return reference(schema);
        }
        if let Some((values, open)) = enumeration(schema)? {
            let prefix = owner.name.trim_end_matches("Arguments").trim_end_matches("Request");
            let name = format!("{prefix}{}", upper_first(field));
            let doc = format!("Values of `{field}` in `{}`.", owner.name);
            self.insert(&name, Definition { doc, kind: Kind::Enumeration, shape: Shape::Enum { values, open } });
            return Ok(name);
        }
        if schema.get("oneOf").is_some() {
            return Ok("Value".to_owned());
        }
        match schema.get("type") {
            Some(Value::String(name)) => self.simple_type(owner, field, schema, name),
            Some(Value::Array(names)) => match names.as_slice() {
                [Value::String(name), Value::String(null)] if null == "null" => {
                    Ok(format!("Option<{}>", self.simple_type(owner, field, schema, name)?))
                }
                _ => Ok("Value".to_owned()),
            },
            _ => bail!("a property without a type"),
        }
    }

    fn simple_type(&mut self, owner: &Owner<'_>, field: &str, schema: &Value, name: &str) -> anyhow::Result<String> {
        Ok(match (name, schema.get("format").and_then(Value::as_str)) {
            ("string", _) => "String".to_owned(),
            ("boolean", _) => "bool".to_owned(),
            ("number", _) => "f64".to_owned(),
            ("integer", Some("int32")) => "i32".to_owned(),
            ("integer", Some("uint32")) => "u32".to_owned(),
            ("integer", Some("int64")) => "i64".to_owned(),
            ("integer", Some("uint64")) => "u64".to_owned(),
            ("array", _) => {
                let items = schema.get("items").context("an array without items")?;
                format!("Vec<{}>", self.type_name(owner, field, items)?)
            }
            ("object", _) => match schema.get("additionalProperties") {
                Some(Value::Bool(true)) => "Map<String, Value>".to_owned(),
                Some(values) => format!("BTreeMap<String, {}>", self.type_name(owner, field, values)?),
                None => bail!("an object inside a property"),
            },
            (name, format) => bail!("the type {name} with the format {format:?}"),
        })
    }

    fn insert(&mut self, name: &str, definition: Definition) {
        self.types.insert(name.to_owned(), definition);
    }

    /// Whether a type has a default: no required field is an enumeration.
    pub(super) fn has_default(&self, name: &str) -> bool {
        match self.types.get(name).map(|definition| &definition.shape) {
            None => true,
            Some(Shape::Enum { .. }) => false,
            Some(Shape::Struct { fields, .. }) => {
                fields.iter().all(|field| !field.required || self.has_default(&field.type_name))
            }
        }
    }
}

/// Returns the definition that an `allOf` extends.
fn base(definition: &Value) -> Option<&str> {
    definition.get("allOf")?.get(0)?.get("$ref")?.as_str()?.rsplit('/').next()
}

/// Returns the properties that an `allOf` adds to its base.
fn part(definition: &Value) -> anyhow::Result<&Value> {
    definition.pointer("/allOf/1").context("an extension without properties")
}

fn reference(schema: &Value) -> anyhow::Result<String> {
    let path = schema.get("$ref").and_then(Value::as_str);
    let name = path.and_then(|path| path.strip_prefix("#/definitions/"));
    Ok(name.context("a reference to no definition")?.to_owned())
}

/// Returns an enumeration's values, and whether other values are allowed.
fn enumeration(schema: &Value) -> anyhow::Result<Option<(Vec<String>, bool)>> {
    let open = schema.get("_enum");
    let values = strings(open.or(schema.get("enum")))?;
    Ok((!values.is_empty()).then_some((values, open.is_some())))
}

fn strings(list: Option<&Value>) -> anyhow::Result<Vec<String>> {
    let list = list.and_then(Value::as_array).into_iter().flatten();
    list.map(|text| Ok(text.as_str().context("a list of texts")?.to_owned())).collect()
}

pub(super) fn upper_first(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_ascii_uppercase().to_string() + letters.as_str())
}

pub(super) fn lower_first(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_ascii_lowercase().to_string() + letters.as_str())
}
