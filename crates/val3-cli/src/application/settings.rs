//! What a controller is like: the arguments, and what a `val3.toml` says where they are silent.

use std::str::FromStr as _;

use val3_config::{ConfigFile, Licence, Run};
use val3_lang::ports::Time;
use val3_machine::controller_state;
use val3_machine::devices::Devices;

use super::lines::LineArg;
use crate::args::{ControllerArgs, LINE_COST, Root, microseconds};
use crate::user_error::UserError;

/// The profile that every controller has.
const FIRST_PROFILE: &str = "default";

/// What a controller is like.
pub(super) struct Settings {
    /// The folders of roots other than `Disk`.
    pub(super) roots: Vec<Root>,
    /// What lines are connected to, those of the arguments last.
    pub(super) lines: Vec<LineArg>,
    /// Sockets reach other machines.
    pub(super) network: bool,
    /// What a line takes.
    pub(super) line_cost: Time,
    /// Per cent.
    pub(super) monitor_speed: Option<u8>,
    /// What the file says, for the rest.
    run: Run,
}

impl Settings {
    /// What the arguments say, and the file where they are silent.
    ///
    /// # Errors
    /// The file has a value that its setting does not take.
    pub(super) fn of(args: &ControllerArgs, file: Option<&ConfigFile>) -> Result<Self, UserError> {
        let silent = ConfigFile::default();
        let file = file.unwrap_or(&silent);
        let run = &file.config.run;
        Ok(Self {
            roots: roots(file).chain(args.root.iter().cloned()).collect(),
            lines: lines(file)?.into_iter().chain(args.line.iter().cloned()).collect(),
            network: args.network || run.network,
            line_cost: args.line_cost.map_or_else(|| line_cost(file), Ok)?,
            monitor_speed: args.monitor_speed.map_or_else(|| monitor_speed(file), |speed| Ok(Some(speed)))?,
            run: run.clone(),
        })
    }

    /// Gives the controller its users, licences and speed.
    pub(super) fn apply(&self, devices: &mut Devices) {
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
    }
}

fn roots(file: &ConfigFile) -> impl Iterator<Item = Root> {
    let root = |(name, folder): (&String, _)| Root { name: name.clone(), folder: file.folder().join(folder) };
    file.config.roots.iter().map(root)
}

fn lines(file: &ConfigFile) -> Result<Vec<LineArg>, UserError> {
    let line = |(link, end): (&String, &String)| {
        LineArg::from_str(&format!("{link}={end}")).map_err(|_| {
            let message = format!("`{end}` is nothing that a line is connected to");
            let help = "write \"server:PORT\", \"client:ADDRESS:PORT\", \"udp:PORT\" or \"serial:DEVICE\"";
            refused(file, &format!("run.lines.{link}"), message, help)
        })
    };
    file.config.run.lines.iter().map(line).collect()
}

fn line_cost(file: &ConfigFile) -> Result<Time, UserError> {
    let cost = file.config.run.line_cost.map_or(LINE_COST.to_owned(), |cost| cost.to_string());
    let message = |help: String| refused(file, "run.line-cost", format!("a line cannot take {cost} µs"), &help);
    microseconds(&cost).map_err(message)
}

fn monitor_speed(file: &ConfigFile) -> Result<Option<u8>, UserError> {
    match file.config.run.monitor_speed {
        Some(speed @ 101..) => {
            let message = format!("the monitor speed cannot be {speed} %");
            Err(refused(file, "run.monitor-speed", message, "write 0 to 100"))
        }
        speed => Ok(speed),
    }
}

fn refused(file: &ConfigFile, key: &str, message: String, help: &str) -> UserError {
    UserError::new(file.fault(key, message, help.to_owned()).to_string())
}

/// The profiles of the file, and `default` unless the file describes that too.
fn profiles(run: &Run) -> controller_state::Profiles {
    let of = |(name, profile): (&String, &val3_config::Profile)| controller_state::Profile {
        name: name.clone(),
        password: profile.password.clone(),
        controls_speed: profile.controls_speed,
    };
    let plain = |name: &str| of((&name.to_owned(), &val3_config::Profile::default()));
    let mut known: Vec<_> = run.profiles.iter().map(of).collect();
    if !run.profiles.contains_key(FIRST_PROFILE) {
        known.push(plain(FIRST_PROFILE));
    }
    let active = run.profile.as_deref().unwrap_or(FIRST_PROFILE);
    let active = known.iter().find(|profile| profile.name == active).cloned().unwrap_or_else(|| plain(active));
    controller_state::Profiles::new(known, active)
}
