//! `unlockAllIos`.

use val3_soap::SoapFault;
use val3_soap::v2::{UnlockAllIos, UnlockAllIosAnswer};

use crate::context::Context;
use crate::signals::{SignalChange, change_all};

/// Answers the request.
pub(super) fn answer(_: &UnlockAllIos, context: &mut Context<'_, '_>) -> Result<UnlockAllIosAnswer, SoapFault> {
    Ok(UnlockAllIosAnswer { successes: change_all(context.controller(), SignalChange::Unlock) })
}
