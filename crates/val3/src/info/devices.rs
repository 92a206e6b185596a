//! Inputs and outputs of a controller, by device.

use std::collections::BTreeMap;

use val3_analysis::cell::{CellIo, Device};
use val3_analysis::load::cell_io;
use val3_backup::info::{TextFiles, joined};
use val3_backup::{BackupFiles, UnreadFile};

/// A device with its signals.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct DeviceInfo {
    /// First part of the links, for example `BasicIO-1`.
    pub(super) name: String,
    /// Signals, sorted by link.
    pub(super) signals: Vec<SignalInfo>,
}

/// A signal.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct SignalInfo {
    /// Link, for example `BasicIO-1\%I0`.
    pub(super) link: String,
    /// Type of the variables that can be linked: `dio`, `aio` or `sio`.
    pub(super) ty: &'static str,
    /// Name in the configuration of the board, for example `bIn0`.
    pub(super) name: Option<String>,
    /// Direction.
    pub(super) direction: SignalDirection,
}

/// Direction of a signal, from its link.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SignalDirection {
    /// `%I…`
    Input,
    /// `%Q…`
    Output,
    /// The link does not state it.
    Unknown,
}

impl SignalDirection {
    fn of(link: &str) -> Self {
        match link.rsplit('\\').next() {
            Some(last) if last.starts_with("%I") => Self::Input,
            Some(last) if last.starts_with("%Q") => Self::Output,
            _ => Self::Unknown,
        }
    }

    /// Word in the description.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Input => "input",
            Self::Output => "output",
            Self::Unknown => "signal",
        }
    }
}

/// Returns the devices with a supported configuration file, sorted by name, and the files that cannot be read.
pub(super) fn devices(files: &dyn BackupFiles, usr: &str) -> (Vec<DeviceInfo>, Vec<UnreadFile>) {
    let mut texts = TextFiles::new(files);
    let io = cell_io(|path| texts.text(&joined(usr, path)));
    let CellIo { devices, names, .. } = &io;
    let names: BTreeMap<&str, &str> = names.iter().map(|(name, link)| (link.as_str(), name.as_str())).collect();
    let mut found: Vec<DeviceInfo> = devices.iter().map(|(name, device)| info(name, device, &names)).collect();
    found.sort_by(|one, next| one.name.cmp(&next.name));
    (found, texts.unread)
}

fn info(name: &str, device: &Device, names: &BTreeMap<&str, &str>) -> DeviceInfo {
    let links = device.iter().map(|(address, ty)| (format!("{name}\\{address}"), ty.name()));
    let mut signals: Vec<SignalInfo> = links.map(|(link, ty)| signal(link, ty, names)).collect();
    // `%I2` precedes `%I10`.
    signals.sort_by(|one, next| (one.link.len(), &one.link).cmp(&(next.link.len(), &next.link)));
    DeviceInfo { name: name.to_owned(), signals }
}

fn signal(link: String, ty: &'static str, names: &BTreeMap<&str, &str>) -> SignalInfo {
    let name = names.get(link.as_str()).map(|&name| name.to_owned());
    let direction = SignalDirection::of(&link);
    SignalInfo { link, ty, name, direction }
}
