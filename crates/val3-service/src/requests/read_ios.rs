//! `readIos`: an unknown signal is a state, not a fault.

use val3_soap::SoapFault;
use val3_soap::v2::{ReadIos, ReadIosAnswer};

use crate::context::Context;
use crate::signals::{check_number, state};

/// Answers the request.
pub(super) fn answer(request: &ReadIos, context: &mut Context<'_, '_>) -> Result<ReadIosAnswer, SoapFault> {
    check_number(&request.paths)?;
    let controller = context.controller();
    let states = request.paths.iter().map(|path| state(controller, path, request.with_description)).collect();
    Ok(ReadIosAnswer { states })
}
