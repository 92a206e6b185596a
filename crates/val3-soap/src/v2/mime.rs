//! Data with a content type.

use crate::base64_value::Binary;
use crate::document::SoapElement;
use crate::error::SoapError;
use crate::value::{SoapField as _, SoapValue};

/// Name spaces of the content type, which differ between stubs. The first, of the only stub with this type, is written.
const NAMESPACES: [&str; 2] = ["http://tempuri.org/xmlmime.xsd", "http://www.w3.org/2004/11/xmlmime"];

/// Name of the attribute.
const CONTENT_TYPE: &str = "contentType";

/// Name of the element with the bytes.
const DATA: &str = "data";

/// Bytes with a content type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MimeData {
    /// Content type, for example `text/xml`.
    pub content_type: Option<String>,
    /// Bytes.
    pub data: Binary,
}

impl MimeData {
    /// XML text.
    #[must_use]
    pub fn xml(text: String) -> Self {
        Self { content_type: Some("text/xml".to_owned()), data: Binary(text.into_bytes()) }
    }
}

/// Returns the content type at an element, in any name space in which stubs write it.
fn content_type(element: &SoapElement) -> Option<&str> {
    NAMESPACES.iter().chain(&[""]).find_map(|namespace| element.attribute(namespace, CONTENT_TYPE))
}

impl SoapValue for MimeData {
    fn read(element: &SoapElement) -> Result<Self, SoapError> {
        let data = Binary::read_field(element, DATA)?;
        let content_type = content_type(element).or_else(|| element.child("", DATA).and_then(content_type));
        Ok(Self { content_type: content_type.map(str::to_owned), data })
    }

    fn write(&self, element: &mut SoapElement) {
        if let Some(content_type) = &self.content_type {
            let [namespace, _] = NAMESPACES;
            element.add_attribute(namespace, CONTENT_TYPE, content_type);
        }
        let mut child = SoapElement::plain(DATA);
        self.data.write(&mut child);
        element.children.push(child);
    }
}
