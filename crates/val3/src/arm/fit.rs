//! `val3 arm fit`: creates an arm file from the times that the application of `val3 arm measure` has logged.

mod estimate;
mod file;
mod log;
mod words;

use std::io::{self, Write};
use std::process::ExitCode;

use val3_files::FileClass;
use val3_kinematics::Arm;
use val3_session::ArmFile;

use crate::args::ArmFitArgs;
use crate::color::Color;
use crate::output::{to_stderr, to_stdout};
use crate::user_error::UserError;

use self::estimate::{AxisTimes, Estimate, Undetermined, estimate};
use self::log::Log;
use self::words::described;
use super::files::{check_absent, write_file};

/// Relative uncertainty up to which a value needs no wider range of measurement.
const GOOD: f64 = 0.01;

/// Root mean square of the residuals, in seconds, above which the times do not follow the model.
const GREAT_RESIDUAL: f64 = 0.01;

/// Runs the command. The exit code is 0 if all axes were measured and the entire log was used.
pub(super) fn run(args: &ArmFitArgs, color: Color) -> Result<ExitCode, UserError> {
    if let Some(path) = args.output.as_ref().filter(|_| !args.force) {
        check_absent(path)?;
    }
    let base = ArmFile::named(&args.arm)?;
    let log = read(args, &base.arm)?;
    let axes: Vec<_> = log.axes.iter().map(|axis| estimate(&axis.moves)).collect();
    to_stderr(|out| report(&base.arm, &log, &axes, out));
    if axes.iter().all(Result::is_err) {
        return Err(UserError::new("the log determines the times of no axis, so no file is written")
            .with_help("measure at least one axis with the application of `val3 arm measure`"));
    }
    let measured: Vec<_> = axes.iter().map(|axis| axis.as_ref().ok()).collect();
    let text = file::text(&base, &measured)?;
    match &args.output {
        Some(path) => write_file(path, &text)?,
        None => to_stdout(color, |out| write!(out, "{text}"))?,
    }
    let is_complete = log.faults.is_empty() && axes.iter().all(Result::is_ok);
    Ok(if is_complete { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn read(args: &ArmFitArgs, arm: &Arm) -> Result<Log, UserError> {
    let mut log = Log::new(arm.axes());
    for path in &args.logs {
        let bytes = val3_files::read(path, FileClass::Record)
            .map_err(|error| UserError::new(format!("cannot read `{path}`: {error}")))?;
        log.read(path.as_str(), &String::from_utf8_lossy(&bytes));
    }
    log.finish();
    match log.arms.as_slice() {
        [] | [_] => Ok(log),
        arms => Err(UserError::new(format!("the log contains measurements of several arms: {}", arms.join(", ")))
            .with_help("copy the lines of one arm into a file of their own")),
    }
}

/// Writes each axis' results and all unused parts of the log.
fn report(arm: &Arm, log: &Log, axes: &[Result<AxisTimes, Undetermined>], out: &mut dyn Write) -> io::Result<()> {
    for fault in &log.faults {
        writeln!(out, "warning: {fault}")?;
    }
    if let [measured] = log.arms.as_slice()
        && measured != arm.name()
    {
        writeln!(out, "note: the log was written by an application for the arm {measured}, not {}", arm.name())?;
    }
    for (index, axis) in axes.iter().enumerate() {
        let number = index + 1;
        match axis {
            Ok(times) => axis_report(number, arm.unit(index), times, out)?,
            Err(Undetermined::Few) => {
                writeln!(out, "warning: axis {number}: the log contains no or too few moves of it")?
            }
            Err(Undetermined::Scattered) => writeln!(
                out,
                "warning: axis {number}: too many times contradict the others; measure it once more without interruptions"
            )?,
            Err(Undetermined::Value(name)) => writeln!(
                out,
                "warning: axis {number}: its moves do not determine the {name}; measure all of them, in a wider range (--range)"
            )?,
        }
    }
    Ok(())
}

fn axis_report(number: usize, unit: &str, times: &AxisTimes, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "axis {number}: {}", described(unit, times))?;
    if times.rejected > 0 {
        writeln!(out, "note: axis {number}: {} measurements contradict the others and were not used", times.rejected)?;
    }
    if times.residual > GREAT_RESIDUAL {
        let residual = times.residual * 1000.0;
        writeln!(out, "note: axis {number}: times differ from the model by {residual:.0} ms; its profile is smoother")?;
    }
    if [&times.speed, &times.acceleration, &times.deceleration].into_iter().any(is_vague) {
        writeln!(out, "note: axis {number}: an uncertainty exceeds 1 %; a wider range (--range) reduces it")?;
    }
    Ok(())
}

fn is_vague(estimate: &Estimate) -> bool {
    estimate.uncertainty > GOOD * estimate.value
}
