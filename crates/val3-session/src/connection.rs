//! Connections of a controller's serial lines and sockets, from the cell and from the settings.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::net::{IpAddr, SocketAddr};
use std::str::FromStr;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Sources};
use val3_analysis::items::input_links::links;
use val3_analysis::items::project::data_files;
use val3_bytecode::LinkTarget;
use val3_files::FileClass;
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_machine::devices::ChannelTable;
use val3_machine::sio::{
    ByteStream, ChannelConfig, LineKind, LineSetting, NetworkAccess, RecordedReply, channels, replay,
};

use crate::cell::config;
use crate::error::SessionError;
use crate::json_fault::json_fault;
use crate::settings::MergedSettings;

/// Connection of a line, written as `Socket\host=server:2000`.
#[derive(Debug, Clone, PartialEq)]
pub struct Connection {
    link: String,
    end: LineEnd,
}

/// Remote end of a line.
#[derive(Debug, Clone, PartialEq)]
enum LineEnd {
    /// A socket of this kind.
    Socket(LineKind, Vec<LineSetting>),
    /// A serial device of this machine.
    Device(Utf8PathBuf),
}

impl FromStr for Connection {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const FORM: &str = r"write LINK=server:PORT, LINK=client:ADDRESS:PORT, LINK=udp:PORT or LINK=serial:DEVICE, for example Socket\host=server:2000";
        let (link, end) = text.split_once('=').filter(|(link, _)| !link.is_empty()).ok_or(FORM)?;
        let (kind, place) = end.split_once(':').ok_or(FORM)?;
        let port = |text: &str| text.parse().map(LineSetting::Port).map_err(|_| FORM);
        let end = match kind {
            "server" => LineEnd::Socket(LineKind::Server, vec![port(place)?]),
            "udp" => LineEnd::Socket(LineKind::Udp, vec![port(place)?]),
            "client" => {
                let (address, number) = place.rsplit_once(':').ok_or(FORM)?;
                let address: IpAddr = address.trim_matches(['[', ']']).parse().map_err(|_| FORM)?;
                LineEnd::Socket(LineKind::Client, vec![LineSetting::Target(address), port(number)?])
            }
            "serial" if !place.is_empty() => LineEnd::Device(place.into()),
            _ => return Err(FORM),
        };
        Ok(Self { link: link.to_owned(), end })
    }
}

/// Recording and replay of received data.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tape<'a> {
    /// Whether received data are recorded.
    pub records: bool,
    /// File from which received data are read instead of from outside. `val3 run --events` writes such a file.
    pub replays: Option<&'a Utf8Path>,
}

/// Connects the lines of the cell around `disk` and the lines in the settings.
pub(crate) fn connect(
    lines: &mut ChannelTable,
    disk: &Utf8Path,
    tape: Tape<'_>,
    settings: &MergedSettings,
) -> Result<(), SessionError> {
    if tape.records {
        lines.record();
    }
    if let Some(file) = tape.replays {
        lines.replay(recorded(file)?);
    }
    let configs = connected(of_cell(disk)?, &settings.connections);
    let access = if settings.network { NetworkAccess::Network } else { NetworkAccess::Loopback };
    let guard_of = |config: &ChannelConfig| settings.guard_of(&config.link);
    lines.configure(&configs, access, &guard_of).map_err(|link| SessionError::Line { link })?;
    if tape.replays.is_none() {
        settings.connections.iter().try_for_each(|line| line.open(lines, &configs))?;
    }
    Ok(())
}

/// Checks that the cell, `val3.toml` (`configured`) or a variable of a project names the line of each connection.
///
/// # Errors
/// The first connection with another name, or a file of the cell cannot be read.
pub(crate) fn check_names(
    connections: &[Connection],
    configured: &[String],
    db: &Database,
    disk: &Utf8Path,
    controller: &Controller,
) -> Result<(), SessionError> {
    if connections.is_empty() {
        return Ok(());
    }
    let of_cell = of_cell(disk)?.into_iter().map(|config| config.link);
    let known: BTreeSet<String> =
        of_cell.chain(configured.iter().cloned()).chain(in_files(db)).chain(in_memory(controller)).collect();
    let is_known = |connection: &&Connection| known.iter().any(|link| connection.is_for(link));
    match connections.iter().find(|connection| !is_known(connection)) {
        Some(Connection { link, .. }) => {
            Err(SessionError::UnknownLine { link: link.clone(), known: known.into_iter().collect() })
        }
        None => Ok(()),
    }
}

/// Lines to which variables in data files are linked, also in libraries that are not loaded.
fn in_files(db: &Database) -> impl Iterator<Item = String> {
    let projects = Sources::get(db).projects(db).values();
    let links = projects.flat_map(|project| data_files(db, *project)).flat_map(|file| links(db, *file));
    links.filter(|link| link.ty == BaseType::Sio).map(|link| link.text.to_string())
}

/// Lines of the applications and libraries in memory. The library `io` of s5 and s6 has them without links in files.
fn in_memory(controller: &Controller) -> impl Iterator<Item = String> {
    let links = controller.vm.space.loaded().flat_map(|(_, instance)| &instance.image.links);
    links.filter_map(|init| match &init.target {
        LinkTarget::Port(BaseType::Sio, link) => Some(link.clone()),
        _ => None,
    })
}

