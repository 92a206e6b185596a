//! Options of a run in its event record, so that `--replay` repeats the run without them.

use serde::{Deserialize, Serialize};
use val3_lang::values::date::DateTime;
use val3_machine::controller::Controller;
use val3_session::{CellChoice, Connection};

use crate::args::{ControllerArgs, RunArgs, START, calendar};
use crate::user_error::UserError;

/// Options of a run on which its events depend, as in the arguments of `val3 run`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct RecordedOptions {
    program: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    arm: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<String>,
    /// Joint position at the start, in degrees or mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    start: Option<Vec<f64>>,
    /// Date of the controller at the start.
    #[serde(skip_serializing_if = "Option::is_none")]
    date: Option<String>,
    power: bool,
    /// In per cent.
    #[serde(skip_serializing_if = "Option::is_none")]
    monitor_speed: Option<u8>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    line: Vec<String>,
    network: bool,
    /// In microseconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    line_cost: Option<f64>,
    /// Lines whose other end was the script.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) silent: Vec<String>,
}

impl RecordedOptions {
    /// Returns the options of a run. `args` include the keys of its script, and `controller` is ready to start.
    pub(super) fn of(program: &str, args: &ControllerArgs, controller: &Controller) -> Self {
        Self {
            program: Some(program.to_owned()),
            arm: args.arm.clone(),
            cell: args.cell.as_ref().map(|cell| match cell {
                CellChoice::Without => "none".to_owned(),
                CellChoice::File(path) => path.to_string(),
            }),
            start: args.start.clone(),
            date: Some(shown(controller.devices.state.calendar.after(0))),
            power: args.power,
            monitor_speed: args.monitor_speed,
            line: args.line.iter().map(Connection::to_string).collect(),
            network: args.network,
            line_cost: args.line_cost.map(|cost| cost as f64 / 1000.0),
            silent: controller.script_lines().map(str::to_owned).collect(),
        }
    }

    /// Completes the arguments with these options. Options that the arguments name keep their values;
    /// the program `start` counts as not named.
    ///
    /// # Errors
    /// An option in the recording is invalid.
    pub(super) fn complete(&self, args: &mut RunArgs) -> Result<(), UserError> {
        if let Some(program) = self.program.as_ref().filter(|_| args.program == START) {
            args.program.clone_from(program);
        }
        let controller = &mut args.controller;
        controller.arm = controller.arm.take().or_else(|| self.arm.clone());
        controller.cell = controller.cell.take().or_else(|| self.cell.as_deref().map(CellChoice::of_text));
        controller.start = controller.start.take().or_else(|| self.start.clone());
        if let (None, Some(date)) = (&controller.date, &self.date) {
            controller.date = Some(calendar(date).map_err(|reason| invalid("date", &reason))?);
        }
        controller.power |= self.power;
        controller.monitor_speed = controller.monitor_speed.or(self.monitor_speed);
        controller.network |= self.network;
        if let (None, Some(cost)) = (controller.line_cost, self.line_cost) {
            let time = val3_session::line_cost(cost);
            controller.line_cost = Some(time.ok_or_else(|| invalid("line_cost", &format!("{cost} microseconds")))?);
        }
        for line in &self.line {
            let connection: Connection = line.parse().map_err(|reason| invalid("line", reason))?;
            if !controller.line.iter().any(|own| own.is_for(connection.link())) {
                controller.line.push(connection);
            }
        }
        Ok(())
    }
}

/// Error for an option of a recording.
fn invalid(option: &str, reason: &str) -> UserError {
    UserError::new(format!("the option `{option}` in the recording is invalid: {reason}"))
        .with_help("record the run again with --events")
}

/// Formats a date as `--date` reads it.
fn shown(DateTime { year, month, day, hour, minute, second }: DateTime) -> String {
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}")
}

#[cfg(test)]
mod tests {
    use clap::{Args as _, Command, FromArgMatches as _};

    use super::*;

    fn args(line: &[&str]) -> RunArgs {
        let command = RunArgs::augment_args(Command::new("run").no_binary_name(true));
        RunArgs::from_arg_matches(&command.get_matches_from(line)).unwrap()
    }

    fn options(json: &str) -> RecordedOptions {
        serde_json::from_str(json).unwrap()
    }

    #[test]
    fn recorded_options_complete_the_arguments_that_are_missing() {
        let recorded = options(
            r#"{"program":"main","arm":"tx2-60l","cell":"none","start":[0,1,2,3,4,5],"date":"2026-11-29T19:07:48","power":true,
               "monitor_speed":30,"line":["Socket\\a=server:2000","Socket\\b=udp:2001"],"network":false,"line_cost":2.5}"#,
        );
        let mut completed = args(&["--arm", "tx2-90", "--line", r"socket\A=server:3000"]);
        recorded.complete(&mut completed).unwrap();
        let controller = &completed.controller;
        assert_eq!((completed.program.as_str(), controller.arm.as_deref()), ("main", Some("tx2-90")));
        assert_eq!((controller.power, controller.network, controller.monitor_speed), (true, false, Some(30)));
        assert_eq!((controller.cell.clone(), controller.line_cost), (Some(CellChoice::Without), Some(2500)));
        assert_eq!(controller.start.as_deref(), Some(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0][..]));
        let lines: Vec<String> = controller.line.iter().map(Connection::to_string).collect();
        assert_eq!(lines, [r"socket\A=server:3000", r"Socket\b=udp:2001"]);
        assert_eq!(shown(controller.date.unwrap().after(0)), "2026-11-29T19:07:48");
    }

    #[test]
    fn a_recording_without_options_changes_nothing() {
        let mut completed = args(&["--program", "main"]);
        RecordedOptions::default().complete(&mut completed).unwrap();
        assert_eq!(completed.program, "main");
        assert_eq!(completed.controller.date, None);
    }

    #[test]
    fn invalid_options_are_named() {
        for (json, option) in
            [(r#"{"date":"today"}"#, "`date`"), (r#"{"line":["x"]}"#, "`line`"), (r#"{"line_cost":-1}"#, "`line_cost`")]
        {
            let error = options(json).complete(&mut args(&[])).unwrap_err();
            assert!(error.to_string().contains(option), "{error}");
        }
    }
}
