//! Measured moves in an event log.
//!
//! The measuring application logs lines such as
//! `val3arm times axis=1 length=30.000 vel=5 accel=100 decel=100 ms=2140,2140,2144,2140;`, which the controller
//! prefixes with date and origin. Other lines are ignored.

use std::fmt;

/// Prefix of all messages from the measuring application.
const MARK: &str = "val3arm ";

/// Maximum percentage in a motion descriptor.
const GREATEST_PERCENTAGE: f64 = 1000.0;

/// Maximum time of a move, in ms.
const LONGEST: f64 = 1e6;

/// A move of one axis, measured several times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Move {
    /// Length, in degrees or mm.
    pub(super) length: f64,
    /// Speed as a fraction of the nominal speed.
    pub(super) vel: f64,
    /// Acceleration as a fraction of the nominal acceleration.
    pub(super) accel: f64,
    /// Deceleration as a fraction of the nominal deceleration.
    pub(super) decel: f64,
    /// Median of the measured times, in seconds. The times of equal moves are rounded to cycles of 4 ms in the same
    /// way, so they count as one measurement.
    pub(super) seconds: f64,
}

/// Axis measurements.
#[derive(Debug, Default, Clone, PartialEq)]
pub(super) struct AxisLog {
    /// Moves in the order of the log.
    pub(super) moves: Vec<Move>,
    /// Number of move lines that the application has written, according to its end marks.
    announced: usize,
    /// Whether move lines follow the last end mark.
    is_open: bool,
}

/// An unused part of the log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum LogFault {
    /// A line of the application that cannot be parsed.
    Line {
        /// File as the user named it.
        file: String,
        /// Line number, from 1.
        line: usize,
        /// Reason.
        reason: String,
    },
    /// The application has measured no moves of this axis.
    Unmeasured {
        /// Axis number, from 1.
        axis: usize,
        /// Reason.
        reason: &'static str,
    },
    /// Lines of this axis are missing.
    Incomplete {
        /// Axis number, from 1.
        axis: usize,
    },
}

impl fmt::Display for LogFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line { file, line, reason } => write!(f, "{file}:{line}: {reason}; the line is not used"),
            Self::Unmeasured { axis, reason } => write!(f, "axis {axis}: {reason}"),
            Self::Incomplete { axis } => {
                write!(
                    f,
                    "axis {axis}: lines of its measurement are missing, because it was ended early or the log was cut"
                )
            }
        }
    }
}

/// Arm measurements.
#[derive(Debug, Default)]
pub(super) struct Log {
    /// Names of the measured arms, without duplicates.
    pub(super) arms: Vec<String>,
    /// One entry for each axis.
    pub(super) axes: Vec<AxisLog>,
    /// Unused parts of the log.
    pub(super) faults: Vec<LogFault>,
}

