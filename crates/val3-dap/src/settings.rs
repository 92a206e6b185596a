//! The settings of a session that are not options of `val3 run`: keys of `launch` and `attach`.

use serde_json::{Map, Value};
use val3_debug::{Debugger, PastLimits, SkipPattern, VariableFilter};
use val3_machine::arm::MotionMode;

use crate::failure::RequestFailure;

/// The settings of a session.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SessionSettings {
    /// Initial motion mode (10.2.2).
    motion_mode: MotionMode,
    /// Limits of the recorded history.
    past: PastLimits,
    /// Whether the run stops before its first line, or as soon as a client has attached.
    pub(crate) stops_on_entry: bool,
    /// Whether text on user pages appears in the debug console.
    pub(crate) shows_screen_output: bool,
    /// Whether the run stops before the end of its last task.
    pub(crate) stops_on_exit: bool,
    /// Whether the run goes to its end without stops, and stops there.
    pub starts_at_end: bool,
    /// Whether the angles of positions are shown in radians.
    pub(crate) has_radians: bool,
    /// Whether a breakpoint, a step or an error stops only its task.
    pub(crate) stops_one_task: bool,
    /// Code in which steps into calls do not end.
    skipped: Vec<SkipPattern>,
    /// Filter of the global variables in scopes; `None` for all variables.
    pub(crate) variable_filter: Option<VariableFilter>,
}

impl SessionSettings {
    /// Starts recording the history, and sets the modes of the run.
    pub fn apply(&self, debugger: &mut Debugger) {
        debugger.stop_at_exit(self.stops_on_exit || self.starts_at_end);
        debugger.record(self.past);
        debugger.skip(self.skipped.clone());
        if !self.starts_at_end {
            self.apply_modes(debugger);
        }
    }

    /// Sets the modes of a run in which the user controls the tasks.
    pub(crate) fn apply_modes(&self, debugger: &mut Debugger) {
        debugger.set_motion_mode(self.motion_mode);
        debugger.stop_tasks_alone(self.stops_one_task);
    }

    /// Reads the settings among the arguments of `launch` or `attach`.
    ///
    /// # Errors
    /// A value is invalid.
    pub(crate) fn of(arguments: &Map<String, Value>) -> Result<Self, RequestFailure> {
        let usual = PastLimits::default();
        let snapshots = number(arguments, "pastSnapshots")?.and_then(|number| usize::try_from(number).ok());
        let bytes = number(arguments, "pastMemory")?.map(|mebibytes| mebibytes.saturating_mul(1 << 20));
        Ok(Self {
            motion_mode: arguments.get("motionMode").map_or(Ok(MotionMode::Continuous), motion_mode)?,
            past: PastLimits { snapshots: snapshots.unwrap_or(usual.snapshots), bytes: bytes.unwrap_or(usual.bytes) },
            stops_on_entry: switch(arguments, "stopOnEntry", false)?,
            stops_on_exit: switch(arguments, "stopOnExit", false)?,
            starts_at_end: switch(arguments, "startAtEnd", false)?,
            shows_screen_output: switch(arguments, "screenOutput", true)?,
            has_radians: is_second(arguments, "angles", ["degrees", "radians"])?,
            stops_one_task: is_second(arguments, "stopScope", ["all", "task"])?,
            skipped: arguments.get("skip").map_or(Ok(Vec::new()), skipped)?,
            variable_filter: arguments.get("variableFilter").map_or(Ok(None), variable_filter)?,
        })
    }
}

/// Returns the motion mode with this name.
fn motion_mode(mode: &Value) -> Result<MotionMode, RequestFailure> {
    match mode.as_str() {
        Some("continuous") => Ok(MotionMode::Continuous),
        Some("step") => Ok(MotionMode::Step),
        _ => Err(RequestFailure::Rejected(format!("the motion has no mode {mode}: write \"continuous\" or \"step\""))),
    }
}

