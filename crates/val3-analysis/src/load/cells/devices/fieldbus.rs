//! Field bus signals of a CS9 (`usr/configs/hilscher/J207J208.xml`), whose links are bare GUIDs.

use val3_lang::types::BaseType;

use crate::cell::{Tags, guid};
use crate::xml::{self, XmlElement};

/// Reads the signals by tag; `None` if a tag is no GUID, because links may have another form then.
pub(super) fn read(text: &str) -> Option<Tags> {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view()).filter(|root| root.name() == "ProcessData")?;
    if !parse.errors().is_empty() {
        return None;
    }
    let mut tags = Tags::default();
    add(root, &mut tags)?;
    Some(tags).filter(|tags| !tags.is_empty())
}

/// Adds the signals in an element and in nested modules.
fn add(element: XmlElement<'_>, tags: &mut Tags) -> Option<()> {
    for inner in element.elements() {
        if inner.name() == "Signal" {
            let tag = inner.value("systemTag")?;
            let key = guid(&tag)?;
            tags.insert(key, kind(inner));
        } else {
            add(inner, tags)?;
        }
    }
    Some(())
}

/// Returns the type of a signal; `None` for an array of bits, which could be read as a number.
fn kind(signal: XmlElement<'_>) -> Option<BaseType> {
    let elements = signal.value("arrayElements");
    let is_single = elements.is_none_or(|count| matches!(count.trim(), "" | "0" | "1"));
    match signal.value("dataType")?.as_ref() {
        "bit" => is_single.then_some(BaseType::Dio),
        "byte" | "signed8" | "unsigned8" | "word" | "signed16" | "unsigned16" | "dword" | "signed32" | "unsigned32"
        | "real32" => Some(BaseType::Aio),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIGNALS: &str = r#"<ProcessData xmlns="x-schema:ProcessDataSchema.xml"><Adapter><Module><Module>
        <Signal systemTag="CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A77" dataType="bit"/>
        <Signal systemTag="CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A78" dataType="bit" arrayElements="8"/></Module>
        <Signal systemTag="ce061c2d-63ef-4c60-9f0e-0d5c5e2b1a79" dataType="unsigned16"/></Module></Adapter></ProcessData>"#;

    #[test]
    fn signals_have_their_tags() {
        let tags = read(SIGNALS).unwrap();
        let of = |end: &str| tags[&format!("ce061c2d-63ef-4c60-9f0e-0d5c5e2b1a{end}")];
        assert_eq!([of("77"), of("78"), of("79")], [Some(BaseType::Dio), None, Some(BaseType::Aio)]);
        assert_eq!(tags.len(), 3);
    }

    #[test]
    fn other_tags_name_nothing() {
        assert_eq!(read(&SIGNALS.replace("CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A77", "Adapter.Module.In")), None);
        assert_eq!(read("<ProcessData/>"), None);
        assert_eq!(read(&SIGNALS.replace("</Adapter>", "")), None);
        assert_eq!(guid("CE061C2D-63EF-4C60-9F0E"), None);
    }
}
