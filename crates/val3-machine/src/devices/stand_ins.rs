//! Libraries that are loaded in place of other libraries.

use std::collections::BTreeMap;

use val3_vm::LibraryRequest;

/// Paths of libraries that are loaded in place of other libraries, by library identifier.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct StandIns(BTreeMap<String, String>);

impl StandIns {
    /// Loads the library at `path` (`Disk://stubs/feeder`) under an identifier from now on, independent of the path
    /// that programs and projects name.
    pub fn insert(&mut self, identifier: String, path: String) {
        self.0.insert(identifier, path);
    }

    /// Returns the path that is loaded for the application or library at `from`. A stand-in itself gets the path that
    /// it names, so that it can use the library that it replaces.
    pub(super) fn path<'p>(&'p self, from: &str, library: LibraryRequest<'p>) -> &'p str {
        let stand_in = self.0.get(library.alias).filter(|path| !path.eq_ignore_ascii_case(from));
        stand_in.map_or(library.path, String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stand_in_is_loaded_under_its_identifier_alone() {
        let mut stand_ins = StandIns::default();
        stand_ins.insert("feeder".to_owned(), "Disk://stubs/feeder".to_owned());
        let cases = [
            ("Disk://main", "feeder", "Disk://stubs/feeder"),
            ("Disk://main", "Feeder", "Disk://own"),
            ("Disk://Stubs/feeder", "feeder", "Disk://own"),
        ];
        for (from, alias, expected) in cases {
            let request = LibraryRequest { alias, path: "Disk://own", password: "" };
            assert_eq!(stand_ins.path(from, request), expected, "{alias} from {from}");
        }
    }
}
