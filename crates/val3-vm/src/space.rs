//! Applications and libraries in memory with their data, and the links between data.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use val3_bytecode::{DataDef, FatherLink, Image, Import, ImportKind, LinkInit, LinkTarget, ProgramRef};
use val3_lang::fault::Fault;
use val3_lang::memory::{LinkPlace, Memory, Owner, Place, StoreId, View};
use val3_lang::types::BaseType;

use crate::counts::LineCounts;
use crate::hit_counters::HitCounters;
use crate::instance::Imported;
use crate::stops::Stops;
use crate::{Host, Instance, InstanceId, ProgramId, StopGuard};

/// Applications and libraries in memory.
#[derive(Debug, Clone, Default)]
pub struct Space {
    /// All data.
    pub memory: Memory,
    /// Instances by number. A running task uses the list from when its turn began, or from when it last loaded a
    /// library.
    pub(crate) instances: Arc<Vec<Instance>>,
    stops: Stops,
    /// Guards of stop marks.
    pub(crate) guards: Arc<Vec<StopGuard>>,
    /// Hit counters of the guards.
    pub(crate) hit_counters: HitCounters,
    /// Whether tasks stop before their end.
    pub(crate) stops_at_ends: bool,
    /// Execution counts of counted lines and branch sides.
    pub counts: LineCounts,
}

impl Space {
    /// Returns the application or library with a number.
    #[must_use]
    pub fn instance(&self, id: InstanceId) -> Option<&Instance> {
        self.instances.get(usize::from(id.0))
    }

    /// Returns the program that a call site of `caller` calls; `None` while its library is not loaded or does not
    /// contain it.
    #[must_use]
    pub fn called(&self, caller: InstanceId, program: ProgramRef) -> Option<ProgramId> {
        match program {
            ProgramRef::Own(number) => Some(ProgramId { instance: caller, number }),
            ProgramRef::Import(number) => match self.instance(caller)?.imports.get(usize::from(number)) {
                Some(Some(Imported::Program(program))) => Some(*program),
                _ => None,
            },
        }
    }

    /// Returns the applications and libraries in memory.
    pub fn loaded(&self) -> impl Iterator<Item = (InstanceId, &Instance)> {
        (0..).map(InstanceId).zip(self.instances.iter()).filter(|(_, instance)| instance.loaded)
    }

    /// Sets the lines of a file before which tasks stop.
    pub(crate) fn set_stops(&mut self, file: &str, rows: BTreeSet<u32>) {
        self.stops.set(file, rows);
        self.mark_stops();
    }

    /// Sets the programs before whose first line tasks stop.
    pub(crate) fn set_program_stops(&mut self, names: BTreeSet<String>) {
        self.stops.set_programs(names);
        self.mark_stops();
    }

    fn mark_stops(&mut self) {
        for instance in Arc::make_mut(&mut self.instances) {
            self.stops.mark(&mut instance.image);
        }
    }

    /// Returns the application or library with a number for writing.
    pub(crate) fn instance_mut(&mut self, id: InstanceId) -> Option<&mut Instance> {
        Arc::make_mut(&mut self.instances).get_mut(usize::from(id.0))
    }

    /// Removes the fragments that do not satisfy the predicate.
    pub(crate) fn retain_fragments(&mut self, is_used: impl Fn(InstanceId, u16) -> bool) {
        for (id, instance) in (0..).map(InstanceId).zip(Arc::make_mut(&mut self.instances)) {
            instance.retain_fragments(|number| is_used(id, number));
        }
    }

    /// Loads an application or library into memory, with the initial data from its files.
    ///
    /// # Errors
    /// 40 if the memory does not suffice.
    pub fn load(&mut self, mut image: Arc<Image>, path: String, host: &mut dyn Host) -> Result<InstanceId, Fault> {
        let free = self.instances.iter().position(|instance| !instance.loaded);
        let at = free.unwrap_or(self.instances.len());
        let id = InstanceId(u16::try_from(at).unwrap_or(u16::MAX));
        let owner = |data: &DataDef| Owner::Project { number: id.0, public: data.public };
        let data = self.memory.create_all(&image.data, |memory, data| memory.create_for(owner(data), &data.init))?;
        if let Err(fault) = self.memory.stores.room.take(image.code_bytes()) {
            data.into_iter().for_each(|store| self.memory.remove(store));
            return Err(fault);
        }
        let data: Arc<[StoreId]> = data.into();
        self.stops.mark(&mut image);
        let instance = Instance {
            data,
            path,
            libraries: vec![None; image.libraries.len()],
            imports: vec![None; image.imports.len()],
            fragments: Vec::new(),
            first_counter: self.counts.first_of(&image),
            loaded: true,
            image,
        };
        match self.instance_mut(id) {
            Some(slot) => *slot = instance,
            None => Arc::make_mut(&mut self.instances).push(instance),
        }
        if let Some(instance) = self.instance(id) {
            host.loaded(id.0, &instance.image, &instance.data);
        }
        self.link_data(id, None, host);
        Ok(id)
    }

