//! Reads the text of a document, with limits on size, depth and numbers of elements and attributes.
//!
//! Documents with a document type are rejected, so no entity expands to a large text.

use quick_xml::events::{BytesRef, BytesStart, Event};
use quick_xml::name::ResolveResult;
use quick_xml::{NsReader, XmlVersion};

use super::{SoapAttribute, SoapElement};
use crate::error::SoapError;

/// Maximum size of a document, in bytes.
pub(crate) const MOST_BYTES: usize = 1 << 20;

/// Maximum number of nested elements. The deepest message of the interface has 10.
const MOST_DEPTH: usize = 32;

/// Maximum number of elements.
const MOST_ELEMENTS: usize = 20_000;

/// Maximum number of attributes in an element.
const MOST_ATTRIBUTES: usize = 64;

/// Byte order mark, with which some clients begin the document.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Reads a document.
pub(super) fn read(bytes: &[u8]) -> Result<SoapElement, SoapError> {
    if bytes.len() > MOST_BYTES {
        return Err(SoapError::TooLarge("1 MiB"));
    }
    let text = std::str::from_utf8(bytes).map_err(|_| SoapError::NotUtf8)?;
    let mut reader = NsReader::from_str(text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text));
    reader.config_mut().expand_empty_elements = true;
    let mut tree = TreeBuilder::default();
    loop {
        let (resolved, event) = reader.read_resolved_event().map_err(malformed)?;
        let namespace = namespace(&resolved)?;
        match event {
            Event::Start(start) => {
                let mut element = SoapElement::qualified(&namespace, start.local_name().as_ref());
                element.attributes = attributes(&reader, &start)?;
                tree.open(element)?;
            }
            Event::End(_) => tree.close(),
            Event::Text(text) => tree.append(&text.xml10_content())?,
            Event::CData(text) => tree.append(&text.xml10_content())?,
            Event::GeneralRef(reference) => tree.append(resolve(&reference)?.encode_utf8(&mut [0; 4]))?,
            Event::Decl(declaration) => check_encoding(declaration.encoding())?,
            Event::DocType(_) => return Err(not_xml("a SOAP message has no document type")),
            Event::Empty(_) | Event::Comment(_) | Event::PI(_) => {}
            Event::Eof => return tree.finish(),
        }
    }
}

/// Elements that were read so far.
#[derive(Default)]
struct TreeBuilder {
    /// Open elements, from the root to the innermost element.
    open: Vec<SoapElement>,
    root: Option<SoapElement>,
    elements: usize,
}

impl TreeBuilder {
    fn open(&mut self, element: SoapElement) -> Result<(), SoapError> {
        self.elements += 1;
        if self.elements > MOST_ELEMENTS {
            return Err(SoapError::TooLarge("20,000 elements"));
        }
        if self.open.len() >= MOST_DEPTH {
            return Err(SoapError::TooLarge("32 nested elements"));
        }
        if self.root.is_some() {
            return Err(not_xml("it has more than one root"));
        }
        self.open.push(element);
        Ok(())
    }

    fn close(&mut self) {
        let Some(element) = self.open.pop() else { return };
        match self.open.last_mut() {
            Some(parent) => parent.children.push(element),
            None => self.root = Some(element),
        }
    }

    fn append(&mut self, text: &str) -> Result<(), SoapError> {
        if text.contains(|character| !is_legal(character)) {
            return Err(not_xml("it contains a control character"));
        }
        match self.open.last_mut() {
            Some(element) => element.text.push_str(text),
            None if text.trim().is_empty() => {}
            None => return Err(not_xml("it has text outside of the root")),
        }
        Ok(())
    }

    fn finish(self) -> Result<SoapElement, SoapError> {
        match (self.open.last(), self.root) {
            (Some(element), _) => Err(not_xml(&format!("it ends within the element `{}`", element.name))),
            (None, Some(root)) => Ok(root),
            (None, None) => Err(not_xml("it has no element")),
        }
    }
}

/// Whether XML 1.0 permits a character.
pub(super) fn is_legal(character: char) -> bool {
    !matches!(character, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}')
}

fn namespace(resolved: &ResolveResult<'_>) -> Result<String, SoapError> {
    match resolved {
        ResolveResult::Bound(namespace) => Ok(namespace.as_ref().to_owned()),
        ResolveResult::Unbound => Ok(String::new()),
        ResolveResult::Unknown(prefix) => Err(not_xml(&format!("the prefix `{prefix}` is not declared"))),
    }
}

