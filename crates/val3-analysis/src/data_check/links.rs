//! Links of inputs and outputs, against the channels the cell declares.

use val3_lang::types::BaseType;

use super::DataCheck;
use crate::near::nearest;
use crate::problem::ProblemKind;
use crate::xml::Attribute;

/// The devices whose modules `sio.cfx` names.
const CHANNEL_DEVICES: [&str; 2] = ["Socket", "Serial"];

impl DataCheck<'_> {
    /// `link="Socket\name"`. Other devices are known to the controller alone.
    pub(super) fn link(&mut self, found: Attribute<'_>, ty: BaseType) {
        let text = found.text();
        let Some((device, channel)) = text.split_once('\\') else { return };
        if !CHANNEL_DEVICES.contains(&device) {
            return;
        }
        let Some(channels) = self.project.cell(self.db).and_then(|cell| cell.config(self.db).channels.as_ref()) else {
            return;
        };
        if !channels.contains(channel) {
            let known: Vec<String> = channels.iter().map(|name| format!("{device}\\{name}")).collect();
            let near = nearest(&text, known.iter().map(String::as_str));
            self.report(found.range, ProblemKind::IoLinkUnknown { link: text.as_ref().into(), near });
        } else if ty != BaseType::Sio {
            let kind = ProblemKind::IoLinkKind {
                link: text.as_ref().into(),
                expected: ty.name().into(),
                found: BaseType::Sio.name().into(),
            };
            self.report(found.range, kind);
        }
    }
}