    /// Replaces the image of an application in memory. Data that both images declare equally keep their values; other
    /// data in the new image begin with their initial values.
    ///
    /// # Errors
    /// 40 if the memory does not suffice. The image in memory is then unchanged.
    pub fn exchange(&mut self, id: InstanceId, mut image: Arc<Image>, host: &mut dyn Host) -> Result<(), Fault> {
        let Some(instance) = self.instance(id) else { return Ok(()) };
        let (before, stores, libraries) =
            (Arc::clone(&instance.image), Arc::clone(&instance.data), instance.libraries.clone());
        let old = by_name(&before.data, &stores);
        let owner = |data: &DataDef| Owner::Project { number: id.0, public: data.public };
        let added = image.data.iter().filter(|data| kept_store(&old, data).is_none());
        let added = self.memory.create_all(added, |memory, data| memory.create_for(owner(data), &data.init))?;
        let mut added = added.into_iter();
        let data = image.data.iter().filter_map(|data| kept_store(&old, data).or_else(|| added.next()));
        let data: Arc<[StoreId]> = data.collect();
        let new = by_name(&image.data, &data);
        let gone = old.iter().filter(|(name, (_, store))| new.get(*name).is_none_or(|(_, same)| same != store));
        gone.for_each(|(_, (_, store))| self.memory.remove(*store));
        self.stops.mark(&mut image);
        host.loaded(id.0, &image, &data);
        self.memory.stores.room.give_back(before.code_bytes());
        self.memory.stores.room.count(image.code_bytes());
        let first_counter = self.counts.first_of(&image);
        if let Some(instance) = self.instance_mut(id) {
            instance.first_counter = first_counter;
            instance.imports = vec![None; image.imports.len()];
            (instance.image, instance.data) = (image, data);
        }
        for (number, library) in (0u16..).zip(libraries) {
            if let Some(library) = library {
                self.connect_items(id, number, library);
            }
        }
        Ok(())
    }

    /// Binds a library identifier of `user` to `library`, and returns whether the library contains the entire expected
    /// interface.
    ///
    /// An item that it does not contain raises error 80 when it is used.
    pub fn connect(&mut self, user: InstanceId, alias: u16, library: InstanceId, host: &mut dyn Host) -> bool {
        let complete = self.connect_items(user, alias, library);
        self.declare_libraries(user);
        self.link_data(user, Some(alias), host);
        complete
    }

    fn connect_items(&mut self, user: InstanceId, alias: u16, library: InstanceId) -> bool {
        let Some(instance) = self.instances.get(usize::from(user.0)) else { return false };
        let exporter = self.instances.get(usize::from(library.0));
        let of_alias = |import: &&Import| import.library == alias;
        let found: Vec<_> = (0usize..)
            .zip(&instance.image.imports)
            .filter(|(_, import)| of_alias(import))
            .map(|(at, import)| (at, exporter.and_then(|exporter| exporter.item(library, import, &instance.image))))
            .collect();
        let complete = found.iter().all(|(at, item)| {
            let import = instance.image.imports.get(*at);
            item.is_some() || import.is_none_or(|import| import.kind == ImportKind::Missing)
        });
        if let Some(instance) = self.instance_mut(user) {
            if let Some(slot) = instance.libraries.get_mut(usize::from(alias)) {
                *slot = Some(library);
            }
            for (at, item) in found {
                if let Some(slot) = instance.imports.get_mut(at) {
                    *slot = item;
                }
            }
        }
        complete
    }

    pub(crate) fn declare_libraries(&mut self, user: InstanceId) {
        let libraries = self.instance(user).map(|instance| &instance.libraries).into_iter().flatten();
        let numbers = libraries.flatten().map(|library| library.0).collect();
        self.memory.declare_libraries(user.0, numbers);
    }