/// Parses the code in which steps into calls do not end.
fn skipped(patterns: &Value) -> Result<Vec<SkipPattern>, RequestFailure> {
    if patterns.is_null() {
        return Ok(Vec::new());
    }
    let parsed = patterns.as_array().and_then(|patterns| {
        patterns.iter().map(|pattern| pattern.as_str()?.parse().ok()).collect::<Option<Vec<SkipPattern>>>()
    });
    let invalid = || format!("`skip` is a list such as [\"library\", \"main:log*\"], not {patterns}");
    parsed.ok_or_else(|| RequestFailure::Rejected(invalid()))
}

/// Parses a filter of variables; an empty text is no filter.
fn variable_filter(filter: &Value) -> Result<Option<VariableFilter>, RequestFailure> {
    match filter {
        Value::Null => Ok(None),
        Value::String(text) if text.trim().is_empty() => Ok(None),
        Value::String(text) => {
            let invalid = |error| RequestFailure::Rejected(format!("`variableFilter` is {filter}: {error}"));
            text.parse().map(Some).map_err(invalid)
        }
        _ => Err(RequestFailure::Rejected(format!("`variableFilter` is a text such as \"nPush*\", not {filter}"))),
    }
}

/// Reads a whole number of at least 1.
fn number(arguments: &Map<String, Value>, key: &str) -> Result<Option<u64>, RequestFailure> {
    let Some(value) = arguments.get(key).filter(|value| !value.is_null()) else { return Ok(None) };
    let number = value.as_u64().filter(|number| *number > 0);
    let invalid = || RequestFailure::Rejected(format!("`{key}` is a whole number of at least 1, not {value}"));
    number.map(Some).ok_or_else(invalid)
}

/// Reads a truth value; `usual` if the key is absent.
fn switch(arguments: &Map<String, Value>, key: &str, usual: bool) -> Result<bool, RequestFailure> {
    match arguments.get(key) {
        None | Some(Value::Null) => Ok(usual),
        Some(Value::Bool(value)) => Ok(*value),
        Some(value) => Err(RequestFailure::Rejected(format!("`{key}` is true or false, not {value}"))),
    }
}

/// Reads a key with two possible values, and returns whether it has the second one. The first one is the default.
fn is_second(arguments: &Map<String, Value>, key: &str, [first, second]: [&str; 2]) -> Result<bool, RequestFailure> {
    match arguments.get(key) {
        None | Some(Value::Null) => Ok(false),
        Some(value) if value == first => Ok(false),
        Some(value) if value == second => Ok(true),
        Some(value) => Err(RequestFailure::Rejected(format!("`{key}` is \"{first}\" or \"{second}\", not {value}"))),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn of(arguments: Value) -> Result<SessionSettings, String> {
        let Value::Object(arguments) = arguments else { panic!("no object") };
        SessionSettings::of(&arguments).map_err(|failure| failure.to_string())
    }

    #[test]
    fn settings_have_usual_values() {
        let usual = of(json!({ "program": "x", "angles": null })).unwrap();
        assert_eq!((usual.motion_mode, usual.past), (MotionMode::Continuous, PastLimits::default()));
        assert!(usual.shows_screen_output && !usual.stops_on_entry && !usual.has_radians && !usual.stops_one_task);
        let chosen = of(json!({
            "motionMode": "step", "pastSnapshots": 20, "pastMemory": 2, "angles": "radians", "stopScope": "task",
        }));
        let chosen = chosen.unwrap();
        assert_eq!((chosen.motion_mode, chosen.past), (MotionMode::Step, PastLimits { snapshots: 20, bytes: 2 << 20 }));
        assert!(chosen.has_radians && chosen.stops_one_task);
    }

    #[test]
    fn wrong_values_are_refused() {
        for (key, value) in [
            ("angles", json!("rad")),
            ("stopScope", json!(1)),
            ("motionMode", json!("fast")),
            ("stopOnEntry", json!("yes")),
            ("skip", json!("library")),
            ("skip", json!(["library", ""])),
            ("variableFilter", json!(["n*"])),
            ("variableFilter", json!("n[")),
        ] {
            let reason = of(json!({ key: value.clone() })).unwrap_err();
            assert!(reason.contains(&value.to_string()), "{reason}");
        }
        assert!(of(json!({ "pastMemory": 0 })).unwrap_err().contains("pastMemory"));
        assert!(of(json!({ "pastSnapshots": "many" })).unwrap_err().contains("pastSnapshots"));
    }
}
