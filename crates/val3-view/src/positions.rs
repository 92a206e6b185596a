//! The positions of the applications and libraries in memory, and the names of data that are linked to signals.

use serde_json::{Value, json};
use val3_debug::subscript;
use val3_geometry::chain;
use val3_lang::call::{FrameRef, PointRef, ToolRef};
use val3_lang::enumerations;
use val3_lang::memory::{KindBase, Link, Memory, Place};
use val3_lang::references::{self, Chain};
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_machine::io::{LinkId, SignalId};

use crate::numbers;

/// A global value of an application or library.
#[derive(Debug, Clone)]
pub(crate) struct Datum {
    /// Its data, with the name of the library before it.
    pub(crate) name: String,
    /// Its index or key; none of data with a single value.
    pub(crate) key: Option<String>,
    pub(crate) base: BaseType,
    pub(crate) place: Place,
}

impl Datum {
    /// Its name with its index or key.
    fn whole_name(&self) -> String {
        match &self.key {
            Some(key) => format!("{}[{key}]", self.name),
            None => self.name.clone(),
        }
    }
}

/// The global values of types that pages show, of the application and its libraries.
pub(crate) fn data(controller: &Controller) -> Vec<Datum> {
    let space = &controller.vm.space;
    let mut found = Vec::new();
    for (number, (_, instance)) in space.loaded().enumerate() {
        let prefix = if number == 0 { String::new() } else { format!("{}:", instance.image.name) };
        for (definition, id) in instance.image.data.iter().zip(instance.data.iter()) {
            let Ok(store) = space.memory.store(*id) else { continue };
            let Some(base) = store.kind.base_type().filter(is_shown) else { continue };
            for index in 0..store.shape.len() {
                let Some(key) = subscript(&store.shape, index) else { continue };
                let key = key.strip_prefix('[').and_then(|key| key.strip_suffix(']')).map(str::to_owned);
                let name = prefix.clone() + &definition.name;
                found.push(Datum { name, key, base, place: store.place(*id, index) });
            }
        }
    }
    found
}

fn is_shown(base: &BaseType) -> bool {
    matches!(base, BaseType::Frame | BaseType::Tool | BaseType::Point | BaseType::Joint | BaseType::Dio | BaseType::Aio)
}

/// The names of a signal's data.
pub(crate) fn names_of(data: &[Datum], controller: &Controller, id: SignalId) -> Vec<String> {
    let (memory, io) = (&controller.vm.space.memory, &controller.devices.state.io);
    let is_linked = |datum: &&Datum| match memory.link(datum.place, 0) {
        Ok(Link::Port(port)) if matches!(datum.base, BaseType::Dio | BaseType::Aio) => {
            io.target_of(LinkId::from_number(port)) == Some(id)
        }
        _ => false,
    };
    data.iter().filter(is_linked).map(Datum::whole_name).collect()
}

/// The name of the tool in memory whose tool centre point is at a place in the flange. The flange itself is a tool too.
pub(crate) fn tool_at(controller: &Controller, is_there: impl Fn(&[f64; 6]) -> bool) -> Option<String> {
    if is_there(&[0.0; 6]) {
        return Some("flange".to_owned());
    }
    let memory = &controller.vm.space.memory;
    let is_meant = |datum: &Datum| {
        let way = references::of_tool(memory, ToolRef(datum.place));
        datum.base == BaseType::Tool && way.is_ok_and(|way| is_there(&numbers(&chain::position(&way, &Chain::new()))))
    };
    data(controller).iter().find(|datum| is_meant(datum)).map(Datum::whole_name)
}

/// The values of one type as objects; those without a place in the cell are left out.
pub(crate) fn of_type(base: BaseType, data: &[Datum], memory: &Memory) -> Vec<Value> {
    let of_base = data.iter().filter(|datum| datum.base == base);
    of_base.filter_map(|datum| described(datum, data, memory)).collect()
}

fn described(datum: &Datum, data: &[Datum], memory: &Memory) -> Option<Value> {
    let Datum { name, key, base, place } = datum;
    if *base == BaseType::Joint {
        let axes = memory.store(place.store).ok()?.kind.size.num;
        return Some(json!({ "name": name, "key": key, "values": nums(memory, *place, axes)? }));
    }
    let way: Chain = match base {
        BaseType::Tool => references::of_tool(memory, ToolRef(*place)),
        BaseType::Frame => references::of_frame(memory, FrameRef(*place)),
        _ => references::of_point(memory, PointRef(*place)),
    }
    .ok()?;
    let father = references::reference(memory, *place).ok().flatten();
    let father = father.and_then(|father| data.iter().find(|known| known.place == father)).map(Datum::whole_name);
    let config = (*base == BaseType::Point).then(|| configuration(memory, *place));
    Some(json!({
        "name": name,
        "key": key,
        "father": father,
        "pose": numbers(&chain::position(&way, &Chain::new())),
        "local": nums(memory, *place, 6),
        "config": config,
    }))
}

/// The words of a point's configuration: shoulder, elbow, wrist; a SCARA arm has a shoulder only.
fn configuration(memory: &Memory, place: Place) -> String {
    let is_scara = memory
        .store(place.store)
        .is_ok_and(|store| matches!(store.kind.base, KindBase::Builtin(_, Some(val3_lang::types::Arm::Scara))));
    let fields = [BaseType::Shoulder, BaseType::Elbow, BaseType::Wrist];
    let word = |(lane, field): (u32, BaseType)| {
        let number = memory.num(place, lane).ok()?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the place of an enumerator")]
        let place = number as usize;
        enumerations::values(field).nth(place).map(|row| row.name)
    };
    (6..).zip(fields).take(if is_scara { 1 } else { 3 }).filter_map(word).collect::<Vec<_>>().join(" ")
}

/// The first numbers of a value.
fn nums(memory: &Memory, place: Place, count: u32) -> Option<Vec<f64>> {
    (0..count).map(|lane| memory.num(place, lane).ok()).collect()
}