    /// Links the data that do not wait for a library, or the data that wait for `alias`.
    fn link_data(&mut self, id: InstanceId, alias: Option<u16>, host: &mut dyn Host) {
        let Some(instance) = self.instance(id) else { return };
        let image = Arc::clone(&instance.image);
        let alias = alias.and_then(|alias| image.libraries.get(usize::from(alias))).map(|library| &library.alias);
        for init in &image.links {
            let library = match &init.target {
                LinkTarget::Father(named) => named.library.as_ref(),
                LinkTarget::Signal(named) => {
                    let mut declared = image.libraries.iter().map(|library| &library.alias);
                    named.library.as_ref().filter(|alias| declared.any(|known| known == *alias))
                }
                LinkTarget::Port(..) => None,
            };
            if library == alias
                && let Some(place) = self.place_of(id, init)
                && let Some(link) = self.target(id, &init.target, host)
            {
                // The place was looked up just now, so it exists.
                let _ = self.memory.set_file_link(place, init.link, link);
            }
        }
    }

    fn place_of(&self, id: InstanceId, init: &LinkInit) -> Option<Place> {
        let mut store = self.instance(id)?.data.get(init.data as usize).copied()?;
        for (value, field) in &init.path {
            let place = self.memory.element(View::whole(store), *value).ok()?;
            store = self.memory.part(place, *field).ok()?;
        }
        let found = self.memory.store(store).ok()?;
        Some(found.place(store, init.value))
    }

    fn target(&self, id: InstanceId, target: &LinkTarget, host: &mut dyn Host) -> Option<LinkPlace> {
        match target {
            LinkTarget::Port(base, path) => host.port(*base, path).map(LinkPlace::Port),
            LinkTarget::Father(father) => self.father(id, father).map(LinkPlace::Data),
            LinkTarget::Signal(named) => {
                self.signal(id, named).or_else(|| host.port(BaseType::Dio, &named.name).map(LinkPlace::Port))
            }
        }
    }

    /// Returns the link of the `dio` that a data file names; `None` if it does not exist.
    #[must_use]
    pub fn signal(&self, id: InstanceId, named: &FatherLink) -> Option<LinkPlace> {
        let place = self.named(id, named)?;
        let is_signal = self.memory.store(place.store).ok()?.kind.base_type() == Some(BaseType::Dio);
        self.memory.link(place, 0).ok().filter(|link| is_signal && matches!(link, LinkPlace::Port(_)))
    }

    /// Returns the frame or tool that a data file names; `None` if it does not exist.
    #[must_use]
    pub fn father(&self, id: InstanceId, father: &FatherLink) -> Option<Place> {
        let place = self.named(id, father)?;
        let base = self.memory.store(place.store).ok()?.kind.base_type();
        matches!(base, Some(BaseType::Frame | BaseType::Tool)).then_some(place)
    }

    fn named(&self, id: InstanceId, named: &FatherLink) -> Option<Place> {
        let own = self.instance(id)?;
        let store = match (&named.library, named.name.as_str()) {
            (Some(library), name) => {
                let at = own.image.libraries.iter().position(|found| found.alias == *library)?;
                let library = self.instance((*own.libraries.get(at)?)?)?;
                library.data.get(usize::from(library.image.data(name)?)).copied()?
            }
            (None, name) => match own.image.data(name) {
                Some(number) => own.data.get(usize::from(number)).copied()?,
                None => builtin(name)?,
            },
        };
        let first = self.value(store, &named.at)?;
        named.fields.iter().try_fold(first, |place, (field, at)| {
            let fields = &self.memory.store(place.store).ok()?.kind.fields;
            let number = fields.iter().position(|known| known.name == *field)?;
            self.value(self.memory.part(place, u32::try_from(number).ok()?).ok()?, at)
        })
    }

    /// Returns the container element that a data file names: `2`, `1,3`, `home`.
    fn value(&self, id: StoreId, at: &str) -> Option<Place> {
        let store = self.memory.store(id).ok()?;
        Some(store.place(id, store.number_of_text(at)?))
    }
}

/// Returns the container of `world` or `flange`.
fn builtin(name: &str) -> Option<StoreId> {
    val3_lang::builtins::find(name).and_then(|builtin| match builtin.ty {
        BaseType::Frame => Some(Memory::WORLD),
        BaseType::Tool => Some(Memory::FLANGE),
        _ => None,
    })
}

type NamedData<'d> = BTreeMap<&'d str, (&'d DataDef, StoreId)>;

/// Returns data definitions with their containers, by name.
fn by_name<'d>(data: &'d [DataDef], stores: &[StoreId]) -> NamedData<'d> {
    data.iter().zip(stores).map(|(data, store)| (data.name.as_str(), (data, *store))).collect()
}

/// Returns the container of data that were declared equally before.
fn kept_store(old: &NamedData<'_>, data: &DataDef) -> Option<StoreId> {
    let (before, store) = old.get(data.name.as_str())?;
    (*before == data).then_some(*store)
}
