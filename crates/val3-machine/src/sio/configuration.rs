//! Channels in a cell's `sio.cfx`, by the names that data link to: `Socket\Motion`.

use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::rc::Rc;

use val3_syntax::xml::{self, XmlElement};

use super::guarded::{GuardedSocket, SocketGuard};
use super::{
    ByteStream, Channel, LineKind, LineSetting, NetworkAccess, SettingRefusal, SettingValue, TcpClient, TcpServer,
    UdpLine, setting::SettingFault,
};

/// Configuration of a channel.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelConfig {
    /// The text that data link to: `Socket\<name>`, `UdpSocket\<name>`, `Serial\<name>`.
    pub link: String,
    /// The kind of channel.
    pub kind: LineKind,
    /// Parameters, as a program could set them.
    pub settings: Vec<LineSetting>,
}

/// Reads the channels of a configuration file. A channel without a name is skipped, and so is a parameter that its
/// channel does not have.
#[must_use]
pub fn channels(text: &str) -> Vec<ChannelConfig> {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view());
    root.into_iter().flat_map(XmlElement::elements).filter_map(channel).collect()
}

/// `<socketSrv><String name="name" value="Motion" /><Num name="portNumber" value="11000" /></socketSrv>`.
fn channel(element: XmlElement<'_>) -> Option<ChannelConfig> {
    let element_name = element.name().to_ascii_lowercase();
    let (kind, device) = match element_name.as_str() {
        "serialport" => (LineKind::Serial, "Serial"),
        "socketclt" => (LineKind::Client, "Socket"),
        "socketsrv" => (LineKind::Server, "Socket"),
        name if name.contains("udp") => (LineKind::Udp, "UdpSocket"),
        _ => return None,
    };
    let entries = || element.elements().filter_map(|entry| Some((entry.value("name")?, entry.value("value")?)));
    let (_, name) = entries().find(|(key, _)| key == "name")?;
    let settings = entries().filter_map(|(key, value)| setting(&key, value.trim(), kind)).collect();
    Some(ChannelConfig { link: format!("{device}\\{name}"), kind, settings })
}

/// Parses an entry's parameter.
fn setting(key: &str, value: &str, kind: LineKind) -> Option<LineSetting> {
    let key = key.to_ascii_lowercase();
    let name = NAMES.iter().find(|(known, _)| *known == key).map_or(key.as_str(), |(_, name)| name);
    let number = value.parse().ok().map(SettingValue::Num);
    let truth = value.to_ascii_lowercase().parse().ok().map(SettingValue::Bool);
    let candidates = [number, truth, Some(SettingValue::Text(value))];
    let mut read = candidates.into_iter().flatten().map(|value| LineSetting::read(name, value, kind));
    read.find_map(Result::<_, SettingFault>::ok)
}

/// Parameters whose names differ between file and programs.
const NAMES: [(&str, &str); 4] =
    [("portnumber", "port"), ("serverip", "target"), ("nbclients", "clients"), ("maxclients", "clients")];

impl ChannelConfig {
    /// Creates the socket for the channel; `None` for a serial line, whose device is set from outside.
    #[must_use]
    pub fn socket(&self, access: NetworkAccess) -> Option<Box<dyn ByteStream>> {
        let any = SocketAddr::from((Ipv4Addr::UNSPECIFIED, 0));
        match self.kind {
            LineKind::Serial => None,
            LineKind::Client => Some(Box::new(TcpClient::new(SocketAddr::from((Ipv4Addr::LOCALHOST, 0)), access))),
            LineKind::Server => Some(Box::new(TcpServer::new(any, access))),
            LineKind::Udp => Some(Box::new(UdpLine::new(any, None, access))),
        }
    }

    /// Like [`socket`](Self::socket), opened only with the permission of `guard`.
    #[must_use]
    pub fn guarded(&self, access: NetworkAccess, guard: Rc<dyn SocketGuard>) -> Option<Box<dyn ByteStream>> {
        let guarded = |socket| -> Box<dyn ByteStream> { Box::new(GuardedSocket::new(socket, self, access, guard)) };
        self.socket(access).map(guarded)
    }

