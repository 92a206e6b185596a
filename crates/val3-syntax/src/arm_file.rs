//! Arm entries in the configuration files of a cell (`arm.cfx`, `cell.cfx`).

use crate::xml::{self, XmlElement};

/// The entries of a file that describe the arm.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ArmFile {
    /// Model name, for example `tx90l-S1`; `None` if the file contains none.
    pub model: Option<String>,
    /// Length of axis 3 of a SCARA arm, for example `L400`.
    pub length_axis3: Option<String>,
    /// Minimum and maximum positions of the axes, in file order. Missing positions are infinite.
    pub ranges: Vec<[Vec<f64>; 2]>,
}

impl ArmFile {
    /// Reads the arm entries in a file. Other entries are ignored.
    pub fn read(text: &str) -> Self {
        let parse = crate::parse(text);
        let entries = || xml::root(parse.view()).into_iter().flat_map(XmlElement::elements);
        Self {
            model: value(entries(), "arm").filter(|model| !model.is_empty()),
            length_axis3: value(entries(), "lengthAxis3"),
            ranges: entries().filter_map(range).collect(),
        }
    }
}

/// Value of the entry with this name.
fn value<'g>(mut entries: impl Iterator<Item = XmlElement<'g>>, name: &str) -> Option<String> {
    let entry = entries.find(|entry| entry.value("name").as_deref() == Some(name))?;
    entry.value("value").map(|value| value.trim().to_owned())
}

fn range(list: XmlElement<'_>) -> Option<[Vec<f64>; 2]> {
    match list.value("name").as_deref() {
        Some("minArmJointPos") => Some([axes(list).into(), Vec::new()]),
        Some("maxArmJointPos") => Some([Vec::new(), axes(list).into()]),
        _ => None,
    }
}

/// Returns the numbers in a list, one for each axis.
fn axes(list: XmlElement<'_>) -> [f64; 6] {
    let mut axes = [f64::INFINITY; 6];
    for entry in list.elements() {
        let number = |name| entry.value(name).map(|text| text.trim().to_owned());
        let (index, value) = (number("index").and_then(|text| text.parse::<usize>().ok()), number("value"));
        let slot = index.and_then(|index| axes.get_mut(index));
        if let (Some(slot), Some(value)) = (slot, value.and_then(|text| text.parse().ok())) {
            *slot = value;
        }
    }
    axes
}

#[cfg(test)]
mod tests {
    use super::ArmFile;

    #[test]
    fn model_and_ranges_are_read() {
        let file = ArmFile::read(
            "<arm><String name=\"arm\" value=\" ts60-S1 \"/><String name=\"lengthAxis3\" value=\"L400\"/>\
             <FloatArray name=\"minArmJointPos\"><Float index=\"1\" value=\"-90\"/><Float index=\"9\" value=\"1\"/>\
             <Float index=\"2\" value=\"x\"/></FloatArray></arm>",
        );
        let unknown = f64::INFINITY;
        assert_eq!((file.model.as_deref(), file.length_axis3.as_deref()), (Some("ts60-S1"), Some("L400")));
        assert_eq!(file.ranges, [[vec![unknown, -90.0, unknown, unknown, unknown, unknown], vec![]]]);
        assert_eq!(ArmFile::read("<arm><String name=\"arm\" value=\"\"/>"), ArmFile::default());
    }
}
