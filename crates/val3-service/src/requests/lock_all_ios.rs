//! `lockAllIos`: locks all signals at their values.

use val3_soap::SoapFault;
use val3_soap::v2::{LockAllIos, LockAllIosAnswer};

use crate::context::Context;
use crate::signals::{SignalChange, change_all};

/// Answers the request.
pub(super) fn answer(_: &LockAllIos, context: &mut Context<'_, '_>) -> Result<LockAllIosAnswer, SoapFault> {
    Ok(LockAllIosAnswer { successes: change_all(context.controller(), SignalChange::LockNow) })
}