/// Lines of a cell with their remote ends. The last matching connection in `lines` replaces the end; the other
/// parameters are kept.
fn connected(mut configs: Vec<ChannelConfig>, lines: &[Connection]) -> Vec<ChannelConfig> {
    for line in lines {
        let mut config = line.config();
        if let Some(at) = configs.iter().position(|known| known.link.eq_ignore_ascii_case(&line.link)) {
            config.take_over(&configs.remove(at));
        }
        configs.push(config);
    }
    configs
}

/// Data that lines have received in another run, by line.
fn recorded(file: &Utf8Path) -> Result<BTreeMap<String, Vec<RecordedReply>>, SessionError> {
    let refused = |reason: String| SessionError::Recording { file: file.to_owned(), reason };
    let text = val3_files::read_text(file, FileClass::Record).map_err(|reason| refused(reason.to_string()))?;
    replay(&text).map_err(|(line, error)| refused(json_fault(&error, line)))
}

/// Lines in `usr/configs/sio.cfx`.
fn of_cell(disk: &Utf8Path) -> Result<Vec<ChannelConfig>, SessionError> {
    Ok(config(disk, "sio.cfx")?.map(|text| channels(&text)).unwrap_or_default())
}

impl fmt::Display for Connection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}=", self.link)?;
        let config = self.config();
        let (kind, port) = (config.kind, config.port().unwrap_or_default());
        match (&self.end, kind, config.target()) {
            (LineEnd::Device(device), ..) => write!(f, "serial:{device}"),
            (_, LineKind::Client, Some(target)) => write!(f, "client:{}", SocketAddr::new(target, port)),
            (_, LineKind::Udp, _) => write!(f, "udp:{port}"),
            _ => write!(f, "server:{port}"),
        }
    }
}

impl Connection {
    /// Line name in the cell, for example `Socket\host`.
    #[must_use]
    pub fn link(&self) -> &str {
        &self.link
    }

    /// Whether this is the connection of the line. Letter case is ignored.
    #[must_use]
    pub fn is_for(&self, link: &str) -> bool {
        self.link.eq_ignore_ascii_case(link)
    }

    /// Serial device; `None` for a socket.
    pub(crate) fn device(&self) -> Option<&Utf8Path> {
        match &self.end {
            LineEnd::Device(device) => Some(device),
            LineEnd::Socket(..) => None,
        }
    }

    /// Address of the machine to which a client connects.
    pub(crate) fn target(&self) -> Option<IpAddr> {
        self.config().target()
    }

    fn config(&self) -> ChannelConfig {
        let (kind, settings) = match &self.end {
            LineEnd::Socket(kind, settings) => (*kind, settings.clone()),
            LineEnd::Device(_) => (LineKind::Serial, Vec::new()),
        };
        ChannelConfig { link: self.link.clone(), kind, settings }
    }

    /// Connects a serial device. Sockets are opened when a program uses them.
    fn open(&self, lines: &mut ChannelTable, configs: &[ChannelConfig]) -> Result<(), SessionError> {
        let LineEnd::Device(device) = &self.end else { return Ok(()) };
        let refused = |reason: String| SessionError::Device { device: device.clone(), link: self.link.clone(), reason };
        let line = serial(device).map_err(|error| refused(error.to_string()))?;
        let known = configs.iter().find(|known| known.link == self.link && known.kind == LineKind::Serial);
        let config = known.cloned().unwrap_or_else(|| self.config());
        lines.attach(&config, line, true).map_err(|_| refused("it does not accept the parameters".to_owned()))
    }
}

#[cfg(unix)]
fn serial(device: &Utf8Path) -> std::io::Result<Box<dyn ByteStream>> {
    Ok(Box::new(val3_machine::sio::SerialLine::open(device)?))
}

#[cfg(not(unix))]
fn serial(_: &Utf8Path) -> std::io::Result<Box<dyn ByteStream>> {
    Err(std::io::ErrorKind::Unsupported.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn connections_are_parsed() {
        let server = Connection::from_str(r"Socket\host=server:2000").unwrap();
        for text in [r"S\a=server:2", r"S\a=client:[::1]:2", r"S\a=client:10.0.0.1:2", r"S\a=udp:2", "S=serial:/d"] {
            assert_eq!(Connection::from_str(text).unwrap().to_string(), text);
        }
        assert_eq!(server.end, LineEnd::Socket(LineKind::Server, vec![LineSetting::Port(2000)]));
        let client = Connection::from_str("Socket\\host=client:[::1]:2000").unwrap().config();
        assert_eq!((client.port(), client.target()), (Some(2000), "::1".parse().ok()));
        assert_eq!(
            Connection::from_str(r"Serial\a=serial:/dev/ttyS0").unwrap().end,
            LineEnd::Device("/dev/ttyS0".into())
        );
        for wrong in
            ["host", "=server:1", "a=server:x", "a=server", "a=client:2000", "a=client:host:1", "a=serial:", "a=x:1"]
        {
            assert!(Connection::from_str(wrong).is_err(), "{wrong}");
        }
    }
}
