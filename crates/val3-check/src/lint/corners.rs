//! Blends of moves whose descriptors are known from the data files.

use val3_analysis::body::ExprId;
use val3_analysis::changes::is_changed;
use val3_analysis::items::manifest::length_unit;
use val3_analysis::targets::path;
use val3_lang::motion::{MotionRole, RequestedPath, is_blend};
use val3_motion::{Blend, Millimetres};

use super::ProgramView;

impl ProgramView<'_> {
    /// Blend at the end of the move that `call` records; `None` if a program may change its descriptor.
    pub(super) fn blend(&self, call: ExprId) -> Option<Blend> {
        if self.call_of(call)?.role == Some(MotionRole::Move(RequestedPath::Compliant)) {
            return Some(Blend::Off);
        }
        let descriptor = self.body.without_parentheses(self.descriptor(call)?);
        let ((name, written), path) = (self.written(descriptor)?, path(self.body, descriptor)?);
        let mut fields = ["blend", "leave", "reach"].into_iter().map(|field| format!("{path}.{field}"));
        if !self.is_closed(name) || fields.any(|field| is_changed(self.db, self.project, &field)) {
            return None;
        }
        let unit = length_unit(self.db, self.project.manifest(self.db)).millimetres();
        let [leave, reach] = written.corner?.map(|distance| Millimetres(distance * unit));
        let (_, choice) = written.choices.iter().find(|(field, _)| *field == "blend")?;
        Some(match choice.name {
            _ if !is_blend(choice) => Blend::Off,
            "Cartesian" => Blend::Cartesian { leave, reach },
            _ => Blend::Joint { leave, reach },
        })
    }
}
