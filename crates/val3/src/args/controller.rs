//! Properties of the controller, as arguments of the commands that execute code. They take precedence over `val3.toml`.

use std::rc::Rc;

use val3_lang::ports::Time;
use val3_lang::values::date::DateTime;
use val3_machine::controller_state::Calendar;
use val3_machine::sio::SocketGuard;

use val3_session::{CellChoice, CodeForm, Connection, ControllerSettings, PathRoot, line_cost};
use val3_suite::ControllerKeys;

/// The properties of the virtual controller.
#[derive(Debug, Clone, Default, clap::Args)]
pub(crate) struct ControllerArgs {
    /// The arm (tx2-60l) or a file that describes it, instead of the arm in val3.toml and the cell
    #[arg(help_heading = "Controller", long, value_name = "NAME")]
    pub(crate) arm: Option<String>,
    /// Map a root of paths to a folder: USB0=/media/stick; may be repeated
    #[arg(hide_short_help = true, help_heading = "Controller", long, value_name = "NAME=DIR", value_parser = root)]
    pub(crate) root: Vec<PathRoot>,
    /// Connect a serial line or socket, overriding the cell: Socket\host=server:2000,
    /// Socket\host=client:127.0.0.1:2000, Socket\host=udp:2000, Serial\a=serial:/dev/ttyS0; may be repeated
    #[arg(help_heading = "Controller", long, value_name = "LINK=END")]
    pub(crate) line: Vec<Connection>,
    /// Place the things of this file around the arm, instead of those of cell.toml; `none` for an empty room
    #[arg(help_heading = "Controller", long, value_name = "FILE")]
    pub(crate) cell: Option<CellChoice>,
    /// Let sockets connect to and accept other machines; otherwise every address means this machine
    #[arg(help_heading = "Controller", long)]
    pub(crate) network: bool,
    /// The controller's date and time at the start, such as 2007-01-01T13:45:23 [default: 2024-01-01T00:00:00, or
    /// in real time the current time in UTC]
    #[arg(hide_short_help = true, help_heading = "Controller", long, value_name = "DATE", value_parser = calendar)]
    pub(crate) date: Option<Calendar>,
    /// The monitor speed in per cent
    #[arg(hide_short_help = true, help_heading = "Controller", long, value_name = "PCT", value_parser = clap::value_parser!(u8).range(0..=100))]
    pub(crate) monitor_speed: Option<u8>,
    /// The joint position of the arm at the start, in degrees (a stroke in mm), one number an axis, such as
    /// --start=0,0,90,0,90,0 [default: 0 for each axis]
    #[arg(
        hide_short_help = true,
        help_heading = "Controller",
        long,
        value_name = "J1,J2,...",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    pub(crate) start: Option<Vec<f64>>,
    /// Switch the arm's power on at the start, as an operator does
    #[arg(help_heading = "Controller", long)]
    pub(crate) power: bool,
    /// The time that a line needs on the controller's clock, in microseconds [default: 2]
    #[arg(hide_short_help = true, help_heading = "Controller", long, value_name = "US", value_parser = microseconds)]
    pub(crate) line_cost: Option<Time>,
}

impl ControllerArgs {
    /// Returns these arguments, completed by the keys of a test file. An argument has precedence over its key.
    #[must_use]
    pub(crate) fn with(&self, keys: &ControllerKeys) -> Self {
        Self {
            arm: self.arm.clone().or_else(|| keys.arm.clone()),
            start: self.start.clone().or_else(|| keys.start.clone()),
            power: self.power || keys.power,
            monitor_speed: self.monitor_speed.or(keys.monitor_speed),
            cell: self.cell.clone().or_else(|| keys.cell.as_ref().map(|cell| CellChoice::of_text(cell))),
            ..self.clone()
        }
    }

    /// Converts the arguments to session settings. `guard` decides about sockets whose ports only the cell names.
    pub(crate) fn settings(&self, guard: Rc<dyn SocketGuard>) -> ControllerSettings {
        ControllerSettings {
            arm: self.arm.clone(),
            roots: self.root.clone(),
            connections: self.line.clone(),
            cell: self.cell.clone(),
            network: self.network,
            date: self.date,
            monitor_speed: self.monitor_speed,
            start: self.start.clone(),
            power: self.power,
            line_cost: self.line_cost,
            guard: Some(guard),
            form: CodeForm::default(),
            edited: Vec::new(),
        }
    }
}

fn root(text: &str) -> Result<PathRoot, String> {
    let (name, folder) = text
        .split_once('=')
        .filter(|(name, folder)| !name.is_empty() && !folder.is_empty())
        .ok_or("write NAME=DIR, for example USB0=/media/stick")?;
    Ok(PathRoot { name: name.to_owned(), folder: folder.into() })
}

/// Parses the date of `--date`.
pub(crate) fn calendar(text: &str) -> Result<Calendar, String> {
    let fields: Vec<u16> = text.split(['-', 'T', ' ', ':']).map_while(|field| field.parse().ok()).collect();
    let small = |field: u16| u8::try_from(field).ok();
    let date = match *fields {
        [year, month, day, hour, minute, second] => || -> Option<Calendar> {
            let (month, day) = (small(month)?, small(day)?);
            let (hour, minute, second) = (small(hour)?, small(minute)?, small(second)?);
            Calendar::starting_at(DateTime { year, month, day, hour, minute, second })
        }(),
        _ => None,
    };
    date.ok_or_else(|| "write a date and a time, such as 2007-01-01T13:45:23".to_owned())
}

fn microseconds(text: &str) -> Result<Time, String> {
    text.parse().ok().and_then(line_cost).ok_or_else(|| "write microseconds from 0.001 to 1e6".to_owned())
}