/// A message of the application.
enum Message<'a> {
    Begin { arm: &'a str },
    Times { axis: usize, measured: Move },
    End { axis: usize, lines: usize },
    Unmeasured { axis: usize, reason: &'static str },
    Finished,
}

impl Log {
    /// Creates an empty log for an arm with this number of axes.
    pub(super) fn new(axes: usize) -> Self {
        Self { axes: vec![AxisLog::default(); axes], ..Self::default() }
    }

    /// Adds the lines of a file.
    pub(super) fn read(&mut self, file: &str, text: &str) {
        for (index, line) in text.lines().enumerate() {
            let Some((_, message)) = line.split_once(MARK) else { continue };
            if let Err(reason) = parse(message.trim_end()).and_then(|message| self.add(message)) {
                self.faults.push(LogFault::Line { file: file.to_owned(), line: index + 1, reason });
            }
        }
    }

    /// Adds faults for axes whose measurement is incomplete.
    pub(super) fn finish(&mut self) {
        for (index, axis) in self.axes.iter().enumerate() {
            if !axis.moves.is_empty() && (axis.is_open || axis.moves.len() < axis.announced) {
                self.faults.push(LogFault::Incomplete { axis: index + 1 });
            }
        }
    }

    fn add(&mut self, message: Message<'_>) -> Result<(), String> {
        match message {
            Message::Begin { arm } => {
                if !self.arms.iter().any(|known| known == arm) {
                    self.arms.push(arm.to_owned());
                }
            }
            Message::Times { axis, measured } => {
                let axis = self.axis(axis)?;
                axis.moves.push(measured);
                axis.is_open = true;
            }
            Message::End { axis, lines } => {
                let axis = self.axis(axis)?;
                axis.announced += lines;
                axis.is_open = false;
            }
            Message::Unmeasured { axis, reason } => {
                self.axis(axis)?;
                self.faults.push(LogFault::Unmeasured { axis, reason });
            }
            Message::Finished => {}
        }
        Ok(())
    }

    fn axis(&mut self, axis: usize) -> Result<&mut AxisLog, String> {
        let axes = self.axes.len();
        let found = axis.checked_sub(1).and_then(|index| self.axes.get_mut(index));
        found.ok_or_else(|| format!("the arm has no axis {axis}, its axes are 1 to {axes}"))
    }
}

fn parse(message: &str) -> Result<Message<'_>, String> {
    let (keyword, fields) = message.split_once(' ').unwrap_or((message, ""));
    let mut fields = Fields(fields);
    match keyword {
        // The arm's name may contain blanks; the number of axes follows it.
        "begin" => {
            let name = message.strip_prefix("begin arm=").and_then(|rest| rest.rsplit_once(" axes="));
            let (arm, _) = name.ok_or("`arm` or `axes` is missing")?;
            Ok(Message::Begin { arm })
        }
        "times" => {
            let axis = fields.count("axis")?;
            let length = fields.number("length", GREATEST_LENGTH)?;
            let vel = fields.percentage("vel")?;
            let accel = fields.percentage("accel")?;
            let decel = fields.percentage("decel")?;
            let times = fields.text("ms")?;
            let times = times.strip_suffix(';').ok_or("the line is cut: no `;` at its end")?;
            let times = times.split(',').map(|time| number("ms", time, LONGEST)).collect::<Result<Vec<_>, _>>()?;
            let seconds = median(times) / 1000.0;
            Ok(Message::Times { axis, measured: Move { length, vel, accel, decel, seconds } })
        }
        "end" => Ok(Message::End { axis: fields.count("axis")?, lines: fields.count("lines")? }),
        "slowed" => Ok(Message::Unmeasured {
            axis: fields.count("axis")?,
            reason: "moves were not used, because working mode, power or monitor speed were changed meanwhile",
        }),
        "outside" => Ok(Message::Unmeasured {
            axis: fields.count("axis")?,
            reason: "it was outside of its range and was not measured",
        }),
        "finished" => Ok(Message::Finished),
        _ => Err(format!("`{keyword}` is no message of the measuring application")),
    }
}

/// Maximum length of a move, in degrees or mm.
const GREATEST_LENGTH: f64 = 1e5;

/// Fields of a message, in order. Blanks may surround a value, because controllers pad numbers.
struct Fields<'a>(&'a str);

impl<'a> Fields<'a> {
    fn text(&mut self, name: &str) -> Result<&'a str, String> {
        let value = self.0.trim_start().strip_prefix(name).and_then(|rest| rest.strip_prefix('='));
        let value = value.ok_or_else(|| format!("the line is cut: `{name}` is missing"))?.trim_start();
        let (value, rest) = value.split_at(value.find(char::is_whitespace).unwrap_or(value.len()));
        self.0 = rest;
        Ok(value)
    }

    fn count(&mut self, name: &str) -> Result<usize, String> {
        let text = self.text(name)?;
        text.parse().map_err(|_| format!("`{name}={text}` is no whole number"))
    }

    fn number(&mut self, name: &str, greatest: f64) -> Result<f64, String> {
        number(name, self.text(name)?, greatest)
    }

    fn percentage(&mut self, name: &str) -> Result<f64, String> {
        self.number(name, GREATEST_PERCENTAGE).map(|percentage| percentage / 100.0)
    }
}

/// Returns the median, or 0 without values.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let at = |index: usize| values.get(index).copied().unwrap_or_default();
    (at(values.len() / 2) + at(values.len().saturating_sub(1) / 2)) / 2.0
}

