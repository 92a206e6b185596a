//! `setSchedulingMode`: only the controller schedules moves.

use val3_soap::v3::{SchedulingMode, SetSchedulingMode};
use val3_soap::{Empty, ExceptionCode, SoapFault};

use crate::context::{Context, refused};

/// Answers the request.
pub(super) fn answer(request: &SetSchedulingMode, _: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    match request.mode {
        SchedulingMode::Internal => Ok(Empty),
        SchedulingMode::External => {
            Err(refused(ExceptionCode::SchedulingMode, "this controller has only the internal scheduling"))
        }
    }
}
