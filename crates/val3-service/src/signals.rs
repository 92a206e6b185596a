//! Signals by their physical paths.

use serde_json::{Map, Value, json};
use val3_machine::controller::Controller;
use val3_machine::io::{Direction, SignalId, SignalKind};
use val3_machine::script::ScriptAction;
use val3_soap::v2::{
    AnalogueAttributes, DigitalAttributes, SignalAttributes, SignalResponse, SignalState, SignalStatus,
};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::refused;
use crate::inferred::{DIGITAL_THRESHOLD, MOST_SIGNALS};

/// Change of a signal by a client.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SignalChange {
    /// Writes an output.
    Write(f64),
    /// Locks a signal at a value.
    Lock(f64),
    /// Locks a signal at its value.
    LockNow,
    /// Unlocks a signal.
    Unlock,
}

/// Checks the number of signals in a request.
///
/// # Errors
/// The request names too many signals.
pub(crate) fn check_number(paths: &[String]) -> Result<(), SoapFault> {
    if paths.len() <= MOST_SIGNALS {
        return Ok(());
    }
    Err(refused(ExceptionCode::InvalidParameters, &format!("a request names at most {MOST_SIGNALS} signals")))
}

/// Pairs signals with values.
///
/// # Errors
/// The request has not one value for each signal, or too many signals.
pub(crate) fn pairs<'r>(
    paths: &'r [String],
    values: &'r [f64],
) -> Result<impl Iterator<Item = (&'r String, f64)>, SoapFault> {
    check_number(paths)?;
    if paths.len() != values.len() {
        return Err(refused(ExceptionCode::InvalidParameters, "each signal needs one value"));
    }
    Ok(paths.iter().zip(values.iter().copied()))
}

/// Finds a signal by its full physical path. Names, and addresses without a board, are no paths.
fn find(controller: &Controller, path: &str) -> Option<SignalId> {
    let io = &controller.devices.state.io;
    io.find(path).filter(|id| io.signal(*id).is_some_and(|signal| signal.path == path))
}

/// State of a signal. An unknown path is a state, not a fault.
pub(crate) fn state(controller: &Controller, path: &str, with_description: bool) -> SignalState {
    let io = &controller.devices.state.io;
    let undefined = SignalState {
        status: SignalStatus::Undefined,
        locked: false,
        simulated: false,
        value: 0.0,
        description: Some(String::new()),
        attributes: SignalAttributes::Digital(DigitalAttributes { inverted: false }),
    };
    let Some(id) = find(controller, path) else { return undefined };
    let (Some(signal), Some(value), Some(forcing)) = (io.signal(id), io.image(id), io.forcing(id)) else {
        return undefined;
    };
    SignalState {
        status: SignalStatus::Defined,
        locked: forcing.is_locked,
        // No signal of this controller has a device.
        simulated: true,
        value,
        description: Some(if with_description { signal.description.clone() } else { String::new() }),
        attributes: match signal.kind {
            SignalKind::Digital => SignalAttributes::Digital(DigitalAttributes { inverted: false }),
            SignalKind::Analog(_) => SignalAttributes::Analogue(AnalogueAttributes { a: 1.0, b: 0.0 }),
        },
    }
}

/// Changes a signal. Inputs can be locked but not written, and a locked output keeps its value.
pub(crate) fn change(controller: &mut Controller, path: &str, change: SignalChange) -> SignalResponse {
    let Some(id) = find(controller, path) else { return SignalResponse { success: false, found: false } };
    let io = &controller.devices.state.io;
    let (Some(signal), Some(forcing)) = (io.signal(id), io.forcing(id)) else {
        return SignalResponse { success: false, found: false };
    };
    let argument = |new| Value::Object(Map::from_iter([(path.to_owned(), script_value(signal.kind, new))]));
    let (key, argument) = match change {
        SignalChange::Write(_) if signal.direction == Direction::Input || forcing.is_locked || signal.protected => {
            return SignalResponse { success: false, found: true };
        }
        SignalChange::Write(new) => ("io", argument(new)),
        SignalChange::Lock(new) => ("lock", argument(new)),
        SignalChange::LockNow => ("lock", json!([path])),
        SignalChange::Unlock => ("unlock", json!([path])),
    };
    let action = ScriptAction::from_json(Map::from_iter([(key.to_owned(), argument)]));
    let success = action.is_ok_and(|action| controller.act(&action).is_ok());
    SignalResponse { success, found: true }
}

/// Value of a signal in a script: `true` or `false` for a digital signal, and a number for an analog one.
fn script_value(kind: SignalKind, value: f64) -> Value {
    match kind {
        SignalKind::Digital => json!(value > DIGITAL_THRESHOLD),
        SignalKind::Analog(_) => json!(value),
    }
}

/// Paths of all signals.
pub(crate) fn paths(controller: &Controller) -> Vec<String> {
    let io = &controller.devices.state.io;
    io.signals().filter_map(|id| io.signal(id)).map(|signal| signal.path.clone()).collect()
}

/// Changes all signals. Returns the number of changed signals.
pub(crate) fn change_all(controller: &mut Controller, new: SignalChange) -> i32 {
    let changed = paths(controller).iter().filter(|path| change(controller, path, new).success).count();
    i32::try_from(changed).unwrap_or(i32::MAX)
}
