//! What the configuration files of a cell say of its controller.

use val3_lang::components::Component;
use val3_syntax::xml::{self, Element};

use super::Devices;

/// The entries that `getVersion` shows, by their names in the files.
const PARTS: [(&str, Component); 3] =
    [("arm", Component::ArmType), ("tuning", Component::Tuning), ("mount", Component::Mounting)];

impl Devices {
    /// Takes over what a file such as `arm.cfx` or `cell.cfx` says of the arm and of the language; the rest of it is
    /// passed over.
    pub fn describe(&mut self, file: &str) {
        let parse = val3_syntax::parse(file);
        let root = xml::root(parse.view());
        for entry in root.into_iter().flat_map(Element::elements) {
            if let (Some(name), Some(value)) = (entry.value("name"), entry.value("value")) {
                self.entry(&name, value.trim());
            }
        }
    }

    fn entry(&mut self, name: &str, value: &str) {
        if value.is_empty() {
            return;
        }
        if name == "language" {
            self.languages.install(value);
            self.languages.change(value);
        } else if let Some((_, part)) = PARTS.iter().find(|(known, _)| *known == name) {
            self.versions.set(*part, value);
        }
    }
}
