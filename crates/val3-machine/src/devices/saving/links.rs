//! Links of values in files: inputs, outputs and lines by path, fathers by name and index.

use std::cell::RefCell;
use std::collections::BTreeMap;

use rustc_hash::FxHashMap;
use val3_bytecode::{DataDef, FatherLink, LinkInit, LinkTarget};
use val3_lang::memory::{ContainerShape, KindBase, LinkPlace, Memory, Place, StoreId};
use val3_lang::types::BaseType;
use val3_lang::values::Text;
use val3_vm::{Instance, InstanceId, Space};

use super::super::lines::ChannelTable;
use super::Saving;
use crate::io::{IoTable, LinkId};

/// Names of link targets, and the loaded links.
pub(super) struct LoadedLinks<'s> {
    space: &'s Space,
    id: InstanceId,
    memory: &'s Memory,
    io: &'s IoTable,
    lines: &'s ChannelTable,
    /// Frames and tools of global data.
    names: FxHashMap<StoreId, FrameContainer>,
    /// Cached places of the fathers in files.
    fathers: RefCell<FxHashMap<FatherLink, Option<Place>>>,
    loaded: BTreeMap<LinkPath, &'s LinkTarget>,
}

/// Container of frames or tools.
struct FrameContainer {
    /// Beginning of a reference: `tSlot["a"].fIn`.
    name: String,
    /// Keys of a collection by value number.
    keys: FxHashMap<u32, Text>,
}

impl FrameContainer {
    fn new(name: String, shape: &ContainerShape) -> Self {
        let keys = match shape {
            ContainerShape::Collection(keys) => keys.iter().map(|(key, number)| (*number, *key)).collect(),
            ContainerShape::Array { .. } => FxHashMap::default(),
        };
        Self { name, keys }
    }
}

/// Identification of a link in global data: the data, the path through fields, the value, and the link of the value.
pub(super) type LinkPath = (u32, Vec<(u32, u32)>, u32, u32);

impl<'s> LoadedLinks<'s> {
    /// Creates the links of the instance that is saved.
    pub(super) fn new(saving: &Saving<'s>, instance: &'s Instance) -> Self {
        let Saving { space, saved, io, lines, .. } = *saving;
        let spot = |init: &LinkInit| (init.data, init.path.clone(), init.value, init.link);
        let loaded = instance.image.links.iter().map(|init| (spot(init), &init.target)).collect();
        let (names, fathers) = (FxHashMap::default(), RefCell::default());
        let mut links = Self { space, id: saved, memory: &space.memory, io, lines, names, fathers, loaded };
        links.name(Memory::WORLD, "world".to_owned());
        links.name(Memory::FLANGE, "flange".to_owned());
        links.name_all(instance, "");
        for (library, id) in instance.image.libraries.iter().zip(&instance.libraries) {
            if let Some(library_instance) = id.and_then(|id| space.instance(id)) {
                links.name_all(library_instance, &format!("{}:", library.alias));
            }
        }
        links
    }

    fn name_all(&mut self, instance: &Instance, prefix: &str) {
        for (data, store) in instance.image.data.iter().zip(instance.data.iter()) {
            self.name(*store, format!("{prefix}{}", data.name));
        }
    }

    fn name(&mut self, id: StoreId, name: String) {
        let Ok(store) = self.memory.store(id) else { return };
        match &store.kind.base {
            KindBase::Builtin(BaseType::Frame | BaseType::Tool, _) => {
                self.names.entry(id).or_insert_with(|| FrameContainer::new(name, &store.shape));
            }
            KindBase::Builtin(..) => {}
            KindBase::User(_) => {
                for (number, index) in indexes(&store.shape) {
                    for (field, at) in store.kind.fields.iter().zip(0u32..) {
                        if let Ok(part) = self.memory.part(store.place(id, number), at) {
                            self.name(part, format!("{name}[{index}].{}", field.name));
                        }
                    }
                }
            }
        }
    }

    /// Returns a link as written in a file; `None` without a link, or if no file can name its target.
    pub(super) fn text(&self, link: LinkPlace, base: BaseType) -> Option<String> {
        match link {
            LinkPlace::None => None,
            LinkPlace::Port(number) if base == BaseType::Sio => self.lines.link(number).map(str::to_owned),
            LinkPlace::Port(number) => Some(self.io.text(LinkId::from_number(number)).to_owned()),
            LinkPlace::Data(place) => {
                let place = self.memory.present(place).ok()?;
                let store = self.memory.store(place.store).ok()?;
                let number = place.num.checked_div(store.kind.size.num)?;
                let FrameContainer { name, keys } = self.names.get(&place.store)?;
                match store.shape {
                    ContainerShape::Array { dims, sizes } if number < store.shape.len() => {
                        Some(format!("{name}[{}]", index(dims, sizes, number)))
                    }
                    ContainerShape::Array { .. } => None,
                    ContainerShape::Collection(_) => Some(format!("{name}[\"{}\"]", keys.get(&number)?)),
                }
            }
        }
    }

