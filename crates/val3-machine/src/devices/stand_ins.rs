//! Libraries that are loaded in place of others.

use std::collections::BTreeMap;

use val3_vm::LibraryRequest;

/// The paths of libraries that are loaded in place of others, by library identifier.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct StandIns(BTreeMap<String, String>);

impl StandIns {
    /// From now on the library at `path` (`Disk://stubs/feeder`) is loaded under an identifier, whatever path programs and
    /// projects name.
    pub fn insert(&mut self, identifier: String, path: String) {
        self.0.insert(identifier, path);
    }

    /// The path that is loaded for the application or library at `from`. A stand-in itself gets what it names, so that it
    /// can use the library whose place it takes.
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
        let path = |from: &'static str, alias: &'static str| {
            stand_ins.path(from, LibraryRequest { alias, path: "Disk://own", password: "" }).to_owned()
        };
        assert_eq!(path("Disk://main", "feeder"), "Disk://stubs/feeder");
        assert_eq!(path("Disk://main", "Feeder"), "Disk://own");
        assert_eq!(path("Disk://Stubs/feeder", "feeder"), "Disk://own");
    }
}
