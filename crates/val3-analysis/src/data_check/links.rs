//! Links of inputs and outputs, against what the cell's configuration declares.

use smol_str::SmolStr;
use val3_lang::suggest::nearest;
use val3_lang::types::BaseType;

use super::DataCheck;
use crate::problem::ProblemKind;
use crate::xml::Attribute;

impl DataCheck<'_> {
    /// `link="Socket\host"`, `link="BasicIO-1\%I3"`, where the cell's configuration names what the device has.
    pub(super) fn link(&mut self, found: Attribute<'_>, ty: BaseType) {
        let text = found.text();
        let Some((device, name)) = text.split_once('\\') else { return };
        let Some(cell) = self.project.cell(self.db) else { return };
        let Some(known) = cell.config(self.db).io.devices.get(device) else { return };
        let wanted = if ty == BaseType::Tool { BaseType::Dio } else { ty };
        match known.get(name) {
            None => {
                let links: Vec<String> = known.keys().map(|name| format!("{device}\\{name}")).collect();
                let near = nearest(&text, links.iter().map(String::as_str)).map(SmolStr::from);
                self.report(found.range, ProblemKind::IoLinkUnknown { link: text.as_ref().into(), near });
            }
            Some(kind) if *kind != wanted => {
                let kind = ProblemKind::IoLinkKind {
                    link: text.as_ref().into(),
                    expected: wanted.name().into(),
                    found: kind.name().into(),
                };
                self.report(found.range, kind);
            }
            Some(_) => {}
        }
    }
}
