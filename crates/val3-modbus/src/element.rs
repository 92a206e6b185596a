//! Single values of a topic, with their links.

use crate::file::{Item, Topic};
use crate::{DEVICE, TableKind, Writer};

/// Value at one address.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Element {
    /// Table of the address.
    pub table: TableKind,
    /// Address, from 0.
    pub address: u16,
    /// Side that writes the value.
    pub writer: Writer,
    /// Link, for example `ModbusSrv-0\Modbus-Bit\bStart`, or `ModbusSrv-0\Modbus-Bit\bIn[0]` in an array.
    pub link: String,
    /// Other links to the same value. Older files contain the array size: `bIn:8[0]`. An array's name is a link to the first
    /// element.
    pub other_links: Vec<String>,
}

impl Topic {
    /// Returns the values of all items.
    pub fn elements(&self) -> impl Iterator<Item = Element> {
        self.items.iter().flat_map(|item| self.elements_of(item))
    }

    fn elements_of(&self, item: &Item) -> impl Iterator<Item = Element> + use<> {
        let Item { table, writer, first, count, .. } = *item;
        let name = format!("{DEVICE}\\{}-{}\\{}", self.name, table.link_name(), item.name);
        (first..=u16::MAX).zip(0..item.addresses()).map(move |(address, index)| {
            let (link, other_links) = match count {
                None => (name.clone(), Vec::new()),
                Some(count) => {
                    let plain = (index == 0).then(|| name.clone());
                    let counted = format!("{name}:{count}[{index}]");
                    (format!("{name}[{index}]"), plain.into_iter().chain([counted]).collect())
                }
            };
            Element { table, address, writer, link, other_links }
        })
    }
}

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use expect_test::expect;

    use crate::ModbusFile;

    #[test]
    fn values_have_links() {
        let file = ModbusFile::read(
            r#"<TOPICSLIST><TOPIC Name="My bus"><MODULE IDModule="BOOLEAN"><ITEM Name="bStart" Syntaxe="%Q0"/>
            <ITEM Name="bOut" Syntaxe="%I1:2"/></MODULE><MODULE IDModule="WORD"><ITEM Name="n" Syntaxe="%QW65535:1"/>
            </MODULE></TOPIC></TOPICSLIST>"#,
        );
        let mut shown = String::new();
        for element in file.topics.iter().flat_map(super::Topic::elements) {
            let (link, others) = (element.link, element.other_links);
            writeln!(shown, "{} {:?}: {link} {others:?}", element.address, element.writer).unwrap();
        }
        expect![[r#"
            0 Client: ModbusSrv-0\My bus-Bit\bStart []
            1 Robot: ModbusSrv-0\My bus-Bit\bOut[0] ["ModbusSrv-0\\My bus-Bit\\bOut", "ModbusSrv-0\\My bus-Bit\\bOut:2[0]"]
            2 Robot: ModbusSrv-0\My bus-Bit\bOut[1] ["ModbusSrv-0\\My bus-Bit\\bOut:2[1]"]
            65535 Client: ModbusSrv-0\My bus-Word\n[0] ["ModbusSrv-0\\My bus-Word\\n", "ModbusSrv-0\\My bus-Word\\n:1[0]"]
        "#]]
        .assert_eq(&shown);
    }
}
