//! Checks of input and output links against the cell's configuration.

use smol_str::SmolStr;
use val3_lang::suggest::nearest;
use val3_lang::types::BaseType;

use super::DataCheck;
use crate::cell::{CellIo, guid};
use crate::problem::ProblemKind;
use crate::xml::Attribute;

impl DataCheck<'_> {
    /// Checks `link="Socket\host"` or `link="BasicIO-1\%I3"` if the cell's configuration lists the signals of the
    /// device.
    pub(super) fn link(&mut self, found: Attribute<'_>, ty: BaseType) {
        let text = found.text();
        let Some(cell) = self.project.cell(self.db) else { return };
        let io = &cell.config(self.db).io;
        let wanted = if ty == BaseType::Tool { BaseType::Dio } else { ty };
        let Some((device, name)) = text.split_once('\\') else { return self.tag(found, wanted, io) };
        let Some(known) = io.devices.get(device) else { return };
        match known.get(name) {
            None => {
                let links: Vec<String> = known.keys().map(|name| format!("{device}\\{name}")).collect();
                let near = nearest(&text, links.iter().map(String::as_str)).map(SmolStr::from);
                self.report(found.range, ProblemKind::IoLinkUnknown { link: text.as_ref().into(), near });
            }
            Some(kind) => self.link_kind(found, wanted, *kind),
        }
    }

    /// Checks the link of a field bus signal, for example `link="CE061C2D-63EF-…"`.
    fn tag(&mut self, found: Attribute<'_>, wanted: BaseType, io: &CellIo) {
        let text = found.text();
        let (Some(tag), Some(known)) = (guid(&text), &io.tags) else { return };
        match known.get(&tag) {
            None => {
                let kind = ProblemKind::IoLinkUnknown { link: text.as_ref().into(), near: None };
                self.report(found.range, kind);
            }
            Some(kind) => kind.iter().for_each(|kind| self.link_kind(found, wanted, *kind)),
        }
    }

    fn link_kind(&mut self, found: Attribute<'_>, wanted: BaseType, kind: BaseType) {
        if kind != wanted {
            let (expected, found_kind) = (wanted.name().into(), kind.name().into());
            let link = found.text().as_ref().into();
            self.report(found.range, ProblemKind::IoLinkKind { link, expected, found: found_kind });
        }
    }
}
