//! Initial fathers of frames, tools and points, and the grippers of tools (9.4 to 9.6).

use val3_analysis::data_check::steps;
use val3_analysis::xml::XmlElement as Xml;
use val3_bytecode::{FatherLink, LinkTarget};
use val3_lang::builtins;
use val3_lang::memory::{DetachedValue, LinkPlace, Memory, PartInit, Place};
use val3_lang::types::BaseType;

use super::LoadedLink;

/// Returns the father in a value of the s7 and s8 dialect.
pub(super) fn of(value: Xml<'_>) -> Option<FatherLink> {
    parse(&value.value("fatherId")?)
}

/// Returns the father that the old dialect declares once for all values of `element`.
pub(super) fn of_all_values(element: Xml<'_>) -> Option<FatherLink> {
    named(element.elements().find(|part| part.name().ends_with("Father"))?, "fatherIndex")
}

/// Returns the `dio` of a tool's gripper in the old dialect.
pub(super) fn gripper(value: Xml<'_>) -> Option<FatherLink> {
    named(value.elements().find(|element| element.name() == "io")?, "ioIndex")
}

/// Reads the reference in an element of the old dialect.
fn named(element: Xml<'_>, index: &str) -> Option<FatherLink> {
    let written = |name: &str| element.value(name).filter(|text| !text.is_empty()).map(|text| text.into_owned());
    let at = written(index).unwrap_or_else(|| "0".to_owned());
    Some(FatherLink { library: written("alias"), name: written("name")?, at, fields: Vec::new() })
}

/// Parses `fTray[0]` or `tSlot["a"].fFrame[0]`.
fn parse(reference: &str) -> Option<FatherLink> {
    let mut steps = steps(reference)?.into_iter().map(|step| {
        let at = step.index.unwrap_or_else(|| "0".to_owned());
        (step.name, at.trim().trim_matches('"').to_owned())
    });
    let (name, at) = steps.next()?;
    Some(FatherLink { library: None, name, at, fields: steps.collect() })
}

/// Links a value to its father: immediately if the father is built in, otherwise after all data exist.
pub(super) fn attach_father(value: &mut DetachedValue, father: FatherLink, number: u32, links: &mut Vec<LoadedLink>) {
    let builtin = builtins::find(&father.name).filter(|builtin| builtin.is_variable && father.library.is_none());
    match builtin {
        Some(builtin) => {
            let store = if builtin.ty == BaseType::Frame { Memory::WORLD } else { Memory::FLANGE };
            value.links.iter_mut().take(1).for_each(|link| *link = LinkPlace::Data(Place::first(store)));
        }
        None => links.push(LoadedLink { path: Vec::new(), value: number, link: 0, target: LinkTarget::Father(father) }),
    }
}

/// Removes the links to built-in variables from these values.
pub(crate) fn detach_fathers(init: &mut PartInit) {
    for value in init.values.iter_mut().flatten() {
        value
            .links
            .iter_mut()
            .filter(|link| matches!(link, LinkPlace::Data(_)))
            .for_each(|link| *link = LinkPlace::None);
        value.parts.iter_mut().for_each(detach_fathers);
    }
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn references() {
        let shown = |text| parse(text).map(|found| format!("{}[{}]{:?}", found.name, found.at, found.fields));
        assert_eq!(shown("fTray[1,2]").as_deref(), Some("fTray[1,2][]"));
        assert_eq!(shown("tSlot[\"a b\"].fIn[0]").as_deref(), Some("tSlot[a b][(\"fIn\", \"0\")]"));
        assert_eq!(shown("fTray").as_deref(), Some("fTray[0][]"));
        assert_eq!(shown(""), None);
    }
}