fn attributes(reader: &NsReader<&[u8]>, start: &BytesStart<'_>) -> Result<Vec<SoapAttribute>, SoapError> {
    let mut attributes = Vec::new();
    for (index, attribute) in start.attributes().enumerate() {
        if index >= MOST_ATTRIBUTES {
            return Err(SoapError::TooLarge("64 attributes of an element"));
        }
        let attribute = attribute.map_err(malformed)?;
        if attribute.key.as_namespace_binding().is_some() {
            continue;
        }
        let (resolved, name) = reader.resolver().resolve_attribute(attribute.key);
        let value = attribute.normalized_value(XmlVersion::Implicit1_0).map_err(malformed)?;
        if value.contains(|character| !is_legal(character)) {
            return Err(not_xml("it contains a control character"));
        }
        attributes.push(SoapAttribute {
            name: name.as_ref().to_owned(),
            namespace: namespace(&resolved)?,
            value: value.into_owned(),
        });
    }
    Ok(attributes)
}

fn resolve(reference: &BytesRef<'_>) -> Result<char, SoapError> {
    if let Some(character) = reference.resolve_char_ref().map_err(malformed)? {
        return Ok(character);
    }
    match reference.as_ref() {
        "lt" => Ok('<'),
        "gt" => Ok('>'),
        "amp" => Ok('&'),
        "quot" => Ok('"'),
        "apos" => Ok('\''),
        other => Err(not_xml(&format!("the entity `{other}` is not declared"))),
    }
}

/// Checks the encoding in the XML declaration.
fn check_encoding<E>(encoding: Option<Result<impl AsRef<str>, E>>) -> Result<(), SoapError> {
    match encoding {
        None => Ok(()),
        Some(Ok(name)) if name.as_ref().eq_ignore_ascii_case("utf-8") => Ok(()),
        Some(Ok(_)) => Err(SoapError::NotUtf8),
        Some(Err(_)) => Err(not_xml("its declaration is malformed")),
    }
}

fn not_xml(reason: &str) -> SoapError {
    SoapError::NotXml(reason.to_owned())
}

fn malformed(error: impl std::fmt::Display) -> SoapError {
    SoapError::NotXml(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        read(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn prefixes_entities_and_line_ends_are_resolved() {
        let root = read("\u{feff}<?xml version='1.0' encoding='UTF-8'?>\r\n<a:r xmlns:a='n'><b xmlns='' a:x='1\n2'>&lt;&#65;<![CDATA[&]]>\r\n</b></a:r>\n".as_bytes()).unwrap();
        assert!(root.is("n", "r"));
        let child = root.child("", "b").unwrap();
        assert_eq!(child.text, "<A&\n");
        assert_eq!(child.attribute("n", "x"), Some("1 2"));
    }

    #[test]
    fn malformed_documents_are_errors() {
        for text in [
            "",
            "x",
            "<a",
            "<a>",
            "<a></b>",
            "<a/><b/>",
            "<a/>x",
            "<p:a/>",
            "<a b='1' b='2'/>",
            "<a>&x;</a>",
            "<a>&#0;</a>",
            "<a>\u{1}</a>",
            "<a>&#xd800;</a>",
            "<a b='&#2;'/>",
            "</a>",
            "<a b=1/>",
            "<a>&</a>",
            "<!DOCTYPE a [<!ENTITY x 'x'>]><a>&x;</a>",
            "<?xml version='1.0' encoding='latin1'?><a/>",
        ] {
            assert!(read(text.as_bytes()).is_err(), "{text}");
        }
        assert!(read(b"<a>\xff</a>").is_err());
        assert_eq!(error("<p:a/>"), "the message is not XML: the prefix `p` is not declared");
    }

    #[test]
    fn limits_hold() {
        let nested = |depth| "<a>".repeat(depth) + &"</a>".repeat(depth);
        assert!(read(nested(32).as_bytes()).is_ok());
        assert_eq!(error(&nested(33)), "the message exceeds the limit of 32 nested elements");
        assert!(error(&nested(100_000)).contains("32 nested"));
        assert!(error(&format!("<a>{}</a>", "<b/>".repeat(20_000))).contains("20,000 elements"));
        let many: String = (0..100_000).map(|n| format!(" a{n}=''")).collect();
        assert!(error(&format!("<a{many}/>")).contains("limit"));
        assert!(error(&" ".repeat(MOST_BYTES + 1)).contains("1 MiB"));
    }
}
