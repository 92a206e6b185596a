//! Controller settings: from the caller, with fallbacks in `val3.toml`.

use std::rc::Rc;
use std::str::FromStr as _;
use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_compile::CodeForm;
use val3_config::{ConfigFile, Licence, RunSettings};
use val3_lang::ports::{Time, nanoseconds};
use val3_machine::arm::RobotArm;
use val3_machine::controller_state::{self, Calendar};
use val3_machine::devices::Devices;
use val3_machine::sio::SocketGuard;

use crate::connection::Connection;
use crate::error::{SessionError, refused};
use crate::grants;
use crate::surroundings::CellChoice;

/// Profile that every controller has.
const FIRST_PROFILE: &str = "default";

/// Default duration of a line in microseconds.
pub const LINE_COST: f64 = 2.0;

/// Settings of the controller that executes an application. `val3.toml` and the cell provide unset values.
#[derive(Debug, Clone, Default)]
pub struct ControllerSettings {
    /// Arm model or arm kind.
    pub arm: Option<String>,
    /// Folders of roots other than `Disk`, in addition to the roots in `val3.toml`.
    pub roots: Vec<PathRoot>,
    /// Connections of serial lines and sockets. They replace connections in the cell and in `val3.toml`.
    pub connections: Vec<Connection>,
    /// The things around the arm, in place of the file in `val3.toml` or beside it.
    pub cell: Option<CellChoice>,
    /// Whether sockets reach other machines; otherwise every address is redirected to this machine.
    pub network: bool,
    /// Date and time at the start.
    pub date: Option<Calendar>,
    /// Monitor speed in per cent, 0 to 100.
    pub monitor_speed: Option<u8>,
    /// Joint position of the arm at the start, in degrees (linear axes in mm), one number per axis.
    pub start: Option<Vec<f64>>,
    /// Whether the arm has power at the start, as if an operator had switched it on.
    pub power: bool,
    /// Controller time of a line, in nanoseconds.
    pub line_cost: Option<Time>,
    /// Guard of the sockets whose ports only the cell configures; without it they are opened without a check.
    pub guard: Option<Rc<dyn SocketGuard>>,
    /// Form of the code of libraries that the application loads.
    pub form: CodeForm,
    /// Program texts that replace files on the disk, by path, for libraries that the application loads.
    pub edited: Vec<(Utf8PathBuf, Arc<str>)>,
}

/// A path root and its folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PathRoot {
    /// Name before `://`.
    pub name: String,
    /// The folder.
    pub folder: Utf8PathBuf,
}

/// Converts the duration of a line from microseconds to controller time in nanoseconds. `None` outside 0.001 to 1e6
/// microseconds, because without a duration a program that never waits would stop the clock.
pub fn line_cost(microseconds: f64) -> Option<Time> {
    (0.001..=1e6).contains(&microseconds).then(|| nanoseconds(microseconds / 1e6))
}

/// Settings of the caller, with fallbacks from `val3.toml`.
pub(crate) struct MergedSettings {
    /// Folders of roots other than `Disk`.
    pub(crate) roots: Vec<PathRoot>,
    /// Names of the lines in `val3.toml`.
    pub(crate) configured_lines: Vec<String>,
    /// Connections of lines; the caller's connections are last.
    pub(crate) connections: Vec<Connection>,
    /// Connections that the user has authorised: from the caller, and from a trusted file.
    pub(crate) named: Vec<Connection>,
    /// Guard of all other sockets.
    pub(crate) guard: Option<Rc<dyn SocketGuard>>,
    /// Whether sockets reach other machines.
    pub(crate) network: bool,
    /// Controller time of a line, in nanoseconds.
    pub(crate) line_cost: Time,
    /// Monitor speed in per cent.
    monitor_speed: Option<u8>,
    /// Joint position of the arm at the start; empty for the arm's default.
    start: Vec<f64>,
    /// Whether the arm has power at the start.
    power: bool,
    /// Settings that exist only in the file.
    run: RunSettings,
}

impl MergedSettings {
    /// Merges the settings.
    ///
    /// # Errors
    /// If the file contains an invalid value.
    pub(crate) fn of(settings: &ControllerSettings, file: Option<&ConfigFile>) -> Result<Self, SessionError> {
        let empty = ConfigFile::default();
        let file = file.unwrap_or(&empty);
        let run = &file.config.run;
        let lines = connections(file)?;
        let reaches_out = run.network || !lines.is_empty();
        let is_trusted = reaches_out && grants::is_trusted(file);
        if !is_trusted {
            grants::check(file, &lines, settings)?;
        }
        let of_caller = settings.connections.iter().cloned();
        let of_user = lines.iter().filter(|_| is_trusted).cloned().chain(of_caller.clone());
        let network = settings.network || run.network;
        Ok(Self {
            roots: roots(file).chain(settings.roots.iter().cloned()).collect(),
            named: of_user.collect(),
            configured_lines: lines.iter().map(|line| line.link().to_owned()).collect(),
            connections: lines.into_iter().chain(of_caller).collect(),
            guard: settings.guard.clone().filter(|_| !network),
            network,
            line_cost: settings.line_cost.map_or_else(|| line_cost_of(file), Ok)?,
            monitor_speed: settings.monitor_speed.map_or_else(|| monitor_speed(file), |speed| Ok(Some(speed)))?,
            start: settings.start.clone().unwrap_or_else(|| run.start.clone()),
            power: settings.power || run.power,
            run: run.clone(),
        })
    }

