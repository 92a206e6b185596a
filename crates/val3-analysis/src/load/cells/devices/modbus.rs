//! Signals of the Modbus server, with links of the form `ModbusSrv-0\<Topic>-Bit\<item>`.

use val3_lang::types::BaseType;
use val3_modbus::file::Topic;
use val3_modbus::{DEVICE, ModbusFile, TableKind};

use crate::cell::Device;

/// Reads the items of all topics, for example `Modbus-Bit\bStart` and `Modbus-Word\nRecipe[1]`; `None` if the file does
/// not determine all items. Inactive topics are included, because the file does not show why they are inactive.
pub(super) fn read(text: &str) -> Option<Device> {
    let file = ModbusFile::read(text);
    if !file.has_all_items() {
        return None;
    }
    let mut device = Device::default();
    for element in file.topics.iter().flat_map(Topic::elements) {
        let base = match element.table {
            TableKind::Bits => BaseType::Dio,
            TableKind::Words => BaseType::Aio,
        };
        let links = std::iter::once(element.link).chain(element.other_links);
        let names = links.filter_map(|link| Some(link.strip_prefix(DEVICE)?.strip_prefix('\\')?.to_owned()));
        device.extend(names.map(|name| (name, base)));
    }
    Some(device)
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
