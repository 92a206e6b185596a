//! Writes a document. All prefixes are declared at the root.

use super::read::is_legal;
use super::{SCHEMA_INSTANCE, SoapElement, XML};
use crate::server::SoapServer;
use crate::version::{SOAP_11, SOAP_12};

/// Text of a document with this root.
pub(super) fn write(root: &SoapElement) -> String {
    let mut namespaces = Vec::new();
    collect(root, &mut namespaces);
    let mut writer = DocumentWriter { text: "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_owned(), namespaces };
    writer.element(root, true);
    writer.text
}

/// Adds each name space in the element and below it once.
fn collect<'a>(element: &'a SoapElement, namespaces: &mut Vec<&'a str>) {
    let attributes = element.attributes.iter().map(|attribute| attribute.namespace.as_str());
    for namespace in std::iter::once(element.namespace.as_str()).chain(attributes) {
        if !namespace.is_empty() && namespace != XML && !namespaces.contains(&namespace) {
            namespaces.push(namespace);
        }
    }
    element.children.iter().for_each(|child| collect(child, namespaces));
}

struct DocumentWriter<'a> {
    text: String,
    /// Name spaces of the document.
    namespaces: Vec<&'a str>,
}

impl DocumentWriter<'_> {
    fn element(&mut self, element: &SoapElement, is_root: bool) {
        self.text.push('<');
        self.name(&element.namespace, &element.name);
        if is_root {
            for index in 0..self.namespaces.len() {
                self.declaration(index);
            }
        }
        for attribute in &element.attributes {
            self.text.push(' ');
            self.name(&attribute.namespace, &attribute.name);
            self.text.push_str("=\"");
            escape(&attribute.value, &mut self.text);
            self.text.push('"');
        }
        if element.children.is_empty() && element.text.is_empty() {
            self.text.push_str("/>");
            return;
        }
        self.text.push('>');
        escape(&element.text, &mut self.text);
        element.children.iter().for_each(|child| self.element(child, false));
        self.text.push_str("</");
        self.name(&element.namespace, &element.name);
        self.text.push('>');
    }

    fn declaration(&mut self, index: usize) {
        let Some(namespace) = self.namespaces.get(index).copied() else { return };
        self.text.push_str(" xmlns:");
        self.prefix(namespace);
        self.text.push_str("=\"");
        escape(namespace, &mut self.text);
        self.text.push('"');
    }

    fn name(&mut self, namespace: &str, name: &str) {
        if !namespace.is_empty() {
            self.prefix(namespace);
            self.text.push(':');
        }
        self.text.push_str(name);
    }

    /// Writes the usual prefix of a name space, or a numbered prefix.
    fn prefix(&mut self, namespace: &str) {
        let usual = match namespace {
            SOAP_11 | SOAP_12 => Some("SOAP-ENV"),
            SCHEMA_INSTANCE => Some("xsi"),
            XML => Some("xml"),
            _ => SoapServer::ALL.into_iter().find(|server| server.namespace() == namespace).map(SoapServer::name),
        };
        match usual {
            Some(prefix) => self.text.push_str(prefix),
            None => {
                let index = self.namespaces.iter().position(|known| *known == namespace).unwrap_or_default();
                self.text.push_str(&format!("n{index}"));
            }
        }
    }
}

/// Appends a text with entities. Characters that XML cannot contain are replaced by U+FFFD.
fn escape(text: &str, to: &mut String) {
    for character in text.chars() {
        match character {
            '<' => to.push_str("&lt;"),
            '>' => to.push_str("&gt;"),
            '&' => to.push_str("&amp;"),
            '"' => to.push_str("&quot;"),
            '\r' => to.push_str("&#13;"),
            '\n' => to.push_str("&#10;"),
            '\t' => to.push_str("&#9;"),
            legal if is_legal(legal) => to.push(legal),
            _ => to.push('\u{fffd}'),
        }
    }
}
