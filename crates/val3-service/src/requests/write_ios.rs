//! `writeIos`: sets outputs. Inputs and locked outputs are found, but not changed.

use val3_soap::SoapFault;
use val3_soap::v2::{WriteIos, WriteIosAnswer};

use crate::context::Context;
use crate::signals::{SignalChange, change, pairs};

/// Answers the request.
pub(super) fn answer(request: &WriteIos, context: &mut Context<'_, '_>) -> Result<WriteIosAnswer, SoapFault> {
    let pairs = pairs(&request.paths, &request.values)?;
    let controller = context.controller();
    let responses = pairs.map(|(path, value)| change(controller, path, SignalChange::Write(value))).collect();
    Ok(WriteIosAnswer { responses })
}