    /// Sets the users, licences, monitor speed, power and arm position.
    ///
    /// # Errors
    /// If the start position exceeds an axis limit, or if its number of axes differs from the arm's.
    pub(crate) fn apply(&self, devices: &mut Devices) -> Result<(), SessionError> {
        if self.run.profile.is_some() || !self.run.profiles.is_empty() {
            devices.state.profiles = profiles(&self.run);
        }
        for (name, state) in &self.run.licences {
            let licence = match state {
                Licence::Enabled => Some(controller_state::Licence::Enabled),
                Licence::Demo => Some(controller_state::Licence::Demo),
                Licence::Missing => None,
            };
            devices.state.versions.set_licence(name, licence);
        }
        if let Some(speed) = self.monitor_speed {
            devices.state.robot.turn_speed(speed.into());
        }
        if self.power {
            devices.state.robot.set_power(true);
        }
        devices.state.io.set_units(self.run.units.clone());
        self.place(&mut devices.state.arm)
    }

    fn place(&self, arm: &mut RobotArm) -> Result<(), SessionError> {
        let axes = arm.model().axes();
        if self.start.is_empty() {
            return Ok(());
        }
        let placed = if self.start.len() == axes {
            let joint = std::array::from_fn(|axis| self.start.get(axis).copied().unwrap_or_default());
            arm.start_at(joint).map_err(|violation| violation.to_string())
        } else {
            Err(format!("the arm has {axes} axes"))
        };
        placed.map_err(|reason| SessionError::Setting {
            message: format!("the arm cannot start at {:?}: {reason}", self.start),
            help: format!("write {axes} numbers, in degrees (a stroke in mm), with `--start` or in `[run] start`"),
        })
    }

    /// Guard that has to permit the socket of a line; `None` for a line whose connection a setting names.
    pub(crate) fn guard_of(&self, link: &str) -> Option<Rc<dyn SocketGuard>> {
        let is_named = self.named.iter().any(|line| line.is_for(link));
        self.guard.clone().filter(|_| !is_named)
    }
}

fn roots(file: &ConfigFile) -> impl Iterator<Item = PathRoot> {
    let root = |(name, folder): (&String, _)| PathRoot { name: name.clone(), folder: file.folder().join(folder) };
    file.config.roots.iter().map(root)
}

fn connections(file: &ConfigFile) -> Result<Vec<Connection>, SessionError> {
    let connections = file.config.run.lines.iter().map(|(link, end)| {
        Connection::from_str(&format!("{link}={end}")).map_err(|_| {
            let message = format!("a line cannot be connected to `{end}`");
            let help = "write \"server:PORT\", \"client:ADDRESS:PORT\", \"udp:PORT\" or \"serial:DEVICE\"";
            refused(file, &format!("run.lines.{link}"), message, help)
        })
    });
    connections.collect()
}

fn line_cost_of(file: &ConfigFile) -> Result<Time, SessionError> {
    let cost = file.config.run.line_cost.unwrap_or(LINE_COST);
    line_cost(cost).ok_or_else(|| {
        let message = format!("a line of code cannot take {cost} µs");
        refused(file, "run.line-cost", message, "write microseconds from 0.001 to 1e6")
    })
}

fn monitor_speed(file: &ConfigFile) -> Result<Option<u8>, SessionError> {
    match file.config.run.monitor_speed {
        Some(speed @ 101..) => {
            let message = format!("the monitor speed cannot be {speed} %");
            Err(refused(file, "run.monitor-speed", message, "write 0 to 100"))
        }
        speed => Ok(speed),
    }
}

/// Profiles of the file, and `default` if the file does not describe it.
fn profiles(run: &RunSettings) -> controller_state::Profiles {
    let mut known: Vec<_> = run.profiles.iter().map(|(name, profile)| controller_profile(name, profile)).collect();
    let plain = val3_config::Profile::default();
    if !run.profiles.contains_key(FIRST_PROFILE) {
        known.push(controller_profile(FIRST_PROFILE, &plain));
    }
    let name = run.profile.as_deref().unwrap_or(FIRST_PROFILE);
    let active = known.iter().find(|profile| profile.name == name).cloned();
    controller_state::Profiles::new(known, active.unwrap_or_else(|| controller_profile(name, &plain)))
}

fn controller_profile(name: &str, profile: &val3_config::Profile) -> controller_state::Profile {
    controller_state::Profile {
        name: name.to_owned(),
        password: profile.password.clone(),
        controls_speed: profile.controls_speed,
    }
}
