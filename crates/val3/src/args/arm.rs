//! Arguments of `val3 arm`.

use std::str::FromStr;

use camino::Utf8PathBuf;
use clap::Subcommand;

use super::OutputArgs;

/// Arguments of `val3 arm`.
#[derive(Debug, clap::Args)]
pub(crate) struct ArmArgs {
    /// The action
    #[command(subcommand)]
    pub(crate) action: ArmAction,
}

/// The actions of `val3 arm`, one a file.
#[derive(Debug, Subcommand)]
pub(crate) enum ArmAction {
    /// List the shipped arms: reach, axes, and the origin of their values
    List(ArmListArgs),
    /// Print the file of an arm, to copy and change it
    Show(ArmShowArgs),
    /// Print an arm as URDF, with its shapes, for ROS and other simulators
    Urdf(ArmUrdfArgs),
    /// Write an application that measures the times of your arm on its controller
    Measure(ArmMeasureArgs),
    /// Compute speeds, accelerations and decelerations from the log of that application, and write an arm file
    Fit(ArmFitArgs),
}

/// Arguments of `val3 arm list`.
#[derive(Debug, clap::Args)]
pub(crate) struct ArmListArgs {
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Arguments of `val3 arm show`.
#[derive(Debug, clap::Args)]
pub(crate) struct ArmShowArgs {
    /// The arm, such as tx2-60l
    pub(crate) name: String,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Arguments of `val3 arm urdf`.
#[derive(Debug, clap::Args)]
pub(crate) struct ArmUrdfArgs {
    /// The arm (tx2-60l) or a file that describes it
    pub(crate) name: String,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Arguments of `val3 arm measure`.
#[derive(Debug, clap::Args)]
pub(crate) struct ArmMeasureArgs {
    /// The folder of the application; its name is the name of the application
    #[arg(value_name = "FOLDER", default_value = "armTimes")]
    pub(crate) folder: Utf8PathBuf,
    /// The arm (tx2-60l) or a file that describes it
    #[arg(long, value_name = "NAME")]
    pub(crate) arm: String,
    /// An axis and its range, in degrees (a stroke in mm): 1=-30..30; may be repeated [default: 15 degrees or 40 mm to
    /// both sides of the position at which the application starts]
    #[arg(long, value_name = "AXIS=FROM..TO", allow_hyphen_values = true)]
    pub(crate) range: Vec<AxisRange>,
    /// Replace the files of an earlier application
    #[arg(long)]
    pub(crate) force: bool,
}

/// Arguments of `val3 arm fit`.
#[derive(Debug, clap::Args)]
pub(crate) struct ArmFitArgs {
    /// The event log of the controller (errors.log, user.log), or the output of `val3 run`; several are read in turn
    #[arg(value_name = "LOG", required = true)]
    pub(crate) logs: Vec<Utf8PathBuf>,
    /// The arm (tx2-60l) or a file that describes it, from which all other values are copied
    #[arg(long, value_name = "NAME")]
    pub(crate) arm: String,
    /// Write the arm file here instead of to the standard output
    #[arg(long, value_name = "FILE")]
    pub(crate) output: Option<Utf8PathBuf>,
    /// Replace the file of --output if it exists
    #[arg(long, requires = "output")]
    pub(crate) force: bool,
}

/// Range within which an axis may move, in degrees, or in mm for a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AxisRange {
    /// Axis number, from 1.
    pub(crate) axis: usize,
    /// Lowest position.
    pub(crate) from: f64,
    /// Highest position.
    pub(crate) to: f64,
}

impl FromStr for AxisRange {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let range = parse_range(text).ok_or("write AXIS=FROM..TO, for example 1=-30..30")?;
        if range.from >= range.to {
            return Err(format!("{} is not less than {}: write the lowest position first", range.from, range.to));
        }
        Ok(range)
    }
}

fn parse_range(text: &str) -> Option<AxisRange> {
    let (axis, positions) = text.split_once('=')?;
    let (from, to) = positions.split_once("..")?;
    let position = |text: &str| text.trim().parse().ok().filter(|position: &f64| position.is_finite());
    Some(AxisRange { axis: axis.trim().parse().ok()?, from: position(from)?, to: position(to)? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_has_an_axis_and_two_positions() {
        assert_eq!("1=-30..30".parse(), Ok(AxisRange { axis: 1, from: -30.0, to: 30.0 }));
        assert_eq!("3=10.5..11".parse(), Ok(AxisRange { axis: 3, from: 10.5, to: 11.0 }));
        for text in ["", "1", "1=30", "1=30..30", "1=30..-30", "1=..3", "-1=0..3", "1=nan..3", "1=0..inf", "a=0..1"] {
            assert!(text.parse::<AxisRange>().is_err(), "{text}");
        }
    }
}
