//! Answers that no source states. Each is a choice, which a real controller may contradict (docs/fidelity.md).

use std::net::IpAddr;

use val3_geometry::IsometryMatrix3;
use val3_session::ReplaceFault;
use val3_soap::ExceptionCode;
use val3_soap::v0::ControllerParameter;
use val3_soap::v2::ReplacementResult;
use val3_soap::v3::{MotionResult, MoveType};

/// Version of the interface. Clients parse a number, and know that the servers V2 and V3 exist from 1.2.
pub(crate) const INTERFACE_VERSION: &str = "1.2";

/// Number of the session in the answer to a rejected login. Clients test for 0.
pub(crate) const NO_SESSION: i32 = 0;

/// Time without a request after which a session ends, in seconds: `sessionTimeout` in the files of cells.
pub(crate) const SESSION_SECONDS: u64 = 3600;

/// Maximum number of simultaneous sessions. Real controllers have a limit, but no source states it.
pub(crate) const MOST_SESSIONS: usize = 32;

/// Parameter with the serial number of the controller. The keys of real controllers are unknown.
pub(crate) fn serial_number(value: &str) -> ControllerParameter {
    let text = |text: &str| Some(text.to_owned());
    ControllerParameter { key: text("serial"), name: text("Serial number"), value: text(value) }
}

/// Version with which the language is compatible: its first number, as `compatibility` in `val3version.xml`.
pub(crate) fn compatibility(version: &str) -> Option<String> {
    let number: String = version.trim_start_matches('s').chars().take_while(char::is_ascii_digit).collect();
    Some(number).filter(|number| !number.is_empty())
}

/// Value above which a digital signal is on, as a client reads it.
pub(crate) const DIGITAL_THRESHOLD: f64 = 0.1;

/// Maximum number of signals in a request. A client states this limit; the answer to a larger request is a choice.
pub(crate) const MOST_SIGNALS: usize = 10;

/// Code of a breakpoint that was set or removed. The enumeration has no value for a success.
pub(crate) const BREAKPOINT_SET: ExceptionCode = ExceptionCode::Unknown;

/// Whether `requested`, the element `prjName`, is the full name or the bare name of a project.
pub(crate) fn is_project_name(project: &str, requested: &str) -> bool {
    let bare = project.rsplit('/').next().and_then(|file| file.rsplit_once('.')).map(|(name, _)| name);
    project.eq_ignore_ascii_case(requested) || bare.is_some_and(|bare| bare.eq_ignore_ascii_case(requested))
}

/// Result of a line that was not replaced.
pub(crate) const fn replacement_result(fault: &ReplaceFault) -> ReplacementResult {
    match fault {
        ReplaceFault::Blocks => ReplacementResult::InstructionControl,
        ReplaceFault::Code(_) => ReplacementResult::CompilationError,
        ReplaceFault::Busy(_) => ReplacementResult::InstructionBusy,
        ReplaceFault::Unavailable(_) => ReplacementResult::Unknown,
    }
}

/// Fault code if an application cannot be loaded or started. Newer interfaces have a specific code with an unknown name.
pub(crate) const NOT_LOADED: ExceptionCode = ExceptionCode::Unknown;

/// Type of a signal in the list of all signals.
pub(crate) const fn signal_type(is_digital: bool, is_input: bool) -> &'static str {
    match (is_digital, is_input) {
        (true, true) => "din",
        (true, false) => "dout",
        (false, true) => "ain",
        (false, false) => "aout",
    }
}

/// Id in the answer to a rejected move. Ids of moves are from 1.
pub(crate) const NO_MOVE: i32 = 0;

/// Result of a move after a rejected move, before the reset, and of a move for which the queue has no place.
pub(crate) const BLOCKED_MOVE: MotionResult = MotionResult::Misuse;

/// Speed in mm/s or degrees/s above which no limit applies, so that 99999 m/s and rad/s are no limits. The greatest valid
/// speed of a motion descriptor.
pub(crate) const UNLIMITED_SPEED: f64 = 1e6;

/// Pose in `world` to which the positions of a move are relative. `frame` is the frame of the motion descriptor, and
/// `start` the pose of the tool at the end of the previous move. A relative position is along the axes of the tool, as
/// with `appro` in programs, so the frame has no effect.
pub(crate) fn origin_of_positions(
    kind: MoveType,
    frame: IsometryMatrix3<f64>,
    start: IsometryMatrix3<f64>,
) -> IsometryMatrix3<f64> {
    match kind {
        MoveType::Absolute => frame,
        MoveType::Relative => start,
    }
}

/// Whether an event service is on this machine. No source states the operations of such a service, so nothing is sent,
/// and services on other machines are rejected.
pub(crate) fn is_local_service(url: &str) -> bool {
    let Some(authority) = url.strip_prefix("http://").and_then(|rest| rest.split(['/', '?', '#']).next()) else {
        return false;
    };
    let host = match authority.rsplit_once(':') {
        Some((host, port)) if port.parse::<u16>().is_ok() => host,
        _ => authority,
    };
    let address = host.trim_start_matches('[').trim_end_matches(']').parse::<IpAddr>();
    host.eq_ignore_ascii_case("localhost") || address.is_ok_and(|address| address.is_loopback())
}
