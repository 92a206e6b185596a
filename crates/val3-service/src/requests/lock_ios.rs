//! `lockIos`: sets signals to values that programs and devices cannot change.

use val3_soap::SoapFault;
use val3_soap::v2::{LockIos, LockIosAnswer};

use crate::context::Context;
use crate::signals::{SignalChange, change, pairs};

/// Answers the request.
pub(super) fn answer(request: &LockIos, context: &mut Context<'_, '_>) -> Result<LockIosAnswer, SoapFault> {
    let pairs = pairs(&request.paths, &request.values)?;
    let controller = context.controller();
    let responses = pairs.map(|(path, value)| change(controller, path, SignalChange::Lock(value))).collect();
    Ok(LockIosAnswer { responses })
}
