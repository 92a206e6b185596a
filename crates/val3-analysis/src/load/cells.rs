//! The configuration of the controller around a `usrapp`.

mod devices;

use std::sync::Arc;

use camino::Utf8Path;
use val3_lang::add_on::{AddOnTable, parse_table};
use val3_lang::types::Arm;
use val3_syntax::encoding::decode;

use crate::cell::CellConfig;
use crate::system::System;
use crate::xml::{self, Element};

/// Reads what `usr/configs` and `usr/app` say; `None` where neither is there.
///
/// `known_arm` is the arm that a `val3.toml` names.
pub(super) fn read(system: &dyn System, usr: &Utf8Path, known_arm: Option<Arm>) -> Option<CellConfig> {
    let (configs, app) = (usr.join("configs"), usr.join("app"));
    let tables = system.list(&app).unwrap_or_default();
    let tables: Vec<&String> = tables.iter().filter(|name| table_name(name).is_some()).collect();
    let arm_file = text(system, &configs.join("arm.cfx"));
    let io = devices::read(|name| text(system, &configs.join(name)));
    if tables.is_empty() && arm_file.is_none() && io.is_empty() {
        return None;
    }
    let arm = known_arm.or_else(|| arm_file.as_deref().and_then(arm));
    let add_ons = tables.iter().filter_map(|name| table(system, &app, name, arm)).collect();
    Some(CellConfig { arm, add_ons: Arc::new(add_ons), io })
}

/// The table of an add-on that a `val3.toml` names.
pub(super) fn named_table(system: &dyn System, path: &Utf8Path) -> Result<AddOnTable, String> {
    let bytes = system.read(path).map_err(|error| error.to_string())?;
    parse_table(&decode(bytes).text).map_err(|error| error.to_string())
}

fn text(system: &dyn System, path: &Utf8Path) -> Option<String> {
    system.read(path).ok().map(|bytes| decode(bytes).text)
}

/// `val3.Motion.anthro.cfx`: the add-on and the arm it is for.
fn table_name(name: &str) -> Option<(&str, Arm)> {
    let (add_on, arm) = name.strip_prefix("val3.")?.strip_suffix(".cfx")?.rsplit_once('.')?;
    Some((add_on, Arm::from_table_word(arm)?))
}

/// The table of an add-on for this arm. A cell that does not tell its arm counts as one with six axes.
fn table(system: &dyn System, folder: &Utf8Path, name: &str, arm: Option<Arm>) -> Option<AddOnTable> {
    let (_, of) = table_name(name)?;
    if of != arm.unwrap_or(Arm::SixAxis) {
        return None;
    }
    parse_table(&text(system, &folder.join(name))?).ok()
}

/// `<String name="arm" value="tx90-S1" />`
fn arm(text: &str) -> Option<Arm> {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view())?;
    let named = |element: &Element<'_>| element.value("name").as_deref() == Some("arm");
    let model = root.elements().find(named)?.value("value")?;
    (!model.trim().is_empty()).then(|| Arm::from_model(&model))
}
