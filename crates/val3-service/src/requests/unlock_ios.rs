//! `unlockIos`: returns signals to programs and devices.

use val3_machine::controller::Controller;
use val3_soap::SoapFault;
use val3_soap::v2::{UnlockIos, UnlockIosAnswer, UnlockedSignal};

use crate::context::Context;
use crate::signals::{SignalChange, change, check_number, state};

/// Answers the request.
pub(super) fn answer(request: &UnlockIos, context: &mut Context<'_, '_>) -> Result<UnlockIosAnswer, SoapFault> {
    check_number(&request.paths)?;
    let controller = context.controller();
    let responses = request.paths.iter().map(|path| unlock(controller, path, request.with_description));
    Ok(UnlockIosAnswer { responses: responses.collect() })
}

/// Unlocks a signal. Returns its state afterwards.
fn unlock(controller: &mut Controller, path: &str, with_description: bool) -> UnlockedSignal {
    UnlockedSignal {
        response: change(controller, path, SignalChange::Unlock),
        state: state(controller, path, with_description),
    }
}
