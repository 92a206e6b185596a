//! Inputs and outputs in the configuration files of a cell.

mod fieldbus;
mod modbus;
mod virtual_boards;

use smol_str::SmolStr;
use val3_lang::types::BaseType;

use crate::cell::{CellIo, CellText, Device};
use crate::xml::{self, XmlElement};

/// Boards of a CS8: file in `usr/configs`, device name in links, tag prefix of digital signals.
const BOARDS: [(&str, &str, &str); 4] = [
    ("bio.cfx", "BasicIO-1", "bio"),
    ("bio2.cfx", "BasicIO-2", "bio2"),
    ("mio.cfx", "ModuleIO", "mio"),
    ("cio.cfx", "Can-Dio", "cio"),
];

/// Reads the existing files; `file` returns the text of a file in `usr/configs`.
pub(super) fn read(mut file: impl FnMut(&str) -> Option<String>) -> CellIo {
    let mut io = CellIo::default();
    for (name, device, prefix) in BOARDS {
        if let Some(text) = file(name) {
            board(&text, device, prefix, &mut io);
        }
    }
    if let Some(text) = file("sio.cfx") {
        lines(&text, &mut io);
    }
    if let Some(text) = file("virtualIOBoards.cfx") {
        insert_known(virtual_boards::DEVICE, virtual_boards::read(&text), &mut io);
    }
    io.tags = file("hilscher/J207J208.xml").as_deref().and_then(fieldbus::read);
    io
}

/// Adds the file of the Modbus server with its signals.
pub(super) fn add_modbus(file: CellText, io: &mut CellIo) {
    insert_known(val3_modbus::DEVICE, modbus::read(&file.text).unwrap_or_default(), io);
    io.modbus = Some(file);
}

/// Reads a board: `<bioDin index="3" name="bIn3" …/>` is `%I3`, `<bioDout index="3" …/>` is `%Q3`.
fn board(text: &str, device: &str, prefix: &str, io: &mut CellIo) {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view());
    let mut signals = Device::default();
    for element in root.into_iter().flat_map(XmlElement::elements) {
        // In some versions, the elements of the second board have the tag of the first board.
        let kind = element.name().strip_prefix(prefix).or_else(|| element.name().strip_prefix("bio"));
        let sign = match kind {
            Some("Din") => "%I",
            Some("Dout") => "%Q",
            _ => continue,
        };
        let Some(index) = element.value("index") else { continue };
        let address = format!("{sign}{}", index.trim());
        if let Some(name) = element.value("name").filter(|name| !name.is_empty()) {
            let path = SmolStr::from(format!("{device}\\{address}"));
            io.names.entry(name.as_ref().into()).or_insert(path);
        }
        signals.insert(address, BaseType::Dio);
    }
    insert_known(device, signals, io);
}

/// Reads serial lines and sockets: `<socketClt><String name="name" value="host" />…`. A file without sockets means that
/// the cell has none. Serial ports and UDP sockets are not in the file of every version.
fn lines(text: &str, io: &mut CellIo) {
    let parse = val3_syntax::parse(text);
    let Some(root) = xml::root(parse.view()).filter(|root| root.name() == "sio") else { return };
    let (mut serial, mut sockets, mut datagrams) = (Device::default(), Device::default(), Device::default());
    for channel in root.elements() {
        let device = match channel.name().to_ascii_lowercase().as_str() {
            "serialport" => &mut serial,
            name if name.contains("udp") => &mut datagrams,
            _ => &mut sockets,
        };
        let name = channel.elements().find(|setting| setting.value("name").as_deref() == Some("name"));
        let name = name.and_then(|setting| setting.value("value"));
        device.extend(name.map(|name| (name.into_owned(), BaseType::Sio)));
    }
    insert_known("Serial", serial, io);
    insert_known("UdpSocket", datagrams, io);
    io.devices.insert("Socket".to_owned(), sockets);
}

/// Adds a device if its file lists signals.
fn insert_known(device: &str, signals: Device, io: &mut CellIo) {
    if !signals.is_empty() {
        io.devices.insert(device.to_owned(), signals);
    }
}
