//! A configuration file of the controller as a list of entries.

use val3_analysis::xml;

use super::entries::{EntryRules, XmlEntry, entries};

/// Reads the entries of a file in order; `None` if it is no XML.
pub(crate) fn read(text: &str) -> Option<Vec<XmlEntry>> {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view()).filter(|_| parse.errors().is_empty())?;
    Some(entries(root, &EntryRules { keys: &["index", "key", "id", "name"], without: &[], has_keys: false }))
}

/// Whether the file describes inputs and outputs: `bio.cfx`, `sio.cfx`, `modbus.cfx`.
pub(crate) fn is_io(file_name: &str) -> bool {
    let name = file_name.to_lowercase();
    let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem);
    let stem = stem.trim_end_matches(|last: char| last.is_ascii_digit() || matches!(last, '-' | 's'));
    let fieldbuses = ["modbus", "fieldbus", "applicom", "profinet", "ethercat", "canopen", "socket"];
    stem.ends_with("io") || stem.starts_with("io") || fieldbuses.iter().any(|bus| stem.contains(bus))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_have_the_path_of_their_elements() {
        let text = "<io xmlns=\"a\"><bioDin index=\"3\" name=\"door\"/><v>s7</v><sock><String name=\"ip\" value=\"1\"/></sock>\
            <sock><String name=\"ip\" value=\"2\"/></sock><e/></io>";
        let entries: Vec<String> =
            read(text).unwrap().into_iter().map(|XmlEntry { path, value }| format!("{path}={value}")).collect();
        assert_eq!(
            entries,
            [
                "xmlns=a",
                "bioDin[3] name=door",
                "v text=s7",
                "sock String[ip] value=1",
                "sock #2 String[ip] value=2",
                "e="
            ]
        );
        assert!(read("<io>").is_none());
    }

    #[test]
    fn files_of_inputs_and_outputs() {
        assert!(["bio.cfx", "BIO2.CFX", "systemios.cfx", "sio.cfx", "ModbusSrv-0.cfx"].iter().all(|name| is_io(name)));
        assert!(!["arm.cfx", "cell.cfx", "val3version.xml"].iter().any(|name| is_io(name)));
    }
}
