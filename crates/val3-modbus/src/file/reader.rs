//! Reads the elements of the file.

use val3_syntax::xml::{self, XmlElement};
use val3_syntax::{TextRange, TextSize};

use super::item::ItemSyntax;
use super::{FaultKind, FileFault, Item, ModbusFile, Topic};
use crate::TableKind;

/// Topic attributes, one of which is the number in the device name.
const NUMBERS: [&str; 3] = ["Card", "Channel", "Equipment"];

/// Reads the elements. The addresses of the items are not compared.
pub(super) fn read(text: &str) -> ModbusFile {
    let parse = val3_syntax::parse(text);
    let mut file = ModbusFile::default();
    if let Some(error) = parse.errors().first() {
        file.add(error.range.start(), FaultKind::Xml);
        return file;
    }
    let Some(root) = xml::root(parse.view()).filter(|root| root.name() == "TOPICSLIST") else {
        file.add(TextSize::new(0), FaultKind::Root);
        return file;
    };
    for element in root.elements().filter(|element| element.name() == "TOPIC") {
        if let Some(topic) = file.topic(element) {
            file.topics.push(topic);
        }
    }
    for element in root.elements().filter(|element| element.name() == "GENERAL_PARAMETERS") {
        file.parameters(element);
    }
    file
}

impl ModbusFile {
    fn add(&mut self, at: TextSize, kind: FaultKind) {
        self.faults.push(FileFault { offset: at.into(), kind });
    }

    /// Reads a topic; `None` without a name.
    fn topic(&mut self, element: XmlElement<'_>) -> Option<Topic> {
        for attribute in NUMBERS {
            if let Some(found) = element.attribute(attribute).filter(|found| found.text().trim() != "0") {
                self.add(found.range.start(), FaultKind::OtherDevice { attribute });
            }
        }
        let name = self.text(element, "TOPIC", "Name")?;
        let is_active = element.value("Actif").is_some_and(|value| value.trim() == "1");
        let mut items = Vec::new();
        for module in element.elements().filter(|element| element.name() == "MODULE") {
            items.extend(self.module(module));
        }
        Some(Topic { name, is_active, items, clients: None, port: None, offset: start(element) })
    }

    /// Reads the items of a module.
    fn module(&mut self, element: XmlElement<'_>) -> Vec<Item> {
        let Some(id) = self.text(element, "MODULE", "IDModule") else { return Vec::new() };
        let table = match id.as_str() {
            "BOOLEAN" => TableKind::Bits,
            "WORD" => TableKind::Words,
            _ => {
                self.add(place(element, "IDModule").start(), FaultKind::Module(id));
                return Vec::new();
            }
        };
        let elements = element.elements().filter(|element| element.name() == "ITEM");
        let items: Vec<Item> = elements.filter_map(|element| self.item(element, table)).collect();
        if let Some(size) = element.attribute("OutputSize") {
            let bits = items.iter().map(Item::end).max().unwrap_or(0) * table.bits();
            let stated = size.text().trim().to_owned();
            if stated.parse() != Ok(bits) && !(stated.is_empty() && bits == 0) {
                self.add(size.range.start(), FaultKind::Size { stated, bits });
            }
        }
        items
    }

    /// Reads an item; `None` if its name or addresses are unknown.
    fn item(&mut self, element: XmlElement<'_>, table: TableKind) -> Option<Item> {
        let name = self.text(element, "ITEM", "Name")?;
        let syntax = self.text(element, "ITEM", "Syntaxe")?;
        let Some(ItemSyntax { writer, first, count }) = ItemSyntax::parse(&syntax, table) else {
            self.add(place(element, "Syntaxe").start(), FaultKind::Syntax(syntax));
            return None;
        };
        if let Some(found) = element.attribute("Offset") {
            let offset = found.text().trim().to_owned();
            if offset.parse() != Ok(first) {
                let kind = FaultKind::Offset { item: name.clone(), offset, address: first };
                self.add(found.range.start(), kind);
            }
        }
        Some(Item { name, table, writer, first, count, offset: start(element) })
    }

    /// Reads a topic's port and client limit.
    fn parameters(&mut self, element: XmlElement<'_>) {
        let Some(name) = self.text(element, "GENERAL_PARAMETERS", "TopicName") else { return };
        let clients = self.parameter(element, "ConnectionNumber");
        let port = self.parameter(element, "TCP_Port");
        if let Some(topic) = self.topics.iter_mut().find(|topic| topic.name == name) {
            (topic.clients, topic.port) = (clients, port);
        }
    }

    /// Reads a number from 1 to 65535; `None` without this attribute, or with a fault.
    fn parameter(&mut self, element: XmlElement<'_>, attribute: &'static str) -> Option<u16> {
        let found = element.attribute(attribute)?;
        let value = found.text();
        let number = value.trim().parse().ok().filter(|number| *number > 0);
        if number.is_none() {
            self.add(found.range.start(), FaultKind::Parameter { attribute, value: value.into_owned() });
        }
        number
    }

    /// Returns an attribute that is not empty.
    fn text(&mut self, element: XmlElement<'_>, name: &'static str, attribute: &'static str) -> Option<String> {
        let text = element.value(attribute).filter(|text| !text.trim().is_empty());
        if text.is_none() {
            self.add(element.tag_range().start(), FaultKind::Missing { element: name, attribute });
        }
        text.map(std::borrow::Cow::into_owned)
    }
}

/// Range of the attribute's value; the start tag without the attribute.
fn place(element: XmlElement<'_>, attribute: &str) -> TextRange {
    element.attribute(attribute).map_or(element.tag_range(), |found| found.range)
}

fn start(element: XmlElement<'_>) -> usize {
    element.tag_range().start().into()
}