    /// Inserts the settings from another configuration for the same channel, except port and target, before the
    /// existing settings, which have precedence. If the kinds differ, only timeout and end of string are inserted.
    pub fn take_over(&mut self, other: &Self) {
        let inherited = other.settings.iter().filter(|setting| match setting {
            LineSetting::Port(_) | LineSetting::Target(_) => false,
            LineSetting::Timeout(_) | LineSetting::EndOfString(_) => true,
            _ => self.kind == other.kind,
        });
        self.settings.splice(0..0, inherited.cloned());
    }

    /// Creates the channel on `line`, with the parameters of the configuration.
    ///
    /// # Errors
    /// If the line does not support its configuration.
    pub fn channel(&self, line: Box<dyn ByteStream>) -> Result<Channel, SettingRefusal> {
        let mut channel = Channel::new(line);
        self.settings.iter().try_for_each(|setting| channel.set(setting))?;
        Ok(channel)
    }

    /// Returns the configured port.
    #[must_use]
    pub fn port(&self) -> Option<u16> {
        self.settings.iter().find_map(|setting| match setting {
            LineSetting::Port(port) => Some(*port),
            _ => None,
        })
    }

    /// Returns the configured address to call.
    #[must_use]
    pub fn target(&self) -> Option<IpAddr> {
        self.settings.iter().find_map(|setting| match setting {
            LineSetting::Target(target) => Some(*target),
            _ => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<sio>
  <serialPort><String name="name" value="Serial1"/><Num name="baudRate" value="9600"/><String name="parity" value="Even"/></serialPort>
  <socketSrv>
    <String name="name" value="Motion" />
    <Num name="portNumber" value="11000" />
    <Num name="timeOut" value="-1" />
    <Num name="endOfString" value="13" />
    <Bool name="nagle" value="false" />
  </socketSrv>
  <socketClt>
    <String name="name" value="host" />
    <String name="serverIp" value="192.168.0.254" />
    <Num name="portNumber" value="2000" />
    <Num name="unknown" value="1" />
  </socketClt>
  <socketSrv><Num name="portNumber" value="1" /></socketSrv>
  <other><String name="name" value="x" /></other>
</sio>"#;

    #[test]
    fn channels_have_their_links_and_parameters() {
        let found = channels(FILE);
        let links: Vec<_> = found.iter().map(|channel| (channel.link.as_str(), channel.kind)).collect();
        let expected = [
            (r"Serial\Serial1", LineKind::Serial),
            (r"Socket\Motion", LineKind::Server),
            (r"Socket\host", LineKind::Client),
        ];
        assert_eq!(links, expected);
        let motion = [
            LineSetting::Port(11000),
            LineSetting::Timeout(-1.0),
            LineSetting::EndOfString(13),
            LineSetting::Nagle(false),
        ];
        assert_eq!(found[1].settings, motion);
        assert_eq!((found[2].port(), found[2].target()), (Some(2000), "192.168.0.254".parse().ok()));
        assert_eq!(found[0].settings.len(), 2);
    }

    #[test]
    fn another_connection_keeps_the_other_parameters() {
        let found = channels(FILE);
        let own = vec![LineSetting::Port(7)];
        let mut server =
            ChannelConfig { link: r"Socket\Motion".to_owned(), kind: LineKind::Server, settings: own.clone() };
        let mut client = ChannelConfig { kind: LineKind::Client, ..server.clone() };
        client.take_over(&found[0]);
        assert_eq!(client.settings, own, "what a serial line has alone");
        server.take_over(&found[1]);
        let kept =
            [LineSetting::Timeout(-1.0), LineSetting::EndOfString(13), LineSetting::Nagle(false), LineSetting::Port(7)];
        assert_eq!(server.settings, kept);
    }

    #[test]
    fn a_configured_channel_can_be_used() {
        for config in channels(FILE).iter().filter(|config| config.kind != LineKind::Serial) {
            let line = config.socket(NetworkAccess::Loopback).unwrap();
            assert_eq!(config.channel(line).unwrap().kind(), config.kind);
        }
        assert!(channels("no xml").is_empty());
    }
}