/// Parses a number above 0 and up to `greatest`.
fn number(name: &str, text: &str, greatest: f64) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| *number > 0.0 && *number <= greatest);
    number.ok_or_else(|| format!("`{name}={text}` is impossible, it must be above 0 and at most {greatest}"))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    fn read(text: &str) -> Log {
        let mut log = Log::new(4);
        log.read("user.log", text);
        log.finish();
        log
    }

    #[test]
    fn lines_of_other_programs_are_no_measurements() {
        let log = read(
            "Nov 3 08:00 USR gripper lost a part\r\n\
             Nov 3 08:01 USR val3arm begin arm=TS2-60 axes=4\r\n\
             Nov 3 08:02 USR val3arm times axis=2 length=30    vel= 5 accel=100 decel=100 ms=2140,2144;\r\n\
             Nov 3 08:03 USR val3arm end axis=2 lines=1\r\n\
             Nov 3 08:04 USR val3arm finished\r\n",
        );
        assert_eq!((log.faults, log.arms), (Vec::new(), vec!["TS2-60".to_owned()]));
        let slow = Move { length: 30.0, vel: 0.05, accel: 1.0, decel: 1.0, seconds: 2.142 };
        assert_eq!(log.axes[1].moves, [slow]);
        assert!(log.axes[0].moves.is_empty());
    }

    #[test]
    fn lines_that_cannot_be_used_are_named() {
        let log = read(
            "val3arm times axis=1 length=30 vel=5 accel=100 decel=100 ms=2140,21\n\
             val3arm times axis=1 length=30 vel=5 acc\n\
             val3arm times axis=1 length=-30 vel=5 accel=100 decel=100 ms=2140;\n\
             val3arm times axis=1 length=30 vel=0 accel=100 decel=100 ms=2140;\n\
             val3arm times axis=1 length=30 vel=5 accel=100 decel=100 ms=NaN;\n\
             val3arm times axis=1 length=30 vel=5 accel=100 decel=100 ms=;\n\
             val3arm times axis=5 length=30 vel=5 accel=100 decel=100 ms=2140;\n\
             val3arm times axis=-1 length=30 vel=5 accel=100 decel=100 ms=2140;\n\
             val3arm times axis=3 length=30 vel=5 accel=100 decel=100 ms=2140;\n\
             val3arm times axis=4 length=30 vel=5 accel=100 decel=100 ms=2140;\n\
             val3arm end axis=4 lines=2\n\
             val3arm slowed axis=2 length=30 vel=5 accel=100 decel=100\n\
             val3arm outside axis=2\n\
             val3arm begin arm=TS2-60\n\
             val3arm \n\
             val3arm moves\n",
        );
        let faults: String = log.faults.iter().map(|fault| format!("{fault}\n")).collect();
        expect![[r#"
            user.log:1: the line is cut: no `;` at its end; the line is not used
            user.log:2: the line is cut: `accel` is missing; the line is not used
            user.log:3: `length=-30` is impossible, it must be above 0 and at most 100000; the line is not used
            user.log:4: `vel=0` is impossible, it must be above 0 and at most 1000; the line is not used
            user.log:5: `ms=NaN` is impossible, it must be above 0 and at most 1000000; the line is not used
            user.log:6: `ms=` is impossible, it must be above 0 and at most 1000000; the line is not used
            user.log:7: the arm has no axis 5, its axes are 1 to 4; the line is not used
            user.log:8: `axis=-1` is no whole number; the line is not used
            axis 2: moves were not used, because working mode, power or monitor speed were changed meanwhile
            axis 2: it was outside of its range and was not measured
            user.log:14: `arm` or `axes` is missing; the line is not used
            user.log:15: `` is no message of the measuring application; the line is not used
            user.log:16: `moves` is no message of the measuring application; the line is not used
            axis 3: lines of its measurement are missing, because it was ended early or the log was cut
            axis 4: lines of its measurement are missing, because it was ended early or the log was cut
        "#]]
        .assert_eq(&faults);
        assert!(log.axes[0].moves.is_empty());
    }
}
