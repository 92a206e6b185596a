//! Boards in `virtualIOBoards.cfx`, with links of the form `VirtualIOBoards\<Board>\%I2`.

use val3_lang::types::BaseType;

use crate::cell::Device;
use crate::xml::{self, XmlElement};

/// Device name in the links.
pub(super) const DEVICE: &str = "VirtualIOBoards";

/// Letters of analog signals between direction and channel: float, 8, 16 and 32 bits.
const ANALOG: [&str; 4] = ["F", "B", "W", "DW"];

/// Reads the signals of all boards, for example `Cell\%Q0` and `Cell\%IF8`.
pub(super) fn read(text: &str) -> Device {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view());
    let boards = root.into_iter().flat_map(XmlElement::elements).filter(|element| element.name() == "Board");
    let mut device = Device::default();
    for board in boards {
        let Some(name) = board.value("name") else { continue };
        for (list, sign) in [("DInputs", "%I"), ("DOutputs", "%Q")] {
            for channel in channels(board, list) {
                device.insert(format!("{name}\\{sign}{channel}"), BaseType::Dio);
            }
        }
        for (list, sign) in [("AInputs", "%I"), ("AOutputs", "%Q")] {
            let items = board.elements().filter(|element| element.name() == list).flat_map(XmlElement::elements);
            for item in items {
                let Some(channel) = item.value("channel") else { continue };
                for letters in letters(item) {
                    device.insert(format!("{name}\\{sign}{letters}{}", channel.trim()), BaseType::Aio);
                }
            }
        }
    }
    device
}

fn channels<'g>(board: XmlElement<'g>, list: &'static str) -> impl Iterator<Item = String> + 'g {
    let items = board.elements().filter(move |element| element.name() == list).flat_map(XmlElement::elements);
    items.filter_map(|item| Some(item.value("channel")?.trim().to_owned()))
}

/// Returns the possible letters for an analog signal: all of them if the format does not determine one.
fn letters(item: XmlElement<'_>) -> &'static [&'static str] {
    let value = |name: &str| item.value(name).map(|text| text.trim().to_ascii_lowercase());
    match (value("format").as_deref(), value("bitCount").as_deref()) {
        (Some("float"), _) => &["F"],
        (_, Some("8")) => &["B"],
        (_, Some("16")) => &["W"],
        (Some(_), Some("32")) => &["DW"],
        _ => &ANALOG,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signals_have_the_names_of_links() {
        let text = r#"<VirtualIOBoards><Board name="Cell">
            <DInputs><Dio channel="0" /></DInputs><DOutputs><Dio channel="3" /></DOutputs>
            <AInputs><Aio channel="1" bitCount="32" format="float" /><Aio channel="33" bitCount="16" format="unsigned" /></AInputs>
            <AOutputs><Aio channel="4" /></AOutputs></Board></VirtualIOBoards>"#;
        let mut names: Vec<_> = read(text).into_iter().map(|(name, ty)| format!("{name} {}", ty.name())).collect();
        names.sort();
        assert_eq!(
            names,
            [
                "Cell\\%I0 dio",
                "Cell\\%IF1 aio",
                "Cell\\%IW33 aio",
                "Cell\\%Q3 dio",
                "Cell\\%QB4 aio",
                "Cell\\%QDW4 aio",
                "Cell\\%QF4 aio",
                "Cell\\%QW4 aio"
            ]
        );
    }
}
