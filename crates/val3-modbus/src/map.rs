//! Addresses of the topic that a server has.

use crate::file::{FileFault, ModbusFile, Topic};
use crate::{Element, TableKind};

/// Addresses of a topic with their values' links.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModbusMap {
    /// Name of the topic.
    pub topic: String,
    /// Maximum number of clients.
    pub clients: u16,
    bits: Vec<Option<Element>>,
    words: Vec<Option<Element>>,
}

/// Reason why no server can use a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotServed {
    /// Faults that make addresses uncertain.
    Faults(Vec<FileFault>),
    /// No topic is active.
    NoTopic,
    /// Several topics are active: their names.
    Topics(Vec<String>),
    /// The file contains no number of clients for the topic.
    NoClients {
        /// Name of the topic.
        topic: String,
    },
}

impl ModbusMap {
    /// Returns the addresses of the active topic.
    ///
    /// # Errors
    /// Addresses are uncertain because of a fault in the file, or the number of active topics is not 1.
    pub fn of(file: &ModbusFile) -> Result<Self, NotServed> {
        let faults: Vec<FileFault> = file.faults.iter().filter(|fault| !fault.kind.is_harmless()).cloned().collect();
        if !faults.is_empty() {
            return Err(NotServed::Faults(faults));
        }
        let active: Vec<&Topic> = file.topics.iter().filter(|topic| topic.is_active).collect();
        let topic = match active[..] {
            [] => return Err(NotServed::NoTopic),
            [topic] => topic,
            _ => return Err(NotServed::Topics(active.into_iter().map(|topic| topic.name.clone()).collect())),
        };
        let clients = topic.clients.ok_or_else(|| NotServed::NoClients { topic: topic.name.clone() })?;
        let [bits, words] = TableKind::ALL.map(|table| elements(topic, table));
        Ok(Self { topic: topic.name.clone(), clients, bits, words })
    }

    /// Returns the values of a table by address; `None` at an address without an item.
    #[must_use]
    pub fn table(&self, table: TableKind) -> &[Option<Element>] {
        match table {
            TableKind::Bits => &self.bits,
            TableKind::Words => &self.words,
        }
    }

    /// Returns the value at an address.
    #[must_use]
    pub fn element(&self, table: TableKind, address: u16) -> Option<&Element> {
        self.table(table).get(usize::from(address))?.as_ref()
    }
}

/// Values of a table by address.
fn elements(topic: &Topic, table: TableKind) -> Vec<Option<Element>> {
    let mut elements = Vec::new();
    for element in topic.elements().filter(|element| element.table == table) {
        let address = usize::from(element.address);
        if elements.len() <= address {
            elements.resize(address + 1, None);
        }
        if let Some(slot) = elements.get_mut(address) {
            *slot = Some(element);
        }
    }
    elements
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOPIC: &str = r#"<TOPIC Name="Modbus" Actif="1">
        <MODULE IDModule="BOOLEAN"><ITEM Name="bStart" Syntaxe="%Q2"/></MODULE></TOPIC>"#;
    const PARAMETERS: &str = r#"<GENERAL_PARAMETERS TopicName="Modbus" ConnectionNumber="4"/>"#;

    fn of(elements: &[&str]) -> Result<ModbusMap, NotServed> {
        ModbusMap::of(&ModbusFile::read(&format!("<TOPICSLIST>{}</TOPICSLIST>", elements.concat())))
    }

    #[test]
    fn the_active_topic_is_served() {
        let inactive = TOPIC.replace("Actif=\"1\"", "Actif=\"0\"").replace("Modbus", "Other");
        let map = of(&[TOPIC, &inactive, PARAMETERS]).unwrap();
        assert_eq!((map.topic.as_str(), map.clients), ("Modbus", 4));
        assert_eq!((map.table(TableKind::Bits).len(), map.table(TableKind::Words).len()), (3, 0));
        assert_eq!(map.element(TableKind::Bits, 2).unwrap().link, r"ModbusSrv-0\Modbus-Bit\bStart");
        assert_eq!((map.element(TableKind::Bits, 0), map.element(TableKind::Bits, 3)), (None, None));
    }

    #[test]
    fn other_files_are_not_served() {
        let other = TOPIC.replace("Modbus", "Other");
        assert_eq!(of(&[]), Err(NotServed::NoTopic));
        assert_eq!(of(&[TOPIC, &other]), Err(NotServed::Topics(vec!["Modbus".to_owned(), "Other".to_owned()])));
        assert_eq!(of(&[TOPIC]), Err(NotServed::NoClients { topic: "Modbus".to_owned() }));
        assert!(matches!(of(&[&TOPIC.replace("%Q2", "%Z2"), PARAMETERS]), Err(NotServed::Faults(_))));
    }
}