    /// Returns a value's link as written in a file. A father that did not exist when the link was loaded keeps its
    /// written text.
    pub(super) fn text_at(&self, spot: Option<&LinkPath>, link: LinkPlace, base: BaseType) -> Option<String> {
        self.text(link, base).or_else(|| self.missing(spot, link).map(reference))
    }

    /// Returns the father that the file names but that does not exist.
    fn missing(&self, spot: Option<&LinkPath>, link: LinkPlace) -> Option<&FatherLink> {
        match self.loaded.get(spot?)? {
            LinkTarget::Father(father) if link == LinkPlace::None && self.father(father).is_none() => Some(father),
            _ => None,
        }
    }

    /// Returns the values that a program has linked to inputs, outputs or lines since they were loaded: `dIn[0]`.
    pub(super) fn new_ports(&self, instance: &Instance) -> Vec<String> {
        let data = instance.image.data.iter().zip(instance.data.iter()).zip(0u32..);
        data.flat_map(|((data, store), number)| self.new_ports_of(data, *store, number)).collect()
    }

    fn new_ports_of(&self, data: &DataDef, id: StoreId, number: u32) -> Vec<String> {
        let Ok(store) = self.memory.store(id) else { return Vec::new() };
        let lanes = store.kind.size.link;
        let values = indexes(&store.shape).filter(|(value, _)| {
            let place = store.place(id, *value);
            (0..lanes).any(|lane| self.is_new_port(place, (number, Vec::new(), *value, lane)))
        });
        values.map(|(_, index)| format!("{}[{index}]", data.name)).collect()
    }

    /// Whether the link of a value at this place is an input, output or line, and was set after loading.
    fn is_new_port(&self, place: Place, spot: LinkPath) -> bool {
        let link = self.memory.link(place, spot.3).unwrap_or(LinkPlace::None);
        matches!(link, LinkPlace::Port(_)) && !self.is_loaded(Some(&spot), link, LinkPlace::None)
    }

    /// Finds the frame or tool that a file names.
    fn father(&self, father: &FatherLink) -> Option<Place> {
        if let Some(known) = self.fathers.borrow().get(father) {
            return *known;
        }
        let place = self.space.father(self.id, father);
        self.fathers.borrow_mut().insert(father.clone(), place);
        place
    }

    /// Whether the value has its loaded link; `own` is the link of the type.
    pub(super) fn is_loaded(&self, spot: Option<&LinkPath>, link: LinkPlace, own: LinkPlace) -> bool {
        match spot.and_then(|spot| self.loaded.get(spot)) {
            Some(LinkTarget::Port(base, path)) => self.text(link, *base).as_ref() == Some(path),
            Some(LinkTarget::Father(father)) => match self.father(father) {
                Some(place) => link == LinkPlace::Data(place),
                None => link == LinkPlace::None,
            },
            Some(LinkTarget::Signal(named)) => {
                let by_name = || self.text(link, BaseType::Dio).as_ref() == Some(&named.name);
                self.space.signal(self.id, named).map_or_else(by_name, |own| own == link)
            }
            None => link == own,
        }
    }
}

/// Returns the value numbers of a container with the indexes of a reference: `2`, `1,3`, `"home"`.
fn indexes(shape: &ContainerShape) -> Box<dyn Iterator<Item = (u32, String)> + '_> {
    match shape {
        ContainerShape::Collection(keys) => Box::new(keys.iter().map(|(key, number)| (*number, format!("\"{key}\"")))),
        ContainerShape::Array { dims, sizes } => {
            Box::new((0..shape.len()).map(|number| (number, index(*dims, *sizes, number))))
        }
    }
}

/// Returns an array value's index: `2`, `1,3`.
pub(super) fn index(dims: u8, [_, rows, columns]: [u32; 3], number: u32) -> String {
    let (rows, columns) = (rows.max(1), columns.max(1));
    let all = [number / columns / rows, number / columns % rows, number % columns];
    let used = all.iter().take(usize::from(dims)).map(u32::to_string);
    used.collect::<Vec<_>>().join(",")
}

/// Returns a father reference as written in a file.
fn reference(father: &FatherLink) -> String {
    let library = father.library.as_ref().map(|library| format!("{library}:")).unwrap_or_default();
    let fields = father.fields.iter().map(|(name, at)| format!(".{name}[{}]", quoted(at)));
    format!("{library}{}[{}]{}", father.name, quoted(&father.at), fields.collect::<String>())
}

/// Quotes keys, but not indexes.
fn quoted(at: &str) -> String {
    let is_index = at.chars().all(|character| character.is_ascii_digit() || matches!(character, ',' | ' '));
    if is_index { at.to_owned() } else { format!("\"{at}\"") }
}
