//! Messages in the controller's event log (`log/errors.log` of a CS8, `log/system.log` and `log/user.log` of a CS9).

/// A kind of message, identified by codes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LogMessage {
    /// Codes as written in the log, for example `0x5405`.
    pub codes: &'static [&'static str],
    /// Summary in a few words, without a full stop.
    pub short: &'static str,
    /// Explanation and remedy.
    pub long: &'static str,
}

const fn row(codes: &'static [&'static str], short: &'static str, long: &'static str) -> LogMessage {
    LogMessage { codes, short, long }
}

/// All known kinds of messages. Their meanings come from public logs of CS8 and CS9 controllers.
pub static LOG_MESSAGES: [LogMessage; 24] = [
    row(
        &["0x0309"],
        "joint position out of limits",
        "A joint position is beyond the software limits of an axis. `val3 check --motion` reports such positions.",
    ),
    row(
        &["0x0313", "0x0316"],
        "point not reachable",
        "A Cartesian point is beyond the limits of the axes, or its orientation is not reachable. `val3 check --motion` reports such points.",
    ),
    row(&["0x1403", "0x1404"], "brakes", "The brakes were opened or closed."),
    row(
        &["0x1601", "0x1602", "0x1603", "0x1604"],
        "arm power",
        "The power of the arm comes, is there, goes, or is off.",
    ),
    row(
        &["0x1626", "0x162C"],
        "arm power refused or lost",
        "The text gives the reason. A program sees it with `isPowered()`.",
    ),
    row(
        &["0x1627"],
        "power off by the working mode",
        "The working mode changed, so the power of the arm was switched off.",
    ),
    row(
        &["0x1801", "0x1802", "0x1803", "0x1804", "0x1805"],
        "working mode",
        "The working mode changed: automatic, manual, test, remote, or invalid. A program sees it with `workingMode()`.",
    ),
    row(&["0x2201", "0x2202"], "user profile", "The profile changed, or it does not permit the action."),
    row(&["0x2E0C"], "Modbus server", "The Modbus server could not start."),
    row(
        &["0x3B05", "0x3B06"],
        "move refused",
        "The target is beyond the limits of the axes or out of reach: run-time error 154 of the move. `val3 check --motion` reports such moves.",
    ),
    row(
        &["0x3B07"],
        "singular position",
        "The line or circle passes a singular position, which the configuration does not allow.",
    ),
    row(&["0x3B0D"], "angle of a circle", "The intermediate point and the target of `movec` do not define a circle."),
    row(&["0x3F10", "0x3F15"], "jog mode", "The connection move has ended, or jogging needs the power of the arm."),
    row(
        &["0x3F30"],
        "moves wait for the end of the jog mode",
        "Moves were recorded in jog mode. They are executed when it is left.",
    ),
    row(
        &["0x4001", "0x4004", "0x4005"],
        "enablePower refused",
        "`enablePower` has no effect in this working mode: it is remote without a signal, or invalid.",
    ),
    row(
        &["0x5401"],
        "application ended with pending moves",
        "The application ended, and the moves that were not finished were cancelled. End it with `waitEndMove()`.",
    ),
    row(
        &["0x5402", "0x5403"],
        "application started or stopped",
        "The application named in the text was started or stopped.",
    ),
    row(
        &["0x5404"],
        "run-time error",
        "A task was stopped by a run-time error: `ERR <number> <text>. <task>.` `val3 explain <number>` explains the number. On s8 a second entry without a number follows.",
    ),
    row(
        &["0x5405"],
        "application cannot be loaded",
        "The compiler refuses the application: `(File <program>.pgx-line <n>) '<token>' : <text>`. The line counts from `begin`, which is line 1. `val3 check` reports the fault at its line. Usual texts:\n\n- `invalid name`: a name is not declared, or is a file that the project does not have (V0101, V0501);\n- `undefined program`: `call` names no program of the project (V0102);\n- `undefined function`: an instruction that this controller does not have, often of an add-on (V0103, V0104, V0532);\n- `invalid type`: a value, an argument or a user type of another type (V0202, V0203, V0501);\n- `syntax error`: the line is not complete (V0010 to V0030).",
    ),
    row(&["0x5464"], "message of a program", "The text of `logMsg`; s7 writes `USR:` before it."),
    row(
        &["0x5501", "0x5502", "0x5503", "0x5504", "0x5510", "0x5511", "0x5512", "0x5513", "0x6201"],
        "EtherCAT",
        "A message of the EtherCAT master or of its slaves.",
    ),
    row(
        &["0x5904", "0x590C", "0x5916", "0x5917"],
        "safety board",
        "An alarm of the safety board; after 0x5916 a restart is needed, and 0x5917 confirms it.",
    ),
    row(&["0x5D02", "0x5D0E"], "fieldbus card", "An error of a fieldbus card. The text gives the reason."),
    row(
        &["0x7807"],
        "application cannot be loaded by the REST server",
        "The text gives the reason; `val3 check` reports the fault at its line.",
    ),
];

#[cfg(test)]
mod tests {
    use super::LOG_MESSAGES;

    #[test]
    fn codes_ascend() {
        assert!(LOG_MESSAGES.is_sorted_by_key(|message| message.codes.first().map(|code| code.to_lowercase())));
    }
}
