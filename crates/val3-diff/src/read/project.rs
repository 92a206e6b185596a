//! A project file: its lists and parameters.

use smol_str::SmolStr;
use val3_analysis::items::manifest::{self, LibraryEntry, Manifest};
use val3_analysis::paths::path_key;
use val3_analysis::xml;
use val3_lang::types::LengthUnit;

/// A `.pjx` of either dialect.
#[derive(Debug, Clone, Default)]
pub(crate) struct ProjectVersion {
    pub(crate) manifest: Manifest,
    /// Attributes of `<Parameters>`.
    pub(crate) parameters: Vec<(String, String)>,
}

impl ProjectVersion {
    /// Reads the text of a `.pjx`; `None` if it is broken.
    pub(crate) fn read(text: &str) -> Option<Self> {
        let parse = val3_syntax::parse(text);
        let root = xml::root(parse.view()).filter(|_| parse.errors().is_empty())?;
        let spelling = manifest::spelling(root);
        if root.name() != spelling.root {
            return None;
        }
        let parameters = root.child(&[spelling.parameters]).into_iter().flat_map(xml::XmlElement::attributes);
        let parameters = parameters.map(|found| (found.name.to_owned(), found.text().trim().to_owned())).collect();
        Some(Self { manifest: manifest::read(parse.view()), parameters })
    }

    /// Returns the value of a parameter.
    pub(crate) fn parameter(&self, name: &str) -> Option<&str> {
        self.parameters.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }

    /// Returns the length unit of the data.
    pub(crate) fn unit(&self) -> LengthUnit {
        let is_inch = self.parameter("millimeterUnit") == Some("false");
        if is_inch { LengthUnit::Inch } else { LengthUnit::Millimetre }
    }

    /// Returns the data files in order, in lower case.
    pub(crate) fn data_files(&self) -> String {
        let files: Vec<String> = self.manifest.data.iter().map(|reference| path_key(reference)).collect();
        files.join(", ")
    }

    /// Returns library identifiers with their paths and whether they are loaded with the application.
    pub(crate) fn libraries(&self) -> Vec<(SmolStr, String)> {
        let libraries = self.manifest.libraries.iter();
        let libraries = libraries.map(|LibraryEntry { alias, path, autoload, .. }| {
            let note = if *autoload { "" } else { " (not loaded at the start)" };
            (alias.clone(), format!("{path}{note}"))
        });
        libraries.collect()
    }

    /// Returns user types with their paths.
    pub(crate) fn types(&self) -> Vec<(SmolStr, String)> {
        self.manifest.types.iter().map(|entry| (entry.name.clone(), entry.path.to_string())).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_dialects_are_read() {
        let new = ProjectVersion::read(
            "<Project><Parameters version=\"s7.8\" millimeterUnit=\"false\"/><Libraries>\
             <Library alias=\"io\" path=\"Disk://io\" autoload=\"false\"/></Libraries></Project>",
        )
        .unwrap();
        assert_eq!((new.unit(), new.parameter("version")), (LengthUnit::Inch, Some("s7.8")));
        assert_eq!(new.libraries(), [("io".into(), "Disk://io (not loaded at the start)".to_owned())]);
        let old = ProjectVersion::read(
            "<project><aliasSection><alias name=\"io\" interface=\"io\"/></aliasSection></project>",
        );
        assert_eq!(old.unwrap().libraries(), [("io".into(), "io".to_owned())]);
        assert!(ProjectVersion::read("<Project>").is_none() && ProjectVersion::read("<Database/>").is_none());
    }
}
