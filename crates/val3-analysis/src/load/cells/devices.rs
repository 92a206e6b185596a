//! Inputs and outputs that the configuration files of a cell name.

use rustc_hash::FxHashMap;
use val3_lang::types::BaseType;

use crate::cell::Device;
use crate::xml::{self, Element};

/// Reads the files that are there; `file` gives the text of a file in `usr/configs`.
pub(super) fn read(mut file: impl FnMut(&str) -> Option<String>) -> FxHashMap<String, Device> {
    let mut devices = FxHashMap::default();
    for (name, device) in [("bio.cfx", "BasicIO-1"), ("bio2.cfx", "BasicIO-2")] {
        if let Some(text) = file(name) {
            devices.insert(device.to_owned(), basic_io(&text));
        }
    }
    if let Some(text) = file("sio.cfx") {
        let serial = |element: Element<'_>| element.name() == "serialPort";
        devices.insert("Serial".to_owned(), channels(&text, serial));
        devices.insert("Socket".to_owned(), channels(&text, |element| !serial(element)));
    }
    devices.retain(|_, device: &mut Device| !device.is_empty());
    devices
}

/// `<bioDin index="3" …/>` is `%I3`, `<bioDout index="3" …/>` is `%Q3`.
fn basic_io(text: &str) -> Device {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view());
    let mut device = Device::default();
    for element in root.into_iter().flat_map(Element::elements) {
        let sign = match element.name() {
            "bioDin" => "%I",
            "bioDout" => "%Q",
            _ => continue,
        };
        if let Some(index) = element.value("index") {
            device.insert(format!("{sign}{}", index.trim()), BaseType::Dio);
        }
    }
    device
}

/// `<socketClt><String name="name" value="host" />…`: the channels that `wanted` takes.
fn channels(text: &str, wanted: impl Fn(Element<'_>) -> bool) -> Device {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view());
    let settings =
        root.into_iter().flat_map(Element::elements).filter(|channel| wanted(*channel)).flat_map(Element::elements);
    settings
        .filter(|setting| setting.value("name").as_deref() == Some("name"))
        .filter_map(|setting| Some((setting.value("value")?.into_owned(), BaseType::Sio)))
        .collect()
}
