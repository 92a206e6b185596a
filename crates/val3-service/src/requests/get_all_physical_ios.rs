//! `getAllPhysicalIos`: the signals of the cell as a document. The form is inferred from the clients that read it.

use val3_machine::io::{Direction, SignalKind};
use val3_soap::v2::{GetAllPhysicalIos, GetAllPhysicalIosAnswer, MimeData};
use val3_soap::{SoapElement, SoapFault};

use crate::context::Context;
use crate::inferred::signal_type;

/// Answers the request.
pub(super) fn answer(
    _: &GetAllPhysicalIos,
    context: &mut Context<'_, '_>,
) -> Result<GetAllPhysicalIosAnswer, SoapFault> {
    let io = &context.controller().devices.state.io;
    let mut list = SoapElement::named("physicalIos");
    for signal in io.signals().filter_map(|id| io.signal(id)) {
        let is_digital = matches!(signal.kind, SignalKind::Digital);
        let attributes = [
            ("name", signal.path.as_str()),
            ("desc", signal.description.as_str()),
            ("type", signal_type(is_digital, signal.direction == Direction::Input)),
            ("lockable", "true"),
        ];
        list.children.push(SoapElement::named("physicalIo").with_attributes(&attributes));
    }
    Ok(GetAllPhysicalIosAnswer { data: MimeData::xml(list.write()) })
}
