//! Tables in `usr/applicom/Modbus/modbus.xml`, with links of the form `ModbusSrv-0\<Topic>-Bit\<item>`.

use val3_lang::types::BaseType;

use crate::cell::Device;
use crate::xml::{self, XmlElement};

/// Device name in the links.
pub(super) const DEVICE: &str = "ModbusSrv-0";

/// Maximum number of item elements: a table has at most 65,536 addresses.
const MOST_ELEMENTS: u32 = 0x1_0000;

/// Reads the items of all topics, for example `Modbus-Bit\bStart` and `Modbus-Word\nRecipe[1]`; `None` if the file does
/// not determine all items. Inactive topics are included, because the file does not show why they are inactive.
pub(super) fn read(text: &str) -> Option<Device> {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view()).filter(|root| root.name() == "TOPICSLIST")?;
    if !parse.errors().is_empty() {
        return None;
    }
    let mut device = Device::default();
    for topic in root.elements().filter(|element| element.name() == "TOPIC") {
        // One of these values is the number in the device name, but it is unknown which one.
        if ["Card", "Channel", "Equipment"].iter().any(|name| topic.value(name).is_some_and(|of| of.trim() != "0")) {
            return None;
        }
        let name = topic.value("Name")?;
        for module in topic.elements().filter(|element| element.name() == "MODULE") {
            let (table, base) = match module.value("IDModule").as_deref() {
                Some("BOOLEAN") => ("Bit", BaseType::Dio),
                Some("WORD") => ("Word", BaseType::Aio),
                _ => return None,
            };
            for item in module.elements().filter(|element| element.name() == "ITEM") {
                add(item, &format!("{name}-{table}"), base, &mut device)?;
            }
        }
    }
    Some(device)
}

/// Adds the item's names. In older files, links contain the number of elements: `N1_102:8[0]`.
fn add(item: XmlElement<'_>, module: &str, base: BaseType, device: &mut Device) -> Option<()> {
    let (name, syntax) = (item.value("Name")?, item.value("Syntaxe")?);
    device.insert(format!("{module}\\{name}"), base);
    if let Some((_, count)) = syntax.split_once(':') {
        let count: u32 = count.trim().parse().ok().filter(|count| *count <= MOST_ELEMENTS)?;
        for number in 0..count {
            device.insert(format!("{module}\\{name}[{number}]"), base);
            device.insert(format!("{module}\\{name}:{count}[{number}]"), base);
        }
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = r#"<TOPICSLIST>
        <TOPIC Name="Modbus" Card="0" Channel="0" Equipment="0" Actif="1">
          <MODULE Tag_name_root="" IDModule="BOOLEAN">
            <ITEM Name="bStart" Syntaxe="%Q0" Offset="0"/><ITEM Name="bIn" Syntaxe="%Q1:2" Offset="1"/></MODULE>
          <MODULE Tag_name_root="Word" IDModule="WORD"><ITEM Name="nRecipe" Syntaxe="%QW0" Offset="0"/></MODULE>
        </TOPIC>
        <GENERAL_PARAMETERS TopicName="Modbus" TCP_Port="502"/></TOPICSLIST>"#;

    #[test]
    fn items_have_names_by_table_and_element() {
        let mut names: Vec<String> =
            read(TABLE).unwrap().into_iter().map(|(name, base)| format!("{name} {}", base.name())).collect();
        names.sort_unstable();
        expect_test::expect![[r#"
            Modbus-Bit\bIn dio
            Modbus-Bit\bIn:2[0] dio
            Modbus-Bit\bIn:2[1] dio
            Modbus-Bit\bIn[0] dio
            Modbus-Bit\bIn[1] dio
            Modbus-Bit\bStart dio
            Modbus-Word\nRecipe aio"#]]
        .assert_eq(&names.join("\n"));
    }

    #[test]
    fn a_file_that_leaves_names_open_names_no_item() {
        for (from, to) in [
            ("IDModule=\"WORD\"", "IDModule=\"REAL\""),
            ("Card=\"0\"", "Card=\"1\""),
            ("%Q1:2", "%Q1:many"),
            ("%Q1:2", "%Q1:4000000000"),
            ("TOPICSLIST>", "LIST>"),
            ("</TOPIC>", ""),
        ] {
            assert_eq!(read(&TABLE.replace(from, to)), None, "{from}");
        }
    }
}
