//! XML documents as trees of elements.

mod read;
mod write;

use crate::error::SoapError;

/// Name space of the attributes `nil` and `type`.
pub(crate) const SCHEMA_INSTANCE: &str = "http://www.w3.org/2001/XMLSchema-instance";

/// Name space of the prefix `xml`.
pub(crate) const XML: &str = "http://www.w3.org/XML/1998/namespace";

/// Element of a document.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SoapElement {
    /// Name without prefix.
    pub name: String,
    /// Name space; empty without.
    pub namespace: String,
    /// Attributes without declarations of name spaces.
    pub attributes: Vec<SoapAttribute>,
    /// Text directly in the element.
    pub text: String,
    /// Elements below this element.
    pub children: Vec<SoapElement>,
}

/// XML attribute.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SoapAttribute {
    /// Name without prefix.
    pub name: String,
    /// Name space; empty without.
    pub namespace: String,
    /// Value without entities.
    pub value: String,
}

impl SoapElement {
    /// Reads a document from its bytes.
    ///
    /// # Errors
    /// The bytes are no well-formed XML document in UTF-8, or exceed a limit.
    pub fn read(bytes: &[u8]) -> Result<Self, SoapError> {
        read::read(bytes)
    }

    /// Text of a document with this root.
    #[must_use]
    pub fn write(&self) -> String {
        write::write(self)
    }

    /// Creates an element without name space, for a document in a message.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self::plain(name)
    }

    /// Element with these attributes without name space: names and values.
    #[must_use]
    pub fn with_attributes(self, attributes: &[(&str, &str)]) -> Self {
        attributes.iter().fold(self, |element, (name, value)| element.with_attribute("", name, value))
    }

    /// Creates an element without name space.
    pub(crate) fn plain(name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::default() }
    }

    /// Creates an element in a name space.
    pub(crate) fn qualified(namespace: &str, name: &str) -> Self {
        Self { name: name.to_owned(), namespace: namespace.to_owned(), ..Self::default() }
    }

    /// Element with this text.
    pub(crate) fn with_text(mut self, text: impl Into<String>) -> Self {
        self.text = text.into();
        self
    }

    /// Element with this last child.
    pub(crate) fn with_child(mut self, child: Self) -> Self {
        self.children.push(child);
        self
    }

    /// Element with this attribute.
    pub(crate) fn with_attribute(mut self, namespace: &str, name: &str, value: &str) -> Self {
        self.add_attribute(namespace, name, value);
        self
    }

    /// Adds an attribute.
    pub(crate) fn add_attribute(&mut self, namespace: &str, name: &str, value: &str) {
        let (namespace, name, value) = (namespace.to_owned(), name.to_owned(), value.to_owned());
        self.attributes.push(SoapAttribute { name, namespace, value });
    }

    /// Whether the element has this name in this name space.
    pub(crate) fn is(&self, namespace: &str, name: &str) -> bool {
        self.name == name && self.namespace == namespace
    }

    /// First child with this name in this name space.
    pub(crate) fn child(&self, namespace: &str, name: &str) -> Option<&Self> {
        self.children.iter().find(|child| child.is(namespace, name))
    }

    /// Attribute value.
    pub(crate) fn attribute(&self, namespace: &str, name: &str) -> Option<&str> {
        let attribute = self.attributes.iter().find(|known| known.name == name && known.namespace == namespace);
        attribute.map(|attribute| attribute.value.as_str())
    }

    /// Whether the element states that it has no value (`xsi:nil`).
    pub(crate) fn is_nil(&self) -> bool {
        matches!(self.attribute(SCHEMA_INSTANCE, "nil"), Some("true" | "1"))
    }

    /// Text, which is the element's only content.
    ///
    /// # Errors
    /// The element has children.
    pub(crate) fn leaf_text(&self, expected: &str) -> Result<&str, SoapError> {
        match self.children.first() {
            Some(child) => Err(SoapError::wrong_value(&self.name, &format!("<{}>", child.name), expected)),
            None => Ok(&self.text),
        }
    }
}
